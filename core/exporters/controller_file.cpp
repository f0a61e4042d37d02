#include "core/exporters/controller_file.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/say.h"
#include "core/exporters/flange.h"

namespace heft {
namespace {

using nlohmann::json;

/// A number of the object; NaN where there is none.
double numberAt(const json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return object.is_object() && found != object.end() && found->is_number() ? found->get<double>() : NAN;
}

double numberAt(const json& list, std::size_t index) {
  return list.is_array() && index < list.size() && list[index].is_number() ? list[index].get<double>() : NAN;
}

json partOf(const json& object, const char* key) { return object.is_object() ? object.value(key, json()) : json(); }

/// {"mass", "centerOfMass": [3], "inertia": [9]}: Desk writes columns first.
Payload fromDesk(const json& object) {
  Payload out;
  out.mass = numberAt(object, "mass");
  const json centre = partOf(object, "centerOfMass"), inertia = partOf(object, "inertia");
  for (std::size_t i = 0; i < 3; ++i) out.com(static_cast<int>(i)) = numberAt(centre, i);
  for (std::size_t i = 0; i < 9; ++i)
    out.inertiaCom(static_cast<int>(i % 3), static_cast<int>(i / 3)) = numberAt(inertia, i);
  return out;
}

/// {"inertial": {"mass", "centerOfMass": {"x", "y", "z"}, "inertia": {"x11" ... "x33"}}}
Payload fromProfile(const json& inertial) {
  Payload out;
  out.mass = numberAt(inertial, "mass");
  const json centre = partOf(inertial, "centerOfMass"), inertia = partOf(inertial, "inertia");
  out.com = {numberAt(centre, "x"), numberAt(centre, "y"), numberAt(centre, "z")};
  const double xx = numberAt(inertia, "x11"), xy = numberAt(inertia, "x12"), xz = numberAt(inertia, "x13"),
               yy = numberAt(inertia, "x22"), yz = numberAt(inertia, "x23"), zz = numberAt(inertia, "x33");
  out.inertiaCom << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return out;
}

bool isDesk(const json& object) {
  return object.is_object() && object.contains("mass") && object.contains("centerOfMass");
}

}  // namespace

bool isControllerFile(const json& object) { return isDesk(object) || partOf(object, "inertial").is_object(); }

Result<Payload> controllerPayloadFromJson(const json& object, const std::string& where) {
  if (isControllerFile(object)) {
    const Payload read = isDesk(object) ? fromDesk(object) : fromProfile(object["inertial"]);
    if (!std::isfinite(read.mass) || !read.com.allFinite() || !read.inertiaCom.allFinite())
      return Error{
          heft::say("{}: mass, centre of mass or inertia is missing or holds something that is not a number.", where)};
    // Through the reader that checks signs and symmetry.
    return payloadFromJson(toJson(read), where);
  }
  if (!object.is_object() || (!object.contains("payload") && !object.contains("mass_kg")))
    return Error{
        heft::say("{} holds no payload. Heft reads a Franka Desk end effector, a Franka tool profile, a "
                  "result of 'heft estimate' and a payload with mass_kg, com_m and inertia_com_kgm2.",
                  where)};
  const auto placed = toFlange(object, where, {});
  if (!placed) return placed.error();
  return placed->input.payload;
}

}  // namespace heft
