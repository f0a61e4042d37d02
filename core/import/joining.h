#pragma once
// What all steps of joining share: the streams, which of their columns count, and what is said about them.
#include <set>
#include <string>
#include <vector>

#include "core/base/findings.h"
#include "core/import/mapping.h"
#include "core/import/streams.h"

namespace heft {

struct Joining {
  const std::vector<Stream>& streams;
  std::vector<ColumnSource> columns;
  const MappingWishes& wishes;
  Findings& findings;
  std::string file;            ///< That findings are about.
  std::set<std::size_t> used;  ///< Streams of the columns, without the accelerometer's.

  void note(Severity severity, const char* code, std::string text, std::string remedy = {});
  /// Joints and velocities of one stream have the same to say.
  void noteOnce(Severity severity, const char* code, const std::string& text);
  std::string nameOf(std::size_t stream) const;
  std::string howToShift(std::size_t stream, double seconds) const;
  /// "q1", "q2", ... as far as there are such columns.
  std::vector<std::string> numbered(const std::string& prefix) const;
  bool sameFile() const;
  /// Columns that tell what a stream's rows are about: joints, else the wrench, else the orientation.
  std::vector<const std::vector<double>*> coreOf(std::size_t stream) const;
};

}  // namespace heft
