#include "core/diagnosis/model/forward_model.h"

#include <algorithm>

#include "core/base/stop.h"

namespace heft::diagnosis {

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

std::vector<IndexedTerm> indexedTerms(const Model& model) {
  std::vector<IndexedTerm> out;
  Eigen::Index at = model.x.size();
  for (const Term& term : model.terms) {
    out.push_back({&term, at});
    at += term.v.size();
  }
  return out;
}

Wrenches payloadWrench(const Kinematics& kin, const Vector10d& phi) {
  const double m = phi(0);
  const Vector3d h = phi.segment<3>(1);
  const Matrix3d I = inertiaTensor(phi);
  const Eigen::Index n = kin.omega.cols();
  Wrenches w(6, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Vector3d s = kin.specificForce.col(k), o = kin.omega.col(k), a = kin.alpha.col(k), turning = I * o;
    w.col(k).head<3>() = m * s + a.cross(h) + o.dot(h) * o - o.squaredNorm() * h;
    w.col(k).tail<3>() = I * a + o.cross(turning) + h.cross(s);
  }
  return w;
}

Order inOrder(const std::vector<Term>& terms) {
  Order out;
  for (const auto& term : terms) out.push_back(&term);
  std::stable_sort(out.begin(), out.end(),
                   [](const Term* a, const Term* b) { return a->form->cause->order() < b->form->cause->order(); });
  return out;
}

Kinematics bent(const Signals& signals, const Order& terms, std::size_t first, Kinematics from) {
  for (std::size_t i = first; i < terms.size(); ++i) {
    stopPoint();
    terms[i]->form->cause->geometry(*terms[i]->form, terms[i]->v, signals, from);
  }
  return from;
}

Kinematics bent(const Signals& signals, const Order& terms) { return bent(signals, terms, 0, signals.kinematics); }

void throughSensor(const Signals& signals, const Order& terms, Wrenches& w, bool linearOnly) {
  for (const Term* t : terms)
    if (!linearOnly || t->form->cause->linear(*t->form)) t->form->cause->sensor(*t->form, t->v, signals, w);
}

Wrenches loads(const Signals& signals, const Model& model, const Order& terms, const Kinematics& kinematics) {
  Wrenches w = payloadWrench(kinematics, model.x.tail<10>());
  for (const Term* t : terms) {
    stopPoint();
    t->form->cause->force(*t->form, t->v, signals, kinematics, w);
  }
  return w;
}

Wrenches sensed(const Signals& signals, const Order& terms, Wrenches load) {
  throughSensor(signals, terms, load, false);
  return load;
}

Wrenches readings(const Signals& signals, const Model& model, const Order& terms, Wrenches sensed) {
  stopPoint();
  for (const Term* t : terms) t->form->cause->readings(*t->form, t->v, signals, sensed);
  sensed.colwise() += Vector6d(model.x.head<6>());
  return sensed;
}

Wrenches predicted(const Signals& signals, const Model& model) {
  const Order terms = inOrder(model.terms);
  return readings(signals, model, terms, sensed(signals, terms, loads(signals, model, terms, bent(signals, terms))));
}

bool isAmplitude(const Form& form, Eigen::Index p) {
  return std::ranges::find(form.scan, static_cast<int>(p)) != form.scan.end();
}

Wrenches valueOf(const Signals& signals, const Model& model) { return averaged(signals, predicted(signals, model)); }

Shift shiftBetween(const Term& from, const Term& to) {
  Shift out;
  for (Eigen::Index p = 0; p < to.v.size(); ++p) {
    const double off = std::abs(to.v(p) - from.v(p)) / to.form->parameters[static_cast<std::size_t>(p)].size;
    double& most = isAmplitude(*to.form, p) ? out.amplitude : out.shape;
    most = std::max(most, off);
  }
  return out;
}

bool changesSums(const Term& term) {
  return term.form->cause->changesSensor(*term.form) && term.form->cause->linear(*term.form);
}

}  // namespace heft::diagnosis
