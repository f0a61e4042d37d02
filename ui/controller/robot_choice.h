#pragma once
// The user's own robot for a recording: its description is named in the recording's meta file.
#include <QString>

#include "core/base/result.h"
#include "ui/controller/workspace.h"

namespace heft {

/// Where nameRobot() would write.
QString metaFileBeside(const OpenRecording& opened);
/// Writes `urdf` as the robot into the meta file beside the recording, all else in it stays as it is. Fails, and writes
/// nothing, if the description cannot be read or does not fit: other joints, or no link where the sensor is mounted.
/// The recording has to be opened again to show it.
Result<bool> nameRobot(const OpenRecording& opened, const QString& urdf);

}  // namespace heft
