#pragma once
// What a live run knows: samples go in, estimate, poses, curves and marks come out. Free of Qt; belongs into a job.
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/coach/arm_surroundings.h"
#include "core/coach/coach.h"
#include "core/coach/pose_guide.h"
#include "core/live/plain_samples.h"
#include "core/live/source.h"
#include "core/online/convention_watch.h"
#include "core/online/online_estimator.h"
#include "ui/wrench_plots/live_history.h"

namespace heft {

/// Half widths of the 95 % intervals at one time, in one number each.
struct KnownSoFar {
  double time = 0.0;                            ///< [s]
  double mass = 0.0, com = 0.0, inertia = 0.0;  ///< [kg], [m] of the worst coordinate, relative of the worst moment
};

/// A snapshot for the window; cheap to copy.
struct LiveView {
  bool any = false;   ///< A complete sample came.
  double time = 0.0;  ///< [s] of the newest one, since the first
  double rateHz = 0.0;
  std::optional<VectorXd> q;  ///< [rad] now, where there are joints
  Isometry3d X_BS = Isometry3d::Identity();
  Vector6d wrench = Vector6d::Zero();  ///< F_PSo_S, biased, averaged over the newest 20 ms
  OnlineState state;
  std::vector<KnownSoFar> known;  ///< At most 400 points over the whole time
  std::vector<Vector3d> path;     ///< Of S's origin, B axes [m], at most 1500 points
  std::vector<Segment> touched;   ///< Contact
  std::shared_ptr<const WrenchTraces> traces;
  std::shared_ptr<const OnlineInformation> information;  ///< Null until there is an estimate.
  std::vector<JudgedPose> poses;                         ///< With standing poses
  PoseResult poseResult;
  std::optional<NextPose> next;
  int posesWanted = 0;
  std::optional<conventions::Report> conventions;  ///< Where the samples do not mean what the meta says
  std::string problem;                             ///< Why samples cannot be used; empty while they can.
};

struct LearnerSetup {
  RecordingMeta meta;
  std::shared_ptr<const RobotModel> robot;  ///< Null where samples carry poses.
  std::optional<Shape> shape;
  bool poses = false;                            ///< Standing poses instead of a motion.
  std::shared_ptr<ArmSurroundings> around = {};  ///< What proposed poses keep clear of; null: nothing
};

/// The poses that are used, one row each.
Recording recordingOf(const std::vector<JudgedPose>& poses, const RecordingMeta& meta);

class LiveLearner {
 public:
  /// Fails like OnlineEstimator::create.
  static Result<std::shared_ptr<LiveLearner>> create(const LearnerSetup& setup);

  /// A sample as its source gives it, in the conventions of the setup's meta.
  void add(const LiveSample& sample);
  LiveView view();
  void removePose(std::size_t index);

 private:
  LiveLearner(const LearnerSetup& setup, PlainSamples plain, OnlineEstimator estimator,
              const std::optional<GuidedTool>& tool);
  void note(const OnlineSample& sample);
  void simulate();
  Isometry3d poseOf(const OnlineSample& sample) const;
  std::optional<NextPose> nextFrom(const VectorXd& q) const;

  LearnerSetup setup_;
  PlainSamples plain_;
  std::string problem_;
  OnlineEstimator estimator_;
  ConventionWatch watch_;
  std::optional<GuidedTool> tool_;
  PoseGuide guide_;
  std::optional<NextPose> next_;
  std::optional<double> start_;
  double lastKnown_ = -1.0, lastPath_ = -1.0, simulatedUpTo_ = 0.0, triedAt_ = 0.0;
  double knownStep_ = 0.25, pathStep_ = 0.05;
  bool touching_ = false;
  std::deque<OnlineSample> newest_;  ///< Two and a half seconds, for the simulated wrench
  LiveHistory history_;
  std::vector<KnownSoFar> known_;
  std::vector<Vector3d> path_;
  std::vector<Segment> touched_;
};

}  // namespace heft
