#include "core/diagnosis/correction/corrected.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/say.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/correction/model_json.h"
#include "core/diagnosis/data_quality/between_rows.h"
#include "core/diagnosis/data_quality/reported_velocities.h"
#include "core/diagnosis/data_quality/time_stamps.h"
#include "core/diagnosis/search/random_walk.h"
#include "core/diagnosis/wording/words.h"

namespace heft {

using namespace diagnosis;
using nlohmann::json;

namespace {

bool has(const std::vector<std::string>& causes, std::string_view id) {
  return std::find(causes.begin(), causes.end(), id) != causes.end();
}

/// The member of `object` under `key`; null if there is none.
const json& memberOf(const json& object, const char* key) {
  static const json nothing;
  const auto it = object.is_object() ? object.find(key) : object.end();
  return it == object.end() ? nothing : *it;
}

/// `count` numbers under `key`; empty if they are not there.
std::vector<double> numbersOf(const json& object, const char* key, std::size_t count) {
  std::vector<double> out;
  const json& array = memberOf(object, key);
  if (!array.is_array() || array.size() != count) return out;
  for (const json& number : array) {
    if (!number.is_number()) return {};
    out.push_back(number.get<double>());
  }
  return out;
}

json readingJson(const conventions::Reading& reading) {
  json turn = json::array();
  for (int i = 0; i < 9; ++i) turn.push_back(reading.turn(i / 3, i % 3));
  const Vector3d& g = reading.gravity;
  return {{"meta", metaPatch(reading.conventions)},
          {"wrench_sign", reading.sign == WrenchSign::sensorOnPayload ? "sensor_on_payload" : "payload_on_sensor"},
          {"turn", turn},
          {"gravity_m_s2", {g.x(), g.y(), g.z()}}};
}

std::optional<conventions::Reading> readingFromJson(const json& object) {
  const json& meta = memberOf(object, "meta");
  const auto stated = readConventions(meta.is_object() ? meta : json::object(), "frame_mistake");
  const auto turn = numbersOf(object, "turn", 9), gravity = numbersOf(object, "gravity_m_s2", 3);
  if (!stated || turn.empty() || gravity.empty()) return std::nullopt;
  conventions::Reading out;
  takeOver(*stated, out.conventions);
  if (memberOf(object, "wrench_sign") == "payload_on_sensor") out.sign = WrenchSign::payloadOnSensor;
  for (int i = 0; i < 9; ++i) out.turn(i / 3, i % 3) = turn[static_cast<std::size_t>(i)];
  out.gravity = Vector3d(gravity[0], gravity[1], gravity[2]);
  return out;
}

std::optional<FrameMistake> mistakeFromJson(const json& object) {
  const auto stated = readingFromJson(memberOf(object, "stated")), reading = readingFromJson(memberOf(object, "is"));
  if (!stated || !reading) return std::nullopt;
  FrameMistake out;
  out.stated = *stated;
  out.reading = *reading;
  out.changes = conventions::changes(out.stated, out.reading);
  out.positionsKept = memberOf(object, "positions_kept") == true;
  return out;
}

struct NamedCause {
  bool direct = false;
  std::vector<std::pair<double, double>> when;
};

std::optional<NamedCause> causeIn(const json& found, const std::string& id) {
  for (const json& cause : memberOf(found, "causes")) {
    if (memberOf(cause, "cause") != id) continue;
    NamedCause out;
    out.direct = memberOf(cause, "direct") == true;
    for (const json& stretch : memberOf(cause, "when"))
      if (stretch.is_array() && stretch.size() == 2 && stretch[0].is_number() && stretch[1].is_number())
        out.when.emplace_back(stretch[0].get<double>(), stretch[1].get<double>());
    return out;
  }
  return std::nullopt;
}

/// Deviations as the joint fit of payload and causes had them, where that is more.
void widen(EstimateReport& report, const json& found) {
  const json& std = memberOf(memberOf(found, "payload_after"), "std");
  const auto grow = [](double& deviation, Interval& interval, const json& least) {
    if (!least.is_number() || !(deviation > 0.0) || !(deviation < least.get<double>())) return;
    const double factor = least.get<double>() / deviation, middle = 0.5 * (interval.lower + interval.upper);
    interval = {middle + factor * (interval.lower - middle), middle + factor * (interval.upper - middle)};
    deviation = least.get<double>();
  };
  grow(report.std.mass, report.interval95.mass, memberOf(std, "mass_kg"));
  const json& com = memberOf(std, "com_m");
  for (std::size_t i = 0; i < 3 && com.is_array() && com.size() == 3; ++i)
    grow(report.std.com(static_cast<Eigen::Index>(i)), report.interval95.com[i], com[i]);
}

/// Adds to both series what the correction took off, between the recording's rows by a straight line.
void addBack(WrenchSeries& series, const Recording& raw, const Recording& cleaned) {
  const Eigen::Matrix<double, Eigen::Dynamic, 6> taken = raw.wrench - cleaned.wrench;
  BetweenRows rows(raw.time);
  for (Eigen::Index k = 0; k < series.time.size(); ++k) {
    const Eigen::Matrix<double, 1, 6> effect = rows.at(taken, series.time(k));
    series.measured.row(k) += effect;
    series.simulated.row(k) += effect;
  }
}

/// The sensor's pose in each row, as a motion that stands still there.
Result<Motion> posesOfRows(const Recording& recording, const RobotModel* robot) {
  Recording standing = recording;
  standing.meta.kind = RecordingKind::poses;
  return standingPoses(standing, robot);
}

}  // namespace

Result<Recording> undone(Recording out, const RobotModel* robot, const FrameMistake& mistake) {
  using conventions::Change;
  const bool posesInFile = out.hasOrientation();
  auto motion = posesOfRows(out, robot);
  if (!motion) return motion.error();
  const Motion right = conventions::readSo(std::move(*motion), mistake.stated, mistake.reading, posesInFile);
  out.wrench = right.wrench.transpose();
  if (posesInFile && (mistake.has(Change::poseInverted) || mistake.has(Change::quaternionOrder))) {
    for (Eigen::Index k = 0; k < out.rows(); ++k) {
      out.quaternion.row(k) = Quaterniond(right.R_BS[static_cast<std::size_t>(k)]).coeffs().transpose();
      if (k > 0 && out.quaternion.row(k).dot(out.quaternion.row(k - 1)) < 0.0) out.quaternion.row(k) *= -1.0;
    }
    if (!mistake.positionsKept) {
      if (out.hasPosition()) out.position = right.position.transpose();
      // Beside poses of the base in the sensor nobody knows what a twist means.
      if (mistake.has(Change::poseInverted)) out.twist.resize(0, 6);
    }
  }
  out.meta.gravity = mistake.reading.gravity;
  out.meta.conventions = mistake.reading.conventions;
  out.meta.wrenchSign = mistake.reading.sign;
  return out;
}

json mistakeToJson(const FrameMistake& mistake, const RecordingMeta& meta, bool fromJoints) {
  json kinds = json::array(), ties = json::array();
  for (const auto change : mistake.changes) kinds.push_back(toString(change));
  for (const auto& tie : mistake.ties) {
    json others = json::array();
    for (const auto change : tie.changes) others.push_back(toString(change));
    ties.push_back({{"kinds", others},
                    {"sentence", tie.sentence},
                    {"evidence", tie.evidence},
                    {"mass_kg", tie.payload.mass},
                    {"com_m", {tie.payload.com.x(), tie.payload.com.y(), tie.payload.com.z()}},
                    {"meta", conventions::metaPatch(mistake.stated, tie.reading, meta.mount, fromJoints)}});
  }
  json turn = json::array();
  for (int i = 0; i < 9; ++i) turn.push_back(mistake.turn()(i / 3, i % 3));
  return {
      {"kind", kinds.front()},
      {"kinds", kinds},
      {"sentence", mistake.sentence()},
      {"check", mistake.check()},
      {"evidence", mistake.evidence},
      {"meta", mistake.positionsKept ? json(nullptr)
                                     : conventions::metaPatch(mistake.stated, mistake.reading, meta.mount, fromJoints)},
      {"turn", turn},
      {"positions_kept", mistake.positionsKept},
      {"tied", mistake.tied},
      {"ties", ties},
      {"decides", mistake.decides},
      {"stated", readingJson(mistake.stated)},
      {"is", readingJson(mistake.reading)}};
}

bool canApply(const DiagnosisReport& report, const DiagnosedCause& cause) {
  if (!cause.direct)
    return std::any_of(report.model.terms.begin(), report.model.terms.end(),
                       [&](const Term& term) { return term.form->cause->id() == cause.id; });
  // Of readings that fit alike a person has to state one.
  if (cause.id == ids::frameError || cause.id == ids::sensorRotation) return report.mistake && !report.mistake->tied;
  if (cause.id == ids::contact || cause.id == ids::payloadChange) return !cause.when.empty();
  // Noisy or coarse angles are smoothed more, which every estimate does by itself.
  return cause.id == ids::jitter || cause.ofVelocities;
}

Result<Recording> corrected(const Recording& recording, const RobotModel* robot, const json& found,
                            const std::vector<std::string>& causes, std::vector<std::string>* unknown) {
  const Error other{
      heft::say("The corrections of this session come from a diagnosis that this version of Heft does not understand; "
                "run the reality check again.")};
  Recording out = recording;
  std::vector<std::string> fitted;
  for (const std::string& id : causes) {
    const auto cause = causeIn(found, id);
    if (!cause) return other;
    if (!cause->direct) {
      fitted.push_back(id);
    } else if (id == ids::frameError || id == ids::sensorRotation) {
      const auto mistake = mistakeFromJson(memberOf(found, "frame_mistake"));
      if (!mistake) return other;
      auto right = undone(std::move(out), robot, *mistake);
      if (!right) return right.error();
      out = std::move(*right);
    } else if (id == ids::contact || id == ids::payloadChange) {
      const MarkLabel label = id == ids::contact ? MarkLabel::contact : MarkLabel::ignore;
      for (const auto& [from, to] : cause->when) out.meta.marks.push_back({from, to, label});
    } else if (id == ids::jitter) {
      if (auto stamps = unevenStamps(out)) out.time = std::move(stamps->even);
    } else if (id == ids::motionLag || id == ids::derivativeNoise) {
      dropReportedVelocities(out);
    }
  }
  if (fitted.empty()) return out;
  // The zero's wandering was fitted along with them and is allowed for together with any of them.
  fitted.emplace_back(kRandomWalk);
  // The model was fitted to a recording without the mistake, whoever applies that one, too.
  Recording stated = out;
  std::optional<FrameMistake> left;
  if (!has(causes, ids::frameError) && !has(causes, ids::sensorRotation))
    left = mistakeFromJson(memberOf(found, "frame_mistake"));
  if (left) {
    auto right = undone(std::move(stated), robot, *left);
    if (!right) return right.error();
    stated = std::move(*right);
  }
  std::vector<std::string> strange;
  auto model = modelFromJson(memberOf(found, "model"), stated, robot, unknown == nullptr ? nullptr : &strange);
  if (!model) return model.error();
  for (const std::string& id : strange)
    if (has(fitted, id) && id != kRandomWalk && !has(*unknown, id)) unknown->push_back(id);
  auto effect = effectOf(*model, stated, robot, fitted);
  if (!effect) return effect.error();
  if (!left) {
    out.wrench -= *effect;
    return out;
  }
  // What the file's numbers are to be without the effect, as they are told.
  stated.wrench -= *effect;
  std::swap(left->stated, left->reading);
  auto again = undone(std::move(stated), robot, *left);
  if (!again) return again.error();
  out.wrench = std::move(again->wrench);
  return out;
}

Result<Recording> correctedByAll(const Recording& recording, const RobotModel* robot, const json& found,
                                 const std::string& where) {
  if (memberOf(found, "schema") != "heft.diagnose/1" || !memberOf(found, "causes").is_array() ||
      !memberOf(found, "model").is_object())
    return Error{
        heft::say("{} is not a result of heft diagnose; write one with heft diagnose REC --json FILE.", where)};
  const bool another = memberOf(found, "file") != recording.file;
  std::vector<std::string> causes, left;
  for (const json& cause : found["causes"]) {
    const json& id = memberOf(cause, "cause");
    if (!id.is_string()) continue;
    const json& when = memberOf(cause, "when");
    const bool ofOneMoment = (when.is_array() && !when.empty()) || isCourseOfTheZero(id.get<std::string>());
    (another && ofOneMoment ? left : causes).push_back(id.get<std::string>());
  }
  if (!another) return corrected(recording, robot, found, causes);
  left.emplace_back(kRandomWalk);
  json lasting = found, terms = json::array();
  for (const json& term : memberOf(found["model"], "terms"))
    if (const json& id = memberOf(term, "cause"); !id.is_string() || !has(left, id.get<std::string>()))
      terms.push_back(term);
  lasting["model"]["terms"] = std::move(terms);
  return corrected(recording, robot, lasting, causes);
}

Result<EstimateReport> estimateWith(const Recording& recording, const RobotModel* robot, const EstimateOptions& options,
                                    const json& found, const std::vector<std::string>& causes,
                                    const Progress& progress) {
  if (causes.empty()) return estimate(recording, robot, options, progress);
  std::vector<std::string> unknown;
  auto cleaned = corrected(recording, robot, found, causes, &unknown);
  if (!cleaned) return cleaned.error();
  auto report = estimate(*cleaned, robot, options, progress);
  if (!report) return report;
  widen(*report, found);
  addBack(report->series, recording, *cleaned);
  std::vector<std::string> known = causes, strange;
  std::erase_if(known, [&](const std::string& id) { return has(unknown, id); });
  if (!known.empty())
    report->findings.push_back(
        {Severity::info,
         "causes_taken_out",
         heft::say("The reality check's corrections are part of these numbers: {}.", fmt::join(known, ", ")),
         {},
         {}});
  for (const std::string& id : unknown) strange.push_back("\"" + causeTitle(id) + "\"");
  if (!strange.empty())
    report->findings.push_back(
        {Severity::warning,
         "causes_unknown",
         heft::say("Another version of Heft saved {} in a form that this one does not know: not part of these numbers.",
                   fmt::join(strange, ", ")),
         heft::say("Run the reality check again."),
         {}});
  return report;
}

}  // namespace heft
