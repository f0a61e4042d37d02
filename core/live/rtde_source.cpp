// Universal Robots' Real-Time Data Exchange, protocol version 2, by the RTDE guide of Universal Robots: TCP,
// big-endian. A package is its size (16 bits, header included), a type (8 bits) and the content. After the version is
// agreed on, the client names the outputs it wants, the controller answers with a recipe's number and their types, and
// sends them at the frequency asked for once it is started.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/bytes.h"
#include "core/live/clock.h"
#include "core/live/network.h"
#include "core/live/sources.h"

namespace heft {

namespace {

/// The types of packages that this client sends or reads. Those that write inputs (I, and U towards the robot) are none
/// of ours.
enum Package : char {
  kProtocolVersion = 'V',
  kControllerVersion = 'v',
  kTextMessage = 'M',
  kData = 'U',
  kSetUpOutputs = 'O',
  kStart = 'S',
  kPause = 'P',
};

constexpr double kRtdePatience = 2.0;  ///< [s] For a connection, and for each answer
constexpr double kRtdeSilence = 1.0;   ///< [s] Without data, after which the connection counts as lost
constexpr double kFastest = 500.0;     ///< [Hz] From version 5 on (e-Series); 125 before
constexpr double kFastestBefore5 = 125.0;
constexpr std::size_t kHeader = 3;
constexpr std::size_t kMostWaiting = 1u << 20;  ///< Bytes that wait for the rest of their package

/// What is asked for, and how many numbers each has by the guide.
struct Output {
  const char* name;
  const char* type;
  std::size_t numbers;
  bool needed;
};
constexpr std::array<Output, 7> kOutputs{{{"timestamp", "DOUBLE", 1, true},
                                          {"actual_q", "VECTOR6D", 6, true},
                                          {"actual_qd", "VECTOR6D", 6, false},
                                          {"ft_raw_wrench", "VECTOR6D", 6, false},
                                          {"payload", "DOUBLE", 1, false},
                                          {"payload_cog", "VECTOR3D", 3, false},
                                          {"payload_inertia", "VECTOR6D", 6, false}}};

std::string package(Package type, const std::string& content) {
  const auto size = kHeader + content.size();
  std::string out{static_cast<char>(size >> 8 & 0xFF), static_cast<char>(size & 0xFF), type};
  return out + content;
}

std::string bigEndian(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  std::string out;
  for (int shift = 56; shift >= 0; shift -= 8) out += static_cast<char>(bits >> shift & 0xFF);
  return out;
}

std::vector<std::string> split(std::string_view list) {
  std::vector<std::string> out;
  for (;;) {
    const auto comma = list.find(',');
    out.emplace_back(list.substr(0, comma));
    if (comma == std::string_view::npos) return out;
    list.remove_prefix(comma + 1);
  }
}

/// Numbers by the names of their outputs.
using Values = std::map<std::string, std::vector<double>>;

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
        waiting_.clear();
        clock_ = {};
        lastStamp_.reset();
        if (const auto ready = setUp(stopping); ready) {
          listen(stopping);
          link_->send(package(kPause, {}));
          why = heft::say("The connection to {}:{} broke; it is tried again.", host_, port_);
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
  struct Received {
    char type = 0;
    std::string content;
  };

  /// The next whole package, or nothing after `seconds` or once the connection is gone.
  std::optional<Received> next(double seconds) {
    const double deadline = hostNow() + seconds;
    for (;;) {
      if (waiting_.size() >= kHeader) {
        const auto size = static_cast<std::size_t>(static_cast<unsigned char>(waiting_[0])) << 8 |
                          static_cast<unsigned char>(waiting_[1]);
        if (size < kHeader) {  // no way to find the next one
          count([](SourceStatus& status) { ++status.malformed; });
          waiting_.clear();
          broken_ = true;
          return std::nullopt;
        }
        if (waiting_.size() >= size) {
          Received out{waiting_[2], waiting_.substr(kHeader, size - kHeader)};
          waiting_.erase(0, size);
          return out;
        }
      }
      const double left = deadline - hostNow();
      if (left <= 0.0 || !link_->open() || waiting_.size() > kMostWaiting) return std::nullopt;
      waiting_ += link_->receive(std::min(left, 0.1));
    }
  }

  /// The answer of that type; texts before it are kept for the reason.
  Result<std::string> answerTo(Package type, const std::string& content, const std::stop_token& stopping) {
    link_->send(package(type, content));
    const double deadline = hostNow() + kRtdePatience;
    std::string said;
    while (!stopping.stop_requested() && link_->open() && !broken_ && hostNow() < deadline) {
      const auto received = next(0.1);
      if (!received) continue;
      if (received->type == type) return received->content;
      if (received->type == kTextMessage) said = textOf(received->content);
    }
    return Error{
        said.empty()
            ? heft::say("{}:{} does not answer as RTDE does. Is it a controller of Universal Robots, and is RTDE "
                        "enabled in its security settings?",
                        host_, port_)
            : heft::say("{}:{} says: {}", host_, port_, said)};
  }

  /// The message of a text package: its length, then its characters.
  static std::string textOf(const std::string& content) {
    if (content.empty()) return {};
    return printable(content.substr(1, static_cast<unsigned char>(content[0])), 200);
  }

  Result<bool> setUp(const std::stop_token& stopping) {
    broken_ = false;
    const auto version = answerTo(kProtocolVersion, std::string("\0\2", 2), stopping);
    if (!version) return version.error();
    if (*version != std::string(1, '\1'))
      return Error{heft::say("{}:{} does not speak version 2 of RTDE: its software is too old.", host_, port_)};
    const auto controller = answerTo(kControllerVersion, {}, stopping);
    if (!controller) return controller.error();
    const auto major = ByteReader(*controller, true).read<std::uint32_t>();
    frequency_ = major >= 5 ? kFastest : kFastestBefore5;
    auto wanted = outputsOf({});
    for (int attempt = 0; attempt < 2; ++attempt) {
      auto content = bigEndian(frequency_);
      content += fmt::format("{}", fmt::join(wanted, ","));
      const auto answer = answerTo(kSetUpOutputs, content, stopping);
      if (!answer) return answer.error();
      const auto types = split(std::string_view(*answer).substr(std::min<std::size_t>(1, answer->size())));
      std::vector<std::string> missing;
      for (std::size_t i = 0; i < wanted.size(); ++i)
        if (i >= types.size() || types[i] != typeOf(wanted[i])) missing.push_back(wanted[i]);
      if (missing.empty()) {
        recipe_ = (*answer)[0];
        names_ = wanted;
        break;
      }
      for (const auto& output : kOutputs)
        if (output.needed && std::find(missing.begin(), missing.end(), output.name) != missing.end())
          return Error{heft::say("{}:{} does not send {}.", host_, port_, output.name)};
      wanted = outputsOf(missing);
      names_.clear();
    }
    if (names_.empty()) return Error{heft::say("{}:{} does not accept the outputs that are asked for.", host_, port_)};
    sayWhatIsMissing();
    const auto started = answerTo(kStart, {}, stopping);
    if (!started) return started.error();
    if (*started != std::string(1, '\1')) return Error{heft::say("{}:{} does not start to send.", host_, port_)};
    return true;
  }

  static std::vector<std::string> outputsOf(const std::vector<std::string>& without) {
    std::vector<std::string> out;
    for (const auto& output : kOutputs)
      if (std::find(without.begin(), without.end(), output.name) == without.end()) out.emplace_back(output.name);
    return out;
  }
  static std::string typeOf(const std::string& name) {
    const auto found = std::find_if(kOutputs.begin(), kOutputs.end(), [&](const Output& o) { return o.name == name; });
    return found->type;
  }

  void sayWhatIsMissing() {
    const bool wrench = std::find(names_.begin(), names_.end(), "ft_raw_wrench") != names_.end();
    count([&](SourceStatus& status) {
      status.topics = names_;
      status.notes.clear();
      if (!wrench)
        status.notes.push_back(heft::say(
            "This controller does not send ft_raw_wrench (e-Series from 5.9 on do), and from actual_TCP_force "
            "it has taken the payload already: the wrench must come from a sensor of its own."));
    });
  }

  void listen(const std::stop_token& stopping) {
    double heard = hostNow();
    while (!stopping.stop_requested() && link_->open() && !broken_ && hostNow() - heard < kRtdeSilence) {
      const auto received = next(0.1);
      if (!received) continue;
      if (received->type == kTextMessage) {
        const auto said = textOf(received->content);
        count([&](SourceStatus& status) { status.text = said; });
      }
      if (received->type != kData) continue;
      heard = hostNow();
      if (!take(received->content, heard)) count([](SourceStatus& status) { ++status.malformed; });
    }
  }

  bool take(const std::string& content, double now) {
    std::size_t numbers = 0;
    for (const auto& output : kOutputs)
      if (std::find(names_.begin(), names_.end(), output.name) != names_.end()) numbers += output.numbers;
    if (content.size() != 1 + 8 * numbers || content[0] != recipe_) return false;
    ByteReader reader(std::string_view(content).substr(1), true);
    Values values;
    for (const auto& output : kOutputs) {
      if (std::find(names_.begin(), names_.end(), output.name) == names_.end()) continue;
      auto& into = values[output.name];
      for (std::size_t i = 0; i < output.numbers; ++i) into.push_back(reader.read<double>());
    }
    const double stamp = values["timestamp"][0];
    if (!std::isfinite(stamp)) return false;
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
    tellConfigured(values);
    LiveSample sample;
    sample.joints = 6;
    sample.q = joints(values["actual_q"]);
    if (const auto found = values.find("actual_qd"); found != values.end()) sample.dq = joints(found->second);
    if (const auto found = values.find("ft_raw_wrench"); found != values.end()) {
      const Vector6d wrench(found->second.data());
      if (wrench.allFinite()) sample.wrench = wrench;
    }
    if (!sample.q) return false;
    sample.time = clock_.timeOf(stamp, now);
    setState(LinkState::live);
    if (std::isfinite(sample.time)) passOn(sample);
    return true;
  }

  static std::optional<std::array<double, 7>> joints(const std::vector<double>& values) {
    std::array<double, 7> out{};
    for (std::size_t i = 0; i < values.size() && i < out.size(); ++i) {
      if (!std::isfinite(values[i])) return std::nullopt;
      out[i] = values[i];
    }
    return out;
  }

  void tellConfigured(const Values& values) {
    const auto mass = values.find("payload");
    if (mass == values.end() || !std::isfinite(mass->second[0])) return;
    ConfiguredPayload told;
    told.source = "payload";
    told.flange = "tool0";
    told.payload.mass = mass->second[0];
    if (const auto com = values.find("payload_cog"); com != values.end())
      told.payload.com = Vector3d(com->second.data());
    if (const auto found = values.find("payload_inertia"); found != values.end()) {
      const auto& v = found->second;  // Ixx, Iyy, Izz, Ixy, Ixz, Iyz
      Matrix3d I;
      I << v[0], v[3], v[4], v[3], v[1], v[5], v[4], v[5], v[2];
      told.payload.inertiaCom = I;
    }
    count([&](SourceStatus& status) {
      told.changed =
          status.configured && (status.configured->changed || status.configured->payload.mass != told.payload.mass);
      status.configured = told;
    });
  }

  const std::string host_;
  const std::uint16_t port_;
  std::optional<TcpConnection> link_;
  std::string waiting_;  ///< Received, not yet a whole package
  bool broken_ = false;
  double frequency_ = kFastest;
  char recipe_ = 0;
  std::vector<std::string> names_;  ///< Of the recipe, in the order of kOutputs
  StampClock clock_;
  std::optional<double> lastStamp_;
};

}  // namespace

std::unique_ptr<LiveSource> makeRtdeSource(const std::string& host, std::uint16_t port) {
  return std::make_unique<RtdeSource>(host, port);
}

}  // namespace heft
