#pragma once
// Runs `heft` on inputs as people have them and compares the answer with the truth that stands beside them.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/cli/process.h"

namespace heft::test {

/// ../shared/cases, or HEFT_SHARED/cases; an empty path if it is not at hand.
std::filesystem::path sharedCases();

/// A copy of one folder of inputs to run in, so that nothing is written beside the originals.
class CaseTest : public CliTest {
 protected:
  /// Copies ../shared/cases/NAME and goes there; false where the shared inputs are absent (skip the test then).
  bool enter(const std::string& name);

  Outcome heftHere(const std::vector<std::string>& arguments) const { return runHeft(arguments, folder_); }
  const std::filesystem::path& here() const { return folder_; }

  /// Estimates `arguments` and expects mass and centre as in truth.json: within `massShare` of the mass and
  /// `centreMm` of the centre, and a trust that is not `none`.
  nlohmann::json expectTruth(const std::vector<std::string>& arguments, double massShare = 0.005,
                             double centreMm = 0.6) const;
  /// Expects exit code 1 and one sentence that holds all of `says`.
  void expectRefusal(const std::vector<std::string>& arguments, const std::vector<std::string>& says) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace heft::test
