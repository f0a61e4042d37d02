#include "core/compensation/diagnosed_effect.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace heft {

namespace {

class DiagnosedEffect final : public WrenchEffect {
 public:
  explicit DiagnosedEffect(WrenchSamples effect) : effect_(std::move(effect)) {}
  std::string_view id() const override { return "diagnosis"; }
  void remove(const VectorXd&, const Motion&, WrenchSamples& wrench) const override {
    const Eigen::Index n = std::min(wrench.rows(), effect_.rows());
    wrench.topRows(n) -= effect_.topRows(n);
  }

 private:
  WrenchSamples effect_;  ///< At the recording's rows
};

}  // namespace

Result<std::shared_ptr<const WrenchEffect>> diagnosedEffect(const nlohmann::json& found, const Recording& recording,
                                                            const RobotModel* robot, const std::string& where) {
  if (!found.is_object() || found.value("schema", std::string()) != "heft.diagnose/1" || !found.contains("model"))
    return Error{where + " is no result of heft diagnose; write one with heft diagnose REC --json FILE."};
  auto model = modelFromJson(found["model"], recording, robot);
  if (!model) return model.error();
  if (found.value("file", std::string()) != recording.file)
    std::erase_if(model->terms, [](const diagnosis::Term& term) { return term.form->local; });
  auto effect = effectOf(*model, recording, robot);
  if (!effect) return effect.error();
  return std::shared_ptr<const WrenchEffect>(std::make_shared<DiagnosedEffect>(std::move(*effect)));
}

}  // namespace heft
