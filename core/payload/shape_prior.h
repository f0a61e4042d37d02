#pragma once
// What a shape says about the ten inertial parameters before, and together with, the data.
//
// The tool's material is spread over the points x_k of its bodies (volumes V_k) with an unknown density that is a
// log-normal random field: ln rho(x) = ln 2500 kg/m3 + f(x), f normal with covariance
//     s0^2 + sb^2 [same body] + sp^2 [same piece of a CAD assembly] + sg^2 exp(-|x - y|^2 / (2 L^2)),
// L the tool's radius of gyration: one unknown level, parts of different materials, and a smooth rest for what the mesh
// does not show. On top each body may be a little wrong: x is mapped by an upper triangular affine map with stretches,
// shears and a shift that are small normal numbers, which is V in P = U0 V V^T U0^T. Everything is positive mass inside
// a slightly deformed shape, so every value is physically possible, and the inertia follows a measured centre of mass
// the way the material of a real tool does. How sure the user is (Certainty) sets the standard deviations.
#include <vector>

#include "core/payload/shape.h"

namespace heft {

/// Standard deviations behind a certainty.
struct ShapeTrust {
  double stretch;  ///< Of each dimension, relative.
  double shear;    ///< Relative.
  double shift;    ///< Of the place, in the body's own standard deviations along that axis.
  double pieces;   ///< sp, of the logarithm of the density between pieces of a mesh.
  double within;   ///< sg, of the logarithm of the density within a body.
  double density;  ///< Of a density that the user gave, relative.
};

/// A CAD mesh is trusted more than a primitive put over the tool by hand. `parts` counts bodies and pieces: where the
/// parts are known, each is more likely of one material.
ShapeTrust trustIn(Certainty certainty, BodyKind kind, int parts);

/// The most probable payload for some data, and the prior seen from there.
class SymmetricSolver;

struct ShapeFit {
  Vector10d phi = Vector10d::Zero();
  Matrix10d covariance = Matrix10d::Zero();       ///< Of phi, prior and data together (Laplace).
  Matrix10d priorCovariance = Matrix10d::Zero();  ///< Of phi, prior alone, linear about phi.

  /// The prior as a normal distribution in the coordinates v = [delta_1, delta_2, delta_3, v12, v13, v23, v14, v24,
  /// v34, delta_4] of P = U0 V V^T U0^T (v_ii = exp(delta_i)), linear about phi = P(v = 0). A Gauss-Newton solve with
  /// it and the same data stops at v = 0 with the same covariance.
  Matrix4d U0 = Matrix4d::Identity();
  Vector10d mean = Vector10d::Zero();
  Matrix10d information = Matrix10d::Identity();

  std::vector<double> bodyMass;     ///< [kg] of each body
  std::vector<double> bodyMassStd;  ///< [kg]
  /// Sum of the squared normal numbers that the data ask of the prior: about the number of directions that the data
  /// tell, at most 10; above 30 (0.1 %) the shape and the data contradict each other.
  double conflict = 0.0;
  int iterations = 0;
  bool converged = false;
};

class ShapePrior {
 public:
  /// `samples` from sampleShape(shape). Masses and densities of bodies and the total mass are soft information: 0.5 %
  /// for what a scale shows, a density by trust.
  ShapePrior(const Shape& shape, const std::vector<BodySamples>& samples);

  /// Minimises |A phi - y|^2 + |prior residuals|^2; rows of A and y (m x 10, m) are whitened, m may be 0.
  ShapeFit fit(const MatrixXd& A, const VectorXd& y) const;

  /// Number of unknowns behind the prior, each standard normal: the field's modes first, then nine of each body's
  /// deformation.
  Eigen::Index size() const { return modes_ + 9 * static_cast<Eigen::Index>(bodies_.size()); }
  /// phi and its derivative (10 x size) at these unknowns.
  Vector10d parameters(const VectorXd& q, MatrixXd* jacobian = nullptr) const;

 private:
  struct Body {
    Eigen::Index first = 0, count = 0;  ///< Its points.
    Matrix4d U = Matrix4d::Identity();  ///< X_SB times the upper factor of its pseudo-inertia in B at 1 kg.
    Matrix4d inverseU = Matrix4d::Identity();
    ShapeTrust trust{};
  };
  /// ln of a body's mass (or of all) is `value` with standard deviation `sd`.
  struct MassObservation {
    int body;  ///< -1: the sum.
    double value, sd;
  };

  VectorXd masses(const VectorXd& q) const;  ///< Of all points [kg].
  void observe(const VectorXd& q, VectorXd& residuals, MatrixXd* jacobian) const;
  /// Mass of each body and its standard deviation.
  void weighBodies(const VectorXd& q, const SymmetricSolver& posterior, ShapeFit& result) const;

  std::vector<Body> bodies_;
  std::vector<MassObservation> observations_;
  Eigen::Matrix<double, 10, Eigen::Dynamic> basis_;  ///< Parameters of 1 kg at each point.
  VectorXd logMass_;                                 ///< Of each point at the mean density.
  MatrixXd field_;                                   ///< Points x modes: f = field * q.
  Eigen::Index modes_ = 0;
};

}  // namespace heft
