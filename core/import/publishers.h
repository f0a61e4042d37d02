#pragma once
// Who sends what on a topic: rows of the publisher that gives the motion, and of others.
#include <map>

#include "core/import/joining.h"

namespace heft {

class Publishers {
 public:
  explicit Publishers(Joining& joining) : joining_(joining) {}

  /// Several nodes may send the same joints on one topic: zeros, a simulation, a second arm. Where their values do not
  /// continue each other, the one that moves most is taken.
  void choose();
  /// Whether row k of a stream is of the publisher that gives the motion: where several share a topic, others' rows
  /// lack all of its joints.
  bool reported(std::size_t stream, std::size_t k) const;
  /// Whether rows of `stream` were left out by choose().
  bool dropsFrom(std::size_t stream) const { return dropped_.contains(stream); }
  /// Who sends what the chosen joints are not in: " (position[finger])".
  std::string others(std::size_t stream) const;

 private:
  /// Rows of one sender: those that hold all core columns.
  struct Sender {
    std::vector<std::size_t> rows;
    double spread = 0.0;  ///< Sum of the columns' standard deviations.
  };
  /// Whether the rows of `other` lie between those of `main` in value as they do in time.
  bool continues(std::size_t s, const std::vector<const std::vector<double>*>& core, const Sender& main,
                 const Sender& other) const;

  Joining& joining_;
  std::map<std::size_t, std::set<std::size_t>> dropped_;  ///< Rows of other publishers, by stream.
};

}  // namespace heft
