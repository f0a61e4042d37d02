#pragma once
// Signals of a recording as their streams have them: complete rows in the order of their times.
#include "core/import/clocks.h"
#include "core/import/publishers.h"
#include "core/math/rigid.h"
#include "core/recording/conventions.h"
#include "core/recording/missing.h"

namespace heft {

inline constexpr double kLongestGapSteps = 5.0;  ///< Across longer gaps nothing is interpolated.

/// Rows of some columns of one stream.
struct Signal {
  std::size_t stream = 0;
  std::vector<std::int64_t> nanoseconds;
  VectorXd time;  ///< [s] after the joint beginning
  MatrixXd values;
  double step = 0.0;  ///< [s] median

  bool empty() const { return values.cols() == 0; }
};

class SignalReader {
 public:
  SignalReader(Joining& joining, const Publishers& publishers, const Clocks& clocks)
      : joining_(joining), publishers_(publishers), clocks_(clocks) {}

  /// Velocities and a position that hardly ever come are worth less than the rows that lack them.
  void setAsideSparse();
  /// The columns `names`, all of one stream; empty where one is missing.
  Signal read(const std::vector<std::string>& names);

 private:
  Joining& joining_;
  const Publishers& publishers_;
  const Clocks& clocks_;
};

/// `at` within the times of a signal.
VectorXd clamped(const VectorXd& at, const Signal& signal);
/// Whether a signal has no gap of more than kLongestGapSteps of the larger of its own step and `step` [s] around t.
bool nearSamples(const Signal& signal, double t, double step);

/// A rotation in one of rotationForms() as quaternions (x, y, z, w), or in the order that is stated for quaternions,
/// which is undone later on.
Signal quaternionsOf(Signal signal, const std::vector<std::string>& form, Conventions::QuaternionOrder order);

}  // namespace heft
