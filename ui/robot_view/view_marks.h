#pragma once
// What the steps put into the 3D picture beside arm and tool, and take out again: a suggested motion, the room, what is
// near, what pulls, and what was found to act.
#include <QRectF>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "core/collision/clearance.h"
#include "core/robot/robot_model.h"
#include "ui/robot_view/cause_mark.h"
#include "ui/robot_view/pull_mark.h"

class QPainter;

namespace heft {

class Viewport;
struct ViewLabel;

class ViewMarks {
 public:
  explicit ViewMarks(Viewport* viewport) : viewport_(viewport) {}

  /// A second arm in these joint angles, translucent: a suggested motion. Nothing hides it.
  void showGhost(const std::optional<VectorXd>& joints);
  /// The way of the suggested motion, B axes [m]; empty hides it.
  void showGhostWay(const std::vector<Vector3d>& way);
  /// Words at the end of that way.
  void setGhostLabel(const QString& title, const QString& note);
  /// What stands around the arm; without obstacles nothing. It stays until it is replaced.
  void showRoom(const Room& room);
  /// Of arm and tool, about the ghost; empty hides them.
  void showHulls(const std::vector<HullSurface>& hulls);
  /// The two bodies that are nearest to each other; nothing hides the mark.
  void showGap(const std::optional<Nearest>& gap);
  const std::optional<Nearest>& gap() const { return gap_; }
  /// What pulls at the tool; nothing hides it.
  void showPull(const std::optional<PullMark>& pull);
  /// What else was found to act on arm and tool.
  void showCauses(std::vector<CauseMark> causes);
  const std::vector<CauseMark>& causes() const { return causes_; }
  /// All but the room.
  void clear();

  // For the view.
  /// Whose ghost it is.
  void setRobot(std::shared_ptr<const RobotModel> robot) { robot_ = std::move(robot); }
  void paint(QPainter& painter, const HandleSet::View& view) const;
  /// At the end of the suggested way; nothing without words.
  std::optional<Vector3d> ghostEnd() const;
  const QString& ghostTitle() const { return ghostTitle_; }
  const QString& ghostNote() const { return ghostNote_; }
  /// Of gap, causes and pull.
  void addLabels(std::vector<ViewLabel>& labels, const HandleSet::View& view) const;
  /// The pull's line in short pieces [px].
  std::vector<QRectF> pullPlaces(const HandleSet::View& view) const;

 private:
  Viewport* viewport_;
  std::shared_ptr<const RobotModel> robot_;
  std::optional<Vector3d> ghostEnd_;
  QString ghostTitle_, ghostNote_;
  std::optional<Nearest> gap_;
  std::optional<PullMark> pull_;
  std::vector<CauseMark> causes_;
};

}  // namespace heft
