#pragma once
// How well answers in the form heft.diagnose/1 name what was hidden: counts, confusion, detection by size, gain.
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tests/support/hidden_effects.h"

namespace heft::test {

enum class Judgement {
  right,        ///< Hidden and named first (a pair: both named); clean and called clean; unlisted and "unexplained".
  tied,         ///< Among the alternatives of the first cause, or a stated near relative of an unlisted effect.
  later,        ///< Named, but not first.
  unexplained,  ///< Called unexplained although listed.
  missed,       ///< Called clean although something was hidden.
  wrong,        ///< Another cause, stated as if it were sure; or an alarm on a clean recording.
};
std::string_view toString(Judgement judgement);

/// `answer`: an object of the contract's heft.diagnose/1. Keys that are missing count as empty.
Judgement judge(const HiddenTruth& truth, const nlohmann::json& answer);

/// Collects answers and prints them.
class DiagnosisScore {
 public:
  void add(const HiddenTruth& truth, const nlohmann::json& answer, double seconds);
  /// Tables for a person.
  std::string text() const;
  /// Share of one judgement among the cases of a kind (at `multiple`, or at all where 0).
  double share(HiddenCase kind, Judgement judgement, double multiple = 0.0) const;

 private:
  struct Entry {
    HiddenCase kind;
    double multiple;
    std::string noise, hidden, named;
    Judgement judgement;
    double massBefore, massAfter;      ///< relative errors
    double centreBefore, centreAfter;  ///< [m]
    double residualOverNoise;          ///< Held-out force residual after the last cause, over the noise; 0: unknown
    std::vector<double> errors;        ///< Of parameters, in their deviations
    double seconds;
  };
  std::vector<Entry> entries_;
};

}  // namespace heft::test
