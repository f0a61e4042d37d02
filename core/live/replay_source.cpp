// A recording at the pace at which it was recorded, or faster.
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/import.h"
#include "core/live/sources.h"
#include "core/motion/sensor_axes.h"

namespace heft {

namespace {

class ReplaySource : public ThreadedSource {
 public:
  ReplaySource(std::filesystem::path file, double speed, std::filesystem::path metaFile)
      : ThreadedSource(heft::say("replay of {}", displayName(file.filename()))),
        file_(std::move(file)),
        speed_(speed),
        metaFile_(std::move(metaFile)) {}
  ~ReplaySource() override { ReplaySource::stop(); }

 protected:
  /// What is read takes its time, and whoever starts a source may be a window: only what is not there is told at once.
  Result<bool> prepare() override { return std::filesystem::exists(file_) ? true : read(); }

  void run(const std::stop_token& stopping) override {
    setState(LinkState::connecting);
    if (const auto there = read(); !there) return setState(LinkState::failed, there.error().message);
    setState(LinkState::live);
    const double start = hostNow();
    for (Eigen::Index k = 0; k < recording_.rows() && !stopping.stop_requested(); ++k) {
      LiveSample sample = sampleAt(k);
      // Faster means sooner, not another motion: the times between samples stay those of the recording.
      const double elapsed = recording_.time(k) - recording_.time(0);
      sample.time = start + elapsed;
      const double due = start + elapsed / speed_;
      for (double left = due - hostNow(); left > 0.0 && !stopping.stop_requested(); left = due - hostNow())
        std::this_thread::sleep_for(std::chrono::duration<double>(std::min(left, 0.05)));
      if (stopping.stop_requested()) return;
      passOn(sample);
    }
    setState(LinkState::finished);
  }

 private:
  Result<bool> read() {
    ImportOptions options;
    options.metaFile = metaFile_;
    auto opened = openRecording(file_, options);
    if (!opened) return opened.error();
    if (auto turned = toSensorAxes(opened->recording); !turned) return turned.error();
    recording_ = std::move(opened->recording);
    if (recording_.hasJoints() && recording_.q.cols() > 7)
      return Error{
          heft::say("{} has {} joints; live samples have seven at most.", displayName(file_), recording_.q.cols())};
    return true;
  }

  LiveSample sampleAt(Eigen::Index k) const {
    LiveSample sample;
    const auto row = [&](const auto& values) {
      std::array<double, 7> out{};
      for (Eigen::Index j = 0; j < values.cols(); ++j) out[static_cast<std::size_t>(j)] = values(k, j);
      return out;
    };
    if (recording_.hasJoints()) sample.q = row(recording_.q);
    sample.joints = static_cast<int>(recording_.q.cols());
    if (recording_.dq.rows() > 0) sample.dq = row(recording_.dq);
    if (recording_.hasOrientation())
      sample.orientation = Quaterniond(recording_.quaternion(k, 3), recording_.quaternion(k, 0),
                                       recording_.quaternion(k, 1), recording_.quaternion(k, 2));
    if (recording_.hasPosition()) sample.position = recording_.position.row(k).transpose();
    sample.wrench = recording_.wrench.row(k).transpose();
    if (recording_.hasAccelerometer()) sample.accelerometer = recording_.accelerometer.row(k).transpose();
    if (sample.accelerometer && recording_.gyroscope.rows() > 0)
      sample.gyroscope = recording_.gyroscope.row(k).transpose();
    return sample;
  }

  const std::filesystem::path file_;
  const double speed_;
  const std::filesystem::path metaFile_;
  Recording recording_;
};

}  // namespace

std::unique_ptr<LiveSource> makeReplaySource(const std::filesystem::path& file, double speed,
                                             const std::filesystem::path& metaFile) {
  return std::make_unique<ReplaySource>(file, speed, metaFile);
}

}  // namespace heft
