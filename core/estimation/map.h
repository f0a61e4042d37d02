#pragma once
// Maximum a posteriori estimate in coordinates in which every payload is physically possible.
//
// P = U0 V V^T U0^T with P0 = U0 U0^T the prior's pseudo-inertia and V upper triangular with positive diagonal
// v_ii = exp(delta_i). Coordinates v = [delta_1, delta_2, delta_3, v12, v13, v23, v14, v24, v34, delta_4]:
// delta_4 is half the logarithm of the mass ratio, (v14, v24, v34) / v44 the shift of the centre of mass in the prior
// body's own standard deviations, the first six its shape (Rucker & Wensing 2022, corrected; Lee, Wensing, Park 2020).
#include <vector>

#include "core/estimation/linear_problem.h"
#include "core/payload/stated_payload.h"

namespace heft {

/// Upper-triangular U with P = U U^T. Throws std::invalid_argument unless P is positive definite.
Matrix4d upperFactor(const Matrix4d& P);

/// How far v is from the prior.
enum class PriorForm {
  normal,    ///< (v - mean)^T information (v - mean)
  entropic,  ///< sum_i w_i (exp(2 delta_i) - 2 delta_i - 1) / 2 + sum_ij w_ij v_ij^2, w the diagonal of `information`:
             ///< with w_ij = w_i / 2 = const the entropic divergence tr(P0^-1 P) - ln(|P| / |P0|) - 4 (Lee, Wensing,
             ///< Park 2020), here with mass, centre and shape weighted apart. A barrier where a body becomes
             ///< impossible.
};

/// A stated payload Ps = Us Us^T as ten numbers that are standard normal if it is right. With W = Us^-1 U for the
/// payload P = U U^T: ln w_ii / w_44 (i < 4) and w_ij / w_44 over the shape's standard deviation, w_i4 / w_44 over the
/// centre's, ln w_44 over half of the mass's, the logarithms d as sign(d) sqrt((exp(2 d) - 2 d - 1) / 2). With equal
/// weights this is the entropic divergence of the two bodies at equal mass plus that of their masses; what is not
/// stated has the weight zero.
struct StatedTerm {
  Matrix4d inverseU = Matrix4d::Identity();  ///< Us^-1
  Vector10d weight = Vector10d::Zero();      ///< 1 / standard deviation, in the order of v
};
StatedTerm termFrom(const StatedPayload& stated);

/// What is believed of v before the data, relative to P0 = U0 U0^T.
struct MapPrior {
  Matrix4d U0 = Matrix4d::Identity();
  Vector10d mean = Vector10d::Zero();
  Matrix10d information = Matrix10d::Identity();
  PriorForm form = PriorForm::normal;
  std::vector<StatedTerm> stated;  ///< Further independent information.

  /// Twice the negative logarithm of the density, its gradient halved, and its (positive) curvature.
  double cost(const Vector10d& v) const;
  Vector10d halfGradient(const Vector10d& v) const;
  Matrix10d curvature(const Vector10d& v) const;
  /// Information of the prior as a normal distribution, linear about v: the curvature that an entropic form has at its
  /// mean, where its density lies, instead of at v.
  Matrix10d normalInformation(const Vector10d& v) const;

 private:
  Matrix10d statedInformation(const Vector10d& v, Vector10d* halfGradient) const;
};

/// A tool of hand size about which nothing is known: mass within a factor of 20, centre within 30 cm of `com`, radius
/// of gyration 5 cm within a factor of about 5 (all at two standard deviations). Its weight against data is negligible.
/// `spread` [m2] is the covariance of the mass about its centre.
MapPrior vaguePrior(double mass, const Vector3d& com,
                    const Matrix3d& spread = kUsualRadius * kUsualRadius * Matrix3d::Identity());

Vector10d parametersFromV(const MapPrior& prior, const Vector10d& v);
/// d phi / d v, 10 x 10.
Matrix10d parametersJacobian(const MapPrior& prior, const Vector10d& v);
/// The same ten numbers and weights as linear rows in phi: |A phi - y|^2 near `phi`, which must be physical.
struct LinearTerm {
  Matrix10d A;
  Vector10d y;
};
LinearTerm linearised(const StatedTerm& term, const Vector10d& phi);

/// The coordinates of a physical payload. Throws std::invalid_argument for another.
Vector10d vFromParameters(const MapPrior& prior, const Vector10d& phi);

struct MapSolution {
  Vector10d v = Vector10d::Zero();
  Vector10d phi = Vector10d::Zero();
  Vector6d bias = Vector6d::Zero();
  Matrix10d dataInformation = Matrix10d::Zero();  ///< J^T A^T A J in v, biases eliminated
  Matrix10d covariance = Matrix10d::Zero();       ///< of v: inverse of data plus prior information (Laplace)
  int iterations = 0;
  bool converged = false;
};

/// |R [bias; phi(v); -1]|^2 + prior.cost(v) with the best biases put in (or zero without `bias`): twice the negative
/// logarithm of the posterior density.
class MapCost {
 public:
  MapCost(const Triangle& R, const MapPrior& prior, bool bias);
  double operator()(const Vector10d& v) const;
  const MatrixXd& A() const { return A_; }
  const VectorXd& y() const { return y_; }

 private:
  const MapPrior& prior_;
  MatrixXd A_;
  VectorXd y_;
};

/// Minimises |R [bias; phi(v); -1]|^2 + prior.cost(v) by Gauss-Newton with Levenberg damping.
/// `R` must be whitened. Without `bias` the six biases are held at zero.
MapSolution solveMap(const Triangle& R, const MapPrior& prior, bool bias, const Vector10d& start);

/// Everything of a solution at given coordinates, as if a solver had stopped there (`converged` is left false).
MapSolution solutionAt(const Triangle& R, const MapPrior& prior, bool bias, const Vector10d& v);

/// The prior about v as linear rows in phi, for solvers of linear least squares: their sum of squares is the prior's
/// quadratic approximation there.
Triangle priorRows(const MapPrior& prior, const Vector10d& v);

}  // namespace heft
