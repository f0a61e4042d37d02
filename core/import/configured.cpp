// Sources: Universal Robots, RTDE guide (payload [kg], payload_cog [m] and payload_inertia, Ixx, Iyy, Izz, Ixy, Ixz,
// Iyz about the centre of mass [kg m2]); libfranka, RobotState (m_ee, F_x_Cee, I_ee and the same of load and total);
// franka_msgs/FrankaRobotState (geometry_msgs/Inertia).
#include "core/import/configured.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>

#include "core/import/time_column.h"

namespace heft {

namespace {

constexpr double kHeaviest = 500.0;      ///< [kg] No arm carries more: the number means something else.
constexpr std::size_t kMostSets = 1000;  ///< Nobody sets more different values in one recording.

/// How one driver calls the numbers of one body; mass, com and inertia (xx, xy, xz, yy, yz, zz).
struct BodyNames {
  std::string body;  ///< "payload", "m_ee"
  std::array<std::string, 10> fields;
  const char* flange;
};

BodyNames urNames() {
  return {"payload",
          {"payload", "payload_cog[0]", "payload_cog[1]", "payload_cog[2]", "payload_inertia[0]", "payload_inertia[3]",
           "payload_inertia[4]", "payload_inertia[1]", "payload_inertia[5]", "payload_inertia[2]"},
          "tool0"};
}

BodyNames frankaNames(const std::string& body) {
  BodyNames out{"m_" + body, {"m_" + body}, "link8"};
  for (std::size_t i = 0; i < 3; ++i) out.fields[1 + i] = fmt::format("f_x_c{}[{}]", body, i);
  constexpr std::array kPlaces{0, 1, 2, 4, 5, 8};  // the matrix is symmetric: rows or columns are one
  for (std::size_t i = 0; i < 6; ++i) out.fields[4 + i] = fmt::format("i_{}[{}]", body, kPlaces[i]);
  return out;
}

BodyNames franka2Names(const std::string& body) {
  BodyNames out{"inertia_" + body, {}, "link8"};
  constexpr std::array kEntries{"m", "com.x", "com.y", "com.z", "ixx", "ixy", "ixz", "iyy", "iyz", "izz"};
  for (std::size_t i = 0; i < 10; ++i) out.fields[i] = fmt::format("inertia_{}.inertia.{}", body, kEntries[i]);
  return out;
}

/// Lower case, without what stands before, an index in brackets: "state.F_x_Cee_2" and "F_x_Cee[2]" are one.
std::string normalised(std::string_view field) {
  std::string name = lowerCase(field);
  if (const auto at = name.find("inertia_ee.inertia"), load = name.find("inertia_load.inertia"),
      total = name.find("inertia_total.inertia");
      at != std::string::npos || load != std::string::npos || total != std::string::npos)
    return name.substr(std::min({at, load, total}));
  if (const auto last = name.find_last_of("./"); last != std::string::npos) name.erase(0, last + 1);
  const auto mark = name.find_last_of('_');
  const bool numbered = mark != std::string::npos && mark + 1 < name.size() && mark + 3 > name.size() &&
                        std::isdigit(static_cast<unsigned char>(name[mark + 1])) != 0;
  return numbered ? fmt::format("{}[{}]", name.substr(0, mark), name.substr(mark + 1)) : name;
}

using Places = std::map<std::string, std::size_t>;

Places placesOf(const Stream& stream) {
  Places out;
  for (std::size_t f = 0; f < stream.fields.size(); ++f) out.try_emplace(normalised(stream.fields[f]), f);
  return out;
}

/// The numbers that held longest, NaN where a field is absent.
struct Held {
  std::array<double, 10> values{};
  bool changed = false;
};

std::optional<Held> heldLongest(const Stream& stream, const Places& places, const BodyNames& names) {
  const auto mass = places.find(names.fields[0]);
  // A column "payload" alone may be anything; UR's comes with others of its controller.
  const bool alone =
      names.fields[0] == "payload" && !places.contains(names.fields[1]) &&
      std::none_of(places.begin(), places.end(), [](const auto& p) { return p.first.starts_with("actual_"); });
  if (mass == places.end() || alone || stream.values.size() <= mass->second) return std::nullopt;
  std::array<const std::vector<double>*, 10> columns{};
  for (std::size_t i = 0; i < 10; ++i)
    if (const auto found = places.find(names.fields[i]);
        found != places.end() && found->second < stream.values.size() && !stream.values[found->second].empty())
      columns[i] = &stream.values[found->second];
  if (columns[0] == nullptr) return std::nullopt;
  std::map<std::array<double, 10>, std::size_t> held;
  for (std::size_t k = 0; k < columns[0]->size(); ++k) {
    std::array<double, 10> row{};
    bool complete = true;
    for (std::size_t i = 0; i < 10; ++i) {
      if (columns[i] == nullptr) continue;
      row[i] = k < columns[i]->size() ? (*columns[i])[k] : std::nan("");
      complete = complete && std::isfinite(row[i]);
    }
    if (complete) ++held[row];
    if (held.size() > kMostSets) return std::nullopt;
  }
  if (held.empty()) return std::nullopt;
  const auto longest =
      std::max_element(held.begin(), held.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  Held out{longest->first, held.size() > 1};
  for (std::size_t i = 0; i < 10; ++i)
    if (columns[i] == nullptr) out.values[i] = std::nan("");
  if (!(out.values[0] >= 0.0) || out.values[0] > kHeaviest) return std::nullopt;
  return out;
}

PartialPayload asPayload(const std::array<double, 10>& v) {
  PartialPayload out;
  out.mass = v[0];
  const auto known = [&](std::size_t from, std::size_t to) {
    return std::all_of(v.begin() + static_cast<std::ptrdiff_t>(from), v.begin() + static_cast<std::ptrdiff_t>(to),
                       [](double x) { return std::isfinite(x); });
  };
  if (known(1, 4)) out.com = Vector3d(v[1], v[2], v[3]);
  if (known(4, 10)) {
    Matrix3d I;
    I << v[4], v[5], v[6], v[5], v[7], v[8], v[6], v[8], v[9];
    out.inertiaCom = I;
  }
  return out;
}

/// Two bodies as one, as far as both are known. One without mass adds nothing.
PartialPayload together(const PartialPayload& a, const PartialPayload& b) {
  if (*b.mass == 0.0) return a;
  if (*a.mass == 0.0) return b;
  PartialPayload out;
  out.mass = *a.mass + *b.mass;
  if (!a.com || !b.com) return out;
  const Payload both = composed({*a.mass, *a.com, a.inertiaCom.value_or(Matrix3d::Zero())},
                                {*b.mass, *b.com, b.inertiaCom.value_or(Matrix3d::Zero())});
  out.com = both.com;
  if (a.inertiaCom && b.inertiaCom) out.inertiaCom = both.inertiaCom;
  return out;
}

std::optional<ConfiguredPayload> fromBody(const Stream& stream, const Places& places, const BodyNames& names) {
  const auto held = heldLongest(stream, places, names);
  if (!held) return std::nullopt;
  return ConfiguredPayload{asPayload(held->values), names.body, names.flange, held->changed};
}

}  // namespace

bool tellsConfiguredPayload(const Stream& stream, std::size_t field) {
  static const std::array kAll{urNames(),           frankaNames("total"),  frankaNames("ee"),
                               frankaNames("load"), franka2Names("total"), franka2Names("ee"),
                               franka2Names("load")};
  const std::string name = normalised(stream.fields[field]);
  return std::any_of(kAll.begin(), kAll.end(), [&](const BodyNames& names) {
    return std::find(names.fields.begin(), names.fields.end(), name) != names.fields.end();
  });
}

std::optional<ConfiguredPayload> configuredPayload(const std::vector<Stream>& streams) {
  for (const auto& stream : streams) {
    const Places places = placesOf(stream);
    if (auto ur = fromBody(stream, places, urNames())) return ur;
    for (const auto names : {frankaNames, franka2Names}) {
      if (auto total = fromBody(stream, places, names("total"))) return total;
      auto hand = fromBody(stream, places, names("ee"));
      const auto load = fromBody(stream, places, names("load"));
      if (!hand) continue;
      if (load) {
        hand->payload = together(hand->payload, load->payload);
        hand->source += " + " + load->source;
        hand->changed = hand->changed || load->changed;
      }
      return hand;
    }
  }
  return std::nullopt;
}

}  // namespace heft
