#include "core/diagnosis/change_detection/carried_load.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/diagnosis/calibration.h"
#include "core/math/linear_algebra.h"
#include "core/wrench/regressor.h"

namespace heft::diagnosis {

namespace {

/// How a block's wrench (6) depends on some parameters, over the usual size of each channel.
using Rows = Eigen::Matrix<double, 6, Eigen::Dynamic>;

struct Best {
  VectorXd parameters;
  MatrixXd information;
  double left = 0.0;  ///< Sum of squares
};

/// The parameters that leave least of `scaled` (6 x N) in the contacts, of which each block may be left as it is: they
/// begin and end somewhere in their stretches. `rows`: of a block, with `count` columns.
template <class OfBlock>
Best bestOf(const Wrenches& scaled, const std::vector<Contact>& contacts, const OfBlock& rows, Eigen::Index count) {
  constexpr int kRounds = 3;  // Which blocks are left shows once the parameters are known
  Best out;
  out.parameters = VectorXd::Zero(count);
  for (int round = 0; round < kRounds; ++round) {
    MatrixXd information = 1e-12 * MatrixXd::Identity(count, count);
    VectorXd g = VectorXd::Zero(count);
    for (const Contact& contact : contacts)
      for (Eigen::Index n = contact.blocks.from; n < contact.blocks.to; ++n) {
        const Rows A = rows(n);
        const Vector6d w = scaled.col(n);
        if (round > 0 && (w - A * out.parameters).squaredNorm() > w.squaredNorm()) continue;
        information += A.transpose() * A;
        g += A.transpose() * w;
      }
    out.parameters = solveSymmetric(information, g);
    out.information = std::move(information);
  }
  for (const Contact& contact : contacts)
    for (Eigen::Index n = contact.blocks.from; n < contact.blocks.to; ++n) {
      const Vector6d w = scaled.col(n);
      out.left += std::min(w.squaredNorm(), (w - rows(n) * out.parameters).squaredNorm());
    }
  return out;
}

constexpr double kShortest = 0.8;  ///< [s]

/// What is left of a fit in `contacts`, as something that acts in all of them would make it.
class LeftBy {
 public:
  LeftBy(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts)
      : signals_(signals),
        weight_(usualPower(signals, fit, blocksOf(contacts)).cwiseSqrt().cwiseInverse()),
        scaled_(weight_.asDiagonal() * fit.residual) {}

  /// Mass, and mass times its place.
  Best load(const std::vector<Contact>& contacts) const {
    const auto rows = [&](Eigen::Index n) -> Rows {
      const Eigen::Index m = signals_.samplesPerBlock;
      const auto mean = [&](const Eigen::Matrix3Xd& of) { return Vector3d(of.middleCols(n * m, m).rowwise().mean()); };
      const Kinematics& kin = signals_.kinematics;
      return weight_.asDiagonal() *
             regressor({mean(kin.specificForce), mean(kin.omega), mean(kin.alpha)}).leftCols<4>();
    };
    return bestOf(scaled_, contacts, rows, 4);
  }

  /// Somebody who holds on to the tool pulls one way in the world, and turns it one way.
  Best holding(const Contact& contact) const {
    const auto rows = [&](Eigen::Index n) -> Rows {
      const Eigen::Index m = signals_.samplesPerBlock;
      Rows out = Rows::Zero(6, 6);
      out.topLeftCorner<3, 3>() = signals_.R_BS[static_cast<std::size_t>(n * m + m / 2)].transpose();
      out.bottomRightCorner<3, 3>().setIdentity();
      return weight_.asDiagonal() * out;
    };
    return bestOf(scaled_, {contact}, rows, 6);
  }

  /// Another zero.
  Best zero(const Contact& contact) const {
    return bestOf(
        scaled_, {contact}, [&](Eigen::Index) -> Rows { return weight_.asDiagonal(); }, 6);
  }

  double all(const std::vector<Contact>& contacts) const {
    double out = 1e-300;
    for (const Contact& c : contacts)
      out += scaled_.middleCols(c.blocks.from, c.blocks.to - c.blocks.from).squaredNorm();
    return out;
  }

 private:
  const Signals& signals_;
  Vector6d weight_;
  Wrenches scaled_;
};

bool areTooShort(const std::vector<Contact>& contacts) {
  return contacts.empty() || std::ranges::any_of(contacts, [](const Contact& c) { return c.to - c.from < kShortest; });
}

}  // namespace

std::optional<LoadIn> loadIn(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts) {
  if (areTooShort(contacts)) return std::nullopt;
  const LeftBy leftBy(signals, fit, contacts);
  const Best load = leftBy.load(contacts);
  double leftByHolding = 1e-300, blocks = 0.0;
  for (const Contact& contact : contacts) {
    leftByHolding += leftBy.holding(contact).left;
    blocks += static_cast<double>(contact.blocks.to - contact.blocks.from);
  }
  return LoadIn{load.left / leftBy.all(contacts), load.left / leftByHolding, load.parameters(0),
                std::sqrt(std::max(1.0, load.left / (6.0 * blocks)) * inverse(load.information)(0, 0))};
}

bool isCarried(const LoadIn& load) {
  // Of what is left in the contacts, and of what holding on leaves. A part that was carried left 0.006 and 0.1; of
  // eight that were touched as long, the most like a load left 0.16 and seven times.
  return load.share <= kTinyShare && load.shareOfHolding <= kMajority && load.mass >= 3.0 * load.massStd;
}

std::optional<CarriedLoad> carriedLoadIn(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts) {
  const auto load = loadIn(signals, fit, contacts);
  if (!load || !isCarried(*load)) return std::nullopt;
  CarriedLoad out;
  out.mass = load->mass;
  out.massStd = load->massStd;
  for (const Contact& contact : contacts) {
    out.evidence += contact.evidence;
    out.when.emplace_back(contact.from, contact.to);
  }
  return out;
}

std::vector<Contact> recurrencesIn(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts,
                                   bool zeroJumps, bool loadChanges) {
  std::vector<Contact> out;
  const LeftBy leftBy(signals, fit, contacts);
  for (const Contact& contact : contacts) {
    const double all = leftBy.all({contact});
    if (contact.to - contact.from > kShortest && ((zeroJumps && leftBy.zero(contact).left < kNoLoad * all) ||
                                                  (loadChanges && leftBy.load({contact}).left < kTinyShare * all)))
      out.push_back(contact);
  }
  return out;
}

}  // namespace heft::diagnosis
