#include "core/diagnosis/model.h"

#include <algorithm>

#include "core/wrench/regressor.h"

namespace heft::diagnosis {

namespace {

constexpr double kStep = 1e-2;  ///< Of a parameter's realistic size, for differences

using Order = std::vector<const Term*>;

Order inOrder(const std::vector<Term>& terms) {
  Order out;
  for (const auto& term : terms) out.push_back(&term);
  std::stable_sort(out.begin(), out.end(),
                   [](const Term* a, const Term* b) { return a->form->cause->order() < b->form->cause->order(); });
  return out;
}

/// `from`: as the terms before `first` bend it.
Kinematics bent(const Signals& signals, const Order& terms, std::size_t first, Kinematics from) {
  for (std::size_t i = first; i < terms.size(); ++i)
    terms[i]->form->cause->geometry(*terms[i]->form, terms[i]->v, signals, from);
  return from;
}

Kinematics bent(const Signals& signals, const Order& terms) { return bent(signals, terms, 0, signals.kinematics); }

/// What the sensor makes of its load. `linearOnly`: what it makes of something added to the load.
void throughSensor(const Signals& signals, const Order& terms, Wrenches& w, bool linearOnly) {
  for (const Term* t : terms)
    if (!linearOnly || t->form->cause->linear(*t->form)) t->form->cause->sensor(*t->form, t->v, signals, w);
}

/// What the sensor carries.
Wrenches loads(const Signals& signals, const Model& model, const Order& terms, const Kinematics& kinematics) {
  Wrenches w = payloadWrench(kinematics, model.x.tail<10>());
  for (const Term* t : terms) t->form->cause->force(*t->form, t->v, signals, kinematics, w);
  return w;
}

/// The same as the sensor tells it, but for what adds to its readings.
Wrenches sensed(const Signals& signals, const Order& terms, Wrenches load) {
  throughSensor(signals, terms, load, false);
  return load;
}

/// With that, too.
Wrenches readings(const Signals& signals, const Model& model, const Order& terms, Wrenches sensed) {
  for (const Term* t : terms) t->form->cause->readings(*t->form, t->v, signals, sensed);
  sensed.colwise() += Vector6d(model.x.head<6>());
  return sensed;
}

}  // namespace

Eigen::Index Model::size() const {
  Eigen::Index n = x.size();
  for (const auto& term : terms) n += term.v.size();
  return n;
}

VectorXd Model::packed() const {
  VectorXd all(size());
  all.head(x.size()) = x;
  Eigen::Index at = x.size();
  for (const auto& term : terms) {
    all.segment(at, term.v.size()) = term.v;
    at += term.v.size();
  }
  return all;
}

void Model::unpack(const VectorXd& all) {
  x = all.head(x.size());
  Eigen::Index at = x.size();
  for (auto& term : terms) {
    term.v = all.segment(at, term.v.size());
    at += term.v.size();
  }
}

Wrenches payloadWrench(const Kinematics& kin, const Vector10d& phi) {
  const double m = phi(0);
  const Vector3d h = phi.segment<3>(1);
  const Matrix3d I = inertiaTensor(phi);
  const Eigen::Index n = kin.omega.cols();
  Wrenches w(6, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Vector3d s = kin.specificForce.col(k), o = kin.omega.col(k), a = kin.alpha.col(k);
    w.col(k).head<3>() = m * s + a.cross(h) + o.cross(o.cross(h));
    w.col(k).tail<3>() = I * a + o.cross(I * o) + h.cross(s);
  }
  return w;
}

Wrenches predicted(const Signals& signals, const Model& model) {
  const Order terms = inOrder(model.terms);
  return readings(signals, model, terms, sensed(signals, terms, loads(signals, model, terms, bent(signals, terms))));
}

Wrenches valueOf(const Signals& signals, const Model& model) { return averaged(signals, predicted(signals, model)); }

namespace {

bool bendsOrChanges(const Term& term) {
  return term.form->cause->bendsGeometry() || term.form->cause->changesSensor(*term.form);
}

/// What changes with each parameter of one term, where everything else stays as it is.
class Moving {
 public:
  Moving(const Signals& signals, const Model& model)
      : signals_(signals), model_(model), terms_(inOrder(model_.terms)), kinematics_(signals.kinematics) {
    for (const Term* t : terms_) {
      before_.push_back(t->form->cause->bendsGeometry() ? kinematics_ : Kinematics{});
      t->form->cause->geometry(*t->form, t->v, signals, kinematics_);
    }
    linear_ = std::ranges::all_of(model.terms, [](const Term& t) { return t.form->cause->linear(*t.form); });
    // What only adds to what the others make leaves them as they are.
    if (std::ranges::none_of(model.terms, bendsOrChanges)) return;
    load_ = loads(signals, model, terms_, kinematics_);
    told_ = sensed(signals, terms_, load_);
  }
  Moving(const Moving&) = delete;
  Moving& operator=(const Moving&) = delete;

  /// The readings, averaged.
  Wrenches value() const {
    const Wrenches told =
        told_.size() > 0 ? told_ : sensed(signals_, terms_, loads(signals_, model_, terms_, kinematics_));
    return averaged(signals_, readings(signals_, model_, terms_, told));
  }

  /// Columns of the payload's parameters.
  void fillPayload(MatrixXd& jacobian) const {
    const bool throughChanges = std::ranges::any_of(terms_, [](const Term* t) {
      const Cause& cause = *t->form->cause;
      return cause.changesSensor(*t->form) && cause.linear(*t->form);
    });
    if (throughChanges) {
      for (int j = 0; j < 10; ++j) {
        Wrenches w = payloadWrench(kinematics_, Vector10d::Unit(j));
        throughSensor(signals_, terms_, w, true);
        jacobian.col(6 + j) = flat(averaged(signals_, w));
      }
      return;
    }
    const Eigen::Index m = signals_.samplesPerBlock;
    for (Eigen::Index n = 0; n < signals_.blocks(); ++n) {
      Regressor sum = Regressor::Zero();
      for (Eigen::Index k = n * m; k < (n + 1) * m; ++k)
        sum += regressor({kinematics_.specificForce.col(k), kinematics_.omega.col(k), kinematics_.alpha.col(k)});
      jacobian.block<6, 10>(6 * n, 6) = sum / static_cast<double>(m);
    }
  }

  /// Columns of the term's parameters in `jacobian` from column `at` on; those that do not move stay as they are.
  void fill(std::size_t term, MatrixXd& jacobian, Eigen::Index at) {
    Term& moved = model_.terms[term];
    const Form& form = *moved.form;
    if (form.walk && moved.moves(0)) {
      fillWalk(moved, jacobian, at);
      return;
    }
    const Wrenches force = forceOf(moved), reading = readingOf(moved);
    for (Eigen::Index p = 0; p < moved.v.size(); ++p, ++at) {
      if (!moved.moves(p)) continue;
      const double step = kStep * form.parameters[static_cast<std::size_t>(p)].size;
      const double old = moved.v(p);
      moved.v(p) = old + step;
      jacobian.col(at) = flat(averaged(signals_, change(moved, force, reading))) / step;
      moved.v(p) = old;
    }
  }

 private:
  Wrenches forceOf(const Term& term) const {
    Wrenches w = Wrenches::Zero(6, signals_.size());
    term.form->cause->force(*term.form, term.v, signals_, kinematics_, w);
    return w;
  }
  Wrenches readingOf(const Term& term) const {
    Wrenches w = Wrenches::Zero(6, signals_.size());
    term.form->cause->readings(*term.form, term.v, signals_, w);
    return w;
  }

  /// `force`, `reading`: the term's before it moved.
  Wrenches change(const Term& moved, const Wrenches& force, const Wrenches& reading) const {
    const Cause& cause = *moved.form->cause;
    if (cause.bendsGeometry()) {
      const auto at = static_cast<std::size_t>(std::ranges::find(terms_, &moved) - terms_.begin());
      return sensed(signals_, terms_, loads(signals_, model_, terms_, bent(signals_, terms_, at, before_[at]))) - told_;
    }
    if (cause.changesSensor(*moved.form)) return sensed(signals_, terms_, load_) - told_;
    Wrenches out = forceOf(moved) - force;
    // What a cause adds is all that its parameters change, as long as the sensor passes sums on as sums.
    if (linear_)
      throughSensor(signals_, terms_, out, true);
    else if (!out.isZero(0.0))
      out = sensed(signals_, terms_, load_ + out) - told_;
    return out + readingOf(moved) - reading;
  }

  /// Each wave once for all channels.
  void fillWalk(const Term& term, MatrixXd& jacobian, Eigen::Index at) const {
    Term one{term.form, VectorXd::Zero(term.v.size()), {}};
    for (Eigen::Index p = 0; p < term.v.size(); p += 6, at += 6) {
      one.v.segment<6>(p).setOnes();
      const Wrenches wave = averaged(signals_, readingOf(one));
      one.v.segment<6>(p).setZero();
      for (Eigen::Index c = 0; c < 6; ++c)
        for (Eigen::Index n = 0; n < wave.cols(); ++n) jacobian(6 * n + c, at + c) = wave(c, n);
    }
  }

  const Signals& signals_;
  Model model_;
  Order terms_;  ///< Of model_
  Kinematics kinematics_;
  std::vector<Kinematics> before_;  ///< Each of terms_ that bends it
  Wrenches load_, told_;            ///< Empty where no parameter changes them
  bool linear_ = true;
};

/// Whether what bends a motion or changes a sensor does clearly another thing to this payload than to that one.
bool otherLoad(const Vector10d& payload, const Vector10d& than) {
  constexpr double kReach = 0.1;  // [m]
  const double mass = kStep * std::max(0.02, std::abs(than(0)));
  const Vector10d off = (payload - than).cwiseAbs();
  return off(0) > mass || off.segment<3>(1).maxCoeff() > kReach * mass ||
         off.tail<6>().maxCoeff() > kReach * kReach * mass;
}

/// Whether the columns of the term's parameters are the same wherever these are, as long as nothing bends or changes
/// what it adds.
bool addsLinearly(const Term& term) {
  return term.form->scan.size() == term.form->parameters.size() && !bendsOrChanges(term);
}

}  // namespace

Linearised linearised(const Signals& signals, const Model& model) {
  Moving moving(signals, model);
  Linearised out{moving.value(), {}};
  out.jacobian = MatrixXd::Zero(out.value.size(), model.size());
  for (Eigen::Index n = 0; n < out.value.cols(); ++n) out.jacobian.block<6, 6>(6 * n, 0).setIdentity();
  moving.fillPayload(out.jacobian);
  Eigen::Index at = kLinear;
  for (std::size_t i = 0; i < model.terms.size(); ++i) {
    moving.fill(i, out.jacobian, at);
    at += model.terms[i].v.size();
  }
  return out;
}

Linearised linearisedAgain(const Signals& signals, const Model& model, Wrenches value, MatrixXd jacobian,
                           Model& around) {
  const bool bends = std::ranges::any_of(model.terms, bendsOrChanges);
  // Differences say nothing of what moves by less than their step.
  const auto moved = [&](std::size_t i) {
    const Term& term = model.terms[i];
    for (Eigen::Index p = 0; p < term.v.size(); ++p) {
      const double step = kStep * term.form->parameters[static_cast<std::size_t>(p)].size;
      if (std::abs(term.v(p) - around.terms[i].v(p)) > step) return true;
    }
    return false;
  };
  bool everything = bends && otherLoad(model.x.tail<10>(), around.x.tail<10>());
  std::vector<bool> again(model.terms.size());
  for (std::size_t i = 0; i < again.size(); ++i) {
    again[i] = moved(i) && (bends || !addsLinearly(model.terms[i]));
    everything = everything || (again[i] && bendsOrChanges(model.terms[i]));
  }
  if (!everything && std::ranges::find(again, true) == again.end()) return {std::move(value), std::move(jacobian)};
  Moving moving(signals, model);
  if (everything) {
    again.assign(again.size(), true);
    moving.fillPayload(jacobian);
    around.x = model.x;
  }
  Eigen::Index at = kLinear;
  for (std::size_t i = 0; i < again.size(); ++i) {
    if (again[i]) {
      moving.fill(i, jacobian, at);
      around.terms[i].v = model.terms[i].v;
    }
    at += model.terms[i].v.size();
  }
  return {std::move(value), std::move(jacobian)};
}

Surroundings::Surroundings(const Signals& signals, const Model& model)
    : signals_(signals),
      model_(model),
      terms_(inOrder(model.terms)),
      kinematics_(bent(signals, terms_)),
      load_(loads(signals, model, terms_, kinematics_)),
      sensed_(sensed(signals, terms_, load_)) {}

MatrixXd Surroundings::signatures(const Form& form) const {
  const auto shared = std::make_shared<const Form>(form);
  MatrixXd out(6 * signals_.blocks(), static_cast<Eigen::Index>(form.scan.size()));
  const Cause& cause = *form.cause;
  const bool additive = !cause.bendsGeometry() && !cause.changesSensor(form);
  for (std::size_t i = 0; i < form.scan.size(); ++i) {
    const auto p = static_cast<std::size_t>(form.scan[i]);
    const double step = kStep * form.parameters[p].size;
    VectorXd v = form.start;
    v(static_cast<Eigen::Index>(p)) += step;
    Wrenches w;
    if (additive) {
      // Forces and readings add to whatever is there: only they need to pass the sensor.
      w = Wrenches::Zero(6, signals_.size());
      cause.force(form, v, signals_, kinematics_, w);
      throughSensor(signals_, terms_, w, true);
      cause.readings(form, v, signals_, w);
    } else {
      Model with = model_;
      with.terms.push_back({shared, v, {}});
      const Order terms = inOrder(with.terms);
      w = sensed(signals_, terms, cause.bendsGeometry() ? loads(signals_, with, terms, bent(signals_, terms)) : load_) -
          sensed_;
    }
    out.col(static_cast<Eigen::Index>(i)) = flat(averaged(signals_, w)) / step;
  }
  return out;
}

Matrix6d Surroundings::sensorMatrix() const {
  Wrenches units = Matrix6d::Identity();
  throughSensor(signals_, terms_, units, true);
  return units;
}

}  // namespace heft::diagnosis
