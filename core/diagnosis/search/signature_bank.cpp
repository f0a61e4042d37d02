#include "core/diagnosis/search/signature_bank.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/parallel.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/catalogue.h"

namespace heft::diagnosis {

namespace {

Signature signatureOf(Form form, const LinearisationPoint& surroundings) {
  Signature out{std::move(form), {}, {}};
  const ChannelColumns all = surroundings.signatures(out.form);
  out.fill(all, 0, all.blocks());
  return out;
}

/// Fills the signature around nothing but a payload; `whole` is of the same signals. What only passes is worked out
/// where it does, since a long recording has thousands of forms that do.
void fillPlain(Signature& signature, const Signals& signals, const LinearisationPoint& whole) {
  const Form& form = signature.form;
  const Eigen::Index blocks = signals.blocks();
  if (!form.local || form.atOnce) {
    signature.fill(whole.signatures(form), 0, blocks);
    return;
  }
  const auto [from, to] = form.cause->when(form, form.start, signals).at(0);
  const auto blockAt = [&](double time) {
    return std::clamp(static_cast<Eigen::Index>(std::floor((time - signals.startTime) * signals.blockRate())),
                      Eigen::Index{0}, blocks);
  };
  const Stretch around =
      reachOf({std::max<Eigen::Index>(0, blockAt(from) - 1), std::min(blocks, blockAt(to) + 2)}, blocks);
  const Signals there = partOf(signals, around.from, around.to);
  const Model nothing;
  signature.fill(LinearisationPoint(there, nothing).signatures(form), around.from, blocks);
}

}  // namespace

void Signature::fill(const ChannelColumns& part, Eigen::Index first, Eigen::Index blocks) {
  const Stretch acts = part.support();
  reach = reachOf({acts.from + first, acts.to + first}, blocks);
  reach = {std::max(reach.from, first), std::min(reach.to, first + part.blocks())};
  columns = std::make_shared<const ChannelColumns>(part.middle({reach.from - first, reach.to - first}));
}

Signature signatureAt(double time, Form form, const LinearisationPoint& surroundings) {
  form.start(0) = std::clamp(time, form.parameters[0].lower, form.parameters[0].upper);
  return signatureOf(std::move(form), surroundings);
}

SignatureBank::SignatureBank(const Signals& signals, const std::vector<std::string>& hidden) {
  for (const auto& cause : catalogue()) {
    if (std::find(hidden.begin(), hidden.end(), cause->id()) != hidden.end()) continue;
    for (auto& form : cause->forms(signals))
      if (!form.later) plain_.push_back({std::move(form), {}, {}});
  }
}

void SignatureBank::forget() {
  for (Signature& signature : plain_) signature.columns.reset();
  changed_.clear();
}

bool SignatureBank::knows(std::string_view cause) const {
  return std::ranges::any_of(plain_, [&](const Signature& s) { return s.form.cause->id() == cause; });
}

namespace {

bool bends(const Term& t) { return t.form->cause->bendsGeometry(); }

bool isNearly(const Term& a, const Term& b) {
  if (a.form->cause != b.form->cause || a.form->name != b.form->name) return false;
  const Shift shift = shiftBetween(a, b);
  return std::max(shift.amplitude, shift.shape) <= kSmallShare;
}

}  // namespace

SignatureBank::Changed& SignatureBank::changedBy(const Model& model) {
  constexpr std::size_t kKept = 2;
  std::vector<Term> by;
  std::ranges::copy_if(model.terms, std::back_inserter(by), [](const Term& t) { return bends(t) || changesSums(t); });
  const auto known = std::ranges::find_if(
      changed_, [&](const Changed& changed) { return std::ranges::equal(changed.by, by, isNearly); });
  if (known != changed_.end()) {
    std::rotate(changed_.begin(), known, known + 1);
  } else {
    if (changed_.size() == kKept) changed_.pop_back();
    changed_.insert(changed_.begin(), Changed{std::move(by), std::vector<Signature>(plain_.size())});
  }
  return changed_.front();
}

std::vector<Signature> SignatureBank::around(const Signals& signals, const Model& model,
                                             const std::function<bool(const Form&)>& wanted) {
  const bool bent = std::ranges::any_of(model.terms, bends),
             matrixOnly = std::ranges::all_of(
                 model.terms, [](const Term&t) { return !changesSums(t) || t.form->cause->isMatrix(*t.form); });
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < plain_.size(); ++i)
    if (!wanted || wanted(plain_[i].form)) which.push_back(i);
  std::vector<Signature> out(which.size());
  const Model nothing;
  const LinearisationPoint surroundings(signals, model), bare(signals, nothing);
  const Matrix6d map = matrixOnly ? surroundings.sensorMatrix() : Matrix6d::Identity();
  Changed* changed = bent || !matrixOnly ? &changedBy(model) : nullptr;
  parallelFor(out.size(), [&](std::size_t i) {
    Signature& known = plain_[which[i]];
    const Cause& cause = *known.form.cause;
    if (cause.bendsGeometry() || cause.changesSensor(known.form)) {
      out[i] = signatureOf(known.form, surroundings);
      return;
    }
    const bool moves = !matrixOnly || (bent && (cause.feelsMotion() || surroundings.turnsAxes()));
    if (moves && !cause.addsToReadings()) {
      Signature& there = changed->signatures[which[i]];
      if (!there.columns) there = signatureOf(known.form, surroundings);
      out[i] = there;
      return;
    }
    if (!known.columns) fillPlain(known, signals, bare);
    out[i] = known;
    if (cause.addsToReadings() || map.isIdentity(0.0)) return;
    ChannelColumns mapped(known.columns->blocks(), known.columns->cols());
    for (Eigen::Index j = 0; j < mapped.cols(); ++j) {
      const VectorXd column = known.columns->column(j).dense();
      mapped.set(j, ChannelColumn(map * Eigen::Map<const Wrenches>(column.data(), 6, mapped.blocks())));
    }
    out[i].columns = std::make_shared<const ChannelColumns>(std::move(mapped));
  });
  return out;
}

}  // namespace heft::diagnosis
