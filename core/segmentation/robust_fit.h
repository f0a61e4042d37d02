#pragma once
// A rigid payload and constant biases fitted to windows of a recording much of which they may not explain.
#include <optional>
#include <vector>

#include "core/wrench/rows.h"

namespace heft {

/// Normal matrix of [Y, bias, y] and the unknowns [phi, bias], channels scaled by what they may miss.
using WindowMatrix = Eigen::Matrix<double, 17, 17>;
using FitVector = Eigen::Matrix<double, 16, 1>;

/// Information on the unknowns before the data: keeps directions that the motion does not excite where they are.
struct FitPrior {
  FitVector mean = FitVector::Zero();
  FitVector information;  ///< Diagonal, in units of the channels' allowances.
};
/// Hardly any: unexcited directions stay at zero instead of anywhere.
FitPrior weakPrior();
/// A first estimate at hand: trusted to 3 % of the mass and 5 mm of the centre at least.
FitPrior priorFrom(const Payload& payload, const Payload& std);

WindowMatrix normalMatrix(const WrenchRows& rows, const Vector6d& scale, Eigen::Index from, Eigen::Index to);
FitVector solveNormal(const WindowMatrix& N, const FitPrior& prior);
/// Sum of the squared scaled residuals that x leaves in a window.
double energyOf(const WindowMatrix& N, const FitVector& x);
/// Wrench that a fit leaves over, 6 x K.
Eigen::Matrix<double, 6, Eigen::Dynamic> residualOf(const WrenchRows& rows, const FitVector& x);

/// What a rigid model may miss in each channel without anything touching the tool: three times the sensor's own scatter
/// (from steps between neighbouring blocks of what a plain fit leaves over, blind to slow misfit and to contact), or
/// what delay, drift and cables usually do, up to 0.15 N and 0.015 N m.
Vector6d allowancesOf(const WrenchRows& rows);

/// The windows that a robust fit looks at.
struct FitWindows {
  std::vector<WindowMatrix> matrices;
  Eigen::Index length = 1;  ///< Blocks a window.
  double cap = 0.0;         ///< Energy beyond which a window is not free: kCap allowances in the root mean square.

  std::size_t size() const { return matrices.size(); }
};
FitWindows windowsOf(const WrenchRows& rows, const Vector6d& allowed);

struct CappedFit {
  FitVector x = FitVector::Zero();
  double energy = 0.0;  ///< Sum of the windows' energies, each at most the cap.
};
/// The fit with the least sum of window energies, each capped, over windows [from, to): windows beyond the cap are not
/// free and pull no further. Random starts and concentration on the windows below the cap (after Rousseeuw & Van
/// Driessen's fast LTS, 1999). Deterministic. `usable` (one a window, may be empty) leaves windows out.
CappedFit cappedFit(const FitWindows& windows, std::size_t from, std::size_t to, const std::vector<char>& usable,
                    const FitPrior& prior, int starts);

}  // namespace heft
