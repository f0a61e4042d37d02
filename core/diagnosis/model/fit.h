#pragma once
// Fitting bias, payload and the causes of a model together, with the noise learned alongside.
#include <vector>

#include "core/diagnosis/model/channel_columns.h"
#include "core/diagnosis/model/forward_model.h"
#include "core/diagnosis/model/linearisation.h"
#include "core/diagnosis/model/noise.h"
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

struct Fit {
  Model model;
  Noise noise;
  Wrenches residual;        ///< 6 x N, all blocks, judged or not
  MatrixXd information;     ///< Of the whitened problem, model.size() squared, without priors
  MatrixXd covariance;      ///< Its inverse with a whisper of prior
  int dimensions = 0;       ///< Parameters of the causes that the motion can tell at all
  double complexity = 0.0;  ///< What these cost, see complexityPenalty()
  double evidence = 0.0;    ///< Twice the log-likelihood less the price
  bool atBound = false;

  VectorXd std() const { return covariance.diagonal().cwiseMax(0.0).cwiseSqrt(); }
};

/// What `count` parameters cost, in units of twice the log-likelihood, that together gain about `gain`. How large an
/// effect is nobody knows by orders of magnitude: each parameter's prior is as wide as what the data say of all of
/// them, and the choice of that width costs a little, too. Never more than BIC's ln n (`lnN`) each, which stands for
/// the widest.
double complexityPenalty(double gain, double count, double lnN);

/// Normal equations of whitened columns `J` with a prior of deviations `sd` around zero, scaled to a unit diagonal.
class Normal {
 public:
  Normal(const WhitenedColumns& J, const VectorXd& sd);
  VectorXd solve(const VectorXd& g) const { return scale_.asDiagonal() * unit_.solve(scale_.asDiagonal() * g); }
  MatrixXd inverse() const;

  MatrixXd information;  ///< J^T J, without the prior

 private:
  VectorXd scale_;
  SymmetricSolver unit_;
};

/// Gauss-Newton from `start`, the noise refitted in between, until the evidence rests. A parameter whose step is
/// switched off (Term::active) keeps its value. `known`: columns of a model whose terms `start` begins with, or null.
Fit fitModel(const Signals& signals, const std::vector<Stretch>& stretches, Model start, int rounds = 8,
             const CachedJacobian* known = nullptr);

/// The fit, or the one that begins with its answer under white noise, whichever has more evidence: a noise that was
/// learned with a long memory swallows slow misfit and holds on to it.
Fit settled(const Signals& signals, const std::vector<Stretch>& stretches, Fit fit,
            const CachedJacobian* known = nullptr);

/// fitModel's answer on other blocks: parameters and noise kept, or refitted by one step on `stretches` only.
/// `columns`: of the fit's model.
Model refitted(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit, CachedJacobian columns);

/// Orthonormal columns (6N rows) that span what a change of the parameters can do to the whitened readings.
/// `columns`: of the parameters.
MatrixXd explainedSpace(const ChannelColumns& columns, const Noise& noise, const std::vector<Stretch>& stretches);

/// What the waves of a walk cost in one channel, which shares the walk's size with two others: amplitudes (k = 1, 2,
/// ..), their variances from the data alone, and the variance of the longest wave that the walk is said to have.
double complexityOfRandomWalk(const VectorXd& amplitudes, const VectorXd& variances, double longest);

/// Whether the zero walks in the model.
bool hasRandomWalk(const Model& model);

/// How far parameters are trusted to lie from zero before any data: tells nothing where the motion tells something, but
/// for the waves of a walk.
VectorXd weakPrior(const Model& model);

}  // namespace heft::diagnosis
