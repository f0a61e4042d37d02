#include "core/diagnosis/model/linearisation.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>

#include "core/base/parallel.h"
#include "core/base/stop.h"
#include "core/diagnosis/calibration.h"
#include "core/wrench/regressor.h"

namespace heft::diagnosis {

namespace {

constexpr double kStep = 1e-2;  ///< Of a parameter's realistic size, for differences

bool bendsOrChanges(const Term& term) {
  return term.form->cause->bendsGeometry() || term.form->cause->changesSensor(*term.form);
}

Wrenches addedToReadings(const Form& form, const VectorXd& v, const Signals& signals) {
  Wrenches out = Wrenches::Zero(6, signals.size());
  form.cause->readings(form, v, signals, out);
  return out;
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

  /// Columns of the payload's parameters.
  void fillPayload(ChannelColumns& columns) const {
    const bool changed = std::ranges::any_of(terms_, [](const Term* t) { return changesSums(*t); });
    // What no sensor changes is averaged first.
    const Eigen::Index together = changed ? 1 : signals_.samplesPerBlock, count = signals_.size() / together;
    std::array<Wrenches, 10> wrenches;
    for (Wrenches& w : wrenches) w.resize(6, count);
    for (Eigen::Index n = 0; n < count; ++n) {
      if (n % 1024 == 0) stopPoint();
      Regressor sum = Regressor::Zero();
      for (Eigen::Index k = n * together; k < (n + 1) * together; ++k)
        sum += regressor({kinematics_.specificForce.col(k), kinematics_.omega.col(k), kinematics_.alpha.col(k)});
      sum /= static_cast<double>(together);
      for (Eigen::Index j = 0; j < 10; ++j) wrenches[static_cast<std::size_t>(j)].col(n) = sum.col(j);
    }
    for (std::size_t j = 0; j < 10; ++j) {
      Wrenches& w = wrenches[j];
      if (changed) throughSensor(signals_, terms_, w, true);
      columns.set(6 + static_cast<Eigen::Index>(j), ChannelColumn(changed ? averaged(signals_, w) : w));
    }
  }

  /// Columns of the term's parameters in `columns` from `at` on, of its shape's only if `shapeOnly`; those that
  /// do not move stay as they are.
  void fill(std::size_t term, ChannelColumns& columns, Eigen::Index at, bool shapeOnly) const {
    const Term& moved = model_.terms[term];
    const Form& form = *moved.form;
    if (form.walk && moved.moves(0)) {
      fillWalk(moved, columns, at);
      return;
    }
    std::vector<Eigen::Index> which;
    std::vector<VectorXd> values;
    std::vector<double> steps;
    for (Eigen::Index p = 0; p < moved.v.size(); ++p) {
      if (!moved.moves(p) || (shapeOnly && isAmplitude(form, p))) continue;
      which.push_back(p);
      steps.push_back(kStep * form.parameters[static_cast<std::size_t>(p)].size);
      values.push_back(moved.v);
      values.back()(p) += steps.back();
    }
    if (which.empty()) return;
    forEachChange(moved, std::move(values), [&](std::size_t i, const Wrenches& change) {
      columns.set(at + which[i], ChannelColumn(averaged(signals_, change), 1.0 / steps[i]));
    });
  }

 private:
  /// take(i, change) with the change in what is read by each of several sets of parameters of one term of the model in
  /// the place of its own; on two threads where each costs much.
  template <class Take>
  void forEachChange(const Term& moved, std::vector<VectorXd> values, const Take& take) const {
    const Form& form = *moved.form;
    const Cause& cause = *form.cause;
    const auto at = std::ranges::find(terms_, &moved);
    if (cause.bendsGeometry()) {
      const auto place = static_cast<std::size_t>(at - terms_.begin());
      parallelFor(values.size(), [&](std::size_t i) {
        Term other = moved;
        other.v = values[i];
        Order terms = terms_;
        terms[place] = &other;
        const Kinematics otherwise = bent(signals_, terms, place, before_[place]);
        take(i, sensed(signals_, terms, loads(signals_, model_, terms, otherwise)) - told_);
      });
      return;
    }
    if (cause.changesSensor(form)) {
      std::vector<Wrenches> out(values.size(), sensed(signals_, Order(terms_.begin(), at), load_));
      cause.sensors(form, values, signals_, out);
      for (std::size_t i = 0; i < out.size(); ++i)
        take(i, sensed(signals_, Order(at + 1, terms_.end()), std::move(out[i])) - told_);
      return;
    }
    if (cause.addsToReadings()) {
      const Wrenches added = addedToReadings(form, moved.v, signals_);
      for (std::size_t i = 0; i < values.size(); ++i) take(i, addedToReadings(form, values[i], signals_) - added);
      return;
    }
    values.push_back(moved.v);
    std::vector<Wrenches> out(values.size());
    for (Wrenches& w : out) w.setZero(6, signals_.size());
    cause.forces(form, values, signals_, kinematics_, out);
    const Wrenches added = std::move(out.back());
    out.pop_back();
    for (std::size_t i = 0; i < out.size(); ++i) {
      Wrenches& w = out[i];
      w -= added;
      // What a cause adds is all that its parameters change, as long as the sensor passes sums on as sums.
      if (linear_)
        throughSensor(signals_, terms_, w, true);
      else if (!w.isZero(0.0))
        w = sensed(signals_, terms_, load_ + w) - told_;
      take(i, w);
    }
  }

  /// Each wave once for all channels.
  void fillWalk(const Term& term, ChannelColumns& columns, Eigen::Index at) const {
    for (Eigen::Index p = 0; p < term.v.size(); p += 6, at += 6) {
      VectorXd one = VectorXd::Zero(term.v.size());
      one.segment<6>(p).setOnes();
      const Wrenches wave = averaged(signals_, addedToReadings(*term.form, one, signals_));
      for (Eigen::Index c = 0; c < 6; ++c)
        columns.set(at + c, ChannelColumn(static_cast<std::size_t>(c), wave.row(c).transpose()));
    }
  }

  const Signals& signals_;
  const Model model_;
  const Order terms_;  ///< Of model_
  Kinematics kinematics_;
  std::vector<Kinematics> before_;  ///< Each of terms_ that bends it
  Wrenches load_, told_;            ///< Empty where no parameter changes them
  bool linear_ = true;
};

/// Whether what bends a motion or changes a sensor does another thing to this payload than to that one, by more than a
/// share of `far`.
bool otherLoad(const Vector10d& payload, const Vector10d& than, double far) {
  const double mass = far * std::max(0.02, std::abs(than(0)));
  const Vector10d off = (payload - than).cwiseAbs();
  return off(0) > mass || off.segment<3>(1).maxCoeff() > kGrip * mass ||
         off.tail<6>().maxCoeff() > kGrip * kGrip * mass;
}

bool beginsWith(const Model& model, const Model& beginning) {
  const auto same = [](const Term& a, const Term& b) { return a.form == b.form && a.active == b.active; };
  return model.terms.size() >= beginning.terms.size() &&
         std::equal(beginning.terms.begin(), beginning.terms.end(), model.terms.begin(), same);
}

}  // namespace

CachedJacobian::CachedJacobian(const Signals& signals, const Model& model) : signals_(&signals) { fill(model); }

CachedJacobian::CachedJacobian(const CachedJacobian& known, const Model& model) : signals_(known.signals_) {
  if (!beginsWith(model, known.own_)) {
    fill(model);
    return;
  }
  whole_ = known.whole_;
  own_ = known.own_;
  for (std::size_t i = whole_.terms.size(); i < model.terms.size(); ++i) {
    const Term& term = model.terms[i];
    whole_.terms.push_back({term.form, term.form->start, term.active, term.walk});
  }
  columns_ = known.columns_;
  columns_.grow(model.size() - columns_.cols());
  follow(model);
}

void CachedJacobian::fill(const Model& model) {
  columns_ = ChannelColumns(signals_->blocks(), model.size());
  for (Eigen::Index c = 0; c < 6; ++c)
    columns_.set(c, ChannelColumn(static_cast<std::size_t>(c), VectorXd::Ones(signals_->blocks())));
  Moving moving(*signals_, model);
  moving.fillPayload(columns_);
  Eigen::Index at = kLinear;
  for (std::size_t i = 0; i < model.terms.size(); ++i) {
    moving.fill(i, columns_, at, false);
    at += model.terms[i].v.size();
  }
  whole_ = own_ = model;
}

void CachedJacobian::follow(const Model& model) {
  constexpr double kFar = 0.3;  // What is off by less takes a fit another step at most
  update(model, kFar);
}

void CachedJacobian::refresh(const Model& model) { update(model, kStep); }

/// `far`: sizes by which an amplitude may have moved; of a shape, differences say nothing of what moves by less than
/// their step.
void CachedJacobian::update(const Model& model, double far) {
  const bool bends = std::ranges::any_of(model.terms, bendsOrChanges),
             linear = std::ranges::all_of(model.terms, [](const Term&t) { return t.form->cause->linear(*t.form); });
  bool everything = bends && otherLoad(model.x.tail<10>(), whole_.x.tail<10>(), far);
  enum class Which { none, shape, all };
  std::vector<Which> again(model.terms.size(), Which::none);
  for (std::size_t i = 0; i < again.size(); ++i) {
    const Term& term = model.terms[i];
    const bool bending = bendsOrChanges(term);
    if (bending) {
      const Shift shift = shiftBetween(whole_.terms[i], term);
      everything = everything || shift.shape > kStep || shift.amplitude > far;
    }
    if (i >= own_.terms.size()) {
      again[i] = Which::all;
      continue;
    }
    const Shift shift = shiftBetween(own_.terms[i], term);
    if (shift.shape > kStep || shift.amplitude > (bending ? far : linear ? 1e300 : kStep))
      again[i] = Which::all;
    else if (!bending && shift.amplitude > kStep && term.form->scan.size() < term.form->parameters.size())
      again[i] = Which::shape;
  }
  if (!everything && std::ranges::count(again, Which::none) == std::ssize(again)) return;
  Moving moving(*signals_, model);
  if (everything) {
    // What adds to the readings does so whatever they are of.
    for (std::size_t i = 0; i < again.size(); ++i)
      if (!model.terms[i].form->cause->addsToReadings()) again[i] = Which::all;
    if (std::ranges::any_of(model.terms,
                            [](const Term& t) { return t.form->cause->bendsGeometry() || changesSums(t); }))
      moving.fillPayload(columns_);
    whole_ = model;
  }
  Eigen::Index at = kLinear;
  own_.terms.resize(std::max(own_.terms.size(), model.terms.size()));
  for (std::size_t i = 0; i < again.size(); ++i) {
    if (again[i] != Which::none) {
      moving.fill(i, columns_, at, again[i] == Which::shape);
      own_.terms[i] = model.terms[i];
    }
    at += model.terms[i].v.size();
  }
}

LinearisationPoint::LinearisationPoint(const Signals& signals, const Model& model)
    : signals_(signals),
      model_(model),
      terms_(inOrder(model.terms)),
      kinematics_(bent(signals, terms_)),
      load_(loads(signals, model, terms_, kinematics_)),
      sensed_(sensed(signals, terms_, load_)) {}

ChannelColumns LinearisationPoint::signatures(const Form& form) const {
  const std::size_t count = form.scan.size();
  std::vector<VectorXd> moved(count, form.start);
  std::vector<double> steps(count);
  for (std::size_t i = 0; i < count; ++i) {
    steps[i] = kStep * form.parameters[static_cast<std::size_t>(form.scan[i])].size;
    moved[i](form.scan[i]) += steps[i];
  }
  const Cause& cause = *form.cause;
  ChannelColumns out(signals_.blocks(), static_cast<Eigen::Index>(count));
  const auto take = [&](std::size_t i, const Wrenches& change) {
    out.set(static_cast<Eigen::Index>(i), ChannelColumn(averaged(signals_, change), 1.0 / steps[i]));
  };
  if (cause.addsToReadings()) {
    for (std::size_t i = 0; i < count; ++i) take(i, addedToReadings(form, moved[i], signals_));
    return out;
  }
  if (cause.bendsGeometry()) {
    Model with = model_;
    with.terms.push_back({std::make_shared<const Form>(form), form.start, {}});
    const Order terms = inOrder(with.terms);
    for (std::size_t i = 0; i < count; ++i) {
      with.terms.back().v = moved[i];
      take(i, sensed(signals_, terms, loads(signals_, with, terms, bent(signals_, terms))) - sensed_);
    }
    return out;
  }
  std::vector<Wrenches> changes(count);
  if (!cause.changesSensor(form)) {
    // Forces add to whatever is there: only they need to pass the sensor.
    for (Wrenches& w : changes) w.setZero(6, signals_.size());
    cause.forces(form, moved, signals_, kinematics_, changes);
    for (Wrenches& w : changes) throughSensor(signals_, terms_, w, true);
  } else {
    const auto later =
        std::ranges::find_if(terms_, [&](const Term* t) { return t->form->cause->order() > cause.order(); });
    changes.assign(count, sensed(signals_, Order(terms_.begin(), later), load_));
    cause.sensors(form, moved, signals_, changes);
    for (Wrenches& w : changes) w = sensed(signals_, Order(later, terms_.end()), std::move(w)) - sensed_;
  }
  for (std::size_t i = 0; i < count; ++i) take(i, changes[i]);
  return out;
}

Matrix6d LinearisationPoint::sensorMatrix() const {
  Wrenches units = Matrix6d::Identity();
  throughSensor(signals_, terms_, units, true);
  return units;
}

}  // namespace heft::diagnosis
