#include "ui/record_panel/touched_walls.h"

#include <QFileInfo>
#include <nlohmann/json.hpp>

#include "core/base/json_file.h"
#include "core/compensation/touched_room.h"
#include "ui/controller/free_file.h"
#include "ui/controller/workspace.h"

namespace heft {
namespace {

Result<Room> roomIn(const Snapshot& now, const EstimateReport& report, const Shape& tool, const Progress& progress) {
  const auto recording = now.recording();
  const auto touched = findTouchedRoom(*recording, now.robot(), toJson(report), recording->file, tool, progress);
  if (!touched) return touched.error();
  return roomOf(*touched, Room{}.margin);
}

}  // namespace

TouchedWalls::TouchedWalls(Workspace* workspace, QObject* parent) : QObject(parent), workspace_(workspace) {}

Result<bool> TouchedWalls::find() {
  const auto opened = workspace_->opened();
  if (!opened)
    return Error{tr("Open a recording in which the tool is pressed against walls and tables first.").toStdString()};
  const auto report = workspace_->report();
  if (!report)
    return Error{tr("The payload is needed to tell a touch from the tool’s weight; there is none yet.").toStdString()};
  const Snapshot now = workspace_->snapshot();
  if (!now.options.shape)
    return Error{tr("State the tool’s shape first (step Shape): a wall begins where the tool ends.").toStdString()};
  jobs_.start(
      tr("Looking for walls that were touched"),
      [now, report, tool = *now.options.shape](const Progress& progress) {
        return roomIn(now, *report, tool, progress);
      },
      [this, recording = opened->path](Result<Room> room) {
        const auto fail = [this](const Error& error) {
          if (!error.cancelled) emit ended(Severity::error, QString::fromStdString(error.message));
        };
        if (!room) return fail(room.error());
        const QFileInfo info(recording);
        const QString file =
            freeFile(info.absolutePath(), info.completeBaseName() + QStringLiteral(".room"), QStringLiteral("json"));
        if (const auto written = writeTextFile(file.toStdString(), toJson(*room).dump(2) + "\n"); !written)
          return fail(written.error());
        workspace_->setRoom(file.toStdString(), tr("Walls that were touched"));
        QStringList names;
        for (const Obstacle& obstacle : room->obstacles) names << QString::fromStdString(titleOf(obstacle));
        emit ended(Severity::info, tr("Found: %1. Saved as %2.").arg(names.join(QStringLiteral(", ")), file));
      });
  return true;
}

}  // namespace heft
