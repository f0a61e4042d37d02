#pragma once
// Mass, centre and zero of standing poses, and what may be wrong beside them, by maximum likelihood.
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/diagnosis/calibration.h"
#include "core/diagnosis/search/search.h"

namespace heft::diagnosis {

/// What goes by the order of the poses.
enum class Course {
  drift,  ///< The zero moves on by as much from each pose to the next: 6 numbers.
  jump,   ///< The zero is another from some pose on: 6 numbers.
  load    ///< The load is: mass and first moments.
};

struct InOrder {
  Course course = Course::drift;
  Eigen::Index from = 0;  ///< First pose after the change
  VectorXd v;
};

/// One thing that may be wrong: a form of the catalogue, or what goes by the order.
struct Suspect {
  std::string cause;
  std::shared_ptr<const Form> form;  ///< Null: in order
  InOrder inOrder;
  double price = 0.0;  ///< For how many of its kind were looked at

  Eigen::Index size() const {
    return form ? static_cast<Eigen::Index>(form->parameters.size()) : inOrder.course == Course::load ? 4 : 6;
  }
};

/// The poses as the catalogue's causes see them: one instant each.
struct PosesSeen {
  Signals signals;
  Eigen::Index count() const { return signals.size(); }
};

/// Everything that is fitted.
struct PoseState {
  Model model;  ///< Of its x: zero, mass, first moments
  std::vector<std::pair<Suspect, VectorXd>> terms;

  Eigen::Index size() const {
    Eigen::Index out = 10;
    for (const auto& [candidate, v] : terms) out += v.size();
    return out;
  }
  VectorXd packed() const {
    VectorXd out(size());
    out.head<10>() = model.x.head<10>();
    Eigen::Index at = 10;
    for (const auto& [candidate, v] : terms) {
      out.segment(at, v.size()) = v;
      at += v.size();
    }
    return out;
  }
  void unpack(const VectorXd& all) {
    model.x.head<10>() = all.head<10>();
    Eigen::Index at = 10;
    for (auto& [candidate, v] : terms) {
      v = all.segment(at, v.size());
      at += v.size();
    }
  }
  void add(const Suspect& candidate) {
    terms.emplace_back(candidate, candidate.form ? candidate.form->start : VectorXd(VectorXd::Zero(candidate.size())));
  }
  /// The catalogue's part of it.
  Model modelled() const {
    Model out = model;
    for (const auto& [candidate, v] : terms)
      if (candidate.form) out.terms.push_back({candidate.form, v, {}});
    return out;
  }
};

/// What the model expects, 6 x K.
Wrenches expectedOf(const PosesSeen& poses, const PoseState& state);
/// 6 K x size(), by differences.
MatrixXd jacobianOf(const PosesSeen& poses, const PoseState& state);

struct PoseFit {
  PoseState state;
  VectorXd weights;  ///< One a pose
  Wrenches residual;
  MatrixXd jacobian;
  double force = 0.0, torque = 0.0;  ///< Scale of what is left, a component [N], [N m]
  double evidence = 0.0;             ///< 2 ln L less ln n for each parameter of a cause
  MatrixXd covariance;
  VectorXd untold;  ///< Share of each parameter that the poses do not tell apart from others
};

constexpr double kUntold = kHardlyAny;  ///< More of PoseFit::untold is not told

/// Of each row, the root of its weight over its scale.
VectorXd scalesOf(const PoseFit& fit);
/// Solves by least squares; what the poses do not tell stays where it is.
VectorXd solved(const MatrixXd& J, const VectorXd& r);
/// The maximum likelihood from `state` on. `used`: a weight of 1 or 0 a pose for plain least squares; empty: robust.
PoseFit fitted(const PosesSeen& poses, PoseState state, const VectorXd& used = {});

}  // namespace heft::diagnosis
