#pragma once
// How long work tells how far it is and learns that it should stop. Free of Qt; ui/jobs turns it into signals.
#include <functional>
#include <stop_token>
#include <string_view>

namespace heft {

/// Passed by const reference into long work. A default one reports nowhere and never stops.
struct Progress {
  std::stop_token stop;
  std::function<void(double fraction, std::string_view what)> report;

  bool cancelled() const { return stop.stop_requested(); }
  void operator()(double fraction, std::string_view what) const {
    if (report) report(fraction, what);
  }
};

}  // namespace heft
