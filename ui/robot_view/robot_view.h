#pragma once
// The 3D half of the window: arm, tool and path at one instant of the recording, with labels and view tools.
#include <QImage>
#include <QPointF>
#include <QPointer>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "core/collision/clearance.h"
#include "core/estimation/estimate.h"
#include "core/payload/shape.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"
#include "ui/robot_view/cause_mark.h"
#include "ui/robot_view/dimension_lines.h"
#include "ui/robot_view/handles.h"
#include "ui/robot_view/pull_mark.h"
#include "ui/robot_view/robot_look.h"

class QLabel;
class QPainter;

namespace heft {

class DimensionEditor;
class LabelOverlay;
class PosedArm;
class SceneTrack;
class Viewport;
struct SceneParts;
struct PayloadLook;
struct SceneState;

/// An arm that is being listened to, at one instant.
struct LiveMoment {
  std::optional<VectorXd> q;  ///< [rad]; absent: the sensor alone
  Isometry3d X_BS = Isometry3d::Identity();
  Vector6d wrench = Vector6d::Zero();            ///< F_PSo_S as measured
  std::shared_ptr<const EstimateReport> report;  ///< What is known of the tool so far; null at first. No series needed.
};

class RobotView : public QWidget {
  Q_OBJECT
 public:
  explicit RobotView(QWidget* parent = nullptr);
  ~RobotView() override;

  /// An arm standing in its home posture, before any recording is open. It also stands in, translucent, where a
  /// recording has poses alone that it can reach.
  void showRobot(std::shared_ptr<const RobotModel> robot, std::shared_ptr<const RobotLook> look);
  /// Neither robot nor recording, nor anything that was found out about one.
  void showNothing();
  /// A recording; robot and look are null where it carries poses only.
  void showRecording(std::shared_ptr<const Recording> recording, std::shared_ptr<const RobotModel> robot,
                     std::shared_ptr<const RobotLook> look);
  /// The estimate on that recording, or null.
  void showReport(std::shared_ptr<const EstimateReport> report);
  void showTime(double time);

  /// The user's tool in S axes; meshes must be loaded. It stays until it is replaced. `selected` is drawn stronger.
  void showTool(std::vector<ShapeBody> bodies, int selected = -1);
  /// While its shape is edited: close to the tool, and nothing in the way. Off brings the earlier view back.
  void setToolEditing(bool editing);
  /// What the shown step lets one grab; null for nothing. Taken out again by the step that put it in.
  void setHandles(HandleSet* handles);
  /// Where a handle's knob is, pixels of the viewport; for tests.
  std::optional<QPointF> knob(int id) const;
  void setDimensions(std::vector<DimensionLine> lines);
  /// Where the label of a handle's length is, pixels of the viewport; for tests.
  std::optional<QPointF> dimensionLabel(int id) const;
  /// What to do here, and the step's own tools beside it, at the top left. The view does not own the tools.
  void setStepNote(const QString& text);
  void setStepTools(QWidget* tools);
  /// A second arm in these joint angles, translucent: a suggested motion. Nothing hides it.
  void showGhost(const std::optional<VectorXd>& joints);
  /// The way of the suggested motion, B axes [m]; empty hides it.
  void showGhostWay(const std::vector<Vector3d>& way);
  /// What stands around the arm; without obstacles nothing. It stays until it is replaced.
  void showRoom(const Room& room);
  /// Of arm and tool, about the ghost; empty hides them.
  void showHulls(const std::vector<HullSurface>& hulls);
  /// The two bodies that are nearest to each other; nothing hides the mark. Taken out again by the step that put it in.
  void showGap(const std::optional<Nearest>& gap);
  const std::optional<Nearest>& gap() const { return gap_; }
  /// What pulls at the tool; nothing hides it. Taken out again by the step that put it in.
  void showPull(const std::optional<PullMark>& pull);
  /// What else was found to act on arm and tool; likewise.
  void showCauses(std::vector<CauseMark> causes);
  const std::vector<CauseMark>& causes() const { return causes_; }
  /// Titles of the labels shown; for tests.
  QStringList labelTexts() const;
  /// Words at the end of that way.
  void setGhostLabel(const QString& title, const QString& note);

  /// Shows a moving arm instead of a recording, which comes back with endLive(). Robot and look are null where only the
  /// sensor's pose is known.
  void beginLive(std::shared_ptr<const RobotModel> robot, std::shared_ptr<const RobotLook> look,
                 const SensorMount& mount, const Vector3d& gravity);
  void showLive(const LiveMoment& moment);
  /// The way of the sensor so far, B axes [m].
  void showLivePath(const std::vector<Vector3d>& path);
  void endLive();

  /// X_BS as drawn now.
  Isometry3d sensorPose() const { return X_BS_; }

  enum class Preset { overview, front, side, top, tool };
  void usePreset(Preset preset);

  /// Where labels and the note stand, pixels of the viewport; for tests.
  std::vector<QRectF> labelPlaces() const;
  QRectF notePlace() const;

  /// Renders the present state at once and smoothly, for pictures.
  void renderNow();
  /// The present state as a picture to keep: without the buttons that only work on the screen.
  QImage picture();
  double lastFrameMilliseconds() const;

 signals:
  void pictureWanted();
  /// A length was typed where it stands in the picture: its handle's id, and what was typed.
  void dimensionTyped(int id, const QString& text);

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void buildTools();
  void rebuildPath();
  void rebuildSweep();
  /// Lets the stand-in follow a recording of poses, where it can.
  void poseStandIn();
  void updateInstant();
  void updateLabels();
  /// What labels name, as rectangles of the picture on the screen.
  std::vector<QRectF> namedPlaces() const;
  /// The arm's links, likewise.
  std::vector<QRectF> linkPlaces() const;
  void updateNote();
  /// At the top left, or at the bottom where that would cover what is shown.
  void placeNote(const std::vector<QRectF>& subjects);
  /// What report_ tells of centre and inertia; nothing without one.
  void showPayload();
  void clearEstimate();
  void applyParts();
  void placeSensor(const Isometry3d& X_BS);
  void setGravity(const Vector3d& gravity);
  void showWrench(const Isometry3d& X_BS, Vector6d wrench);
  void dress(std::shared_ptr<const RobotLook> look, const SensorMount& mount);
  void paintOver(QPainter& painter) const;
  std::vector<PlacedDimension> placedDimensions() const;

  Viewport* viewport_;
  LabelOverlay* overlay_;
  QWidget* tools_;
  QLabel* note_;
  SceneState& scene_;  ///< What the viewport draws
  std::unique_ptr<SceneParts> parts_;
  std::unique_ptr<SceneTrack> track_;
  std::shared_ptr<const Recording> recording_;
  std::shared_ptr<const RobotModel> robot_;
  std::shared_ptr<const RobotLook> look_;
  std::shared_ptr<const RobotModel> standIn_;  ///< For recordings without a robot
  std::shared_ptr<const RobotLook> standInLook_;
  std::unique_ptr<PosedArm> posed_;  ///< Null unless it stands in
  std::shared_ptr<const EstimateReport> report_;
  std::vector<Vector3d> sweep_;  ///< Where arm and tool get in this recording, B axes [m].
  double time_ = 0.0;
  double pathAbout_ = 0.0;  ///< [s] The instant that the path of a long recording is shown about
  bool labelsShown_ = true;
  Preset preset_ = Preset::overview;
  Isometry3d X_BS_ = Isometry3d::Identity();
  std::vector<ShapeBody> tool_;
  bool editing_ = false;
  struct LookBefore;
  std::unique_ptr<LookBefore> before_;  ///< Camera before editing.
  QPointer<HandleSet> handles_;
  std::vector<DimensionLine> dimensions_;
  DimensionEditor* editor_;
  std::optional<PullMark> pull_;
  std::optional<Nearest> gap_;
  std::vector<CauseMark> causes_;
  struct Kept;
  std::unique_ptr<Kept> kept_;  ///< What was shown before something live; null otherwise.
  std::optional<Vector3d> ghostEnd_;
  QString ghostTitle_, ghostNote_;
  QString stepNote_;
  int noteWay_ = 0;  ///< Even: in one line; from 2: at the bottom.
  QPointer<QWidget> stepTools_;
  bool cameraTouched_ = false;  ///< The user moved it: no automatic fit on resize.
};

/// What to draw of an estimate: region enlarged to a readable size, box only where the inertia is known.
PayloadLook payloadLook(const EstimateReport& report);

}  // namespace heft
