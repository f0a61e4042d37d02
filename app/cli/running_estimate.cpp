#include "app/cli/running_estimate.h"

#include <fmt/format.h>

#include <set>

#include "app/cli/cli.h"
#include "core/live/plain_samples.h"
#include "core/online/online_estimator.h"

namespace heft::cli {

struct RunningEstimate::Impl {
  PlainSamples plain;
  std::optional<double> start;
  OnlineEstimator estimator;
  std::set<std::string> told;
};

RunningEstimate::RunningEstimate(const RecordingMeta& meta, const RobotModel* robot,
                                 const std::optional<Shape>& shape) {
  OnlineOptions options;
  options.shape = shape;
  impl_.reset(new Impl{orFail(PlainSamples::create(meta, robot)),
                       std::nullopt,
                       orFail(OnlineEstimator::create(meta, robot, options)),
                       {}});
}

void RunningEstimate::add(const LiveSample& read) {
  const LiveSample sample = orFail(impl_->plain.plain(read));
  if (!impl_->start) impl_->start = sample.time;
  OnlineSample out;
  out.time = sample.time - *impl_->start;
  out.q = sample.q;
  out.dq = sample.dq;
  if (sample.orientation) out.pose = OnlineSample::Pose{sample.position, *sample.orientation};
  out.wrench = *sample.wrench;
  impl_->estimator.add(out);
}

std::string RunningEstimate::line() const {
  const OnlineState& state = impl_->estimator.state();
  if (!state.estimated) return fmt::format("{:6.1f} s  moving and measuring ...", state.time);
  const auto& com = state.payload.com;
  const auto& mass = state.interval95.mass;
  return fmt::format("{:6.1f} s  {:.3f} kg [{:.3f}, {:.3f}]  centre ({:.1f}, {:.1f}, {:.1f}) mm  {}  {}", state.time,
                     state.payload.mass, mass.lower, mass.upper, 1e3 * com.x(), 1e3 * com.y(), 1e3 * com.z(),
                     toString(state.touch), state.inertia.words);
}

std::vector<std::string> RunningEstimate::news() {
  std::vector<std::string> out;
  for (const auto& finding : impl_->estimator.state().findings)
    if ((finding.code == "tool_changed" || finding.code == "tool_back") && impl_->told.insert(finding.text).second)
      out.push_back(finding.text);
    else if ((finding.code == "stamps_jitter" || finding.code == "no_agreement") &&
             impl_->told.insert(finding.code).second)
      out.push_back(finding.text + " " + finding.remedy);
  return out;
}

RunningEstimate::~RunningEstimate() = default;

}  // namespace heft::cli
