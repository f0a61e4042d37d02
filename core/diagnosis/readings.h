#pragma once
// What single readings say, and the recording without what they spoil: the first step of a diagnosis.
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/diagnosis/data_quality/dead_band.h"
#include "core/diagnosis/data_quality/sample_tests.h"
#include "core/diagnosis/data_quality/stuck_bit.h"
#include "core/diagnosis/frames.h"
#include "core/diagnosis/options.h"
#include "core/motion/motion.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"

namespace heft::diagnosis {

/// What single readings say, and the recording without what they spoil.
struct Readings {
  std::optional<FrameMistake> mistake;  ///< Put right before anything else is made of the readings
  Recording stated;                     ///< The recording without it, where there is one
  Recording cleaned;
  Motion motion;  ///< What a payload feels of it
  std::vector<Direct> directs;
  Vector6d steps = Vector6d::Zero();  ///< As of CoarseReadings
  std::vector<DeadBand> deadBands;
  std::vector<StuckBit> stuckBits;
  std::optional<FrozenChannel> frozen;
  std::vector<bool> bad;   ///< Rows that are not judged: one a row, or none
  Eigen::Index leaps = 0;  ///< Rows that leap and are neither spikes nor of a stuck bit
  bool cutsMost = false;   ///< Readings are cut off flat most of the time: those rows are judged, too

  /// The `recording` that this was told of, without a mistake.
  const Recording& asRead(const Recording& recording) const { return mistake ? stated : recording; }
  /// Whether a test of single readings found this cause.
  bool have(std::string_view cause) const;
};

/// Whether `options` ask not to look for this cause.
bool isHidden(const DiagnoseOptions& options, std::string_view id);

/// `asStated`: whatever the conventions are.
Result<Readings> readingsOf(const Recording& recording, const RobotModel* robot, const DiagnoseOptions& options,
                            const Progress& progress, bool asStated = false);

}  // namespace heft::diagnosis
