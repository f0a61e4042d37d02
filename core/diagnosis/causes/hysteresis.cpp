// The sensor remembers its load: reading a little behind on the way up and on the way down.
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {
namespace {

class Hysteresis final : public Cause {
 public:
  std::string_view id() const override { return "hysteresis"; }
  std::vector<std::string> lookAlikes() const override { return {"coulomb_friction", "low_pass_lag"}; }
  std::vector<Form> forms(const Signals&) const override {
    std::vector<Form> out;
    for (const int percent : {5, 20, 60}) {
      std::vector<Parameter> parameters;
      for (int c = 0; c < 6; ++c) parameters.push_back({channelName(c), "%", 100.0, 0.01, -0.3, 0.3});
      out.push_back(formOf(this, fmt::format("play of {} % of the range", percent), parameters));
      out.back().subset = true;
      out.back().choice = {percent};
    }
    // What remembers through many small plays: bristles that bend over a way of the load.
    for (const int percent : {15, 40}) {
      Form form = out.front();
      form.name = fmt::format("bristles over {} % of the range", percent);
      form.choice = {percent, 1};
      out.push_back(std::move(form));
    }
    return out;
  }
  int order() const override { return 50; }
  bool changesSensor() const override { return true; }
  bool linear() const override { return false; }
  void sensor(const Form& form, const VectorXd& v, const Signals&, Wrenches& w) const override {
    const Vector6d r = 0.005 * form.choice[0] * (w.rowwise().maxCoeff() - w.rowwise().minCoeff());
    if (form.choice.size() > 1) {
      const Vector6d reach = (2.0 * r).cwiseMax(1e-9);
      Vector6d bend = Vector6d::Zero(), last = w.col(0);
      for (Eigen::Index k = 0; k < w.cols(); ++k) {
        const Vector6d u = w.col(k), way = (u - last).cwiseQuotient(reach);
        const Vector6d end = way.cwiseSign();
        bend = end + (bend - end).cwiseProduct((-way.cwiseAbs()).array().exp().matrix());
        last = u;
        w.col(k) -= v.cwiseProduct(bend).cwiseProduct(reach);
      }
      return;
    }
    Vector6d play = w.col(0);
    // The lag of a play behind its input: what a dead band remembers.
    for (Eigen::Index k = 0; k < w.cols(); ++k) {
      const Vector6d u = w.col(k);
      play = play.cwiseMax(u - r).cwiseMin(u + r);
      w.col(k) += v.cwiseProduct(play - u);
    }
  }
};

}  // namespace

std::unique_ptr<Cause> makeHysteresis() { return std::make_unique<Hysteresis>(); }

}  // namespace heft::diagnosis
