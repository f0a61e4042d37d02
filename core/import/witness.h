#pragma once
// An accelerometer beside motion and wrench. It must not cost anything: where it does not fit the other streams it is
// left aside, and the findings say so.
#include "core/import/signals.h"
#include "core/recording/recording.h"

namespace heft {

/// Whether a column is the accelerometer's or its gyroscope's.
bool ofWitness(const ColumnSource& column);

class Witness {
 public:
  explicit Witness(Joining& joining) : joining_(joining) {}

  /// Reads it beside a wrench that comes from stream `wrench`.
  void read(SignalReader& reader, Clocks& clocks, std::size_t wrench);
  void forget(const std::string& why);
  /// Both are on one clock, and the force follows what the tool feels at once.
  void align(const Signal& wrench);
  /// Where it alone tells the acceleration, the recording begins and ends with it, if it was there half of the time.
  void limit(double& from, double& to) const;
  /// Puts it on the times `at` of the recording, which are `step` apart, if it was there nearly all the time.
  void take(const VectorXd& at, double step, Recording& recording);

  std::vector<Signal*> signals() { return {&accelerometer_, &gyroscope_}; }
  Signal& accelerometer() { return accelerometer_; }
  Signal& gyroscope() { return gyroscope_; }

 private:
  Joining& joining_;
  Signal accelerometer_, gyroscope_;
};

}  // namespace heft
