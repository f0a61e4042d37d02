#include "core/base/say.h"
#include "core/live/network.h"
#include "core/live/rdt_protocol.h"
#include "core/live/sources.h"

namespace heft {

namespace {

constexpr double kAskAgain = 1.0;  ///< [s] after which the stream is asked for again

class RdtSource : public ThreadedSource {
 public:
  explicit RdtSource(RdtSettings settings)
      : ThreadedSource(fmt::format("Net F/T {}", settings.host)),
        settings_(std::move(settings)),
        units_{settings_.countsPerNewton, settings_.countsPerNewtonMetre} {}
  ~RdtSource() override { RdtSource::stop(); }

 protected:
  Result<bool> prepare() override {
    auto socket = UdpSocket::connected(settings_.host, settings_.port);
    if (!socket) return socket.error();
    socket_.emplace(std::move(*socket));
    return true;
  }

  void run(const std::stop_token& stopping) override {
    while (!stopping.stop_requested() && !units_.known()) {
      if (const auto known = askUnits(); !known) setState(LinkState::connecting, known.error().message);
      for (int i = 0; i < 10 && !units_.known() && !stopping.stop_requested(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    double heard = hostNow();
    if (!stopping.stop_requested()) socket_->send(rdt::request(rdt::kRealTime));
    while (!stopping.stop_requested()) {
      const auto bytes = socket_->receive(0.1);
      const double now = bytes ? socket_->arrival() : hostNow();
      if (bytes) {
        take(*bytes, now);
        heard = now;
      } else if (now - heard > kAskAgain) {
        setState(LinkState::lost, heft::say("{} sends nothing. Is RDT enabled on its web page? Is another program "
                                            "using the stream? It serves only one client.",
                                            settings_.host));
        socket_->send(rdt::request(rdt::kRealTime));
        heard = now;
        records_.restart();
      }
    }
    socket_->send(rdt::request(rdt::kStop));
    socket_.reset();
  }

 private:
  Result<bool> askUnits() {
    const auto page = httpGet(settings_.host, settings_.httpPort, "/netftapi2.xml");
    if (!page)
      return Error{
          heft::say("{} Its counts per newton can be given instead: rdt:HOST?cpf=N&cpt=N.", page.error().message)};
    const auto units = rdt::unitsIn(*page);
    if (!units) return units.error();
    units_ = *units;
    return true;
  }

  void take(std::string_view bytes, double now) {
    rdt::Counts counts;
    const auto samples = records_.read(bytes, units_, now, counts);
    count([&](SourceStatus& status) {
      status.lost = status.lost + counts.lost - counts.late;
      status.reordered += counts.reordered;
      status.malformed += counts.malformed;
      status.flagged += counts.flagged;
    });
    for (const LiveSample& sample : samples) {
      setState(LinkState::live);
      passOn(sample);
    }
  }

  RdtSettings settings_;
  rdt::Units units_;
  std::optional<UdpSocket> socket_;
  rdt::RecordReader records_;
};

}  // namespace

std::unique_ptr<LiveSource> makeRdtSource(const RdtSettings& settings) { return std::make_unique<RdtSource>(settings); }

}  // namespace heft
