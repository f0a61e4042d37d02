// JSON over UDP: one object a datagram, with the names that a CSV's columns have.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "core/base/say.h"
#include "core/import/json_numbers.h"
#include "core/import/time_column.h"
#include "core/live/field_mapper.h"
#include "core/live/network.h"
#include "core/live/sources.h"
#include "core/recording/clock.h"

namespace heft {

namespace {

/// Which of motion, wrench and inertial sensor a sample holds: 0 to 7.
std::size_t partsOf(const LiveSample& sample) {
  return (sample.hasMotion() ? 1U : 0U) | (sample.wrench ? 2U : 0U) | (sample.accelerometer ? 4U : 0U);
}

constexpr double kSenderGone = 1.0;  ///< [s] after which the sender counts as gone

class JsonUdpSource : public ThreadedSource {
 public:
  JsonUdpSource(std::string host, std::uint16_t port, std::vector<std::string> jointNames,
                const Conventions& conventions)
      : ThreadedSource(fmt::format("JSON over UDP {}:{}", host, port)),
        host_(std::move(host)),
        port_(port),
        mapper_(std::move(jointNames), conventions) {}
  ~JsonUdpSource() override { JsonUdpSource::stop(); }

 protected:
  Result<bool> prepare() override {
    auto socket = UdpSocket::listening(host_, port_);
    if (!socket) return socket.error();
    socket_.emplace(std::move(*socket));
    return true;
  }

  void run(const std::stop_token& stopping) override {
    double heard = hostNow();
    while (!stopping.stop_requested()) {
      const auto bytes = socket_->receive(0.1);
      const double now = bytes ? socket_->arrival() : hostNow();
      if (bytes) {
        take(*bytes, now);
        heard = now;
      } else if (now - heard > kSenderGone) {
        setState(LinkState::lost, heft::say("Nothing arrives at {}:{}.", host_, port_));
        heard = now;
      }
    }
    socket_.reset();
  }

 private:
  void take(std::string_view bytes, double now) {
    const NamedNumbers* const numbers = json_.read(bytes);
    if (numbers == nullptr) {
      count([](SourceStatus& status) { ++status.malformed; });
      return;
    }
    const std::vector<double>& values = numbers->values;
    auto sample = mapper_.map({}, {}, numbers->names, values);
    if (!sample) {
      count([](SourceStatus& status) {
        ++status.malformed;
        status.text = heft::say("The objects have neither joint angles or a pose, nor fx, fy, fz, tx, ty, tz.");
      });
      return;
    }
    sample->time = now;
    if (const auto time = mapper_.timeColumn({}, {}, numbers->names); time && std::isfinite(values[time->index])) {
      const double unit = time->unitKnown ? time->unit : unitOfTimes({values[time->index]});
      const double stamp = values[time->index] * unit;
      // A sender that begins anew, seconds back, is a new beginning; less is a packet that took another way.
      std::optional<double>& last = lastStamps_[partsOf(*sample)];
      if (last && stamp <= *last && stamp > *last - 5.0) {
        count([](SourceStatus& status) { ++status.reordered; });
        return;
      }
      last = stamp;
      sample->time = clock_.timeOf(stamp, now);
    }
    if (const auto notes = mapper_.notes(); !notes.empty()) count([&](SourceStatus& status) { status.notes = notes; });
    setState(LinkState::live);
    if (std::isfinite(sample->time)) passOn(*sample);
  }

  const std::string host_;
  const std::uint16_t port_;
  std::optional<UdpSocket> socket_;
  FieldMapper mapper_;
  StampClock clock_;
  std::array<std::optional<double>, 8> lastStamps_;  ///< By partsOf(): each may come in objects of its own
  JsonNumbers json_;
};

}  // namespace

std::unique_ptr<LiveSource> makeJsonUdpSource(const std::string& host, std::uint16_t port,
                                              const std::vector<std::string>& jointNames,
                                              const Conventions& conventions) {
  return std::make_unique<JsonUdpSource>(host, port, jointNames, conventions);
}

}  // namespace heft
