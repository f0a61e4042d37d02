#include "core/estimation/judgement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/base/time_span.h"
#include "core/math/linear_algebra.h"
#include "core/math/statistics.h"
#include "core/recording/channels.h"

namespace heft {

Residuals residualsOver(const Prepared& prepared,
                        const std::function<const SolverSolution&(Eigen::Index block)>& solutionOf) {
  Vector6d sum = Vector6d::Zero();
  double count = 0.0;
  const int perBlock = prepared.blocks.samplesPerBlock;
  for (const auto& run : prepared.runs)
    for (Eigen::Index block = run.from; block < run.to; ++block) {
      const SolverSolution& solution = solutionOf(block);
      for (Eigen::Index k = block * perBlock; k < (block + 1) * perBlock; ++k) {
        const Motion& m = prepared.sampled();
        const Vector6d predicted =
            regressor({m.specificForce.col(k), m.omega.col(k), m.alpha.col(k)}) * solution.phi + solution.bias;
        sum += (m.wrench.col(k) - predicted).cwiseAbs2();
        count += 1.0;
      }
    }
  sum /= std::max(1.0, count);
  Residuals out;
  out.channels = sum.cwiseSqrt();
  const auto meanOver = [&](int first) {
    double squares = 0.0, channels = 0.0;
    for (int c = first; c < first + 3; ++c) {
      if (prepared.silent[static_cast<std::size_t>(c)]) continue;
      squares += sum(c);
      channels += 1.0;
    }
    return std::sqrt(squares / std::max(1.0, channels));
  };
  out.force = meanOver(0);
  out.torque = meanOver(3);
  return out;
}

Vector6d scatterOf(const Eigen::Matrix<double, 6, Eigen::Dynamic>& samples) {
  Vector6d out = Vector6d::Zero();
  for (int c = 0; c < 6; ++c) {
    std::vector<double> steps;
    for (Eigen::Index k = 1; k < samples.cols(); ++k)
      if (const double d = samples(c, k) - samples(c, k - 1); d != 0.0) steps.push_back(d);
    out(c) = robustStd(steps) / std::sqrt(2.0);
  }
  return out;
}

namespace {

/// What is slow and strong in a channel's residual is no sensor noise: long memory shows it, and so does a residual far
/// above its own scatter. Every channel is judged by its own noise; those that are not used are not counted.
void sayMisfit(const Prepared& prepared, const Residuals& heldout, const Unseen& unseen, EstimateReport& report) {
  constexpr double kStrong = 3.0;  // Times its scatter that a channel is missed
  constexpr double kSlow = 1.3;    // Times the scatter that slow noise must be
  struct Missed {
    double times = 0.0;  // The scatter
    std::string words;
  };
  std::array<std::optional<Missed>, 2> worst;  // Of the forces, and of the torques
  bool others = false;
  const Vector6d scatters = scatterOf(prepared.sampled().wrench);
  for (int c = 0; c < 6; ++c) {
    const auto i = static_cast<std::size_t>(c);
    if (prepared.silent[i] || prepared.usedDuration <= 0.0) continue;
    const double scatter = scatters(c);
    const double gain = prepared.noise.channels[i].gain();
    const bool strong = unseen.left(c) > kStrong * unseen.noise(c) && heldout.channels(c) > kStrong * scatter;
    const bool slow = !(gain > 0.0 && gain <= kMostMemory) && heldout.channels(c) > kSlow * scatter;
    if (!strong && !slow) continue;
    auto& kind = worst[c < 3 ? 0 : 1];
    others = others || kind.has_value();
    const double times = heldout.channels(c) / std::max(scatter, 1e-12);
    if (kind && kind->times >= times) continue;
    kind = {
        times,
        c < 3 ? heft::say("{} by {:.2g} N (sensor noise: {:.2g} N)", channelName(c), heldout.channels(c), scatter)
              : heft::say("{} by {:.2g} N m (sensor noise: {:.2g} N m)", channelName(c), heldout.channels(c), scatter)};
  }
  std::vector<std::string> missed;
  for (const auto& kind : worst)
    if (kind) missed.push_back(kind->words);
  if (missed.empty()) return;
  report.forcesMisfit = report.forcesMisfit || worst[0].has_value();
  if (others) missed.push_back(heft::say("others by less"));
  report.findings.push_back(
      {Severity::warning,
       "misfit",
       heft::say("On held-out segments the model misses {}: something other than a rigid tool affects the readings "
                 "(contact, drift, delay, a cable, a poorly calibrated sensor).",
                 joined(missed)),
       heft::say("Trust is low: the true values may lie outside the intervals. Look where the residual is large."),
       {}});
}

}  // namespace

void judgeFit(const Prepared& prepared, const Residuals& heldout, const Unseen& unseen, EstimateReport& report) {
  double contact = 0.0;
  std::vector<std::string> stretches;
  int listed = 0;
  for (const auto& segment : report.segments) {
    if (segment.label != MarkLabel::contact) continue;
    contact += segment.to - segment.from;
    if (++listed > 6) continue;
    stretches.push_back(timeSpan(std::max(0.0, segment.from), segment.to));
  }
  const std::string where = listed > 6 ? heft::say("{} and {} more", joined(stretches), listed - 6) : joined(stretches);
  const bool mostlyContact = contact > 0.3 * report.duration;
  if (contact > 0.0)
    report.findings.push_back(
        {mostlyContact ? Severity::warning : Severity::info,
         "contact_left_out",
         heft::say("{:.1f} s of {:.1f} s look like contact and were excluded: {}.", contact, report.duration, where),
         mostlyContact ? heft::say("This is too little free motion for a reliable result: check the marks, or record a "
                                   "longer free segment.")
                       : heft::say("Mark them by hand if that is wrong."),
         {}});

  sayMisfit(prepared, heldout, unseen, report);

  // A clearly negative mass is the other sign of the wrench. Linear fits say it; the map estimate cannot.
  if (report.identifiability.mass == Source::data || report.payload.mass < 0.0) {
    const MatrixXd A = prepared.whitened.leftCols<kColumns>();
    const VectorXd x = leastSquares(A, prepared.whitened.col(kColumns)).x;
    const double mass = x(kBiasColumns);
    const double sd = std::sqrt(std::max(0.0, pseudoInverse(transposedProduct(A, A))(kBiasColumns, kBiasColumns)));
    if (mass < -6.0 * sd && mass < -0.02)
      report.findings.push_back(
          {Severity::warning,
           "wrench_sign",
           heft::say("A plain fit gives a mass of {:.2f} kg: the wrench seems to have the opposite sign.", mass),
           remedy(Remedy::turnWrench),
           {}});
  }

  // Soft information that the data contradict. What the shape's material leaves open is judged with the shape.
  const auto& disagreement = report.evidence.disagreement;
  std::vector<std::string> parts;
  constexpr const char* kCentreAxes[] = {"x", "y", "z"};
  constexpr const char* kInertiaEntries[] = {"xx", "xy", "xz", "yy", "yz", "zz"};
  const auto nameOf = [&](int i) {
    return i == 0  ? heft::say("mass")
           : i < 4 ? heft::say("centre along {}", kCentreAxes[i - 1])
                   : heft::say("inertia {}", kInertiaEntries[i - 4]);
  };
  for (int i = 0; i < 10; ++i)
    if (std::abs(disagreement(i)) > 4.0)
      parts.push_back(heft::say("{} ({:.0f} sigma)", nameOf(i), std::abs(disagreement(i))));
  if (!parts.empty())
    report.findings.push_back(
        {Severity::warning,
         "prior_contradicts_data",
         heft::say("Your input disagrees with the measurement: {}.", joined(parts)),
         heft::say("Check that the values are for this tool and position, and the sensor's calibration. Trust is low."),
         {}});
}

void compareWithKnown(const PartialPayload& known, EstimateReport& report) {
  constexpr double kFar = 4.0;  // Own standard deviations
  constexpr double kMass = 0.03, kCentre = 0.003,
                   kMoment = 0.1;  // Hardly anybody knows a tool better: relative, [m], relative
  const auto warn = [&](const char* code, std::string text) {
    report.findings.push_back(
        {Severity::warning,
         code,
         std::move(text),
         heft::say("Check that the known value is for this tool, and the sensor's calibration. Trust is low."),
         {}});
  };
  const auto& id = report.identifiability;
  const double mass = known.mass && *known.mass > 0.0 ? std::abs(report.payload.mass - *known.mass) : 0.0;
  if (known.mass && id.mass == Source::data && mass > kMass * *known.mass && mass > kFar * report.std.mass)
    warn("known_disagrees", heft::say("The estimated mass is {:.0f} % off the known one, far outside its interval.",
                                      100.0 * mass / *known.mass));
  double centre = 0.0, moment = 0.0;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double off = known.com ? std::abs(report.payload.com(i) - (*known.com)(i)) : 0.0;
    if (id.com[k] == Source::data && off > kFar * report.std.com(i)) centre = std::max(centre, off);
    const double away = known.inertiaCom ? std::abs(report.payload.inertiaCom(i, i) - (*known.inertiaCom)(i, i)) : 0.0;
    if (id.inertia[k][k] == Source::data && away > kFar * report.std.inertiaCom(i, i))
      moment = std::max(moment, away / known.inertiaCom->diagonal().maxCoeff());
  }
  if (centre > kCentre)
    warn("known_centre_disagrees",
         heft::say("The estimated centre of mass is {:.0f} mm off the known one, far outside its interval.",
                   1e3 * centre));
  if (moment > kMoment)
    warn("known_inertia_disagrees",
         heft::say("The estimated inertia is {:.0f} % off the known one, far outside its interval.", 100.0 * moment));
}

void addFindings(EstimateReport& report) {
  const auto count = [](const auto& sources, Source wanted) {
    return std::count(sources.begin(), sources.end(), wanted);
  };
  const Identifiability& id = report.identifiability;
  if (id.mass == Source::none)
    report.findings.push_back({Severity::warning,
                               "mass_not_known",
                               heft::say("This motion does not determine the mass; the number is a placeholder."),
                               heft::say("Tilt the tool in several directions."),
                               {}});
  if (count(id.com, Source::none) > 0)
    report.findings.push_back(
        {Severity::warning,
         "com_not_known",
         heft::say(
             "This motion does not determine the whole centre of mass; what is marked \"none\" is a placeholder."),
         heft::say("Tilt the tool about more axes."),
         {}});
  int unknown = 0;
  for (std::size_t i = 0; i < 3; ++i) unknown += id.inertia[i][i] == Source::none ? 1 : 0;
  if (unknown > 0 && report.parameters == ParameterSet::full)
    report.findings.push_back({Severity::warning,
                               "inertia_not_known",
                               heft::say("This motion does not determine {} of the three moments of inertia; they are "
                                         "placeholders with wide intervals.",
                                         unknown),
                               heft::say("Rotate the tool faster, or specify its shape."),
                               {}});
  std::vector<std::string> given;
  const auto lean = [&](bool part, std::string name) {
    if (part) given.push_back(std::move(name));
  };
  if (report.parameters == ParameterSet::full && report.evidence.hasPrior) {
    lean(id.mass == Source::prior, heft::say("mass"));
    lean(count(id.com, Source::prior) > 0, heft::say("centre of mass"));
    lean(id.inertia[0][0] == Source::prior || id.inertia[1][1] == Source::prior || id.inertia[2][2] == Source::prior,
         heft::say("inertia"));
  }
  if (!given.empty())
    report.findings.push_back(
        {Severity::info,
         "from_what_you_gave",
         heft::say("These values come mainly from your input, not from the motion: {}.", joined(given)),
         {},
         {}});
  if (!report.physicallyConsistent)
    report.findings.push_back(
        {Severity::warning,
         "not_physical",
         heft::say("These values are physically impossible: {}", checkPhysical(report.payload).reason),
         report.method == Method::map ? heft::say("Specify its shape, or record a motion that rotates the tool faster.")
                                      : heft::say("Use the method map, which always gives a possible payload."),
         {}});
  if (!report.termination.usable)
    report.findings.push_back({Severity::warning,
                               "solver_not_usable",
                               heft::say("The solver did not reach a trustworthy solution: {}", report.termination.why),
                               heft::say("Use the method map."),
                               {}});
  for (const auto& words : id.weakDirections)
    report.findings.push_back({Severity::info, "weak_direction", words, {}, {}});
}

}  // namespace heft
