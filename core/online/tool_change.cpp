#include "core/online/tool_change.h"
#include "core/estimation/triangle.h"
#include "core/math/linear_algebra.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace heft {

namespace {

constexpr double kUnexplained = 0.8;  // share of blocks that the present tool does not explain
constexpr double kExplained = 0.85;   // share of blocks that the other tool explains
constexpr Eigen::Index kHole = 10;    // blocks in a row that end what the other tool explains

struct Look {
  double seconds;  ///< Newest data that are looked at
  double tilt;     ///< Least spread of gravity's directions [degrees]
  bool freeBias;
};
constexpr Look kLooks[] = {{2.0, 8.0, false}, {4.0, 20.0, true}};

using Vector16d = Eigen::Matrix<double, kColumns, 1>;

/// Angle whose cosine is the length of the mean direction of the specific force.
double tiltSpread(const LaneBlocks& blocks, Eigen::Index from) {
  Vector3d mean = Vector3d::Zero();
  for (Eigen::Index k = from; k < blocks.size(); ++k)
    mean += blocks.Y[static_cast<std::size_t>(k)].block<3, 1>(0, 0).normalized();
  mean /= static_cast<double>(blocks.size() - from);
  return std::acos(std::clamp(mean.norm(), 0.0, 1.0)) * 180.0 / std::numbers::pi;
}

/// Earliest block from which on all but short holes satisfy `fits`.
Eigen::Index backTo(const LaneBlocks& blocks, Eigen::Index from, const std::function<bool(Eigen::Index)>& fits) {
  Eigen::Index start = from, hole = 0;
  for (Eigen::Index k = from - 1; k >= 0 && hole < kHole; --k) {
    if (fits(k)) {
      start = k;
      hole = 0;
    } else {
      ++hole;
    }
  }
  return std::min(start, blocks.size());
}

}  // namespace

std::optional<ToolChange> findToolChange(const LaneBlocks& blocks, const BlockLearner& present) {
  const auto& judged = present.judged();
  const Eigen::Index n = blocks.size();
  const Vector6d allowed =
      (4.0 * present.scatter()).cwiseMax((Vector6d() << Vector3d::Constant(0.1), Vector3d::Constant(0.01)).finished());
  for (const Look& look : kLooks) {
    const auto count = static_cast<Eigen::Index>(look.seconds * blocks.rateHz);
    const Eigen::Index from = n - count;
    if (count < 10 || from < 1 || judged.size() != static_cast<std::size_t>(n)) continue;
    if (static_cast<double>(std::count(judged.begin() + from, judged.end(), Judged::contact)) <
        kUnexplained * static_cast<double>(count))
      continue;
    if (tiltSpread(blocks, from) < look.tilt) continue;

    Vector16d known;
    known << present.solution().bias, Vector10d::Zero();
    // What hand-held tools can be, as weak information; the bias is that of before unless it is free.
    Vector16d sd;
    sd << Vector6d::Constant(1.0), 3.0, 0.3, 0.3, 0.3, Vector6d::Constant(0.1);
    sd.head<3>() *= look.freeBias ? 30.0 : 1e-3;
    sd.segment<3>(3) *= look.freeBias ? 3.0 : 1e-4;
    Eigen::Matrix<double, kColumns, kColumns> H = sd.cwiseAbs2().cwiseInverse().asDiagonal();
    Vector16d g = sd.cwiseAbs2().cwiseInverse().cwiseProduct(known);
    const WrenchRows rows = blocks.rows(from, n);
    const auto residual = [&](const WrenchRows& r, Eigen::Index k, const Vector16d& x) -> Vector6d {
      return r.wrench.col(k) - x.head<6>() - r.Y[static_cast<std::size_t>(k)] * x.tail<10>();
    };
    Vector16d x = Vector16d::Zero();
    for (int round = 0; round < 3; ++round) {
      auto H1 = H;
      auto g1 = g;
      for (Eigen::Index k = 0; k < count; ++k) {
        // Hands that let go of the tool, and taps, are left out after the first round.
        if (round > 0 && residual(rows, k, x).cwiseAbs().cwiseQuotient(allowed).maxCoeff() > 3.0) continue;
        const Eigen::Matrix<double, 6, kColumns + 1> six = allowed.cwiseInverse().asDiagonal() * blockRows(rows, k);
        H1.noalias() += six.leftCols<kColumns>().transpose() * six.leftCols<kColumns>();
        g1.noalias() += six.leftCols<kColumns>().transpose() * six.col(kColumns);
      }
      x = solveSymmetric(H1, g1);
    }
    const double mass = x(kBiasColumns);
    if (!(mass > 0.0)) continue;
    const auto fits = [&](const Vector6d& r) { return r.cwiseAbs().cwiseQuotient(allowed).maxCoeff() < 1.0; };
    Eigen::Index explained = 0;
    for (Eigen::Index k = 0; k < count; ++k) explained += fits(residual(rows, k, x)) ? 1 : 0;
    if (static_cast<double>(explained) < kExplained * static_cast<double>(count)) continue;
    const WrenchRows all = blocks.rows(0, n);
    return ToolChange{backTo(blocks, from,
                             [&](Eigen::Index k) {
                               return fits(residual(all, k, x)) && judged[static_cast<std::size_t>(k)] != Judged::free;
                             }),
                      mass};
  }
  return std::nullopt;
}

std::optional<Eigen::Index> explainedSince(const LaneBlocks& blocks, const BlockLearner& present,
                                           const BlockLearner& other) {
  const auto& judged = present.judged();
  const Eigen::Index n = blocks.size();
  const auto count = static_cast<Eigen::Index>(blocks.rateHz);
  if (count < 10 || n <= count || judged.size() != static_cast<std::size_t>(n)) return std::nullopt;
  if (static_cast<double>(std::count(judged.end() - count, judged.end(), Judged::contact)) <
      kUnexplained * static_cast<double>(count))
    return std::nullopt;
  const auto fits = [&](Eigen::Index k) {
    const auto i = static_cast<std::size_t>(k);
    return judged[i] != Judged::free && other.score(blocks.Y[i], blocks.wrench[i]) < 1.0;
  };
  Eigen::Index explained = 0;
  for (Eigen::Index k = n - count; k < n; ++k) explained += fits(k) ? 1 : 0;
  if (static_cast<double>(explained) < kExplained * static_cast<double>(count)) return std::nullopt;
  return backTo(blocks, n - count, fits);
}

}  // namespace heft
