#pragma once
// The 3D half of the window: arm, tool and path at one instant of the recording, with labels and view tools.
#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "core/estimation/estimate.h"
#include "core/payload/shape.h"
#include "core/recording/recording.h"
#include "core/robot/robot_model.h"
#include "ui/robot_look/robot_look.h"
#include "ui/robot_view/handle_layer.h"
#include "ui/robot_view/orbit_camera.h"
#include "ui/robot_view/step_note.h"
#include "ui/robot_view/view_marks.h"

class QPainter;

namespace heft {

class LabelOverlay;
class ShownMotion;
class ViewTools;
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

  /// What the shown step lets one grab.
  HandleLayer& handles() { return *handles_; }
  /// What the shown step says and offers here.
  StepNote& note() { return *note_; }
  /// What steps put into the picture and take out again.
  ViewMarks& marks() { return *marks_; }
  const ViewMarks& marks() const { return *marks_; }
  /// Titles of the labels shown, and where they stand, pixels of the viewport; for tests.
  QStringList labelTexts() const;
  std::vector<QRectF> labelPlaces() const;

  /// Shows a moving arm instead of a recording, which comes back with endLive(). Robot and look are null where only the
  /// sensor's pose is known.
  void beginLive(std::shared_ptr<const RobotModel> robot, std::shared_ptr<const RobotLook> look,
                 const SensorMount& mount, const Vector3d& gravity);
  void showLive(const LiveMoment& moment);
  /// The way of the sensor so far, B axes [m].
  void showLivePath(const std::vector<Vector3d>& path);
  void endLive();

  /// X_BS as drawn now.
  Isometry3d sensorPose() const;

  using Preset = ViewPreset;
  void usePreset(Preset preset);

  /// Renders the present state at once and smoothly, for pictures.
  void renderNow();
  /// The present state as a picture to keep: without the buttons that only work on the screen.
  QImage picture();
  double lastFrameMilliseconds() const;

 signals:
  void pictureWanted();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void rebuildPath();
  /// Lets the stand-in follow a recording of poses, where it can.
  void poseStandIn();
  void updateInstant();
  void updateLabels();
  /// What labels name, as rectangles of the picture on the screen.
  std::vector<QRectF> namedPlaces() const;
  /// The arm's links as such rectangles.
  std::vector<QRectF> linkPlaces() const;
  void updateNote();
  /// The centre of mass and inertia of report_, if any.
  void showPayload();
  void clearEstimate();
  void applyParts();
  void placeSensor(const Isometry3d& X_BS);
  void setGravity(const Vector3d& gravity);
  void showWrench(const Isometry3d& X_BS, Vector6d wrench);
  void dress(std::shared_ptr<const RobotLook> look, const SensorMount& mount);
  void paintOver(QPainter& painter) const;

  Viewport* viewport_;
  LabelOverlay* overlay_;
  ViewTools* tools_;
  SceneState& scene_;  ///< What the viewport draws
  std::unique_ptr<SceneParts> parts_;
  HandleLayer* handles_;
  std::unique_ptr<ViewMarks> marks_;
  std::unique_ptr<StepNote> note_;
  std::unique_ptr<ShownMotion> motion_;  ///< Null without a recording.
  std::shared_ptr<const RobotModel> robot_;
  std::shared_ptr<const RobotLook> look_;
  std::shared_ptr<const RobotModel> standIn_;  ///< For recordings without a robot
  std::shared_ptr<const RobotLook> standInLook_;
  std::shared_ptr<const EstimateReport> report_;
  std::vector<Vector3d> sweep_;  ///< Where arm and tool get in this recording, B axes [m].
  double time_ = 0.0;
  double pathAbout_ = 0.0;  ///< [s] The instant that the path of a long recording is shown about
  bool labelsShown_ = true;
  Preset preset_ = Preset::overview;
  std::vector<ShapeBody> tool_;
  bool editing_ = false;
  struct LookBefore;
  std::unique_ptr<LookBefore> before_;  ///< Camera before editing.
  struct Kept;
  std::unique_ptr<Kept> kept_;  ///< What was shown before something live; null otherwise.
  bool cameraTouched_ = false;  ///< The user moved it: no automatic fit on resize.
};

/// What to draw of an estimate: region enlarged to a readable size, box only where the inertia is known.
PayloadLook payloadLook(const EstimateReport& report);

}  // namespace heft
