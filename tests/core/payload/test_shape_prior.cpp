// The prior that a shape gives: identities of its derivatives and normal form, and what it is worth on simulated data.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "core/math/linear_algebra.h"
#include "core/payload/shape_prior.h"

namespace heft {
namespace {

constexpr double kGravity = 9.81;

Shape shapeOf(std::initializer_list<const char*> texts, Certainty certainty) {
  Shape shape;
  for (const char* text : texts) {
    const auto one = parseShape(text);
    EXPECT_TRUE(one.ok()) << (one.ok() ? "" : one.error().message);
    shape.bodies.push_back(one->bodies[0]);
  }
  shape.certainty = certainty;
  return shape;
}

std::vector<BodySamples> priorSamplesOf(const Shape& shape) {
  Findings findings;
  auto samples = sampleShape(shape, findings);
  EXPECT_TRUE(samples.ok()) << (samples.ok() ? "" : samples.error().message);
  return *samples;
}

ShapePrior priorOf(const Shape& shape) { return ShapePrior(shape, priorSamplesOf(shape)); }

const MatrixXd kNoRows(0, 10);
const VectorXd kNoValues(0);

/// Whitened rows, biases eliminated.
struct Data {
  MatrixXd A;
  VectorXd y;
};

/// Motions of the sensor: orientation by roll, pitch, yaw [rad] and position [m] over time.
using Motion = std::function<std::pair<Vector3d, Vector3d>(double)>;

/// Sums of sines, up to about 0.9 Hz * speed.
Motion freeMotion(int seed, double speed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  Eigen::Matrix<double, 6, 5> size, frequency, phase;
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 5; ++k) {
      frequency(i, k) = speed * (0.1 + 0.8 * uniform(random));
      size(i, k) = (i < 3 ? 0.4 : 0.07) * normal(random) / std::hypot(1.0, frequency(i, k) / 0.5);
      phase(i, k) = 2 * std::numbers::pi * uniform(random);
    }
  return [=](double t) {
    Vector6d x = Vector6d::Zero();
    for (int i = 0; i < 6; ++i)
      for (int k = 0; k < 5; ++k)
        x(i) += size(i, k) * std::sin(2 * std::numbers::pi * frequency(i, k) * t + phase(i, k));
    return std::pair<Vector3d, Vector3d>{x.head<3>(), x.tail<3>()};
  };
}

/// Moves of 0.9 s / speed between random poses with rests of half a second.
Motion stopAndGo(int seed, double speed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Vector6d> poses;
  for (int i = 0; i < 40; ++i) {
    Vector6d pose;
    for (int k = 0; k < 6; ++k) pose(k) = (k < 3 ? 0.9 : 0.15) * uniform(random);
    poses.push_back(pose);
  }
  return [=](double t) {
    const double move = 0.9 / speed, cycle = move + 0.5;
    const auto i = std::min<std::size_t>(static_cast<std::size_t>(t / cycle), poses.size() - 2);
    const double u = std::min(1.0, (t - static_cast<double>(i) * cycle) / move);
    const double f = u * u * u * (10 - 15 * u + 6 * u * u);
    const Vector6d x = poses[i] + f * (poses[i + 1] - poses[i]);
    return std::pair<Vector3d, Vector3d>{x.head<3>(), x.tail<3>()};
  };
}

/// The contract's equations as rows in [m, h, I], written out here once more.
Eigen::Matrix<double, 6, 10> wrenchRows(const Vector3d& w, const Vector3d& alpha, const Vector3d& aMinusG) {
  Eigen::Matrix<double, 6, 10> Y = Eigen::Matrix<double, 6, 10>::Zero();
  Y.block<3, 1>(0, 0) = aMinusG;
  Y.block<3, 3>(0, 1) = skew(alpha) + skew(w) * skew(w);
  Y.block<3, 3>(3, 1) = -skew(aMinusG);
  for (int k = 0; k < 6; ++k) {
    const Matrix3d I = inertiaTensor(Vector10d::Unit(4 + k));
    Y.block<3, 1>(3, 4 + k) = I * alpha + w.cross(I * w);
  }
  return Y;
}

Data simulate(const Motion& motion, double duration, const Vector10d& phi, double forceNoise, double torqueNoise,
              int seed) {
  constexpr double kRate = 100.0, kStep = 1e-3;
  std::mt19937 random(static_cast<unsigned>(seed));
  std::normal_distribution<double> normal;
  const auto rotation = [&](double t) { return rotationFromRpy(motion(t).first); };
  const auto velocity = [&](double t) {
    return Vector3d(vectorFromRotation(rotation(t - kStep).transpose() * rotation(t + kStep)) / (2 * kStep));
  };
  MatrixXd H = MatrixXd::Zero(16, 16);
  VectorXd g = VectorXd::Zero(16);
  Vector6d sd, bias;
  sd << Vector3d::Constant(forceNoise), Vector3d::Constant(torqueNoise);
  for (int k = 0; k < 6; ++k) bias(k) = (k < 3 ? 1.0 : 0.05) * normal(random);
  for (double t = 0.01; t < duration; t += 1 / kRate) {
    const Vector3d a = (motion(t + kStep).second - 2 * motion(t).second + motion(t - kStep).second) / (kStep * kStep);
    const Vector3d alpha = (velocity(t + kStep) - velocity(t - kStep)) / (2 * kStep);
    MatrixXd rows(6, 16);
    rows << Matrix6d::Identity(),
        wrenchRows(velocity(t), alpha, rotation(t).transpose() * (a + Vector3d(0, 0, kGravity)));
    VectorXd y = rows.rightCols(10) * phi + bias;
    for (int k = 0; k < 6; ++k) y(k) = (y(k) + sd(k) * normal(random)) / sd(k);
    rows = sd.cwiseInverse().asDiagonal() * rows;
    H += transposedProduct(rows, rows);
    g += rows.transpose() * y;
  }
  const MatrixXd gain = SymmetricSolver(H.topLeftCorner(6, 6)).solveAll(H.topRightCorner(6, 10));
  const MatrixXd information = H.bottomRightCorner(10, 10) - product(H.bottomLeftCorner(10, 6), gain);
  const VectorXd linear = g.tail(10) - gain.transpose() * g.head(6);
  const SymmetricEigen eigen = symmetricEigen(information);  // a square root also where directions are blind
  const VectorXd root = eigen.values.cwiseMax(1e-12 * eigen.values.maxCoeff()).cwiseSqrt();
  return {root.asDiagonal() * eigen.vectors.transpose(),
          root.cwiseInverse().asDiagonal() * (eigen.vectors.transpose() * linear)};
}

/// Rows that pin mass and first moments only, as rest in several orientations does.
Data standing(const Vector10d& phi, double relative) {
  Data data{MatrixXd::Zero(4, 10), VectorXd(4)};
  for (int k = 0; k < 4; ++k) data.A(k, k) = 1.0 / (relative * (k == 0 ? phi(0) : 0.1 * phi(0)));
  data.y = data.A * phi;
  return data;
}

double inertiaError(const Payload& got, const Payload& truth, const Matrix3d& R, const Vector3d& sides) {
  const Matrix3d difference = R * (got.inertiaCom - truth.inertiaCom) * R.transpose();
  const Matrix3d scale =
      truth.mass / 12.0 * (sides.squaredNorm() * Matrix3d::Identity() - sides * sides.transpose()).cwiseAbs();
  return 100.0 * difference.cwiseAbs().cwiseQuotient(scale).mean();
}

TEST(ShapePrior, DerivativeIsThatOfFiniteDifferences) {
  const ShapePrior prior =
      priorOf(shapeOf({"box:0.05,0.04,0.2@0,0,0.1", "cylinder:0.02,0.12@0.01,0,0.22,1.57,0,0.3"}, Certainty::rough));
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  VectorXd q(prior.size());
  for (double& x : q) x = normal(random);
  MatrixXd J;
  prior.parameters(q, &J);
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    const VectorXd h = 1e-5 * VectorXd::Unit(q.size(), k);
    const Vector10d numeric = (prior.parameters(q + h) - prior.parameters(q - h)) / 2e-5;
    EXPECT_LT((numeric - J.col(k)).norm(), 1e-6 * J.norm()) << "column " << k;
  }
}

TEST(ShapePrior, WithoutDataItIsTheHomogeneousBody) {
  const Shape shape = shapeOf({"box:0.1,0.06,0.2@0,0.02,0.1,0.3,0.2,0.1"}, Certainty::exact);
  const ShapeFit fit = priorOf(shape).fit(kNoRows, kNoValues);
  EXPECT_TRUE(fit.converged);
  const Vector10d expected =
      2500.0 * 0.1 * 0.06 * 0.2 * parametersFromPseudoInertia(priorSamplesOf(shape)[0].unitPseudoInertia);
  EXPECT_LT((fit.phi - expected).norm(), 1e-9 * expected.norm());
  EXPECT_NEAR(fit.mean.norm(), 0.0, 1e-9);
  EXPECT_GT(std::sqrt(fit.priorCovariance(0, 0)), 0.9 * fit.phi(0)) << "the mass is not known";
  EXPECT_LT((fit.covariance - fit.priorCovariance).norm(), 1e-9 * fit.covariance.norm());
}

TEST(ShapePrior, NormalFormStopsWhereTheFitStopsWithTheSameCovariance) {
  for (const Certainty certainty : {Certainty::rough, Certainty::good, Certainty::exact}) {
    Shape shape = shapeOf({"box:0.05,0.04,0.2@0,0,0.1", "sphere:0.04@0.01,0.01,0.22"}, certainty);
    shape.totalMass = 0.9;
    const ShapePrior prior = priorOf(shape);
    Payload truth;
    truth.mass = 0.9;
    truth.com = {0.004, -0.002, 0.16};
    truth.inertiaCom = Vector3d(0.003, 0.0031, 0.0006).asDiagonal();
    const Data data = simulate(freeMotion(2, 0.5), 5.0, toParameters(truth), 0.1, 0.005, 1);
    const ShapeFit fit = prior.fit(data.A, data.y);
    ASSERT_TRUE(fit.converged);
    const Matrix4d P0 = fit.U0 * fit.U0.transpose();
    EXPECT_LT((parametersFromPseudoInertia(P0) - fit.phi).norm(), 1e-12 * fit.phi.norm());
    // d phi / d v by finite differences of P = U0 V V^T U0^T, in the documented order.
    const std::array<std::pair<int, int>, 10> order{
        {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}, {3, 3}}};
    Matrix10d G;
    for (int k = 0; k < 10; ++k) {
      const auto at = [&](double h) {
        Matrix4d V = Matrix4d::Identity();
        const auto [r, c] = order[static_cast<std::size_t>(k)];
        V(r, c) = r == c ? std::exp(h) : h;
        return parametersFromPseudoInertia(fit.U0 * V * V.transpose() * fit.U0.transpose());
      };
      G.col(k) = (at(1e-6) - at(-1e-6)) / 2e-6;
    }
    const MatrixXd AG = product(data.A, G);
    const MatrixXd covarianceOfV = inverse(transposedProduct(AG, AG) + fit.information);
    const VectorXd gradient = AG.transpose() * (data.A * fit.phi - data.y) - fit.information * fit.mean;
    EXPECT_LT(std::sqrt(gradient.dot(covarianceOfV * gradient)), 1e-3) << "in standard deviations";
    const MatrixXd covariance = congruence(G, covarianceOfV);
    const VectorXd sd = fit.covariance.diagonal().cwiseSqrt();
    EXPECT_LT((sd.cwiseInverse().asDiagonal() * (covariance - fit.covariance) * sd.cwiseInverse().asDiagonal()).norm(),
              1e-3)
        << covariance << "\n\n"
        << fit.covariance;
  }
}

TEST(ShapePrior, MovingTheSensorFrameMovesTheResult) {
  Shape shape = shapeOf({"box:0.05,0.04,0.2@0,0,0.1", "sphere:0.04@0.01,0.01,0.22"}, Certainty::rough);
  Payload truth;
  truth.mass = 0.7;
  truth.com = {0.004, -0.002, 0.16};
  const Isometry3d X_NS = poseFromXyzRpy({0.1, -0.3, 0.2}, {0.5, 1.0, -2.0});
  const Data here = standing(toParameters(truth), 1e-4);
  const Payload a = fromParameters(priorOf(shape).fit(here.A, here.y).phi);
  for (ShapeBody& body : shape.bodies) body.X_SB = X_NS * body.X_SB;
  const Data there = standing(toParameters(transformed(truth, X_NS)), 1e-4);
  const Payload b = fromParameters(priorOf(shape).fit(there.A, there.y).phi);
  const Payload expected = transformed(a, X_NS);
  // The rows' own noise is not turned along, so that the two differ by a little of it.
  EXPECT_LT((b.com - expected.com).norm(), 1e-5);
  EXPECT_LT((b.inertiaCom - expected.inertiaCom).norm(), 1e-4 * expected.inertiaCom.norm());
}

TEST(ShapePrior, SplitOfTheMassIsFoundFromTheCentreOfMass) {
  // A steel head (7850) on a wooden handle (600 kg/m3).
  const Shape shape = shapeOf({"cylinder:0.015,0.3@0,0,0.15", "box:0.03,0.1,0.03@0,0,0.315"}, Certainty::exact);
  const auto samples = priorSamplesOf(shape);
  const double handle = 600.0 * samples[0].volume, head = 7850.0 * samples[1].volume;
  const Vector10d truth = handle * parametersFromPseudoInertia(samples[0].unitPseudoInertia) +
                          head * parametersFromPseudoInertia(samples[1].unitPseudoInertia);
  const Data data = standing(truth, 1e-3);
  const ShapeFit fit = ShapePrior(shape, samples).fit(data.A, data.y);
  ASSERT_TRUE(fit.converged);
  EXPECT_NEAR(fit.bodyMass[0], handle, 3 * fit.bodyMassStd[0]);
  EXPECT_NEAR(fit.bodyMass[1], head, 3 * fit.bodyMassStd[1]);
  EXPECT_NEAR(fit.bodyMass[1], head, 0.03 * head);
  EXPECT_LT(fit.bodyMassStd[0], 0.2 * handle);
  const Payload got = fromParameters(fit.phi), expected = fromParameters(truth);
  EXPECT_LT((got.inertiaCom - expected.inertiaCom).norm(), 0.03 * expected.inertiaCom.norm());
}

TEST(ShapePrior, ABodyThatIsNotThereKeepsAMassAboveZero) {
  const Shape shape = shapeOf({"box:0.05,0.05,0.1@0,0,0.05", "box:0.05,0.05,0.1@0,0,0.25"}, Certainty::good);
  const auto samples = priorSamplesOf(shape);
  const Vector10d truth = 0.5 * parametersFromPseudoInertia(samples[0].unitPseudoInertia);
  const Data data = standing(truth, 1e-3);
  const ShapeFit fit = ShapePrior(shape, samples).fit(data.A, data.y);
  EXPECT_GT(fit.bodyMass[1], 0.0);
  EXPECT_LT(fit.bodyMass[1], 0.02);
}

TEST(ShapePrior, StatedMassesAreSoftInformation) {
  Shape shape = shapeOf({"box:0.05,0.05,0.1@0,0,0.05", "box:0.05,0.05,0.1@0,0,0.25"}, Certainty::good);
  shape.bodies[0].mass = 0.3;
  shape.totalMass = 1.0;
  ShapeFit fit = priorOf(shape).fit(kNoRows, kNoValues);
  EXPECT_NEAR(fit.bodyMass[0], 0.3, 0.001);
  EXPECT_NEAR(fit.bodyMass[1], 0.7, 0.01);
  EXPECT_NEAR(fit.phi(0), 1.0, 0.001);
  EXPECT_NEAR(std::sqrt(fit.priorCovariance(0, 0)), 0.005, 0.0005);
  shape.bodies[0].mass.reset();
  shape.totalMass.reset();
  shape.bodies[0].density = shape.bodies[1].density = 1000.0;
  fit = priorOf(shape).fit(kNoRows, kNoValues);
  EXPECT_NEAR(fit.bodyMass[0], 0.25, 0.01);
  EXPECT_NEAR(fit.bodyMassStd[0], 0.03 * 0.25, 0.001);
}

TEST(ShapePrior, ContradictionIsSeenAndTheResultStaysPhysical) {
  const Shape shape = shapeOf({"box:0.05,0.05,0.1@0,0,0.05"}, Certainty::good);
  const ShapePrior prior = priorOf(shape);
  Payload truth;
  truth.mass = 0.6;
  truth.com = {0.0, 0.0, 0.05};
  Data data = standing(toParameters(truth), 1e-3);
  EXPECT_LT(prior.fit(data.A, data.y).conflict, 10.0);
  truth.com = {0.3, 0.0, 0.05};  // far outside the box
  data = standing(toParameters(truth), 1e-3);
  const ShapeFit fit = prior.fit(data.A, data.y);
  EXPECT_GT(fit.conflict, 30.0);
  EXPECT_TRUE(checkPhysical(fromParameters(fit.phi)).physical);
}

TEST(ShapePrior, AlwaysPhysicalOnRandomRows) {
  const ShapePrior prior =
      priorOf(shapeOf({"box:0.05,0.04,0.2@0,0,0.1", "sphere:0.04@0.01,0.01,0.22"}, Certainty::rough));
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 10; ++trial) {
    MatrixXd A(6, 10);
    VectorXd y(6);
    for (double& a : A.reshaped()) a = 100 * normal(random);
    for (double& b : y) b = 100 * normal(random);
    const ShapeFit fit = prior.fit(A, y);
    const Consistency consistency = checkPhysical(fromParameters(fit.phi));
    EXPECT_TRUE(consistency.physical) << consistency.reason;
    EXPECT_TRUE(fit.information.allFinite() && fit.covariance.allFinite());
  }
}

/// A tool of two or three primitives of random materials, with its shape.
struct RandomTool {
  Shape shape;
  Vector10d phi = Vector10d::Zero();
};

RandomTool randomTool(std::mt19937& random, Certainty certainty, double dimensionError) {
  std::uniform_real_distribution<double> uniform;
  const std::array<double, 7> materials{600, 1150, 1400, 2700, 4400, 7850, 7850};
  const auto material = [&] { return materials[static_cast<std::size_t>(uniform(random) * 6.999)]; };
  RandomTool tool;
  tool.shape.certainty = certainty;
  ShapeBody handle, head;
  handle.kind = BodyKind::cylinder;
  handle.dims = {0.008 + 0.01 * uniform(random), 0.1 + 0.15 * uniform(random)};
  handle.X_SB.translation() = Vector3d(0, 0, 0.3 * handle.dims[1]);
  head.kind = uniform(random) < 0.5 ? BodyKind::box : BodyKind::capsule;
  head.dims = head.kind == BodyKind::box
                  ? std::vector<double>{0.02 + 0.03 * uniform(random), 0.04 + 0.08 * uniform(random), 0.03}
                  : std::vector<double>{0.01 + 0.01 * uniform(random), 0.05 * uniform(random)};
  head.X_SB = poseFromXyzRpy({0, 0.03 * (uniform(random) - 0.5), 0.82 * handle.dims[1]}, {uniform(random), 0, 0});
  tool.shape.bodies = {handle, head};
  const bool same = uniform(random) < 0.3;
  const double density = material();
  for (const BodySamples& body : priorSamplesOf(tool.shape)) {
    const double own = same ? density : material();
    tool.phi += own * body.volume * parametersFromPseudoInertia(body.unitPseudoInertia);
  }
  for (ShapeBody& body : tool.shape.bodies)
    for (double& d : body.dims) d *= uniform(random) < 0.5 ? 1 - dimensionError : 1 + dimensionError;
  return tool;
}

struct Score {
  double medianError = 0.0;       ///< Of the inertia about the centre of mass, Frobenius, relative.
  double rmsZ = 0.0, inside = 0;  ///< Over mass, h and I: error in standard deviations; share within 1.96 of them.
};

Score score(Certainty certainty, double dimensionError, double speed) {
  std::mt19937 random(11);
  std::vector<double> errors;
  double squares = 0.0, inside = 0.0, count = 0.0;
  for (int i = 0; i < 40; ++i) {
    const RandomTool tool = randomTool(random, certainty, dimensionError);
    const Motion motion = i % 2 == 0 ? freeMotion(i, speed) : stopAndGo(i, speed);
    const Data data = simulate(motion, 10.0, tool.phi, 0.1, 0.005, i);
    const ShapeFit fit = priorOf(tool.shape).fit(data.A, data.y);
    EXPECT_TRUE(fit.converged);
    const Matrix3d truth = fromParameters(tool.phi).inertiaCom;
    errors.push_back((fromParameters(fit.phi).inertiaCom - truth).norm() / truth.norm());
    for (int k = 0; k < 10; ++k) {
      const double z = (fit.phi(k) - tool.phi(k)) / std::sqrt(fit.covariance(k, k));
      squares += z * z;
      inside += std::abs(z) < 1.96;
      count += 1;
    }
  }
  std::sort(errors.begin(), errors.end());
  const Score result{errors[errors.size() / 2], std::sqrt(squares / count), inside / count};
  std::cout << "certainty " << toString(certainty) << ", dimensions " << 100 * dimensionError << " % off, speed "
            << speed << ": median inertia error " << 100 * result.medianError << " %, rms z " << result.rmsZ
            << ", inside " << 100 * result.inside << " %\n";
  return result;
}

TEST(ShapePrior, HonestOnRandomToolsWithRoughDimensions) {
  const Score got = score(Certainty::rough, 0.1, 0.5);
  EXPECT_LT(got.medianError, 0.10);
  EXPECT_GT(got.inside, 0.90);
  EXPECT_LT(got.rmsZ, 1.3);
}

TEST(ShapePrior, SlowMotionLeansOnTheShape) {
  const Score got = score(Certainty::rough, 0.1, 0.2);
  EXPECT_LT(got.medianError, 0.15);
  EXPECT_GT(got.inside, 0.90);
}

TEST(ShapePrior, ExactShapeIsPreciseAndHonest) {
  const Score got = score(Certainty::exact, 0.0, 0.5);
  EXPECT_LT(got.medianError, 0.02);
  EXPECT_GT(got.inside, 0.93);
}

std::filesystem::path sharedToolFiles() {
  if (const char* shared = std::getenv("HEFT_SHARED")) return std::filesystem::path(shared) / "tools";
  return std::filesystem::path(HEFT_SOURCE_DIR) / ".." / "shared" / "tools";
}

TEST(ShapePrior, SixRealToolsAsRoughMeshesOfUnknownDensity) {
  const auto folder = sharedToolFiles();
  if (!std::filesystem::exists(folder))
    GTEST_SKIP() << folder << " is not there: the real tools come with the shared material.";
  const std::array<std::array<double, 3>, 3> levels{{{0.05, 0.0025, 5.0}, {0.1, 0.005, 6.0}, {0.2, 0.01, 8.0}}};
  std::array<double, 3> sum{};
  int count = 0;
  for (const char* name : {"box_wrench", "clamp", "hammer", "measuring_tape", "pliers", "screwdriver"}) {
    std::ifstream in(folder / (std::string(name) + ".json"));
    const auto json = nlohmann::json::parse(in);
    Payload inMesh;
    Isometry3d X_MS = Isometry3d::Identity();
    inMesh.mass = json["mass_kg"];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto r = static_cast<Eigen::Index>(i);
      inMesh.com(r) = json["com_in_mesh_m"][i];
      for (std::size_t k = 0; k < 3; ++k)
        inMesh.inertiaCom(r, static_cast<Eigen::Index>(k)) = json["inertia_com_kgm2"][i][k];
      for (std::size_t k = 0; k < 4; ++k) X_MS.matrix()(r, static_cast<Eigen::Index>(k)) = json["grasp_in_mesh"][i][k];
    }
    Shape shape;
    ShapeBody body;
    body.kind = BodyKind::mesh;
    body.file = folder / json["mesh"].get<std::string>();
    body.unit = 0.001;
    body.X_SB = X_MS.inverse();
    shape.bodies.push_back(body);
    const auto samples = priorSamplesOf(shape);
    const Eigen::Matrix3Xd mesh = X_MS * samples[0].points;
    const Vector3d sides = mesh.rowwise().maxCoeff() - mesh.rowwise().minCoeff();
    const ShapePrior prior(shape, samples);
    const Payload truth = transformed(inMesh, X_MS.inverse());
    for (std::size_t level = 0; level < levels.size(); ++level)
      for (int seed = 0; seed < 4; ++seed) {
        const Motion motion = seed % 2 == 0 ? stopAndGo(seed, 1.0) : freeMotion(seed, 1.0);
        const Data data = simulate(motion, 10.0, toParameters(truth), levels[level][0], levels[level][1], seed);
        const ShapeFit fit = prior.fit(data.A, data.y);
        EXPECT_TRUE(fit.converged) << name;
        EXPECT_LT(fit.conflict, 30.0) << name;
        sum[level] += inertiaError(fromParameters(fit.phi), truth, X_MS.linear(), sides);
        count += level == 0;
      }
  }
  for (std::size_t level = 0; level < levels.size(); ++level) {
    std::cout << "force noise " << levels[level][0] << " N: mean inertia error " << sum[level] / count << " %\n";
    EXPECT_LT(sum[level] / count, 0.6 * levels[level][2]);
  }
}

}  // namespace
}  // namespace heft
