#pragma once
// Bias, payload and accepted causes together: what the sensor should have read.
#include <cstddef>
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

/// Terms of one model, in the order in which they act.
using Order = std::vector<const Term*>;

Order inOrder(const std::vector<Term>& terms);

/// The motion as the terms from `first` on bend it; `from`: as those before bend it.
Kinematics bent(const Signals& signals, const Order& terms, std::size_t first, Kinematics from);
/// As all bend it.
Kinematics bent(const Signals& signals, const Order& terms);

/// What the sensor makes of its load. `linearOnly`: what it makes of something added to the load.
void throughSensor(const Signals& signals, const Order& terms, Wrenches& w, bool linearOnly);

/// What the sensor carries.
Wrenches loads(const Signals& signals, const Model& model, const Order& terms, const Kinematics& kinematics);

/// The same as the sensor tells it, but for what adds to its readings.
Wrenches sensed(const Signals& signals, const Order& terms, Wrenches load);

/// With that, too.
Wrenches readings(const Signals& signals, const Model& model, const Order& terms, Wrenches sensed);

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

}  // namespace heft::diagnosis
