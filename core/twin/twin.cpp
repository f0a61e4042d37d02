#include "core/twin/twin.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/diagnosis/correction/model_json.h"
#include "core/diagnosis/model/forward_model.h"
#include "core/simulation/effects/effect.h"
#include "core/simulation/random.h"
#include "core/twin/found.h"

namespace heft {

using diagnosis::Model;
using diagnosis::Term;
using nlohmann::json;

namespace {

using AddedRows = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// A found cause, for the truth; one without a name carries what bias and causes together add to the readings.
class FoundEffect final : public Effect {
 public:
  FoundEffect(EffectTruth truth, std::shared_ptr<const AddedRows> rows) : rows_(std::move(rows)) {
    this->truth() = std::move(truth);
  }
  void shiftZero(const VectorXd&, SampledWrench& rows) override {
    if (rows_) rows += *rows_;
  }

 private:
  std::shared_ptr<const AddedRows> rows_;
};

/// Draws the sizes of a term, the `occurrence`-th of its cause, from their standard deviations, and notes all values.
void drawTerm(Term& term, const json* cause, int occurrence, bool fixed, RandomStream& random, EffectTruth& truth) {
  const std::string ending = occurrence > 1 ? "_" + std::to_string(occurrence) : "";
  for (Eigen::Index p = 0; p < term.v.size(); ++p) {
    const auto& parameter = term.form->parameters[static_cast<std::size_t>(p)];
    if (!fixed && cause != nullptr && parameter.reported == nullptr && diagnosis::isAmplitude(*term.form, p)) {
      const double z = random.normal();  // even where nothing is drawn: the same seed, the same other sizes
      const json stated = cause->value("parameters", json::object()).value(parameter.name + ending, json::object());
      const double std = stated.contains("std") && stated["std"].is_number() ? stated["std"].get<double>() : 0.0;
      if (std > 0.0) {
        term.v(p) += z * std / std::abs(parameter.scale);
        if (parameter.lower < parameter.upper) term.v(p) = std::clamp(term.v(p), parameter.lower, parameter.upper);
      }
    }
    if (parameter.reported == nullptr)
      truth.parameters.push_back({parameter.name + ending, {parameter.scale * term.v(p)}});
  }
}

/// What the model of the causes that act adds along the recording, and their truths.
struct Acting {
  Model model;
  std::vector<EffectTruth> truths;
};

Acting actingCauses(Model model, const json& found, const TwinOptions& options, std::vector<TwinCause>& causes) {
  Acting out;
  out.model.x = model.x;
  std::map<std::string, int> occurrences;
  RandomStream random(options.simulate.seed, RandomPurpose::effect, 1u << 20);
  for (auto& term : model.terms) {
    const std::string id(term.form->cause->id());
    const int occurrence = ++occurrences[id];
    EffectTruth truth;
    truth.id = id;
    truth.form = term.form->name;
    drawTerm(term, findCauseIn(found, id), occurrence, options.fixed, random, truth);
    const auto entry = std::ranges::find(causes, id, &TwinCause::id);
    if (entry == causes.end() || std::ranges::count(options.without, id) > 0) continue;
    if (term.form->local && term.v(0) > options.simulate.duration) {
      entry->why = heft::say("It happened at {:.1f} s, after the end of this motion.", term.v(0));
      continue;
    }
    entry->simulated = true;
    entry->why.clear();
    out.truths.push_back(std::move(truth));
    out.model.terms.push_back(std::move(term));
  }
  return out;
}

std::vector<TwinCause> listCauses(const json& found, const TwinOptions& options) {
  std::vector<TwinCause> causes;
  for (const auto& cause : found["causes"]) {
    const auto id = cause["cause"].get<std::string>();
    const bool off = std::ranges::count(options.without, id) > 0;
    causes.push_back({id, false,
                      off ? heft::say("It is switched off.")
                          : heft::say("It has no model that could be carried to another motion.")});
  }
  if (found.contains("frame_mistake"))
    causes.push_back(
        {"frame_mistake", false, heft::say("It is about what the file's numbers mean, not about the setup.")});
  return causes;
}

}  // namespace

Result<Twin> simulateTwin(const json& found, const std::string& where, const RobotModel& robot,
                          const TwinOptions& options, const Progress& progress) {
  if (auto missing = whatIsMissing(found, where, options.without)) return *missing;
  Payload payload;
  if (options.payload) {
    payload = *options.payload;
  } else {
    auto read = payloadFromJson(found["payload_after"], where);
    if (!read) return read.error();
    payload = *read;
  }
  if (const auto physical = checkPhysical(payload); !physical.physical)
    return Error{heft::say("{}: its payload cannot exist: {}", where, physical.reason)};

  // The motion first, with exact readings: what the causes add depends on it.
  SimulateOptions settings = options.simulate;
  settings.effects.clear();
  settings.sensor.forceBias = settings.sensor.torqueBias = 0.0;
  const auto plain = simulate(robot, payload, settings, progress);
  if (!plain) return plain.error();
  std::vector<std::string> unknown;
  auto model = modelFromJson(found["model"], plain->recording, &robot, &unknown);
  if (!model) return model.error();
  const Vector6d bias = model->x.head<6>();
  model->x.tail<10>() = toParameters(payload);

  Twin twin;
  twin.causes = listCauses(found, options);
  Acting acting = actingCauses(std::move(*model), found, options, twin.causes);
  auto rows = std::make_shared<AddedRows>(AddedRows::Zero(plain->recording.rows(), 6));
  if (!acting.model.terms.empty()) {
    auto added = effectOf(acting.model, plain->recording, &robot);
    if (!added) return added.error();
    *rows = std::move(*added);
  }
  rows->rowwise() += bias.transpose();
  auto simulated = simulateWith(
      robot, payload, settings,
      [&](const EffectScene& scene) -> Result<Effects> {
        // Other faults that were asked for come first, as in the signal's way.
        auto effects = makeEffects(options.simulate.effects, options.simulate.seed, scene);
        if (!effects) return effects.error();
        Effects all = std::move(*effects);
        all.push_back(std::make_unique<FoundEffect>(EffectTruth{}, rows));
        for (const auto& truth : acting.truths) all.push_back(std::make_unique<FoundEffect>(truth, nullptr));
        return all;
      },
      progress);
  if (!simulated) return simulated.error();
  twin.simulated = std::move(*simulated);
  std::erase_if(twin.simulated.truth.effects, [](const EffectTruth& truth) { return truth.id.empty(); });
  twin.simulated.truth.forceBias = bias.head<3>();
  twin.simulated.truth.torqueBias = bias.tail<3>();
  return twin;
}

}  // namespace heft
