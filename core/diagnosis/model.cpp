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

Kinematics bent(const Signals& signals, const Order& terms) {
  Kinematics out = signals.kinematics;
  for (const Term* t : terms) t->form->cause->geometry(*t->form, t->v, signals, out);
  return out;
}

void throughSensor(const Signals& signals, const Order& terms, Wrenches& w, bool linearOnly) {
  for (const Term* t : terms)
    if (!linearOnly || t->form->cause->linear()) t->form->cause->sensor(*t->form, t->v, signals, w);
}

/// What the sensor carries.
Wrenches loads(const Signals& signals, const Model& model, const Order& terms, const Kinematics& kinematics) {
  Wrenches w = payloadWrench(kinematics, model.x.tail<10>());
  for (const Term* t : terms) t->form->cause->force(*t->form, t->v, signals, kinematics, w);
  return w;
}

/// What it makes of that.
Wrenches readings(const Signals& signals, const Model& model, const Order& terms, Wrenches w) {
  throughSensor(signals, terms, w, false);
  for (const Term* t : terms) t->form->cause->readings(*t->form, t->v, signals, w);
  w.colwise() += Vector6d(model.x.head<6>());
  return w;
}

Wrenches forwards(const Signals& signals, const Model& model, const Order& terms, const Kinematics& kinematics) {
  return readings(signals, model, terms, loads(signals, model, terms, kinematics));
}

Eigen::Map<const VectorXd> flat(const Wrenches& w) { return {w.data(), w.size()}; }

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
  return forwards(signals, model, terms, bent(signals, terms));
}

Linearised linearised(const Signals& signals, const Model& model) {
  const Order terms = inOrder(model.terms);
  const Kinematics kinematics = bent(signals, terms);
  Linearised out;
  const Wrenches load = loads(signals, model, terms, kinematics), value = readings(signals, model, terms, load);
  out.value = averaged(signals, value);
  out.jacobian = MatrixXd::Zero(out.value.size(), model.size());
  for (Eigen::Index n = 0; n < out.value.cols(); ++n) out.jacobian.block<6, 6>(6 * n, 0).setIdentity();
  const bool throughChanges =
      std::any_of(terms.begin(), terms.end(), [](const Term* t) { return t->form->cause->changesSensor(); });
  const bool linear = std::all_of(terms.begin(), terms.end(), [](const Term* t) { return t->form->cause->linear(); });
  if (throughChanges) {
    for (int j = 0; j < 10; ++j) {
      Wrenches w = payloadWrench(kinematics, Vector10d::Unit(j));
      throughSensor(signals, terms, w, true);
      out.jacobian.col(6 + j) = flat(averaged(signals, w));
    }
  } else {
    const Eigen::Index m = signals.samplesPerBlock;
    for (Eigen::Index n = 0; n < out.value.cols(); ++n) {
      Regressor sum = Regressor::Zero();
      for (Eigen::Index k = n * m; k < (n + 1) * m; ++k)
        sum += regressor({kinematics.specificForce.col(k), kinematics.omega.col(k), kinematics.alpha.col(k)});
      out.jacobian.block<6, 10>(6 * n, 6) = sum / static_cast<double>(m);
    }
  }
  Model moved = model;
  Eigen::Index at = kLinear;
  for (std::size_t i = 0; i < moved.terms.size(); ++i) {
    Term& term = moved.terms[i];
    const Form& form = *term.form;
    const Cause& cause = *form.cause;
    const bool bends = cause.bendsGeometry(), adds = linear && !bends && !cause.changesSensor();
    // What a cause adds is all that its parameters change, as long as the sensor passes sums on as sums.
    const auto added = [&] {
      Wrenches w = Wrenches::Zero(6, signals.size());
      cause.force(form, term.v, signals, kinematics, w);
      throughSensor(signals, terms, w, true);
      cause.readings(form, term.v, signals, w);
      return w;
    };
    const auto ownForce = [&](const Term& t) {
      Wrenches w = Wrenches::Zero(6, signals.size());
      cause.force(form, t.v, signals, kinematics, w);
      return w;
    };
    if (form.walk && term.moves(0)) {
      // Each wave once for all channels.
      VectorXd wave = VectorXd::Zero(term.v.size());
      for (Eigen::Index p = 0; p < term.v.size(); p += 6, at += 6) {
        wave.segment<6>(p).setOnes();
        Wrenches w = Wrenches::Zero(6, signals.size());
        cause.readings(form, wave, signals, w);
        wave.segment<6>(p).setZero();
        const Wrenches blocks = averaged(signals, w);
        for (Eigen::Index c = 0; c < 6; ++c)
          for (Eigen::Index n = 0; n < blocks.cols(); ++n) out.jacobian(6 * n + c, at + c) = blocks(c, n);
      }
      continue;
    }
    Wrenches own, unmoved;
    if (adds) own = added();
    if (!adds && !bends && !cause.changesSensor()) unmoved = ownForce(term);
    for (Eigen::Index p = 0; p < term.v.size(); ++p, ++at) {
      if (!term.moves(p)) continue;
      const double step = kStep * form.parameters[static_cast<std::size_t>(p)].size;
      const double old = term.v(p);
      term.v(p) = old + step;
      Wrenches change;
      if (adds) {
        change = added() - own;
      } else {
        const Order movedTerms = inOrder(moved.terms);
        if (bends) {
          change = forwards(signals, moved, movedTerms, bent(signals, movedTerms)) - value;
        } else {
          Wrenches carried = load;
          if (!cause.changesSensor()) carried += ownForce(moved.terms[i]) - unmoved;
          change = readings(signals, moved, movedTerms, std::move(carried)) - value;
        }
      }
      term.v(p) = old;
      out.jacobian.col(at) = flat(averaged(signals, change)) / step;
    }
  }
  return out;
}

MatrixXd signatures(const Signals& signals, const Model& model, const Form& form) {
  const auto shared = std::make_shared<const Form>(form);
  const Order before = inOrder(model.terms);
  const Kinematics kinematics = bent(signals, before);
  MatrixXd out(6 * signals.blocks(), static_cast<Eigen::Index>(form.scan.size()));
  const Cause& cause = *form.cause;
  const bool additive = !cause.bendsGeometry() && !cause.changesSensor();
  Wrenches value;
  if (!additive) value = forwards(signals, model, before, kinematics);
  for (std::size_t i = 0; i < form.scan.size(); ++i) {
    const auto p = static_cast<std::size_t>(form.scan[i]);
    const double step = kStep * form.parameters[p].size;
    VectorXd v = form.start;
    v(static_cast<Eigen::Index>(p)) += step;
    Wrenches w;
    if (additive) {
      // Forces and readings add to whatever is there: only they need to pass the sensor.
      w = Wrenches::Zero(6, signals.size());
      cause.force(form, v, signals, kinematics, w);
      throughSensor(signals, before, w, true);
      cause.readings(form, v, signals, w);
    } else {
      Model with = model;
      with.terms.push_back({shared, v, {}});
      const Order terms = inOrder(with.terms);
      w = forwards(signals, with, terms, cause.bendsGeometry() ? bent(signals, terms) : kinematics) - value;
    }
    out.col(static_cast<Eigen::Index>(i)) = flat(averaged(signals, w)) / step;
  }
  return out;
}

}  // namespace heft::diagnosis
