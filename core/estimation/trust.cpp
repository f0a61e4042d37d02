// Whether an estimate may be relied on.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/doubts.h"
#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/estimation/judgement.h"
#include "core/math/statistics.h"

namespace heft {

using conventions::Verdict;

namespace {

/// Blocks of a fiftieth of a second in one average: 80 ms pass what hands do and drop most of sensor noise and
/// vibration.
constexpr Eigen::Index kAveraged = 4;
/// A model that leaves more than half the power of what the motion made of the payload, in any channel, does not
/// describe it: a constant in its place would hardly do worse. Causes that people live with (drift, a cable, poor
/// calibration) stay below: 0.45 in the worst recording at hand.
constexpr double kDescribes = 0.7;
/// A load's torque is compared at least with what its weight makes at this distance [m].
constexpr double kLeastLever = 0.01;
constexpr double kNormal = 1.4826;  // Standard deviation over median size

double typicalSize(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return kNormal * median(std::move(values));
}

/// Standard deviation of means of `n` successive values of the noise.
double meanStd(const ArModel& noise, Eigen::Index n) {
  constexpr std::size_t kLongestResponse = 2000;  // Values after which the response to one has died away
  std::vector<double> response{1.0};
  double sum = 0.0, square = 0.0;
  for (std::size_t m = 0; m < kLongestResponse; ++m) {
    sum += response[m];
    if (m >= static_cast<std::size_t>(n)) sum -= response[m - static_cast<std::size_t>(n)];
    square += sum * sum;
    double next = 0.0;
    for (Eigen::Index i = 0; i < noise.order() && static_cast<std::size_t>(i) <= m; ++i)
      next += noise.coefficients(i) * response[m - static_cast<std::size_t>(i)];
    response.push_back(next);
  }
  return noise.sigma * std::sqrt(square) / static_cast<double>(n);
}

bool isOf(const std::string& code, std::initializer_list<const char*> codes) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

bool warned(const Findings& findings, std::initializer_list<const char*> codes) {
  return std::any_of(findings.begin(), findings.end(), [&](const Finding& finding) {
    return finding.severity == Severity::warning && isOf(finding.code, codes);
  });
}

std::string inOneLine(std::initializer_list<std::string> sentences) {
  std::string out;
  for (const auto& sentence : sentences)
    if (!sentence.empty()) out += (out.empty() ? "" : " ") + sentence;
  return out;
}

std::string patchOf(const EstimateReport& report, const conventions::Reading& reading) {
  const auto patch = conventions::metaPatch(report.conventions.stated, reading, report.mount, report.motionFromJoints);
  return patch.is_null() ? std::string() : patch.dump();
}

/// How much of the load the readings leave unexplained, read as suggested and as stated.
std::string evidenceOf(const conventions::Report& said) {
  // The sign alone changes nothing in how well a payload fits: it would have to be lighter than nothing.
  if (said.statedPayload.mass < 0.0 && said.statedMisfit.worst() < conventions::kFits)
    return heft::say("As stated, the tool would weigh {:.2f} kg.", said.statedPayload.mass);
  return heft::say(
      "With this interpretation the model misses {:.0f} % of the force and {:.0f} % of the torque that the motion "
      "causes; as stated it misses {:.0f} % and {:.0f} %.",
      100.0 * said.misfit.force, 100.0 * said.misfit.torque, 100.0 * said.statedMisfit.force,
      100.0 * said.statedMisfit.torque);
}

/// The way to read the file as physics suggests.
std::string howToReadSo(const EstimateReport& report, const conventions::Reading& reading) {
  const std::string patch = patchOf(report, reading);
  return patch.empty() ? std::string() : remedy(Remedy::readSo, patch);
}

std::string tiesOf(const EstimateReport& report) {
  std::string out;
  for (const auto& tie : report.conventions.ties)
    out += (out.empty() ? "" : " ") + heft::say("Fits equally well: {}", tie.sentence);
  return out;
}

/// Empty if nothing takes all trust from the numbers.
NoTrust whyNone(const EstimateReport& report, const Unseen& unseen) {
  const conventions::Report& said = report.conventions;
  if (!report.readAsSuggested && said.verdict != Verdict::asStated) {
    if (said.verdict == Verdict::none) return {said.sentence, said.check};
    const bool plain = said.verdict == Verdict::suggested;
    return {inOneLine({said.sentence, plain ? evidenceOf(said) : tiesOf(report)}),
            inOneLine({plain ? howToReadSo(report, *said.suggested) : said.decides, said.check})};
  }
  for (const Finding& finding : report.findings)
    if (finding.code == "wrench_sign") return {finding.text, finding.remedy};
  if (report.payload.mass < 0.0)
    return {heft::say("The fit gives a negative mass."),
            heft::say("Check the sign of the wrench and which column is which.")};
  if (!report.termination.usable)
    return {heft::say("The solver did not reach a solution: {}", report.termination.why),
            report.method == Method::map ? heft::say("Record a longer motion that tilts and turns the tool.")
                                         : heft::say("Use the method map.")};
  const Interval& mass = report.interval95.mass;
  const double width = mass.upper - mass.lower;
  if (report.identifiability.mass == Source::data &&
      (report.payload.mass > mass.upper + width || report.payload.mass < mass.lower - width))
    return {heft::say("The value of the mass is outside its own interval."),
            heft::say("Record a longer motion that tilts and turns the tool.")};
  if (unseen.worst() > kDescribes)
    return {heft::say("On held-out segments a rigid tool misses {:.0f} % of the force and {:.0f} % of the torque that "
                      "the motion causes.",
                      100.0 * unseen.force, 100.0 * unseen.torque),
            heft::say("Look for contact, a cable, or a sensor that was zeroed during the recording; 'heft diagnose' "
                      "names the cause.")};
  return {};
}

void withhold(EstimateReport& report) {
  Identifiability& id = report.identifiability;
  const auto lower = [](Source& source) {
    if (source == Source::data || source == Source::doubted) source = Source::none;
  };
  lower(id.mass);
  for (Source& source : id.com) lower(source);
  for (auto& row : id.inertia)
    for (Source& source : row) lower(source);
  id.weakDirections.clear();
  std::erase_if(report.findings, [](const Finding& finding) {
    return isOf(finding.code, {"stood_still", "swing_assumed", "contact_left_out", "trim_lifted", "misfit",
                               "wrench_sign", "prior_contradicts_data", "known_disagrees", "shape_contradicts_data",
                               "held_inside_shape", "mass_not_known", "com_not_known", "inertia_not_known",
                               "from_what_you_gave", "not_physical", "solver_not_usable", "weak_direction"});
  });
}

}  // namespace

std::string_view toString(Trust trust) {
  constexpr std::string_view kNames[] = {"good", "low", "none"};
  return kNames[static_cast<std::size_t>(trust)];
}

Unseen unseenOver(const Prepared& prepared,
                  const std::function<const SolverSolution&(Eigen::Index block)>& solutionOf) {
  const WrenchRows& blocks = prepared.blocks;
  const bool standing = blocks.rateHz <= 0.0;
  const Eigen::Index n = standing ? 1 : kAveraged;
  std::array<std::vector<double>, 6> left, change, load;
  for (const Run& run : prepared.runs) {
    Vector6d before = Vector6d::Zero(), beforeThat = Vector6d::Zero();
    Eigen::Index inRun = 0;
    for (Eigen::Index from = run.from; from + n <= run.to; from += n, ++inRun) {
      Vector6d missed = Vector6d::Zero(), made = Vector6d::Zero();
      for (Eigen::Index k = from; k < from + n; ++k) {
        const SolverSolution& solution = solutionOf(k);
        const Vector6d predicted = blocks.Y[static_cast<std::size_t>(k)] * solution.phi;
        made += predicted;
        missed += blocks.wrench.col(k) - predicted - solution.bias;
      }
      missed /= static_cast<double>(n);
      made /= static_cast<double>(n);
      for (int c = 0; c < 6; ++c) {
        const auto i = static_cast<std::size_t>(c);
        left[i].push_back(missed(c));
        load[i].push_back(made(c));
        if (!standing && inRun > 1) change[i].push_back(beforeThat(c) - 2.0 * before(c) + missed(c));
      }
      beforeThat = before;
      before = missed;
    }
  }
  Unseen out;
  constexpr double kMostOfNoise = 1.5;  // Times what the learned noise leaves that chance may make
  double loadF = 0.0, loadT = 0.0, noiseF = 0.0;
  Vector6d beyondNoise = Vector6d::Zero();
  for (int c = 0; c < 6; ++c) {
    const auto i = static_cast<std::size_t>(c);
    if (left[i].empty() || prepared.silent[i]) continue;
    const double size = typicalSize(left[i]);
    const double noise = change[i].empty() ? 0.0 : typicalSize(change[i]) / std::sqrt(6.0);
    // What is less than the noise does not show beside it.
    out.noise(c) = noise;
    const double beyond = size * size - noise * noise;
    out.left(c) = beyond > noise * noise ? std::sqrt(beyond) : 0.0;
    const ArModel& learned = prepared.noise.channels[i];
    const bool ofSensor = !standing && learned.gain() > 0.0 && learned.gain() <= kMostMemory;
    if (!ofSensor || out.left(c) > kMostOfNoise * meanStd(learned, n)) beyondNoise(c) = out.left(c);
    const Eigen::Map<const VectorXd> made(load[i].data(), static_cast<Eigen::Index>(load[i].size()));
    out.load(c) = std::sqrt((made.array() - made.mean()).square().mean());
    (c < 3 ? loadF : loadT) += out.load(c) * out.load(c) / 3.0;
    if (c < 3) noiseF += noise * noise / 3.0;
  }
  loadF = std::max(loadF, 9.0 * noiseF);  // Less does not show
  loadT = std::max(loadT, kLeastLever * kLeastLever * loadF);
  const double sizeF = std::sqrt(std::max(1e-18, loadF)), sizeT = std::sqrt(std::max(1e-18, loadT));
  out.force = out.left.head<3>().maxCoeff() / sizeF;
  out.torque = out.left.tail<3>().maxCoeff() / sizeT;
  out.forceBeyond = beyondNoise.head<3>().maxCoeff() / sizeF;
  out.torqueBeyond = beyondNoise.tail<3>().maxCoeff() / sizeT;
  return out;
}

void loseTrust(EstimateReport& report, const NoTrust& why) {
  report.trust = Trust::none;
  report.whyNoTrust = why.what;
  report.whatToDo = why.next;
  withhold(report);
  report.findings.push_back({Severity::warning, "no_trust", why.what, why.next, {}});
}

void doubtLabels(EstimateReport& report) {
  unsigned doubted = kNoNumber;
  for (const Finding& finding : report.findings) {
    const bool ofTorques = finding.code == "misfit" && !report.forcesMisfit;
    doubted |= doubtedBy(finding.severity, finding.code) & (ofTorques ? ~kMass : kAllNumbers);
  }
  if (doubted != kNoNumber && report.trust == Trust::good) report.trust = Trust::low;
  const auto doubt = [&](Numbers kind, Source& source) {
    if ((doubted & kind) != 0 && source == Source::data) source = Source::doubted;
  };
  Identifiability& id = report.identifiability;
  doubt(kMass, id.mass);
  for (Source& source : id.com) doubt(kCentre, source);
  for (auto& row : id.inertia)
    for (Source& source : row) doubt(kInertia, source);
}

void addReadingFindings(const Findings& read, EstimateReport& report) {
  report.findings.insert(report.findings.begin(), read.begin(), read.end());
  doubtLabels(report);
}

void judgeTrust(const Unseen& unseen, EstimateReport& report) {
  const conventions::Report& said = report.conventions;
  report.unseenForceShare = unseen.force;
  report.unseenTorqueShare = unseen.torque;
  if (report.readAsSuggested)
    report.findings.push_back({Severity::warning,
                               "read_as_suggested",
                               inOneLine({heft::say("The readings were interpreted differently from what is stated."),
                                          said.sentence, evidenceOf(said)}),
                               inOneLine({remedy(Remedy::keepReading, patchOf(report, *said.suggested)), said.check}),
                               {}});
  if (const NoTrust why = whyNone(report, unseen); !why.what.empty()) {
    loseTrust(report, why);
    return;
  }
  // Another name for the same payload is no reason for doubt.
  constexpr double kSameMass = 0.02, kSameCentre = 0.003;  // relative, [m]
  const bool tied = std::ranges::any_of(said.ties, [&](const conventions::Alternative& tie) {
    return std::abs(tie.payload.mass - said.payload.mass) > kSameMass * std::abs(said.payload.mass) ||
           (tie.payload.com - said.payload.com).norm() > kSameCentre;
  });
  if (tied)
    report.findings.push_back(
        {Severity::warning,
         "conventions_tie",
         inOneLine({report.readAsSuggested
                        ? heft::say("This recording fits this interpretation and others equally well.")
                        : heft::say("This recording fits the stated conventions and others equally well."),
                    tiesOf(report)}),
         said.decides,
         {}});
  report.findings.insert(report.findings.end(), said.cautions.begin(), said.cautions.end());
  report.forcesMisfit = report.forcesMisfit || unseen.forceBeyond > conventions::kFits;
  if (std::max(unseen.forceBeyond, unseen.torqueBeyond) > conventions::kFits && !warned(report.findings, {"misfit"}))
    report.findings.push_back(
        {Severity::warning,
         "misfit",
         heft::say("On held-out segments a rigid tool misses {:.0f} % of the force and {:.0f} % of the torque that the "
                   "motion causes.",
                   100.0 * unseen.force, 100.0 * unseen.torque),
         heft::say("Trust is low: the true values may lie outside the intervals. Look where the residual is large."),
         {}});
  doubtLabels(report);
}

}  // namespace heft
