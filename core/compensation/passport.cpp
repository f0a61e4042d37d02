#include "core/compensation/passport.h"

#include <array>
#include <cmath>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/compensation/payload_difference.h"

namespace heft {
namespace {

using nlohmann::json;
using namespace nlohmann::literals;

constexpr std::string_view kSchema = "heft.passport/1";
constexpr double kBeyondInterval = 1.96;  // Standard deviations of a 95 % interval
constexpr double kOnceIn200 = 2.807;      // Standard deviations that a normal number exceeds once in 200
constexpr std::array kQuantities{"mass_kg",         "com_x_m",         "com_y_m",         "com_z_m",
                                 "inertia_xx_kgm2", "inertia_xy_kgm2", "inertia_xz_kgm2", "inertia_yy_kgm2",
                                 "inertia_yz_kgm2", "inertia_zz_kgm2"};

std::string textOf(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

struct Numbers {
  Payload payload;
  Vector10d std;
};

Result<Numbers> numbersOf(const json& passport, const std::string& where) {
  if (!passport.is_object() || textOf(passport, "schema") != kSchema)
    return Error{heft::say("{} is not a passport: its \"schema\" should be \"{}\".", where, kSchema)};
  auto payload = payloadFromJson(passport.value("payload", json()), where);
  if (!payload) return payload.error();
  auto std = payloadFromJson(passport.value("std", json()), where);
  if (!std) return std.error();
  return Numbers{*payload, componentsOf(*std)};
}

}  // namespace

std::vector<PassportNumber> passportNumbers(const json& passport) {
  struct Place {
    const char* quantity;
    int row, column;  ///< Of the inertia; the component of the centre, or -1
  };
  static constexpr std::array kPlaces{Place{"inertia_xx_kgm2", 0, 0}, Place{"inertia_yy_kgm2", 1, 1},
                                      Place{"inertia_zz_kgm2", 2, 2}, Place{"inertia_xy_kgm2", 0, 1},
                                      Place{"inertia_xz_kgm2", 0, 2}, Place{"inertia_yz_kgm2", 1, 2}};
  const auto number = [](const json& value) { return value.is_number() ? value.get<double>() : NAN; };
  const auto source = [](const json& word) {
    return word == toString(Source::data)    ? Source::data
           : word == toString(Source::prior) ? Source::prior
                                             : Source::none;
  };
  const json &payload = passport.at("payload"), &interval = passport.at("interval95"),
             &known = passport.at("identifiability");
  std::vector<PassportNumber> out;
  const auto add = [&](const char* quantity, const json& value, const json& range, const json& from,
                       const json::json_pointer& place) {
    const json doubted = known.value("/doubted"_json_pointer / place, json(false));
    out.push_back({quantity, number(value), number(range.at(0)), number(range.at(1)),
                   doubted == true ? Source::doubted : source(from)});
  };
  add("mass_kg", payload.at("mass_kg"), interval.at("mass_kg"), known.at("mass"), "/mass"_json_pointer);
  for (std::size_t i = 0; i < 3; ++i)
    add(kQuantities[1 + i], payload.at("com_m").at(i), interval.at("com_m").at(i), known.at("com").at(i),
        "/com"_json_pointer / i);
  for (const Place& p : kPlaces) {
    const auto r = static_cast<std::size_t>(p.row), c = static_cast<std::size_t>(p.column);
    add(p.quantity, payload.at("inertia_com_kgm2").at(r).at(c), interval.at("inertia_com_kgm2").at(r).at(c),
        known.at("inertia").at(r).at(c), "/inertia"_json_pointer / r / c);
  }
  return out;
}

Result<json> passportOf(const PassportContent& content, const json& estimate, const std::string& where) {
  if (content.tool.empty()) return Error{heft::say("A passport needs the tool's name.")};
  const auto incomplete = [&] {
    return Error{heft::say("{} is not a result of an estimate; make one with heft estimate REC --json FILE.", where)};
  };
  if (!estimate.is_object() || textOf(estimate, "schema") != "heft.estimate/1") return incomplete();
  if (textOf(estimate, "trust") == toString(Trust::none))
    return Error{heft::say("Nothing in this result can be trusted, so no passport is made of it.")};
  json causes = json::array();
  for (const PassportCause& cause : content.causes)
    causes.push_back({{"cause", cause.id}, {"sentence", cause.sentence}, {"applied", cause.applied}});
  json out{{"schema", kSchema},
           {"tool", content.tool},
           {"date", content.date},
           {"program", content.program},
           {"looked_for_causes", content.lookedForCauses},
           {"causes", std::move(causes)},
           {"not_seen", content.notSeen},
           {"proof", content.proof},
           {"since", nullptr}};
  for (const char* key : {"recording", "method", "trust", "payload", "std", "interval95", "identifiability", "bias",
                          "sensor_mount", "findings"})
    if (const auto found = estimate.find(key); found != estimate.end()) out[key] = *found;
  if (const auto numbers = numbersOf(out, where); !numbers) return numbers.error();
  try {
    passportNumbers(out);
  } catch (const json::exception&) {
    return incomplete();
  }
  return out;
}

Result<PassportChange> changeSince(const json& before, const std::string& where, const json& now) {
  const auto first = numbersOf(before, where);
  if (!first) return first.error();
  const auto second = numbersOf(now, heft::say("the new passport"));
  if (!second) return second.error();
  if (textOf(before, "tool") != textOf(now, "tool"))
    return Error{heft::say("{} is the passport of another tool, \"{}\".", where, printable(textOf(before, "tool")))};
  PassportChange out;
  out.date = printable(textOf(before, "date"), 40);
  out.file = where;
  out.otherMount = before.value("sensor_mount", json()) != now.value("sensor_mount", json());
  const Vector10d a = componentsOf(first->payload), b = componentsOf(second->payload);
  const Vector10d variance = first->std.cwiseAbs2() + second->std.cwiseAbs2();
  const PayloadDifference difference = payloadDifference(b - a, variance.asDiagonal(), second->payload);
  // A sensor that sits elsewhere tells its centres and inertias in other axes.
  const int rows = out.otherMount ? 1 : 10;
  out.massCentre =
      out.otherMount ? std::abs(difference.off(0)) > kOnceIn200 * difference.std(0) : difference.massCentreDiffers();
  out.inertia = !out.otherMount && difference.inertiaDiffers();
  for (int i = 0; i < rows; ++i) {
    const bool differs =
        (i < 4 ? out.massCentre : out.inertia) && std::abs(difference.off(i)) > kBeyondInterval * difference.std(i);
    out.rows.push_back(
        {kQuantities[static_cast<std::size_t>(i)], a(i), b(i), difference.off(i), difference.std(i), differs});
  }
  return out;
}

json toJson(const PassportChange& change) {
  json rows = json::array();
  for (const auto& row : change.rows)
    rows.push_back({{"quantity", row.quantity},
                    {"before", row.before},
                    {"now", row.now},
                    {"difference", row.difference},
                    {"std", row.std},
                    {"more_than_chance", row.moreThanChance}});
  return {{"date", change.date},
          {"file", change.file},
          {"numbers", std::move(rows)},
          {"mass_and_centre_changed", change.massCentre},
          {"inertia_changed", change.inertia},
          {"other_mount", change.otherMount}};
}

}  // namespace heft
