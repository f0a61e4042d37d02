#pragma once
// What the sensor's frame does where one joint's angle is another than was recorded.
#include <memory>
#include <mutex>
#include <vector>

#include "core/base/memo.h"
#include "core/diagnosis/signals/kinematics.h"
#include "core/math/rigid.h"
#include "core/robot/robot_model.h"

namespace heft::diagnosis {

/// By how much a joint's angle q is another than recorded: constant + sine sin q + cosine cos q [rad].
struct JointTurn {
  int joint = 0;
  double constant = 0.0, sine = 0.0, cosine = 0.0;

  bool operator==(const JointTurn&) const = default;
};

/// The motion of an arm cut in two at each of its joints: what carries the link that a joint turns, and what that link
/// carries, in its own axes, where a further turn of the joint changes nothing. A few products instead of the whole
/// arm's kinematics at each instant. Safe to share between threads.
class JointTurns {
 public:
  /// Of frame S at X_LS on `link`; q, dq, ddq dof x K. `robot` must outlive it.
  JointTurns(const RobotModel& robot, int link, const Isometry3d& X_LS, MatrixXd q, MatrixXd dq, MatrixXd ddq);
  ~JointTurns();

  const MatrixXd& q() const { return q_; }
  const MatrixXd& dq() const { return dq_; }
  const MatrixXd& ddq() const { return ddq_; }

  /// Whether the joint turns, and no other with it: only such can be turned further here.
  bool turnsAlone(int joint) const;

  /// Motion of S in S axes with one joint turned further. `gravity`: g_B. The latest answers are kept: who bends one
  /// joint after the other asks for the same ones again.
  std::shared_ptr<const Kinematics> with(const JointTurn& turn, const Vector3d& gravity) const;

  /// Gives the memory of the answers back: whoever asks again waits again.
  void forget() const { answers_.forget(); }

 private:
  struct Cut;
  struct Asked {
    JointTurn turn;
    Vector3d gravity;

    bool operator==(const Asked&) const = default;
  };
  const Joint& jointAt(int joint) const;
  const Cut& cutAt(int joint) const;
  std::unique_ptr<Cut> made(int joint) const;  ///< Under the lock
  Kinematics worked(const JointTurn& turn, const Vector3d& gravity) const;

  const RobotModel& robot_;
  int link_;
  Isometry3d X_LS_;
  MatrixXd q_, dq_, ddq_;
  mutable std::mutex mutex_;
  mutable std::vector<FrameMotion> sensor_;  ///< Of S in B, for all cuts; like them made when first asked for
  mutable std::vector<std::unique_ptr<Cut>> cuts_;
  mutable Memo<Asked, Kinematics> answers_;
};

}  // namespace heft::diagnosis
