#pragma once
// Robot and sensor of a recording, as the setup file beside it says them, and changing that.
#include <QString>

#include "core/base/result.h"
#include "ui/controller/workspace.h"

namespace heft {

/// The setup file beside a recording.
QString metaFileBeside(const QString& recording);

/// What holds for a recording now: as it was opened, else what its setup file says, else the usual.
Result<RecordingMeta> rigOf(const QString& recording, const OpenRecording* opened);

/// Writes what differs between `before` and `after` (robot, kind, sensor, gravity, conventions) into the setup file
/// beside the recording; all else in it stays as it is, and a map file that stated a convention otherwise leaves it to
/// this. Fails, and writes nothing, if the robot's description cannot be read or does not fit: other joints than the
/// opened recording has, or no link where the sensor is mounted. The recording has to be opened again to show it.
Result<bool> writeRig(const QString& recording, const OpenRecording* opened, const RecordingMeta& before,
                      const RecordingMeta& after);

/// The user's own robot for a recording that is open.
Result<bool> nameRobot(const OpenRecording& opened, const QString& urdf);

}  // namespace heft
