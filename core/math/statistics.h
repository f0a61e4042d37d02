#pragma once
// Robust location and scale, and autoregressive models of coloured noise.
#include <Eigen/Dense>
#include <vector>

namespace heft {

/// Median of the values (the mean of the middle two for an even count); 0 for none. Reorders its copy.
double median(std::vector<double> values);

/// 1.4826 times the median absolute deviation from the median: the standard deviation of a normal distribution.
double robustStd(const std::vector<double>& values);

/// Share of the power of vectors along the direction that takes most of it, 0 to 1; 0 where there is none. `power`: the
/// sum of their outer products, n x n.
double shareAlongOneDirection(const Eigen::MatrixXd& power);

/// Autoregressive noise: e_k = sum_i a_i e_(k-i) + innovation of standard deviation sigma.
struct ArModel {
  Eigen::VectorXd coefficients;  ///< a_1 .. a_p; may be empty (white noise).
  double sigma = 1.0;

  int order() const { return static_cast<int>(coefficients.size()); }
  /// Long-run standard deviation over the innovation's: sum of the noise's impulse response, 1 / (1 - sum a).
  double gain() const { return 1.0 / (1.0 - coefficients.sum()); }
};

/// Sums needed to fit autoregressive models, collected over several stretches of one channel.
class AutoCovariance {
 public:
  explicit AutoCovariance(int maxOrder) : sums_(Eigen::VectorXd::Zero(maxOrder + 1)) {}
  /// Adds a contiguous stretch of zero-mean noise; weight 0 leaves a sample out of every product it takes part in.
  void add(const Eigen::Ref<const Eigen::VectorXd>& noise, const Eigen::Ref<const Eigen::VectorXd>& weights);
  void add(const Eigen::Ref<const Eigen::VectorXd>& noise);
  /// Adds to the products what a fit has taken from the noise that was added: no samples of its own.
  void addTaken(const Eigen::Ref<const Eigen::VectorXd>& taken, const Eigen::Ref<const Eigen::VectorXd>& weights);
  double count() const { return count_; }
  /// Yule-Walker fit by Levinson-Durbin; the order up to the maximum that minimises BIC. Always stable. `beyond` more
  /// orders are taken than BIC asks for: it leaves out what it cannot prove, and slow noise comes out too weak.
  ArModel fit(int beyond = 0) const;

 private:
  Eigen::VectorXd sums_;
  double count_ = 0.0;
};

}  // namespace heft
