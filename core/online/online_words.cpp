#include "core/online/online_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace heft {

namespace {

// Green: as good as a load's data sheet needs it. Yellow: known, but worth improving. What the estimate calls not
// identified is red.
constexpr double kGoodMass = 0.01;     // relative standard deviation
constexpr double kGoodCom = 0.002;     // [m]
constexpr double kGoodInertia = 0.10;  // relative

/// The least that a quantity's numbers rest on.
Source weakest(std::initializer_list<Source> sources) {
  Source worst = Source::data;
  for (const Source s : sources)
    if (s == Source::none || worst == Source::data) worst = s;
  return worst;
}

Excitation judged(Source source, bool good, std::string name, const std::string& size, const std::string& advice) {
  if (source == Source::none) return {ExcitationLight::none, fmt::format("{}: not known yet. {}", name, advice)};
  if (source == Source::prior)
    return {ExcitationLight::coarse, fmt::format("{}: {}, from your shape. {}", name, size, advice)};
  if (!good) return {ExcitationLight::coarse, fmt::format("{}: {}. {}", name, size, advice)};
  return {ExcitationLight::good, fmt::format("{}: {}, measured.", name, size)};
}

}  // namespace

std::string_view toString(ExcitationLight light) {
  switch (light) {
    case ExcitationLight::none:
      return "none";
    case ExcitationLight::coarse:
      return "coarse";
    case ExcitationLight::good:
      return "good";
  }
  return "none";
}

std::string_view toString(Touch touch) {
  switch (touch) {
    case Touch::unknown:
      return "unknown";
    case Touch::free:
      return "free";
    case Touch::contact:
      return "contact";
  }
  return "unknown";
}

void judgeExcitation(OnlineState& state) {
  if (!state.estimated) {
    state.mass = {ExcitationLight::none, "Mass: not known yet. Move the tool without touching anything."};
    state.com = {ExcitationLight::none, "Centre of mass: not known yet. Tilt the tool."};
    state.inertia = {ExcitationLight::none, "Inertia: not known yet. Turn the tool."};
    return;
  }
  const Identifiability& id = state.identifiability;
  const double mass = state.std.mass / state.payload.mass;
  state.mass = judged(id.mass, mass < kGoodMass, "Mass", fmt::format("± {:.1f} %", 196.0 * mass),
                      "Tilt the tool into other directions.");
  const double com = state.std.com.maxCoeff();
  state.com = judged(weakest({id.com[0], id.com[1], id.com[2]}), com < kGoodCom, "Centre of mass",
                     fmt::format("± {:.1f} mm", 1960.0 * com), "Tilt the tool about more axes.");
  double inertia = 0.0;
  int axis = 0;
  for (int i = 0; i < 3; ++i)
    if (const double relative = state.std.inertiaCom(i, i) / state.payload.inertiaCom(i, i); relative > inertia) {
      inertia = relative;
      axis = i;
    }
  state.inertia = judged(weakest({id.inertia[0][0], id.inertia[1][1], id.inertia[2][2]}), inertia < kGoodInertia,
                         "Inertia", fmt::format("± {:.0f} %", 196.0 * inertia),
                         fmt::format("Rotate the tool faster, back and forth about its {} axis.", "xyz"[axis]));
}

}  // namespace heft
