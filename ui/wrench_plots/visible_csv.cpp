#include "ui/wrench_plots/visible_csv.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace heft {

std::string visibleCsv(const WrenchTraces& traces, double from, double to) {
  using Kind = WrenchTraces::Kind;
  static constexpr const char* kNames[6] = {"fx", "fy", "fz", "tx", "ty", "tz"};
  std::string text = traces.poses() ? "pose" : "time";
  for (const char* name : kNames) text += fmt::format(",{}", name);
  if (traces.hasSimulated()) {
    for (const char* kind : {"simulated", "difference"})
      for (const char* name : kNames) text += fmt::format(",{}_{}", name, kind);
  }
  text += '\n';
  const auto out = std::back_inserter(text);
  for (const double time : traces.timesWithin(from, to)) {
    fmt::format_to(out, "{}", time);
    for (const Kind kind : {Kind::measured, Kind::simulated, Kind::difference}) {
      if (kind != Kind::measured && !traces.hasSimulated()) break;
      for (int channel = 0; channel < 6; ++channel) {
        const double value = traces.valueAt(kind, channel, time);
        text += ',';
        if (std::isfinite(value)) fmt::format_to(out, "{}", value);
      }
    }
    text += '\n';
  }
  return text;
}

}  // namespace heft
