// A controller of Universal Robots, over TCP.
#include "core/live/rtde_protocol.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/say.h"
#include "core/import/bytes.h"
#include "core/live/network.h"
#include "core/live/sources.h"
#include "core/recording/clock.h"

namespace heft {

namespace {

constexpr double kRtdePatience = 2.0;  ///< [s] For a connection, and for each answer
constexpr double kRtdeSilence = 1.0;   ///< [s] Without data, after which the connection counts as lost
constexpr double kFastest = 500.0;     ///< [Hz] From version 5 on (e-Series); 125 before
constexpr double kFastestBefore5 = 125.0;

class RtdeSource : public ThreadedSource {
 public:
  RtdeSource(std::string host, std::uint16_t port)
      : ThreadedSource(fmt::format("UR {}:{}", host, port)), host_(std::move(host)), port_(port) {}
  ~RtdeSource() override { RtdeSource::stop(); }

 protected:
  void run(const std::stop_token& stopping) override {
    while (!stopping.stop_requested()) {
      std::string why;
      auto made = TcpConnection::connect(host_, port_, kRtdePatience);
      if (made) {
        link_.emplace(std::move(*made));
        reader_ = {};
        clock_ = {};
        lastStamp_.reset();
        if (const auto ready = setUp(stopping); ready) {
          listen(stopping);
          link_->send(rtde::package(rtde::kPause, {}));
          why = heft::say("The connection to {}:{} was lost; reconnecting.", host_, port_);
        } else {
          why = ready.error().message;
        }
        link_.reset();
      } else {
        why = made.error().message;
      }
      if (stopping.stop_requested()) return;
      const bool was = status().state == LinkState::live || status().state == LinkState::lost;
      setState(was ? LinkState::lost : LinkState::connecting, why);
      for (int i = 0; i < 10 && !stopping.stop_requested(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }

 private:
  /// The next whole package, or nothing after `seconds` or once the connection is gone.
  std::optional<rtde::Received> next(double seconds) {
    const double deadline = hostNow() + seconds;
    for (;;) {
      if (auto whole = reader_.next()) return whole;
      if (reader_.broken()) {
        count([](SourceStatus& status) { ++status.malformed; });
        return std::nullopt;
      }
      const double left = deadline - hostNow();
      if (left <= 0.0 || !link_->open()) return std::nullopt;
      reader_.add(link_->receive(std::min(left, 0.1)));
    }
  }

  /// The answer of that type; texts before it are kept for the reason.
  Result<std::string> answerTo(rtde::Package type, const std::string& content, const std::stop_token& stopping) {
    link_->send(rtde::package(type, content));
    const double deadline = hostNow() + kRtdePatience;
    std::string said;
    while (!stopping.stop_requested() && link_->open() && !reader_.broken() && hostNow() < deadline) {
      const auto received = next(0.1);
      if (!received) continue;
      if (received->type == type) return received->content;
      if (received->type == rtde::kTextMessage) said = rtde::textOf(received->content);
    }
    return Error{said.empty() ? heft::say("{}:{} does not answer as RTDE. Is it a Universal Robots controller, and is "
                                          "RTDE enabled in its security settings?",
                                          host_, port_)
                              : heft::say("{}:{} says: {}", host_, port_, said)};
  }

  Result<bool> setUp(const std::stop_token& stopping) {
    const auto version = answerTo(rtde::kProtocolVersion, std::string("\0\2", 2), stopping);
    if (!version) return version.error();
    if (*version != std::string(1, '\1'))
      return Error{heft::say("{}:{} does not speak version 2 of RTDE: its software is too old.", host_, port_)};
    const auto controller = answerTo(rtde::kControllerVersion, {}, stopping);
    if (!controller) return controller.error();
    const auto major = ByteReader(*controller, true).read<std::uint32_t>();
    frequency_ = major >= 5 ? kFastest : kFastestBefore5;
    recipe_ = {};
    auto wanted = rtde::outputsWithout({});
    for (int attempt = 0; attempt < 2; ++attempt) {
      const auto answer = answerTo(rtde::kSetUpOutputs, rtde::outputRequest(frequency_, wanted), stopping);
      if (!answer) return answer.error();
      const auto missing = rtde::missingIn(*answer, wanted);
      if (missing.empty()) {
        recipe_ = {(*answer)[0], wanted};
        break;
      }
      if (const auto needed = std::ranges::find_if(missing, rtde::isNeeded); needed != missing.end())
        return Error{heft::say("{}:{} does not send {}.", host_, port_, *needed)};
      wanted = rtde::outputsWithout(missing);
    }
    if (recipe_.outputs.empty())
      return Error{heft::say("{}:{} does not accept the outputs that are asked for.", host_, port_)};
    sayWhatIsMissing();
    const auto started = answerTo(rtde::kStart, {}, stopping);
    if (!started) return started.error();
    if (*started != std::string(1, '\1')) return Error{heft::say("{}:{} does not start to send.", host_, port_)};
    return true;
  }

  void sayWhatIsMissing() {
    const bool wrench = std::ranges::find(recipe_.outputs, "ft_raw_wrench") != recipe_.outputs.end();
    count([&](SourceStatus& status) {
      status.topics = recipe_.outputs;
      status.notes.clear();
      if (!wrench)
        status.notes.push_back(
            heft::say("This controller does not send ft_raw_wrench (e-Series do from 5.9 on), and its actual_TCP_force "
                      "already has the payload subtracted: the wrench must come from a separate sensor."));
    });
  }

  void listen(const std::stop_token& stopping) {
    double heard = hostNow();
    while (!stopping.stop_requested() && link_->open() && !reader_.broken() && hostNow() - heard < kRtdeSilence) {
      const auto received = next(0.1);
      if (!received) continue;
      if (received->type == rtde::kTextMessage) {
        const auto said = rtde::textOf(received->content);
        count([&](SourceStatus& status) { status.text = said; });
      }
      if (received->type != rtde::kData) continue;
      heard = hostNow();
      if (!take(received->content, heard)) count([](SourceStatus& status) { ++status.malformed; });
    }
  }

  bool take(const std::string& content, double now) {
    const auto row = rtde::rowOf(content, recipe_);
    const auto at = row ? rtde::stampOf(*row) : std::nullopt;
    if (!at) return false;
    const double stamp = *at;
    if (lastStamp_) {
      // A controller that was started anew counts from zero.
      if (stamp <= *lastStamp_ && stamp > *lastStamp_ - 5.0) {
        count([](SourceStatus& status) { ++status.reordered; });
        return true;
      }
      const double steps = std::round((stamp - *lastStamp_) * frequency_);
      if (steps > 1.0 && steps < 1e6)
        count([&](SourceStatus& status) { status.lost += static_cast<std::uint64_t>(steps) - 1; });
    }
    lastStamp_ = stamp;
    tellConfigured(rtde::configuredIn(*row));
    auto sample = rtde::sampleOf(*row);
    if (!sample) return false;
    sample->time = clock_.timeOf(stamp, now);
    setState(LinkState::live);
    if (std::isfinite(sample->time)) passOn(*sample);
    return true;
  }

  void tellConfigured(std::optional<ConfiguredPayload> told) {
    if (!told) return;
    count([&](SourceStatus& status) {
      told->changed =
          status.configured && (status.configured->changed || status.configured->payload.mass != told->payload.mass);
      status.configured = std::move(told);
    });
  }

  const std::string host_;
  const std::uint16_t port_;
  std::optional<TcpConnection> link_;
  rtde::PackageReader reader_;
  rtde::Recipe recipe_;
  double frequency_ = kFastest;
  StampClock clock_;
  std::optional<double> lastStamp_;
};

}  // namespace

std::unique_ptr<LiveSource> makeRtdeSource(const std::string& host, std::uint16_t port) {
  return std::make_unique<RtdeSource>(host, port);
}

}  // namespace heft
