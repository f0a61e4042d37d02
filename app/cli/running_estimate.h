#pragma once
// The estimate while samples arrive, as a line of text.
#include <memory>
#include <string>
#include <vector>

#include "core/estimation/options.h"
#include "core/live/source.h"
#include "core/payload/shape.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft::cli {

class RunningEstimate {
 public:
  /// `robot` may be null where samples have poses. With ConventionChoice::suggested the samples are read as physics
  /// says from when it says so on. Throws Failed.
  RunningEstimate(const RecordingMeta& meta, const RobotModel* robot, const std::optional<Shape>& shape,
                  ConventionChoice choice);
  ~RunningEstimate();
  RunningEstimate(const RunningEstimate&) = delete;
  RunningEstimate& operator=(const RunningEstimate&) = delete;

  /// A complete sample, in the conventions of the meta. Throws Failed where they take a pose that it does not have.
  void add(const LiveSample& sample);
  /// Without a weight where the numbers do not mean what the meta says.
  /// "  12.4 s  0.800 kg [0.798, 0.803]  centre (8.4, 2.1, 53.1) mm  free  Inertia: turn the tool faster"
  std::string line() const;
  /// What is worth a line of its own and was not yet returned: that the tool changed, what the numbers mean.
  std::vector<std::string> news();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace heft::cli
