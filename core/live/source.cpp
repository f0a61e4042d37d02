#include "core/live/source.h"

#include <charconv>
#include <chrono>
#include <map>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/live/sources.h"
#include "core/live/virtual_source.h"
#include "core/motion/motion.h"

namespace heft {

std::string_view toString(LinkState state) {
  switch (state) {
    case LinkState::idle:
      return "idle";
    case LinkState::connecting:
      return "connecting";
    case LinkState::live:
      return "live";
    case LinkState::lost:
      return "lost";
    case LinkState::failed:
      return "failed";
    case LinkState::finished:
      return "finished";
  }
  return "";
}

double hostNow() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// Derived classes stop in their own destructors, while run() still exists; this only joins what is left.
ThreadedSource::~ThreadedSource() { ThreadedSource::stop(); }

Result<bool> ThreadedSource::start(SampleSink sink) {
  stop();
  sink_ = std::move(sink);
  if (auto ready = prepare(); !ready) {
    setState(LinkState::failed, ready.error().message);
    return ready;
  }
  setState(LinkState::connecting);
  thread_ = std::jthread([this](const std::stop_token& stopping) { run(stopping); });
  return true;
}

void ThreadedSource::stop() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
  thread_ = std::jthread();
  count([](SourceStatus& status) {
    if (status.state != LinkState::finished && status.state != LinkState::failed) status.state = LinkState::idle;
  });
}

SourceStatus ThreadedSource::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

void ThreadedSource::passOn(const LiveSample& sample) {
  count([](SourceStatus& status) { ++status.samples; });
  if (sink_) sink_(sample);
}

void ThreadedSource::setState(LinkState state, std::string text) {
  const std::lock_guard lock(mutex_);
  if (status_.state == LinkState::live && state == LinkState::lost) ++status_.disconnects;
  status_.state = state;
  status_.text = std::move(text);
}

std::vector<std::string> jointNamesOf(const RecordingMeta& meta) {
  std::vector<std::string> names;
  Findings aside;
  if (!meta.robot) return names;
  if (const auto robot = robotFor(meta, aside))
    for (const int joint : robot->movingJoints())
      names.push_back(robot->joints()[static_cast<std::size_t>(joint)].name);
  return names;
}

namespace {

struct Address {
  std::string kind;  ///< Before the first colon.
  std::string rest;  ///< Host and port, or a file.
  std::map<std::string, std::string> parameters;
  std::string whole;

  /// Takes the parameter out; empty without one.
  std::string take(const std::string& name) {
    const auto node = parameters.extract(name);
    return node.empty() ? std::string() : node.mapped();
  }
  /// Once all that are known are taken out.
  std::optional<Error> unknownParameter() const {
    if (parameters.empty()) return std::nullopt;
    return Error{
        heft::say("\"{}\" in \"{}\" is not known.", printable(parameters.begin()->first), printable(whole, 100))};
  }
};

std::optional<std::uint16_t> portOf(std::string_view text) {
  unsigned port = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (code != std::errc() || end != text.data() + text.size() || port == 0 || port > 65535) return std::nullopt;
  return static_cast<std::uint16_t>(port);
}

std::optional<double> positive(const std::string& text) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size() || !(value > 0.0) || value > 1e12) return std::nullopt;
  return value;
}

Error badAddress(const std::string& address) {
  return Error{
      heft::say("\"{}\" is not a live source. Sources are rtde:HOST[:PORT], rdt:HOST[:PORT], foxglove:HOST[:PORT], "
                "rosbridge:HOST[:PORT], udp:[HOST:]PORT, replay:FILE and virtual:SEED.",
                printable(address, 100))};
}

using Source = Result<std::unique_ptr<LiveSource>>;

/// KIND:REST or KIND://REST, then ?NAME=VALUE&NAME=VALUE.
std::optional<Address> addressIn(const std::string& text) {
  Address out;
  out.whole = text;
  const auto colon = text.find(':');
  if (colon == std::string::npos || colon + 1 == text.size()) return std::nullopt;
  out.kind = text.substr(0, colon);
  out.rest = text.substr(colon + 1);
  if (out.rest.starts_with("//")) out.rest.erase(0, 2);
  const auto mark = out.rest.rfind('?');
  if (mark == std::string::npos) return out;
  std::string_view query = std::string_view(out.rest).substr(mark + 1);
  while (!query.empty()) {
    const auto pair = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(query.size(), pair.size() + 1));
    const auto sign = pair.find('=');
    if (sign == std::string_view::npos) return std::nullopt;
    out.parameters[std::string(pair.substr(0, sign))] = pair.substr(sign + 1);
  }
  out.rest.resize(mark);
  return out;
}

struct HostAndPort {
  std::string host;  ///< Empty: this machine; of UDP only
  std::optional<std::uint16_t> port;
};

std::optional<HostAndPort> hostAndPort(const Address& address) {
  HostAndPort out{address.rest, {}};
  const bool udp = address.kind == "udp";
  if (const auto last = out.host.rfind(':'); last != std::string::npos) {
    out.port = portOf(std::string_view(out.host).substr(last + 1));
    if (!out.port) return std::nullopt;
    out.host.resize(last);
  } else if (udp) {
    out.port = portOf(out.host);
    if (!out.port) return std::nullopt;
    out.host.clear();
  }
  if (out.host.empty() && !udp) return std::nullopt;
  return out;
}

Source virtualSource(const std::string& address) {
  std::uint64_t seed = 1;
  const std::string_view digits = std::string_view(address).substr(std::min<std::size_t>(8, address.size()));
  const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), seed);
  if (!digits.empty() && (code != std::errc() || end != digits.data() + digits.size())) return badAddress(address);
  VirtualRigOptions options;
  options.seed = seed;
  options.payload = practiceTool(seed);
  auto source = VirtualSource::create(RobotModel::panda(), options, VirtualSource::Pace::realTime);
  if (!source) return source.error();
  (*source)->guide([](GuidedArm& arm) { arm.wander(); });
  return std::unique_ptr<LiveSource>(std::move(*source));
}

Source replaySource(Address address, const std::filesystem::path& meta) {
  double speed = 1.0;
  if (const auto text = address.take("speed"); !text.empty()) {
    const auto value = positive(text);
    if (!value) return badAddress(address.whole);
    speed = *value;
  }
  if (auto failure = address.unknownParameter()) return *failure;
  return makeReplaySource(address.rest, speed, meta);
}

Source rdtSource(Address address, const HostAndPort& at) {
  RdtSettings settings;
  settings.host = at.host;
  settings.port = at.port.value_or(49152);
  for (const auto& [name, target] :
       {std::pair{"cpf", &settings.countsPerNewton}, std::pair{"cpt", &settings.countsPerNewtonMetre}}) {
    const auto text = address.take(name);
    if (text.empty()) continue;
    const auto value = positive(text);
    if (!value) return badAddress(address.whole);
    *target = *value;
  }
  if (auto failure = address.unknownParameter()) return *failure;
  if ((settings.countsPerNewton > 0.0) != (settings.countsPerNewtonMetre > 0.0))
    return Error{heft::say("cpf and cpt, the counts per newton and per newton metre, must be given together.")};
  return makeRdtSource(settings);
}

}  // namespace

Result<std::unique_ptr<LiveSource>> makeLiveSource(const std::string& text, const std::filesystem::path& replayMeta,
                                                   const std::vector<std::string>& jointNames,
                                                   const Conventions& conventions) {
  if (text == "virtual" || text.starts_with("virtual:")) return virtualSource(text);
  auto address = addressIn(text);
  if (!address) return badAddress(text);
  if (address->kind == "replay") return replaySource(std::move(*address), replayMeta);
  const auto at = hostAndPort(*address);
  if (!at) return badAddress(text);
  if (address->kind == "rdt") return rdtSource(std::move(*address), *at);
  RosbridgeTopics topics;
  if (address->kind == "rosbridge") topics = {address->take("wrench"), address->take("joints")};
  if (auto failure = address->unknownParameter()) return *failure;
  if (address->kind == "udp")
    return makeJsonUdpSource(at->host.empty() ? "127.0.0.1" : at->host, *at->port, jointNames, conventions);
  if (address->kind == "rtde") return makeRtdeSource(at->host, at->port.value_or(30004));
  if (address->kind == "foxglove")
    return makeFoxgloveSource(at->host, at->port.value_or(8765), jointNames, conventions);
  if (address->kind == "rosbridge")
    return makeRosbridgeSource(at->host, at->port.value_or(9090), topics, jointNames, conventions);
  return badAddress(text);
}

}  // namespace heft
