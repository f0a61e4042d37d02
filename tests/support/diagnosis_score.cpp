#include "tests/support/diagnosis_score.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "core/math/statistics.h"
#include "tests/support/parameter_errors.h"

namespace heft::test {
namespace {

using nlohmann::json;

constexpr Judgement kJudgements[] = {Judgement::right,       Judgement::tied,   Judgement::later,
                                     Judgement::unexplained, Judgement::missed, Judgement::wrong};
std::vector<std::string> strings(const json& list) {
  std::vector<std::string> out;
  if (list.is_array())
    for (const json& item : list)
      if (item.is_string()) out.push_back(item.get<std::string>());
  return out;
}

struct Cause {
  std::string id;
  std::vector<std::string> alternatives;
};

std::vector<Cause> causesOf(const json& answer) {
  std::vector<Cause> causes;
  const json list = answer.value("causes", json::array());
  for (const json& cause : list)
    causes.push_back({cause.value("cause", std::string()), strings(cause.value("alternatives", json::array()))});
  return causes;
}

bool contains(const std::vector<std::string>& list, const std::string& id) {
  return std::find(list.begin(), list.end(), id) != list.end();
}

/// Two words for one thing: a row that repeats the last packet has lost one; a jump of the zero is a bias.
bool means(const std::string& named, const std::string& hidden) {
  static const std::set<std::pair<std::string, std::string>> same{
      {"repeats", "dropouts"}, {"dropouts", "repeats"}, {"sensor_bias", "bias_drift"}};
  return named == hidden || same.count({named, hidden}) > 0;
}

double number(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_number() ? found->get<double>() : std::nan("");
}

/// Relative error of the mass, and distance of the centres of mass.
std::pair<double, double> errorsOf(const Payload& truth, const json& answer, const char* key) {
  const json payload = answer.value(key, json::object());
  const double mass = std::abs(number(payload, "mass_kg") - truth.mass) / truth.mass;
  const json com = payload.value("com_m", json::array());
  if (com.size() != 3 || !com[0].is_number()) return {mass, std::nan("")};
  const Vector3d c(com[0].get<double>(), com[1].get<double>(), com[2].get<double>());
  return {mass, (c - truth.com).norm()};
}

double percent(double share) { return 100.0 * share; }

/// Leaves out what is not a number.
double medianOf(std::vector<double> values) {
  std::erase_if(values, [](double x) { return !std::isfinite(x); });
  return median(std::move(values));
}

}  // namespace

std::string_view toString(Judgement judgement) {
  switch (judgement) {
    case Judgement::right:
      return "right";
    case Judgement::tied:
      return "tied";
    case Judgement::later:
      return "later";
    case Judgement::unexplained:
      return "unexplained";
    case Judgement::missed:
      return "missed";
    case Judgement::wrong:
      break;
  }
  return "wrong";
}

Judgement judge(const HiddenTruth& truth, const json& answer) {
  std::string verdict = answer.value("verdict", std::string());
  std::vector<Cause> causes = causesOf(answer);
  // Picking and placing touches things: saying so is neither an alarm nor an answer.
  const bool maybeContact = contains(truth.relatives, "contact") && !truth.touches;
  if (!contains(truth.ids, "contact") && !maybeContact) {
    std::erase_if(causes, [](const Cause& cause) { return cause.id == "contact"; });
    if (causes.empty() && verdict == "explained") verdict = "clean";
  }
  if (truth.ids.empty()) return verdict == "clean" ? Judgement::right : Judgement::wrong;
  if (verdict == "clean") return Judgement::missed;
  if (truth.kind == HiddenCase::unlisted) {
    if (verdict == "unexplained") return Judgement::right;
    return !causes.empty() && contains(truth.relatives, causes.front().id) ? Judgement::tied : Judgement::wrong;
  }
  const auto named = [&](const std::string& id) {
    return std::any_of(causes.begin(), causes.end(), [&](const Cause& cause) { return means(cause.id, id); });
  };
  const auto namedOrTied = [&](const std::string& id) {
    return std::any_of(causes.begin(), causes.end(),
                       [&](const Cause& cause) { return means(cause.id, id) || contains(cause.alternatives, id); });
  };
  const auto& ids = truth.ids;
  if (ids.size() > 1 && std::all_of(ids.begin(), ids.end(), named)) return Judgement::right;
  if (ids.size() > 1 && std::all_of(ids.begin(), ids.end(), namedOrTied)) return Judgement::tied;
  if (ids.size() == 1 && !causes.empty()) {
    if (means(causes.front().id, ids.front())) return Judgement::right;
    if (contains(causes.front().alternatives, ids.front())) return Judgement::tied;
  }
  if (std::any_of(ids.begin(), ids.end(), namedOrTied)) return Judgement::later;
  return verdict == "unexplained" ? Judgement::unexplained : Judgement::wrong;
}

void DiagnosisScore::add(const HiddenTruth& truth, const json& answer, double seconds) {
  const std::vector<Cause> causes = causesOf(answer);
  Entry entry{truth.kind, truth.multiple, truth.noise, "", "", judge(truth, answer), 0, 0, 0, 0, 0, {}, seconds};
  entry.hidden = truth.ids.empty() ? "(nothing)" : fmt::format("{}", fmt::join(truth.ids, " + "));
  entry.named = causes.empty() ? fmt::format("({})", answer.value("verdict", std::string("?"))) : causes.front().id;
  const Payload& payload = truth.simulation.payload;
  std::tie(entry.massBefore, entry.centreBefore) = errorsOf(payload, answer, "payload_before");
  std::tie(entry.massAfter, entry.centreAfter) = errorsOf(payload, answer, "payload_after");
  const double noise = number(answer.value("baseline", json::object()), "noise_force_rms_n");
  if (!causes.empty())
    entry.residualOverNoise =
        number(answer["causes"].back().value("gain", json::object()), "force_rms_after_n") / noise;
  for (const json& cause : answer.value("causes", json::array()))
    for (const EffectTruth& hidden : truth.simulation.effects)
      if (cause.value("cause", std::string()) == hidden.id)
        for (const double error : parameterErrors(hidden, cause)) entry.errors.push_back(error);
  entries_.push_back(std::move(entry));
}

double DiagnosisScore::share(HiddenCase kind, Judgement judgement, double multiple) const {
  double all = 0.0, hits = 0.0;
  for (const Entry& e : entries_) {
    if (e.kind != kind || (multiple > 0.0 && std::abs(e.multiple - multiple) > 1e-9)) continue;
    all += 1.0;
    hits += e.judgement == judgement;
  }
  return all > 0.0 ? hits / all : 0.0;
}

std::string DiagnosisScore::text() const {
  std::string out = fmt::format("{:<10} {:>6} {:>5}", "case", "size", "n");
  for (const Judgement judgement : kJudgements) out += fmt::format(" {:>11} %", toString(judgement));
  out += "\n";
  for (const HiddenCase kind : kHiddenCases) {
    std::map<double, int> sizes;
    for (const Entry& e : entries_)
      if (e.kind == kind) ++sizes[e.multiple];
    for (const auto& [size, count] : sizes) {
      out += fmt::format("{:<10} {:>6.2f} {:>5}", toString(kind), size, count);
      for (const Judgement judgement : kJudgements)
        out += fmt::format(" {:>13.1f}", percent(share(kind, judgement, size)));
      out += "\n";
    }
  }

  out += "\nHidden, and what was named first (not where right)\n";
  std::map<std::string, std::map<std::string, int>> confusion;
  for (const Entry& e : entries_) ++confusion[e.hidden][e.judgement == Judgement::right ? "right" : e.named];
  for (const auto& [hidden, names] : confusion) {
    out += fmt::format("  {:<34}", hidden);
    for (const auto& [name, count] : names) out += fmt::format(" {} {};", name, count);
    out += "\n";
  }

  std::map<std::string, std::pair<int, int>> alarms;
  for (const Entry& e : entries_) {
    if (e.kind != HiddenCase::clean && e.kind != HiddenCase::walking) continue;
    ++alarms[e.noise].second;
    alarms[e.noise].first += e.judgement != Judgement::right;
  }
  out += "\nFalse alarms by noise:";
  for (const auto& [noise, counts] : alarms) out += fmt::format(" {} {}/{};", noise, counts.first, counts.second);

  out += "\n\nMedians        mass error before/after %   centre before/after mm   unseen residual/noise   seconds\n";
  for (const HiddenCase kind : kHiddenCases) {
    std::vector<double> values[6];
    for (const Entry& e : entries_) {
      if (e.kind != kind) continue;
      const double row[] = {percent(e.massBefore), percent(e.massAfter), 1e3 * e.centreBefore,
                            1e3 * e.centreAfter,   e.residualOverNoise,  e.seconds};
      for (std::size_t i = 0; i < 6; ++i) values[i].push_back(row[i]);
    }
    if (values[0].empty()) continue;
    out += fmt::format("{:<12} {:>13.2f} / {:<10.2f} {:>12.2f} / {:<10.2f} {:>15.2f} {:>15.2f}\n", toString(kind),
                       medianOf(values[0]), medianOf(values[1]), medianOf(values[2]), medianOf(values[3]),
                       medianOf(values[4]), medianOf(values[5]));
  }

  std::size_t stated = 0, within = 0, named = 0, quiet = 0;
  for (const Entry& e : entries_) {
    if (e.kind == HiddenCase::unlisted) continue;
    stated += e.errors.size();
    within += static_cast<std::size_t>(
        std::count_if(e.errors.begin(), e.errors.end(), [](double z) { return std::abs(z) < 3.0; }));
    if (e.residualOverNoise <= 0.0) continue;
    ++named;
    quiet += e.residualOverNoise < 1.15 ? 1 : 0;
  }
  out += fmt::format(
      "\nParameters within 3 of their deviations: {} of {}. Unseen residual within 15 % of the noise: {} of {}.\n",
      within, stated, quiet, named);
  return out;
}

}  // namespace heft::test
