#pragma once
// Intervals for every reported number.
#include <functional>

#include "core/estimation/map.h"
#include "core/payload/payload_interval.h"

namespace heft {

/// What files hold, as one vector: mass, com, Ixx, Ixy, Ixz, Iyy, Iyz, Izz about the centre of mass.
Vector10d componentsOf(const Payload& payload);
Payload payloadFromComponents(const Vector10d& components);
/// d components / d phi at phi.
Matrix10d componentsJacobian(const Vector10d& phi);

/// What the rows alone say of phi, linear and without any prior.
struct PlainFit {
  Vector10d phi;
  Matrix10d covariance;
};
/// Least squares on the rows below the biases, or on all of them without `bias`. What no row tells gets a standard
/// deviation of 100, far more than a tool can have, instead of none.
PlainFit plainFit(const Triangle& R, bool bias);

/// The same rows and the same best phi, with `more` added to phi's covariance: for what was found in the same readings
/// and is not sure, such as how the sensor is turned.
Triangle lessSure(const Triangle& R, const Matrix10d& more);

/// 95 % intervals by draws of v near the posterior's mode, weighted by the posterior itself (importance sampling) and
/// carried through to the payload: intervals of positive quantities stay positive, and skewed ones are skewed.
/// Deterministic: the draws are fixed and come in opposite pairs. `R` and `bias` are those that the solution was found
/// with. `bound`, if given, moves the draws' phi to the nearest allowed one: the posterior projected on a bound (Dunson
/// and Neelon 2003, doi 10.1111/1541-0420.00035), so that the intervals keep to it, too.
PayloadInterval intervalsFromV(const Triangle& R, const MapPrior& prior, bool bias, const MapSolution& solution,
                               const std::function<Vector10d(const Vector10d&)>& bound = {});

/// value +- 1.96 standard deviations, for linear estimates with the covariance of the ten components.
PayloadInterval intervalsFromCovariance(const Vector10d& components, const Matrix10d& covariance);

/// The covariance divided by both standard deviations; 0 beside what has none, 1 on the diagonal.
Matrix10d correlationFrom(const Matrix10d& covariance);

/// Half the intervals' width over 1.96: the standard deviation of a normal distribution with these intervals.
Payload standardDeviations(const PayloadInterval& intervals);

}  // namespace heft
