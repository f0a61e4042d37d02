#pragma once
// Bias, payload and accepted causes together: what the sensor should have read, and how that changes with each
// parameter.
#include <memory>
#include <vector>

#include "core/diagnosis/model/cause.h"

namespace heft::diagnosis {

constexpr int kLinear = 16;  ///< x = [bias force, bias torque, phi]

struct Term {
  std::shared_ptr<const Form> form;
  VectorXd v;                        ///< SI
  std::vector<bool> active;          ///< One a parameter: false keeps it where it is. Empty: all move.
  Vector6d walk = Vector6d::Zero();  ///< Of a walk's waves: variance of each channel's longest, learned with the fit,
                                     ///< one for each kind

  bool moves(Eigen::Index p) const { return active.empty() || active[static_cast<std::size_t>(p)]; }
};

struct Model {
  VectorXd x = VectorXd::Zero(kLinear);
  std::vector<Term> terms;

  /// Everything in one vector: x, then the terms' parameters.
  Eigen::Index size() const;
  VectorXd packed() const;
  void unpack(const VectorXd& all);
};

/// A term and where its parameters begin in Model::packed().
struct IndexedTerm {
  const Term* term;
  Eigen::Index at;
};

/// All terms of the model, which must outlive the answer.
std::vector<IndexedTerm> indexedTerms(const Model& model);

/// Wrench of the ten parameters under `kinematics`, 6 x K.
Wrenches payloadWrench(const Kinematics& kinematics, const Vector10d& phi);

/// What the sensor should have read at the full rate, 6 x K.
Wrenches predicted(const Signals& signals, const Model& model);

/// predicted(), averaged into blocks: 6 x N.
Wrenches valueOf(const Signals& signals, const Model& model);

/// Whether the form is linear in the parameter, or nearly so; others are about the shape of what it does.
bool isAmplitude(const Form& form, Eigen::Index p);

/// By how many realistic sizes two terms of one form differ, in the parameters that do most.
struct Shift {
  double amplitude = 0.0, shape = 0.0;
};

Shift shiftBetween(const Term& from, const Term& to);

/// Whether the term changes what the sensor makes of a force, and of a sum what it makes of its parts: columns of the
/// other terms go through it. The end of a range and a memory are linearised without.
bool changesSums(const Term& term);

/// How valueOf() changes with each parameter: 6N x size(), row 6 n + channel. They follow the model from step to step
/// of a fit: columns that do not depend on what moved, or hardly, are kept. The signals must outlive them.
class CachedJacobian {
 public:
  CachedJacobian(const Signals& signals, const Model& model);
  /// Of a model that may begin with the terms of the one that others are known for.
  CachedJacobian(const CachedJacobian& known, const Model& model);

  /// Good for the next step from `model`, which has the same terms.
  void follow(const Model& model);
  /// As good as new: nothing that differences tell has moved since.
  void refresh(const Model& model);

  const MatrixXd& jacobian() const { return jacobian_; }

 private:
  void fill(const Model& model);
  void update(const Model& model, double far);

  const Signals* signals_;
  MatrixXd jacobian_;
  Model whole_, own_;  ///< Where all columns were worked out together, and each term's own ones
};

/// A model that a form may be added to; neither it nor the signals may go before this.
class LinearisationPoint {
 public:
  LinearisationPoint(const Signals& signals, const Model& model);
  /// How the reading changes with each parameter in form.scan at form.start: 6N x scan.size().
  MatrixXd signatures(const Form& form) const;
  /// Whether a term has S stand otherwise than recorded.
  bool turnsAxes() const { return kinematics_.turned != nullptr; }
  /// What the sensor makes of forces, where that is one matrix for all instants.
  Matrix6d sensorMatrix() const;

 private:
  const Signals& signals_;
  const Model& model_;
  std::vector<const Term*> terms_;  ///< In their order
  Kinematics kinematics_;           ///< As the terms bend it
  Wrenches load_;                   ///< What the sensor carries
  Wrenches sensed_;                 ///< Without what adds to the readings
};

}  // namespace heft::diagnosis
