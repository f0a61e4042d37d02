#pragma once
// What this motion can tell: shares of data and prior, and the weak directions in words.
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/estimation/linear_problem.h"
#include "core/payload/inertial_parameters.h"

namespace heft {

struct MapPrior;
struct MapSolution;
struct Motion;
struct ToldParts;

/// Where a number comes from.
enum class Source {
  data,     ///< Measured: the data alone tell it.
  doubted,  ///< So, but a finding says that it may be off by more than its interval: not called measured.
  prior,    ///< From the shape or values that the user gave.
  none,     ///< Not known: a placeholder of plausible size with a wide interval.
};
/// "data", "prior" or "none"; what is doubted is no data, and listed beside (report.h).
std::string_view toString(Source source);

struct Identifiability {
  Source mass = Source::none;
  std::array<Source, 3> com{Source::none, Source::none, Source::none};
  std::array<std::array<Source, 3>, 3> inertia{{{Source::none, Source::none, Source::none},
                                                {Source::none, Source::none, Source::none},
                                                {Source::none, Source::none, Source::none}}};
  VectorXd singularValues;       ///< Of the same matrix, the largest first; empty where a column is zero.
  double conditionNumber = 0.0;  ///< Of the whitened regressor, biases eliminated, columns scaled to unit length.
  double massShare = 0, comShare = 0, inertiaShare = 0;  ///< Share of the data (1) against the prior (0).
  /// The ten independent directions in which data and prior were weighed against each other, the best known first.
  struct Direction {
    double dataShare = 0;  ///< lambda / (1 + lambda), lambda of (data information, prior information)
    std::string about;     ///< What it mostly is: "mass", "rotation about the tool's long axis".
  };
  std::vector<Direction> directions;
  std::vector<std::string> weakDirections;  ///< In words: what this motion told too little about.
};

/// Singular values of the trailing 10 columns of a whitened triangle, each scaled to unit length; empty if one is zero.
VectorXd scaledSingularValues(const Triangle& R);
/// Their condition number; infinite if singular.
double scaledCondition(const Triangle& R);

/// Judges a map solution. What the user told something about comes from the prior where the data tell less than half of
/// it. What nobody told is not identified if its relative standard deviation exceeds 30 % (Gautier): mass relative to
/// itself, centre of mass to the body's radius of gyration, inertia to the geometric mean of its two moments.
/// `std` holds the map solution's standard deviations.
Identifiability assess(const Triangle& R, const MapPrior& prior, const MapSolution& solution, const Payload& std,
                       const ToldParts& told);

/// Says which rotation or tilt was missing for what is not measured, in terms of the tool's own axes where it has any.
/// Nothing of what a channel that says nothing would have shown: no motion makes up for it.
std::vector<std::string> weakDirections(const Identifiability& identifiability, const Motion& motion,
                                        const Payload& payload, const std::array<bool, 6>& silent);

}  // namespace heft
