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
    return out;
  }
  int order() const override { return 50; }
  bool changesSensor() const override { return true; }
  bool linear() const override { return false; }
  void sensor(const Form& form, const VectorXd& v, const Signals&, Wrenches& w) const override {
    for (Eigen::Index c = 0; c < 6; ++c) {
      if (v(c) == 0.0) continue;
      const double range = w.row(c).maxCoeff() - w.row(c).minCoeff();
      const double r = 0.005 * form.choice[0] * range;
      double play = w(c, 0);
      // The lag of a play behind its input: what a dead band remembers.
      for (Eigen::Index k = 0; k < w.cols(); ++k) {
        const double u = w(c, k);
        play = std::min(u + r, std::max(u - r, play));
        w(c, k) = u + v(c) * (play - u);
      }
    }
  }
};

}  // namespace

std::unique_ptr<Cause> makeHysteresis() { return std::make_unique<Hysteresis>(); }

}  // namespace heft::diagnosis
