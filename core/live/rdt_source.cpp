// Net F/T Raw Data Transfer: UDP, big-endian. Request: 0x1234, command, count; record: three numbers of 32 bits
// (sequence of the transfer, sequence of the sensor, status), then six counts of 32 bits with sign.
#include <algorithm>
#include <charconv>
#include <set>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/bytes.h"
#include "core/live/network.h"
#include "core/live/sources.h"
#include "core/recording/clock.h"

namespace heft {

namespace {

constexpr std::size_t kRecordBytes = 36;
constexpr std::size_t kMostRecords = 40;     ///< In one packet, by the specification
constexpr double kAskAgain = 1.0;            ///< [s] after which the stream is asked for again
constexpr std::uint32_t kRemembered = 1000;  ///< Missing numbers that may still come late
enum Command : unsigned char { kStop = 0, kRealTime = 2 };

std::string request(Command command) {
  return {'\x12', '\x34', '\0', static_cast<char>(command), '\0', '\0', '\0', '\0'};
}

/// The text of the first element `name`.
std::string_view element(std::string_view xml, const std::string& name) {
  const auto open = xml.find("<" + name + ">");
  if (open == std::string_view::npos) return {};
  const auto start = open + name.size() + 2;
  const auto close = xml.find("</" + name + ">", start);
  return close == std::string_view::npos ? std::string_view() : xml.substr(start, close - start);
}

double numberOf(std::string_view text) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  return code == std::errc() && end == text.data() + text.size() ? value : 0.0;
}

class RdtSource : public ThreadedSource {
 public:
  explicit RdtSource(RdtSettings settings)
      : ThreadedSource(fmt::format("Net F/T {}", settings.host)), settings_(std::move(settings)) {}
  ~RdtSource() override { RdtSource::stop(); }

 protected:
  Result<bool> prepare() override {
    auto socket = UdpSocket::connected(settings_.host, settings_.port);
    if (!socket) return socket.error();
    socket_.emplace(std::move(*socket));
    return true;
  }

  void run(const std::stop_token& stopping) override {
    while (!stopping.stop_requested() && settings_.countsPerNewton <= 0.0) {
      if (const auto known = askUnits(); !known) setState(LinkState::connecting, known.error().message);
      for (int i = 0; i < 10 && settings_.countsPerNewton <= 0.0 && !stopping.stop_requested(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    double heard = hostNow();
    if (!stopping.stop_requested()) socket_->send(request(kRealTime));
    while (!stopping.stop_requested()) {
      const auto bytes = socket_->receive(0.1);
      const double now = hostNow();
      if (bytes) {
        take(*bytes, now);
        heard = now;
      } else if (now - heard > kAskAgain) {
        setState(LinkState::lost, heft::say("{} sends nothing. Is RDT enabled on its web page? Is another program "
                                            "using the stream? It serves only one client.",
                                            settings_.host));
        socket_->send(request(kRealTime));
        heard = now;
        started_ = false;
      }
    }
    socket_->send(request(kStop));
    socket_.reset();
  }

 private:
  Result<bool> askUnits() {
    const auto page = httpGet(settings_.host, settings_.httpPort, "/netftapi2.xml");
    if (!page)
      return Error{
          heft::say("{} Its counts per newton can be given instead: rdt:HOST?cpf=N&cpt=N.", page.error().message)};
    const auto force = element(*page, "scfgfu");
    const auto torque = element(*page, "scfgtu");
    if ((!force.empty() && force != "N") || (!torque.empty() && torque != "N-m" && torque != "Nm"))
      return Error{heft::say("The sensor is set to {} and {}: choose N and N-m on its web page.", printable(force),
                             printable(torque))};
    const double perForce = numberOf(element(*page, "cfgcpf"));
    const double perTorque = numberOf(element(*page, "cfgcpt"));
    if (!(perForce > 0.0) || !(perTorque > 0.0))
      return Error{heft::say("The sensor does not state its counts per newton; give them: rdt:HOST?cpf=N&cpt=N.")};
    settings_.countsPerNewton = perForce;
    settings_.countsPerNewtonMetre = perTorque;
    return true;
  }

  void take(const std::string& bytes, double now) {
    // Boxes that know buffered streaming alone send several records at once, whatever was asked for.
    if (bytes.empty() || bytes.size() % kRecordBytes != 0 || bytes.size() > kMostRecords * kRecordBytes) {
      count([](SourceStatus& status) { ++status.malformed; });
      return;
    }
    for (std::size_t at = 0; at < bytes.size(); at += kRecordBytes)
      takeRecord(std::string_view(bytes).substr(at, kRecordBytes), now);
  }

  void takeRecord(std::string_view record, double now) {
    ByteReader reader(record, true);
    const auto number = reader.read<std::uint32_t>();
    reader.read<std::uint32_t>();  // the sensor's own sequence runs faster than the transfer
    const auto state = reader.read<std::uint32_t>();
    if (started_) {
      // The difference modulo 2^32, with sign, tells later from earlier over the wrap.
      const auto step = static_cast<std::int32_t>(number - number_);
      if (step <= 0) {
        const bool missed = missing_.erase(number) > 0;
        count([missed](SourceStatus& status) {
          ++status.reordered;
          if (missed) --status.lost;
        });
        // A sensor that was switched off and on counts from the start.
        if (step < -100000 || ++old_ > 100) started_ = false;
        return;
      }
      if (step > 1) count([&](SourceStatus& status) { status.lost += static_cast<std::uint64_t>(step - 1); });
      for (std::uint32_t n = number - std::min(static_cast<std::uint32_t>(step) - 1, kRemembered); n != number; ++n)
        missing_.insert(n);
      while (missing_.size() > kRemembered) missing_.erase(missing_.begin());
      sequence_ += step;
    } else {
      started_ = true;
      missing_.clear();
      ++sequence_;
    }
    old_ = 0;
    number_ = number;
    if (state != 0) count([](SourceStatus& status) { ++status.flagged; });
    LiveSample sample;
    sample.time = clock_.timeOf(sequence_, now);
    Vector6d wrench;
    for (int a = 0; a < 6; ++a)
      wrench(a) = reader.read<std::int32_t>() / (a < 3 ? settings_.countsPerNewton : settings_.countsPerNewtonMetre);
    sample.wrench = wrench;
    setState(LinkState::live);
    passOn(sample);
  }

  RdtSettings settings_;
  std::optional<UdpSocket> socket_;
  SequenceClock clock_;
  bool started_ = false;
  std::uint32_t number_ = 0;
  std::set<std::uint32_t> missing_;  ///< Counted as lost
  std::int64_t sequence_ = 0;
  int old_ = 0;
};

}  // namespace

std::unique_ptr<LiveSource> makeRdtSource(const RdtSettings& settings) { return std::make_unique<RdtSource>(settings); }

}  // namespace heft
