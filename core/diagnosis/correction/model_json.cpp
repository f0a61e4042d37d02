#include "core/diagnosis/correction/model_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/say.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/search/search.h"

namespace heft {

using namespace diagnosis;
using nlohmann::json;

namespace {

Model withoutTerms(const Model& model) {
  Model out;
  out.x = model.x;
  return out;
}

}  // namespace

Result<Eigen::Matrix<double, Eigen::Dynamic, 6>> effectOf(const Model& model, const Recording& recording,
                                                          const RobotModel* robot,
                                                          const std::vector<std::string>& causes) {
  MotionOptions options;
  options.cutoffHz = kDefaultCutoffHz;
  const auto motion = motionOf(recording, robot, options);
  if (!motion) return motion.error();
  const Signals signals = signalsOf(recording, *std::move(motion), robot);
  Model applied = model;
  if (!causes.empty())
    std::erase_if(applied.terms, [&](const Term& t) {
      return std::find(causes.begin(), causes.end(), t.form->cause->id()) == causes.end();
    });
  const Wrenches effect = predicted(signals, applied) - predicted(signals, withoutTerms(applied));
  Eigen::Matrix<double, Eigen::Dynamic, 6> out(recording.rows(), 6);
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const double at = std::clamp((recording.time(i) - signals.startTime) * signals.rateHz, 0.0,
                                 static_cast<double>(signals.size() - 1));
    const auto k = std::min<Eigen::Index>(static_cast<Eigen::Index>(at), signals.size() - 2);
    const double u = at - static_cast<double>(k);
    out.row(i) = ((1.0 - u) * effect.col(k) + u * effect.col(k + 1)).transpose();
  }
  return out;
}

json modelToJson(const Model& model) {
  json terms = json::array();
  for (const auto& term : model.terms) {
    json values = json::array();
    for (Eigen::Index i = 0; i < term.v.size(); ++i) values.push_back(term.v(i));
    terms.push_back({{"cause", term.form->cause->id()},
                     {"form", term.form->name},
                     {"choice", term.form->choice},
                     {"values_si", values}});
  }
  json x = json::array();
  for (Eigen::Index i = 0; i < model.x.size(); ++i) x.push_back(model.x(i));
  return {{"bias_and_parameters", x}, {"terms", terms}};
}

namespace {

/// A term as modelToJson() wrote it. Forms have grown since: what an older one lacks is where it had no effect.
std::optional<Term> termFromJson(const json& object, const Signals& signals) {
  const Cause* cause = findCause(object["cause"].get<std::string>());
  if (cause == nullptr) return std::nullopt;
  const json choice = object.value("choice", json::array()), &values = object["values_si"];
  for (auto& form : cause->forms(signals)) {
    if (json(form.choice) != choice || form.parameters.size() < values.size()) continue;
    Term term{std::make_shared<const Form>(form), form.start, {}};
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!values[i].is_number()) return std::nullopt;
      term.v(static_cast<Eigen::Index>(i)) = values[i].get<double>();
    }
    return term;
  }
  return std::nullopt;
}

}  // namespace

Result<Model> modelFromJson(const json& object, const Recording& recording, const RobotModel* robot,
                            std::vector<std::string>* unknown) {
  const Error broken{heft::say(
      "The diagnosis holds no extended model that this version of Heft understands; run heft diagnose again.")};
  if (!object.is_object() || !object.contains("terms") || !object["terms"].is_array() ||
      !object.contains("bias_and_parameters") || object["bias_and_parameters"].size() != kLinear)
    return broken;
  MotionOptions options;
  options.cutoffHz = kDefaultCutoffHz;
  const auto motion = motionOf(recording, robot, options);
  if (!motion) return motion.error();
  const Signals signals = signalsOf(recording, *std::move(motion), robot);
  Model model;
  for (int i = 0; i < kLinear; ++i) {
    const json& value = object["bias_and_parameters"][static_cast<std::size_t>(i)];
    if (!value.is_number()) return broken;
    model.x(i) = value.get<double>();
  }
  for (const auto& saved : object["terms"]) {
    if (!saved.is_object() || !saved.contains("cause") || !saved["cause"].is_string() || !saved.contains("values_si") ||
        !saved["values_si"].is_array())
      return broken;
    auto term = termFromJson(saved, signals);
    if (!term && unknown == nullptr) return broken;
    if (term)
      model.terms.push_back(std::move(*term));
    else
      unknown->push_back(saved["cause"].get<std::string>());
  }
  return model;
}

}  // namespace heft
