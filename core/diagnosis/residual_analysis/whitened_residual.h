#pragma once
// Columns that might explain what a fit leaves over, judged under its noise.
#include "core/diagnosis/model/fit.h"
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

struct Judged {
  double gain = 0.0, explained = 0.0;  ///< Evidence; share of the residual's energy
};

/// The residual under one noise, and what the fit could do about it.
struct WhitenedResidual {
  const std::vector<Stretch>& stretches;
  const Fit& fit;
  Noise noise;
  bool learnsAgain;  ///< The noise is no more than a weighting; gains are counted with noise refitted to what is left.
  MatrixXd basis;
  VectorXd r;  ///< Whitened residual, freed of what the fit can do
  double energy = 1.0;

  double before = 0.0;  ///< Evidence of the residual as it is, all blocks made equally loud

  /// `columns`: of the fit's model.
  WhitenedResidual(const std::vector<Stretch>& where, const Fit& what, const ChannelColumns& columns, const Noise& with,
                   bool refits);
  /// The same with another residual in its place, of the same noise with all blocks made equally loud.
  WhitenedResidual(const WhitenedResidual& other, const Wrenches& residual);

  /// Evidence of `left` (whitened) with the noise learned from it, over what it was.
  double evidence(const VectorXd& left) const;

 private:
  void take(const VectorXd& residual);
};

/// Whitened columns freed of what the fit can do, and their products. Freed they are only where they are asked for:
/// what is about one channel alone costs a sixth of what it does freed.
class Dictionary {
 public:
  /// `columns` 6N x F; the ground must outlive this.
  Dictionary(const WhitenedResidual& ground, const MatrixXd& columns);

  /// Products of the columns with `r`, which is free of what the fit can do.
  VectorXd productsWith(const VectorXd& r) const { return C_.transposeTimes(r); }
  /// What the columns, each so many times, come to.
  VectorXd sum(const VectorXd& times) const {
    return C_.times(times) - ground_.basis * (explained_.transpose() * times);
  }
  /// The sizes of all columns together, if they are few, that are most like `r`.
  VectorXd likeness(const VectorXd& r) const;
  bool few() const { return scale_.size() > 0; }

  MatrixXd products;
  VectorXd squares;  ///< Their diagonal; 0 for columns that the fit can do

 private:
  const WhitenedResidual& ground_;
  WhitenedColumns C_;
  MatrixXd explained_;  ///< Products with the ground's basis, a row a column
  VectorXd scale_;
  SymmetricSolver together_;
};

/// All columns at once, which must be few: a little of everything is cheaper so than piece by piece. `tries`: of how
/// many such sets this is the best.
Judged judgeAll(const Dictionary& of, const WhitenedResidual& ground, double lnN, double tries);

/// As many of the columns as pay for themselves, or all at once.
Judged judge(const Dictionary& of, const WhitenedResidual& ground, double lnN);

/// The rows of `b` below those of `a`, which may have none.
MatrixXd stacked(const MatrixXd& a, const MatrixXd& b);

/// Columns (6N x 6F) of features of blocks, F x N: a channel's features in its own rows only.
MatrixXd onEachChannel(const MatrixXd& features);

}  // namespace heft::diagnosis
