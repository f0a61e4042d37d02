// What a check found, in words and as JSON.
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/base/say.h"
#include "core/conventions/search.h"
#include "core/math/linear_algebra.h"

namespace heft::conventions {

using nlohmann::json;

namespace {

void addCautions(Report& report, double heaviest, bool standing) {
  const Payload& p = report.payload;
  if (p.com.norm() > kUsualReach)
    report.cautions.push_back(
        {standing ? Severity::warning : Severity::info,
         "centre_far",
         heft::say("The centre of mass would be {:.2f} m from the sensor. If the tool is not that "
                   "long, force and torque are in other units than the setup file says.",
                   p.com.norm()),
         heft::say("Check force_unit and torque_unit in the setup file."),
         {}});
  if (p.mass > heaviest)
    report.cautions.push_back({Severity::warning,
                               "weight_large",
                               heft::say("A load of {:.0f} kg is more than this arm carries: the force's unit is "
                                         "probably not what the setup file says.",
                                         p.mass),
                               heft::say("State force_unit in the setup file."),
                               {}});
}

/// A point that was found explains the force's misfit by turning: what else is in it moves the point, by at most the
/// share that is left.
void addPointBesideOther(Report& report) {
  constexpr double kMuch = 0.2;
  const double share = report.misfit.force / std::max(1e-12, report.statedMisfit.force);
  if (share < kMuch) return;
  const double off = share * report.suggested->conventions.wrenchPoint.offset.norm();
  report.cautions.push_back(
      {Severity::warning,
       "point_unsure",
       heft::say("Something else affects the readings, too. The reference point of the torque, and the centre of mass "
                 "with it, may be off by as much as {:.0f} mm.",
                 1e3 * off),
       heft::say("Ask the controller's manual for the point, and state it as wrench_point in the setup file."),
       {}});
}

/// A turn or a point that was found in the readings is as sure as they make it, and the centre goes with it.
void addFreeUnsure(Report& report) {
  constexpr double kCentre = 0.001, kMass = 0.01;  // Half of what two payloads may differ by and be the same
  constexpr double kInterval = 1.96;               // 95 % of a normal distribution
  const Payload& p = report.payload;
  if (report.fromFree.isZero() || p.mass == 0.0) return;
  const double ofCentre = centreStd(p, report.fromFree);
  const double massStd = std::sqrt(std::max(0.0, report.fromFree(0, 0))) / std::abs(p.mass);
  const bool ofPoint = report.turnStd <= 0.0;
  if (ofPoint) addPointBesideOther(report);
  if (ofCentre < kCentre && massStd < kMass) return;
  report.cautions.push_back(
      ofPoint ? Finding{Severity::warning,
                        "point_unsure",
                        heft::say("This recording determines the reference point of the torque, and with it the centre "
                                  "of mass, only to +- {:.0f} mm.",
                                  1e3 * kInterval * ofCentre),
                        heft::say("State wrench_point in the setup file, or record a motion with brisk turns."),
                        {}}
              : Finding{Severity::warning,
                        "turn_unsure",
                        heft::say("This recording determines the orientation of the sensor or the robot's base only to "
                                  "+- {:.1f} degrees. That alone may shift the centre of mass by {:.0f} mm.",
                                  kInterval * report.turnStd * 180.0 / std::numbers::pi, 1e3 * kInterval * ofCentre),
                        heft::say("State the mount and gravity in the setup file, or record a motion that tilts and "
                                  "rotates the tool more."),
                        {}});
}

/// What bends mass and centre although the numbers mean what is stated.
void addDisagreement(Report& report) {
  constexpr double kRadPerDegree = std::numbers::pi / 180.0;
  const Agreement& a = *report.agreement;
  if (a.turned())
    report.cautions.push_back(
        {Severity::warning,
         "sensor_turned",
         heft::say(
             "The readings look as if the sensor were turned by about {:.1f} degrees from where the setup file has "
             "it. The centre of mass is off accordingly, by more than its interval says.",
             a.turn / kRadPerDegree),
         heft::say("Look for causes: a turned sensor, a tilted base and a joint's zero look alike."),
         {}});
  if (a.ratioDisagrees())
    report.cautions.push_back(
        {Severity::warning,
         "force_and_torque",
         heft::say(
             "Force and torque do not agree: in the torque, mass times lever is about {:.0f} % of what it is in the "
             "force. Mass and centre may be off by as much.",
             100.0 * a.ratio),
         heft::say("Look for causes: a gain of force or torque, and a sensor beside its place, look like this."),
         {}});
}

}  // namespace

double centreStd(const Payload& payload, const Eigen::Matrix<double, 10, 10>& ofPhi) {
  Eigen::Matrix<double, 3, 10> J = Eigen::Matrix<double, 3, 10>::Zero();  // d c / d phi
  J.col(0) = -payload.com / payload.mass;
  J.block<3, 3>(0, 1) = Matrix3d::Identity() / payload.mass;
  return std::sqrt(std::max(0.0, symmetricEigen(congruence(J, ofPhi)).values(2)));
}

void putIntoWords(const Question& question, Report& report) {
  const bool standing = question.kind == RecordingKind::poses;
  addCautions(report, question.heaviest, standing);
  addFreeUnsure(report);
  if (report.agreement) addDisagreement(report);
  constexpr double kPlain = 20.0;  // Odds of 20,000 to 1: less is no more than one pose may change
  if (report.verdict == Verdict::suggested && report.next && report.evidence < kPlain)
    report.cautions.push_back(
        {Severity::warning,
         "nearly_tied",
         heft::say("The evidence is weak: another interpretation fits nearly as well. {}", report.next->sentence),
         standing ? heft::say("Record more poses, tilted to all sides.")
                  : heft::say("Record a longer motion that tilts and turns the tool."),
         {}});
  if (standing && report.payload.com.z() < -kBehind && report.verdict != Verdict::none)
    report.cautions.push_back(
        {Severity::warning,
         "centre_behind_sensor",
         heft::say("The centre of mass lies {:.0f} mm behind the sensor, in the arm. Standing poses cannot distinguish "
                   "that from a torque with the opposite sign, or one taken about another point.",
                   -1e3 * report.payload.com.z()),
         heft::say("Check the torque's sign and reference point, or record a motion with brisk turns."),
         {}});
  switch (report.verdict) {
    case Verdict::asStated:
      report.sentence = report.ties.empty() ? heft::say("The readings follow the stated conventions.")
                                            : heft::say("The readings fit the stated conventions, and others as well.");
      break;
    case Verdict::suggested:
      report.sentence = sentence(question.stated, *report.suggested);
      report.check = whatToCheck(question.stated, *report.suggested);
      break;
    case Verdict::ambiguous:
      report.sentence = tiedSentence(question.stated, *report.suggested);
      report.check = whatToCheck(question.stated, *report.suggested);
      break;
    case Verdict::none:
      report.sentence =
          heft::say("No rigid payload explains the readings, under the stated conventions or any other usual ones.");
      report.check = heft::say("Look for contact, a cable, or a sensor that was zeroed during the recording.");
      break;
  }
  if (!report.ties.empty())
    report.decides = standing
                         ? heft::say("A motion with brisk turns in all directions would decide.")
                         : heft::say("A longer motion that tilts and turns the tool in all directions would decide.");
}

std::string_view toString(Verdict verdict) {
  constexpr std::string_view kNames[] = {"as_stated", "suggested", "ambiguous", "none"};
  return kNames[static_cast<std::size_t>(verdict)];
}

json toJson(const Report& report, const SensorMount& mount, bool fromJoints) {
  json out;
  out["verdict"] = toString(report.verdict);
  out["stated"] = toJson(report.stated);
  const bool told = report.verdict == Verdict::suggested;
  out["suggested"] = told ? toJson(*report.suggested) : json(nullptr);
  if (told && report.suggested->gravity != report.stated.gravity) {
    const Vector3d& g = report.suggested->gravity;
    out["suggested"]["gravity_m_s2"] = {g.x(), g.y(), g.z()};
  }
  out["meta"] = told ? metaPatch(report.stated, *report.suggested, mount, fromJoints) : json(nullptr);
  if (told && report.turnStd > 0.0) out["turn_std_rad"] = report.turnStd;
  out["evidence"] = report.evidence;
  out["over_stated"] = report.overStated;
  out["sentence"] = report.sentence;
  out["misfit"] = {{"force", report.misfit.force}, {"torque", report.misfit.torque}};
  json ties = json::array();
  for (const Alternative& tie : report.ties) {
    json kinds = json::array();
    for (const Change change : tie.changes) kinds.push_back(toString(change));
    ties.push_back({{"changes", kinds},
                    {"sentence", tie.sentence},
                    {"evidence", tie.evidence},
                    {"mass_kg", tie.payload.mass},
                    {"com_m", {tie.payload.com.x(), tie.payload.com.y(), tie.payload.com.z()}},
                    {"meta", metaPatch(report.stated, tie.reading, mount, fromJoints)}});
  }
  out["ties"] = ties;
  return out;
}

}  // namespace heft::conventions
