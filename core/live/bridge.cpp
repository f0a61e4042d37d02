#include "core/live/bridge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/say.h"
#include "core/import/configured.h"
#include "core/import/streams.h"

namespace heft {

namespace {

constexpr double kPatience = 2.0;  ///< [s] For a connection.
constexpr double kSilence = 2.0;   ///< [s] without a sample, after which the user is told.

}  // namespace

BridgeSource::BridgeSource(const std::string& what, std::string host, std::uint16_t port, std::string protocols,
                           std::vector<std::string> jointNames, const Conventions& conventions)
    : ThreadedSource(fmt::format("{} {}:{}", what, host, port)),
      host_(std::move(host)),
      port_(port),
      protocols_(std::move(protocols)),
      jointNames_(std::move(jointNames)),
      conventions_(conventions) {}

void BridgeSource::run(const std::stop_token& stopping) {
  while (!stopping.stop_requested()) {
    auto made = WebSocketClient::connect(host_, port_, protocols_, kPatience);
    if (made) {
      client_.emplace(std::move(*made));
      mapper_ = FieldMapper(jointNames_, conventions_);
      clock_ = {};
      lastStamp_.clear();
      configuredTold_ = false;
      connected();
      talk(stopping);
      client_.reset();
      if (stopping.stop_requested()) return;
      setState(LinkState::lost, heft::say("The connection to {}:{} was lost; reconnecting.", host_, port_));
    } else if (status().state == LinkState::lost) {
      setState(LinkState::lost, made.error().message);
    } else {
      setState(LinkState::connecting, made.error().message);
    }
    for (int i = 0; i < 10 && !stopping.stop_requested(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

bool BridgeSource::talk(const std::stop_token& stopping) {
  double heard = hostNow();
  std::uint64_t before = status().samples;
  while (!stopping.stop_requested() && client_->connected()) {
    const auto received = client_->receive(0.1);
    if (received && !message(*received)) count([](SourceStatus& status) { ++status.malformed; });
    const auto now = hostNow();
    if (const auto samples = status().samples; samples != before) {
      before = samples;
      heard = now;
    } else if (now - heard > kSilence) {
      count([&](SourceStatus& status) {
        status.text =
            status.topics.empty()
                ? heft::say("{} is connected, but no topic with joint states or a wrench is publishing.", status.name)
                : heft::say("{} is connected, but its topics publish nothing.", status.name);
      });
      heard = now;
    }
  }
  return true;
}

void BridgeSource::note(const std::string& sentence) {
  count([&](SourceStatus& status) {
    if (std::find(status.notes.begin(), status.notes.end(), sentence) == status.notes.end())
      status.notes.push_back(sentence);
  });
}

void BridgeSource::tellConfigured(const std::string& type, const std::vector<std::string>& names,
                                  const std::vector<double>& values) {
  if (configuredTold_ || !type.starts_with("franka_msgs/")) return;
  configuredTold_ = true;
  std::vector<Stream> state(1);
  state[0].fields = names;
  for (const double value : values) state[0].values.push_back({value});
  if (auto told = configuredPayload(state)) count([&](SourceStatus& status) { status.configured = std::move(told); });
}

bool BridgeSource::send(const std::string& text) { return client_ && client_->send(text); }

void BridgeSource::take(const std::string& topic, const std::string& type, const std::vector<std::string>& names,
                        const std::vector<double>& values, std::int64_t stamp) {
  tellConfigured(type, names, values);
  auto sample = mapper_.map(topic, type, names, values);
  const double now = hostNow();
  stamp = soundStamp(stamp);
  if (stamp != 0) {
    auto& last = lastStamp_[topic];
    // Seconds back is a sender that began anew; less is a message that came late.
    if (stamp <= last && last - stamp < 5000000000) {
      count([](SourceStatus& status) { ++status.reordered; });
      return;
    }
    last = stamp;
  }
  if (!sample) return;
  sample->time = stamp != 0 ? clock_.timeOf(1e-9 * static_cast<double>(stamp), now) : now;
  const auto topics = mapper_.topics();
  count([&](SourceStatus& status) {
    if (status.topics != topics) status.topics = topics;
  });
  for (const auto& sentence : mapper_.notes()) note(sentence);
  setState(LinkState::live);
  if (std::isfinite(sample->time)) passOn(*sample);
}

void BridgeSource::take(const std::string& topic, const std::string& type, const NamedNumbers& numbers,
                        std::int64_t fallback) {
  std::int64_t stamp = 0;
  for (std::size_t i = 0; i < numbers.names.size(); ++i) {
    const auto& name = numbers.names[i];
    const double value = numbers.values[i];
    if (name == "header.stamp.sec" || name == "header.stamp.secs") stamp += nanoseconds(value);
    if (name == "header.stamp.nanosec" || name == "header.stamp.nsec" || name == "header.stamp.nsecs")
      stamp += nanoseconds(1e-9 * value);
  }
  take(topic, type, numbers.names, numbers.values, stamp != 0 ? stamp : fallback);
}

}  // namespace heft
