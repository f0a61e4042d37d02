#include "core/estimation/joint.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/estimation/estimate_prepared.h"
#include "core/estimation/judgement.h"
#include "core/estimation/prior.h"
#include "core/estimation/triangle.h"
#include "core/estimation/uncertainty.h"
#include "core/math/linear_algebra.h"

namespace heft {

namespace {

constexpr double kWorthwhile = 1.10;                     // an interval that is this much wider without a recording
constexpr double kContradiction = 25.0;                  // chi-squared, 4 degrees of freedom: p = 5e-5
constexpr double kMassFloor = 0.005, kComFloor = 0.001;  // relative, [m]: calibration and mounting, one deviation

using Clock = std::chrono::steady_clock;

/// A map solution in the numbers of a payload.
struct Told {
  Vector10d components = Vector10d::Zero();
  Matrix10d covariance = Matrix10d::Identity();
};

/// What other recordings may know of this one: phi, without its biases.
Triangle withoutBias(const Triangle& R, bool bias) {
  if (!bias) return R;
  Triangle out = Triangle::Zero();
  out.bottomRightCorner<kColumns + 1 - kBiasColumns, kColumns + 1 - kBiasColumns>() =
      R.bottomRightCorner<kColumns + 1 - kBiasColumns, kColumns + 1 - kBiasColumns>();
  return out;
}

class Joiner {
 public:
  Joiner(const EstimateOptions& options, std::vector<Triangle> triangles)
      : options_(options), triangles_(std::move(triangles)) {}

  Result<Told> told(const std::vector<std::size_t>& members) const {
    std::vector<Triangle> parts;
    for (const std::size_t i : members) parts.push_back(triangles_[i]);
    const Triangle R = merged(parts);
    Findings ignored;
    auto prior = priorFor(options_, R, ignored);
    if (!prior) return prior.error();
    const MapSolution map = solveMap(R, prior->prior, options_.bias, prior->start);
    const Matrix10d J = componentsJacobian(map.phi) * parametersJacobian(prior->prior, map.v);
    return Told{componentsOf(fromParameters(map.phi)), J * map.covariance * J.transpose()};
  }
  const Triangle& triangle(std::size_t i) const { return triangles_[i]; }

 private:
  const EstimateOptions& options_;
  std::vector<Triangle> triangles_;
};

bool contradict(const Told& a, const Told& b) {
  const Eigen::Vector4d d = (a.components - b.components).head<4>();
  Eigen::Matrix4d S = (a.covariance + b.covariance).topLeftCorner<4, 4>();
  const double mass = kMassFloor * std::max(a.components(0), b.components(0));
  S.diagonal() += Eigen::Vector4d(mass * mass, kComFloor * kComFloor, kComFloor * kComFloor, kComFloor * kComFloor);
  return d.dot(solveSymmetric(S, d)) > kContradiction;
}

/// Its numbers mean what is taken for them.
bool isUnderstood(const Prepared& prepared) {
  return prepared.readAsSuggested || !prepared.conventions ||
         prepared.conventions->verdict == conventions::Verdict::asStated;
}

/// The largest set of recordings that agree with one of them; of equal ones the first. What is not understood agrees
/// with nothing, unless nothing is.
std::vector<std::size_t> agreeing(const std::vector<Told>& alone, const std::vector<Prepared>& prepared) {
  const bool any = std::any_of(prepared.begin(), prepared.end(), isUnderstood);
  std::vector<std::size_t> best;
  for (std::size_t i = 0; i < alone.size(); ++i) {
    if (any && !isUnderstood(prepared[i])) continue;
    std::vector<std::size_t> set;
    for (std::size_t j = 0; j < alone.size(); ++j)
      if (any && !isUnderstood(prepared[j]))
        continue;
      else if (i == j || !contradict(alone[i], alone[j]))
        set.push_back(j);
    if (set.size() > best.size()) best = set;
  }
  return best;
}

struct Sizes {
  double mass, com, inertia;
};
Sizes sizesOf(const Told& told) {
  const Vector10d variance = told.covariance.diagonal().cwiseMax(1e-30);
  return {std::sqrt(variance(0)), std::sqrt(variance.segment<3>(1).sum()), std::sqrt(variance.tail<6>().sum())};
}

InformationGain gainOf(const Told& with, const Told& without) {
  InformationGain gain;
  gain.components = without.covariance.diagonal().cwiseQuotient(with.covariance.diagonal().cwiseMax(1e-30)).cwiseSqrt();
  const Sizes a = sizesOf(with), b = sizesOf(without);
  gain.mass = b.mass / a.mass;
  gain.com = b.com / a.com;
  gain.inertia = b.inertia / a.inertia;
  return gain;
}

double largest(const InformationGain& gain) { return std::max({gain.mass, gain.com, gain.inertia}); }
double volume(const Sizes& s) { return std::log(s.mass) + std::log(s.com) + std::log(s.inertia); }

/// Begins with the recording that tells most and adds the one that helps most while an interval shrinks by a tenth.
Result<std::vector<std::size_t>> propose(const Joiner& joiner, std::vector<std::size_t> rest) {
  std::vector<std::size_t> chosen;
  Told best;
  while (!rest.empty()) {
    std::size_t next = rest.size();
    Told nextTold;
    for (std::size_t r = 0; r < rest.size(); ++r) {
      chosen.push_back(rest[r]);
      const auto told = joiner.told(chosen);
      chosen.pop_back();
      if (!told) return told.error();
      if (next == rest.size() || volume(sizesOf(*told)) < volume(sizesOf(nextTold))) {
        next = r;
        nextTold = *told;
      }
    }
    if (!chosen.empty() && largest(gainOf(nextTold, best)) < kWorthwhile) break;
    best = nextTold;
    chosen.push_back(rest[next]);
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(next));
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::string listed(const std::vector<std::size_t>& indices) {
  std::string text;
  for (std::size_t i = 0; i < indices.size(); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : i + 1 == indices.size() ? " and " : ", ", indices[i] + 1);
  return text;
}

std::string proposalWords(const std::vector<JointPiece>& pieces, const std::vector<std::size_t>& proposal) {
  std::vector<std::size_t> idle, foreign, strange;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].used)
      (pieces[i].report.trust == Trust::none ? strange : foreign).push_back(i);
    else if (std::find(proposal.begin(), proposal.end(), i) == proposal.end())
      idle.push_back(i);
  }
  std::string text = idle.empty() && foreign.empty() && strange.empty() ? "Use all of them" : "Use " + listed(proposal);
  if (!idle.empty()) text += fmt::format("; {} add{} nothing", listed(idle), idle.size() == 1 ? "s" : "");
  if (!foreign.empty())
    text += fmt::format("; {} {} of another tool", listed(foreign), foreign.size() == 1 ? "is" : "are");
  if (!strange.empty())
    text += fmt::format("; {} {} not understood", listed(strange), strange.size() == 1 ? "is" : "are");
  return text + ".";
}

std::string gainWords(const InformationGain& gain) {
  if (largest(gain) < kWorthwhile) return heft::say("Adds next to nothing: without it the intervals are as narrow.");
  return heft::say("Without it the intervals of mass, centre and inertia are {:.1f}, {:.1f} and {:.1f} times as wide.",
                   gain.mass, gain.com, gain.inertia);
}

/// The numbers rest on all that are used, and so does the trust in them.
void shareTrust(JointReport& out) {
  EstimateReport& result = out.pieces[out.first].report;
  for (std::size_t i = 0; i < out.pieces.size(); ++i) {
    const EstimateReport& own = out.pieces[i].report;
    if (i == out.first || !out.pieces[i].used || own.trust <= result.trust) continue;
    if (own.trust == Trust::none) {
      loseTrust(result, {heft::say("Recording {}:", i + 1) + " " + own.whyNoTrust, own.whatToDo});
    } else {
      result.trust = own.trust;
      result.findings.push_back(
          {Severity::warning,
           "low_trust_of_one",
           heft::say("Recording {} is not reliable, so neither are the numbers from all of them.", i + 1),
           heft::say("Look at its findings, or leave it out."),
           {}});
      doubtLabels(result);
    }
  }
}

/// `components`: of all that are used.
void sayLeftOut(const std::vector<Prepared>& prepared, const Vector10d& components, JointReport& out) {
  for (std::size_t i = 0; i < out.pieces.size(); ++i)
    if (!out.pieces[i].used && !isUnderstood(prepared[i]))
      out.pieces[out.first].report.findings.push_back(
          {Severity::warning,
           "recording_not_understood",
           heft::say("Recording {} was left out:", i + 1) + " " + out.pieces[i].report.whyNoTrust,
           out.pieces[i].report.whatToDo,
           {}});
    else if (!out.pieces[i].used)
      out.pieces[out.first].report.findings.push_back(
          {Severity::warning,
           "different_tool",
           heft::say("Recording {} contradicts the others: {:.3f} kg against {:.3f} kg, centre of mass {:.0f} mm "
                     "apart. It was excluded.",
                     i + 1, out.pieces[i].alone.mass, components(0),
                     1e3 * (out.pieces[i].alone.com - Vector3d(components.segment<3>(1))).norm()),
           out.pieces.size() == 2
               ? heft::say("With two recordings it is not clear which one has the right tool: check both.")
               : heft::say("Estimate it separately."),
           {}});
}

}  // namespace

Result<JointReport> estimateJointly(std::span<const JointInput> inputs, const EstimateOptions& options,
                                    const Progress& progress) {
  if (inputs.empty()) return Error{"There is no recording to estimate from."};
  if (options.method != Method::map || options.parameters != ParameterSet::full)
    return Error{
        "Several recordings are joined by the method map with all parameters; leave --method and --parameters away, or "
        "estimate each recording by itself."};
  const auto begin = Clock::now();
  std::vector<Prepared> prepared;
  std::vector<Triangle> triangles;
  for (const auto& input : inputs) {
    auto one = prepareFor(*input.recording, input.robot, options, progress);
    if (!one)
      return Error{fmt::format("{}: {}", printable(input.recording->file, 200), one.error().message),
                   one.error().cancelled};
    triangles.push_back(withoutBias(one->whitened, options.bias));
    prepared.push_back(std::move(*one));
  }
  const double prepareSeconds = std::chrono::duration<double>(Clock::now() - begin).count();

  const Joiner joiner(options, triangles);
  std::vector<Told> alone;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    auto told = joiner.told({i});
    if (!told) return told.error();
    alone.push_back(*told);
  }
  const std::vector<std::size_t> used = agreeing(alone, prepared);
  const auto all = joiner.told(used);
  if (!all) return all.error();

  JointReport out;
  out.first = used.front();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (progress.cancelled()) return Error{"Stopped.", true};
    JointPiece piece;
    piece.used = std::find(used.begin(), used.end(), i) != used.end();
    piece.alone = payloadFromComponents(alone[i].components);
    piece.aloneStd = payloadFromComponents(alone[i].covariance.diagonal().cwiseMax(0.0).cwiseSqrt());
    std::vector<Triangle> others;
    std::vector<std::size_t> rest;
    for (const std::size_t j : used)
      if (j != i) {
        others.push_back(triangles[j]);
        rest.push_back(j);
      }
    if (!piece.used) others.clear();
    auto report = estimatePrepared(*inputs[i].recording, prepared[i], options, others, prepareSeconds, progress);
    if (!report) return report.error();
    piece.report = std::move(*report);
    if (!piece.used && !isUnderstood(prepared[i])) {
      piece.words = piece.report.whyNoTrust;
    } else if (!piece.used) {
      piece.words = heft::say("From another tool: by itself it gives {:.3f} kg, the others give {:.3f} kg.",
                              piece.alone.mass, all->components(0));
    } else if (rest.empty()) {
      piece.words = heft::say("The only one that is used.");
    } else {
      const auto without = joiner.told(rest);
      if (!without) return without.error();
      piece.adds = gainOf(*all, *without);
      piece.words = gainWords(piece.adds);
    }
    out.pieces.push_back(std::move(piece));
  }
  auto proposal = propose(joiner, used);
  if (!proposal) return proposal.error();
  out.proposal = std::move(*proposal);
  out.proposalText = proposalWords(out.pieces, out.proposal);
  shareTrust(out);
  sayLeftOut(prepared, all->components, out);
  return out;
}

}  // namespace heft
