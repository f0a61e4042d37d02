#include "app/cli/running_estimate.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "app/cli/cli.h"
#include "core/live/plain_samples.h"
#include "core/online/convention_watch.h"
#include "core/online/online_estimator.h"

namespace heft::cli {

struct RunningEstimate::Impl {
  RecordingMeta meta;
  std::optional<RobotModel> robot;
  OnlineOptions options;
  ConventionChoice choice;
  PlainSamples plain;
  OnlineEstimator estimator;
  ConventionWatch watch;
  Matrix3d turn = Matrix3d::Identity();  ///< Of the wrench, beside poses
  bool readSo = false, fromJoints = false;
  std::optional<double> start{};
  std::set<std::string> told{};

  const RobotModel* model() const { return robot ? &*robot : nullptr; }
  void read(const conventions::Report& report);
};

/// From now on the samples mean what `report` suggests.
void RunningEstimate::Impl::read(const conventions::Report& report) {
  const RecordingMeta so = conventions::metaSo(meta, report.stated, *report.suggested, fromJoints);
  if (!fromJoints) turn = report.suggested->turn * report.stated.turn.transpose();
  plain = orFail(PlainSamples::create(so, model()));
  estimator = orFail(OnlineEstimator::create(so, model(), options));
  watch = ConventionWatch(so, nullptr);  // Asks no more
  readSo = true;
}

RunningEstimate::RunningEstimate(const RecordingMeta& meta, const RobotModel* robot, const std::optional<Shape>& shape,
                                 ConventionChoice choice) {
  OnlineOptions options;
  options.shape = shape;
  impl_.reset(new Impl{meta, robot ? std::optional(*robot) : std::nullopt, options, choice,
                       orFail(PlainSamples::create(meta, robot)), orFail(OnlineEstimator::create(meta, robot, options)),
                       ConventionWatch(meta, robot)});
}

void RunningEstimate::add(const LiveSample& read) {
  const LiveSample sample = orFail(impl_->plain.plain(read));
  if (!impl_->start) {
    impl_->start = sample.time;
    impl_->fromJoints = !sample.orientation;
  }
  OnlineSample out;
  out.time = sample.time - *impl_->start;
  out.q = sample.q;
  out.dq = sample.dq;
  if (sample.orientation) out.pose = OnlineSample::Pose{sample.position, *sample.orientation};
  out.wrench << impl_->turn * sample.wrench->head<3>(), impl_->turn * sample.wrench->tail<3>();
  impl_->estimator.add(out);
  if (!impl_->readSo) impl_->watch.add(out);
}

std::string RunningEstimate::line() const {
  const OnlineState& state = impl_->estimator.state();
  if (const auto* out = impl_->watch.report()) return fmt::format("{:6.1f} s  no mass: {}", state.time, out->sentence);
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
  if (impl_->readSo || !impl_->watch.news()) return out;
  const conventions::Report* report = impl_->watch.report();
  if (!report) {
    out.push_back("The numbers mean what the setup file says after all.");
  } else if (report->verdict == conventions::Verdict::suggested && impl_->choice == ConventionChoice::suggested) {
    out.push_back(report->sentence + " The samples are read so from now on.");
    impl_->read(conventions::Report(*report));
  } else {
    out.push_back(report->sentence);
    const bool plain = report->verdict == conventions::Verdict::suggested;
    const auto patch =
        plain ? conventions::metaPatch(report->stated, *report->suggested, impl_->meta.mount, impl_->fromJoints)
              : nlohmann::json(nullptr);
    if (!patch.is_null())
      out.push_back(
          fmt::format("Write {} into the setup file, or add --conventions suggested. {}", patch.dump(), report->check));
  }
  return out;
}

RunningEstimate::~RunningEstimate() = default;

}  // namespace heft::cli
