// Reading, writing and checking what the user says about the tool's shape (declared in shape.h).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/base/json_file.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/payload/kind_name.h"
#include "core/payload/shape_moments.h"

namespace heft {

namespace {

using nlohmann::json;

struct KindInfo {
  BodyKind kind;
  std::string_view name;
  std::vector<std::string_view> dims;
};

const std::vector<KindInfo>& kinds() {
  static const std::vector<KindInfo> all{{BodyKind::box, "box", {"x", "y", "z"}},
                                         {BodyKind::cylinder, "cylinder", {"radius", "height"}},
                                         {BodyKind::tube, "tube", {"outer", "inner", "height"}},
                                         {BodyKind::sphere, "sphere", {"radius"}},
                                         {BodyKind::cone, "cone", {"radius", "height"}},
                                         {BodyKind::capsule, "capsule", {"radius", "length"}},
                                         {BodyKind::plate, "plate", {"x", "y", "thickness"}},
                                         {BodyKind::mesh, "mesh", {}}};
  return all;
}

struct UnitInfo {
  std::string_view name;
  double metres;
};
constexpr std::array<UnitInfo, 4> kUnits{{{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}}};

std::string form(const KindInfo& info) { return fmt::format("{}:{}", info.name, fmt::join(info.dims, ",")); }

const KindInfo& infoOf(BodyKind kind) {
  return *std::find_if(kinds().begin(), kinds().end(), [&](const KindInfo& i) { return i.kind == kind; });
}

std::string primitiveForms() {
  std::vector<std::string> forms;
  for (const KindInfo& info : kinds())
    if (info.kind != BodyKind::mesh) forms.push_back(form(info));
  return fmt::format("{}", fmt::join(forms, ", "));
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Numbers between commas. `what` stands in the message.
Result<std::vector<double>> numbers(std::string_view text, std::string_view what) {
  std::vector<double> values;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    std::string_view field = trimmed(text.substr(start, comma - start));
    if (field.starts_with('+')) field.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc{} || end != field.data() + field.size() || !std::isfinite(value))
      return Error{heft::say("{}: '{}' is not a number.", what, printable(trimmed(text.substr(start, comma - start))))};
    values.push_back(value);
    start = comma + 1;
  }
  return values;
}

std::string whyInvalidBody(const ShapeBody& body) {
  const KindInfo& info = infoOf(body.kind);
  if (!body.X_SB.matrix().allFinite()) return heft::say("the pose has a component that is not a number.");
  if (!(body.X_SB.linear().transpose() * body.X_SB.linear()).isIdentity(1e-6) || body.X_SB.linear().determinant() < 0)
    return heft::say("the pose is not a rotation and a translation.");
  if (body.kind == BodyKind::mesh) {
    if (body.file.empty() && !body.mesh) return heft::say("the mesh needs a file.");
    if (!(body.unit > 0.0) || !std::isfinite(body.unit))
      return heft::say("the unit of the mesh must be a positive number of metres, not {}.", body.unit);
  } else {
    if (body.dims.size() != info.dims.size())
      return info.dims.size() == 1 ? heft::say("{} needs 1 dimension in metres ({}), but {} are given.",
                                               kindName(body.kind), info.dims[0], body.dims.size())
             : body.dims.size() == 1
                 ? heft::say("{} needs {} dimensions in metres ({}), but 1 is given.", kindName(body.kind),
                             info.dims.size(), fmt::join(info.dims, ", "))
                 : heft::say("{} needs {} dimensions in metres ({}), but {} are given.", kindName(body.kind),
                             info.dims.size(), fmt::join(info.dims, ", "), body.dims.size());
    for (std::size_t i = 0; i < body.dims.size(); ++i) {
      const bool mayBeZero = (body.kind == BodyKind::tube && i == 1) || (body.kind == BodyKind::capsule && i == 1);
      if (!std::isfinite(body.dims[i]) || body.dims[i] < 0.0 || (!mayBeZero && body.dims[i] == 0.0))
        return mayBeZero ? heft::say("{} ({}) must be a positive (or zero) number of metres, not {}.", info.dims[i],
                                     form(info), body.dims[i])
                         : heft::say("{} ({}) must be a positive number of metres, not {}.", info.dims[i], form(info),
                                     body.dims[i]);
    }
    if (body.kind == BodyKind::tube && body.dims[1] >= body.dims[0])
      return heft::say(
          "the outer radius of a tube (tube:outer,inner,height) must be larger than the inner one, but {} m "
          "and {} m are given.",
          body.dims[0], body.dims[1]);
    if (body.kind == BodyKind::tube && body.wall)
      return heft::say("a tube is hollow already: leave out the wall, or use a cylinder.");
  }
  if (body.wall) {
    if (!std::isfinite(*body.wall) || *body.wall <= 0.0)
      return heft::say("the wall must be a positive number of metres, not {}.", *body.wall);
    if (body.kind != BodyKind::mesh) {
      const double limit = inradius(body);
      if (*body.wall >= limit)
        return heft::say(
            "a wall of {} m leaves no hollow: it must be thinner than {:.4g} m, or left out for a solid {}.",
            *body.wall, limit, kindName(body.kind));
      if (*body.wall < 1e-4 * limit)
        return heft::say("a wall of {} m is too thin for this {}: at least {:.2g} m are expected.", *body.wall,
                         kindName(body.kind), 1e-4 * limit);
    }
  }
  if (body.mass && body.density) return heft::say("give the mass or the density, not both.");
  if (body.mass && (!std::isfinite(*body.mass) || *body.mass <= 0.0))
    return heft::say("mass must be a positive number of kg, not {}.", *body.mass);
  if (body.density && (!std::isfinite(*body.density) || *body.density <= 0.0))
    return heft::say("density must be a positive number of kg/m3, not {}.", *body.density);
  return {};
}

/// A number or null; absent counts as null.
Result<std::optional<double>> optionalNumber(const json& object, const char* key, const std::string& where) {
  const auto it = object.find(key);
  if (it == object.end() || it->is_null()) return std::optional<double>{};
  if (!it->is_number()) return Error{heft::say("{}.{} must be a number or null.", where, key)};
  return std::optional<double>{it->get<double>()};
}

Result<std::optional<Vector3d>> optionalVector(const json& object, const char* key, const std::string& where) {
  const auto it = object.find(key);
  if (it == object.end() || it->is_null()) return std::optional<Vector3d>{};
  const bool good = it->is_array() && it->size() == 3 &&
                    std::all_of(it->begin(), it->end(), [](const json& x) { return x.is_number(); });
  if (!good) return Error{heft::say("{}.{} must be a list of three numbers.", where, key)};
  return std::optional<Vector3d>{Vector3d((*it)[0].get<double>(), (*it)[1].get<double>(), (*it)[2].get<double>())};
}

Result<ShapeBody> bodyFromJson(const json& object, const std::string& where, const std::filesystem::path& folder) {
  if (!object.is_object()) return Error{heft::say("{} must be an object with a kind.", where)};
  const auto kindText = object.value("kind", json());
  const auto info = std::find_if(kinds().begin(), kinds().end(), [&](const KindInfo& i) { return kindText == i.name; });
  std::vector<std::string_view> names;
  for (const KindInfo& each : kinds()) names.push_back(each.name);
  if (info == kinds().end())
    return Error{kindText.is_null() ? heft::say("{}.kind must be one of {}.", where, fmt::join(names, ", "))
                                    : heft::say("{}.kind must be one of {}, not {}.", where, fmt::join(names, ", "),
                                                printable(kindText.dump()))};
  ShapeBody body;
  body.kind = info->kind;
  if (info->kind == BodyKind::mesh) {
    const auto file = object.value("file", json());
    if (!file.is_string() || file.get<std::string>().empty())
      return Error{heft::say("{}.file must name the mesh file.", where)};
    body.file = file.get<std::string>();
    if (body.file.is_relative()) body.file = folder / body.file;
    const auto unitText = object.value("unit", json());
    if (!unitText.is_null()) {
      const auto unit = std::find_if(kUnits.begin(), kUnits.end(), [&](const UnitInfo& u) {
        return unitText.is_string() && unitText.get<std::string>() == u.name;
      });
      if (unit == kUnits.end())
        return Error{
            heft::say("{}.unit must be \"m\", \"cm\", \"mm\" or \"in\", not {}.", where, printable(unitText.dump()))};
      body.unit = unit->metres;
    }
  } else {
    const auto dims = object.value("dims_m", json());
    if (!dims.is_array() || !std::all_of(dims.begin(), dims.end(), [](const json& x) { return x.is_number(); }))
      return Error{heft::say("{}.dims_m must be a list of numbers in metres: {}.", where, fmt::join(info->dims, ", "))};
    body.dims = dims.get<std::vector<double>>();
  }
  const auto xyz = optionalVector(object, "xyz_m", where), rpy = optionalVector(object, "rpy_rad", where);
  if (!xyz) return xyz.error();
  if (!rpy) return rpy.error();
  body.X_SB = poseFromXyzRpy(xyz->value_or(Vector3d::Zero()), rpy->value_or(Vector3d::Zero()));
  for (const auto& [key, target] :
       {std::pair{"wall_m", &body.wall}, {"mass_kg", &body.mass}, {"density_kg_m3", &body.density}}) {
    auto value = optionalNumber(object, key, where);
    if (!value) return value.error();
    *target = *value;
  }
  return body;
}

}  // namespace

std::string_view toString(BodyKind kind) { return infoOf(kind).name; }

std::string kindName(BodyKind kind) {
  switch (kind) {
    case BodyKind::box:
      return heft::say("box");
    case BodyKind::cylinder:
      return heft::say("cylinder");
    case BodyKind::tube:
      return heft::say("tube");
    case BodyKind::sphere:
      return heft::say("sphere");
    case BodyKind::cone:
      return heft::say("cone");
    case BodyKind::capsule:
      return heft::say("capsule");
    case BodyKind::plate:
      return heft::say("plate");
    case BodyKind::mesh:
      return heft::say("mesh");
  }
  return {};
}

std::string_view toString(Certainty certainty) {
  switch (certainty) {
    case Certainty::rough:
      return "rough";
    case Certainty::good:
      return "good";
    case Certainty::exact:
      return "exact";
  }
  return "rough";
}

std::optional<Certainty> certaintyFromString(std::string_view text) {
  for (const Certainty c : {Certainty::rough, Certainty::good, Certainty::exact})
    if (text == toString(c)) return c;
  return std::nullopt;
}

Result<std::optional<Certainty>> certaintyFromJson(const json& object, const std::string& where) {
  const auto it = object.find("certainty");
  if (it == object.end() || it->is_null()) return std::optional<Certainty>{};
  if (it->is_string())
    if (const auto certainty = certaintyFromString(it->get<std::string>())) return certainty;
  return Error{
      heft::say("{}: certainty must be \"rough\", \"good\" or \"exact\", not {}.", where, printable(it->dump()))};
}

std::optional<BodyKind> bodyKindFromString(std::string_view text) {
  for (const KindInfo& info : kinds())
    if (info.name == text) return info.kind;
  return std::nullopt;
}

std::vector<std::string_view> dimensionNames(BodyKind kind) { return infoOf(kind).dims; }

std::string whyInvalid(const Shape& shape) {
  if (shape.bodies.empty()) return heft::say("The shape has no bodies.");
  double sum = 0.0;
  bool allKnown = true;
  for (std::size_t i = 0; i < shape.bodies.size(); ++i) {
    const ShapeBody& body = shape.bodies[i];
    if (const std::string why = whyInvalidBody(body); !why.empty())
      return shape.bodies.size() == 1 ? heft::say("Shape {}: {}", kindName(body.kind), why)
                                      : heft::say("Shape body {} ({}): {}", i + 1, kindName(body.kind), why);
    sum += body.mass.value_or(0.0);
    allKnown = allKnown && body.mass;
  }
  if (!shape.totalMass) return {};
  if (!std::isfinite(*shape.totalMass) || *shape.totalMass <= 0.0)
    return heft::say("The shape's total mass must be a positive number of kg, not {}.", *shape.totalMass);
  if (sum > *shape.totalMass * 1.02 || (allKnown && sum < *shape.totalMass * 0.98))
    return heft::say("The bodies of the shape weigh {:.4g} kg, which does not fit their total of {:.4g} kg.", sum,
                     *shape.totalMass);
  return {};
}

Result<Shape> parseShape(const std::string& text) {
  const auto fail = [&](const std::string& why) {
    return Error{
        fmt::format("--shape {}: {} Expected is KIND:DIMS[:wall=T][@x,y,z[,roll,pitch,yaw]] in metres and radians "
                    "with {}; meshes and several bodies go into a --shape-file.",
                    printable(text, 200), why, primitiveForms())};
  };
  const std::string_view all = text;
  const auto at = all.find('@');
  std::string_view bodyText = all.substr(0, at);
  const auto colon = bodyText.find(':');
  const std::string_view kindText = trimmed(bodyText.substr(0, colon));
  const auto kind = bodyKindFromString(kindText);
  if (!kind || *kind == BodyKind::mesh) return fail(fmt::format("'{}' is not one of the kinds.", printable(kindText)));
  if (colon == std::string_view::npos) return fail(fmt::format("the dimensions of the {} are missing.", kindText));
  ShapeBody body;
  body.kind = *kind;
  std::string_view dimsText = bodyText.substr(colon + 1);
  if (const auto second = dimsText.find(':'); second != std::string_view::npos) {
    constexpr std::string_view kWall = "wall=";
    const std::string_view extra = trimmed(dimsText.substr(second + 1));
    if (!extra.starts_with(kWall)) return fail(fmt::format("'{}' is not wall=THICKNESS.", printable(extra)));
    auto wall = numbers(extra.substr(kWall.size()), "wall");
    if (!wall) return fail(wall.error().message);
    if (wall->size() != 1) return fail("wall is one number.");
    body.wall = wall->front();
    dimsText = dimsText.substr(0, second);
  }
  auto dims = numbers(dimsText, "dimensions");
  if (!dims) return fail(dims.error().message);
  body.dims = *dims;
  if (at != std::string_view::npos) {
    auto pose = numbers(all.substr(at + 1), "pose");
    if (!pose) return fail(pose.error().message);
    if (pose->size() != 3 && pose->size() != 6)
      return fail(fmt::format("a pose has 3 or 6 numbers, not {}.", pose->size()));
    const auto& p = *pose;
    body.X_SB = poseFromXyzRpy({p[0], p[1], p[2]}, p.size() == 6 ? Vector3d(p[3], p[4], p[5]) : Vector3d::Zero());
  }
  Shape shape;
  shape.bodies.push_back(body);
  if (const std::string why = whyInvalidBody(body); !why.empty()) return fail(why);
  return shape;
}

Result<Shape> shapeFromJson(const json& object, const std::string& where, const std::filesystem::path& folder) {
  if (!object.is_object()) return Error{heft::say("{}: a shape is an object with the key \"bodies\".", where)};
  const auto bodies = object.find("bodies");
  if (bodies == object.end() || !bodies->is_array() || bodies->empty())
    return Error{heft::say("{}: \"bodies\" must be a list with at least one body.", where)};
  Shape shape;
  for (std::size_t i = 0; i < bodies->size(); ++i) {
    auto body = bodyFromJson((*bodies)[i], fmt::format("{}: bodies[{}]", where, i), folder);
    if (!body) return body.error();
    if (const std::string why = whyInvalidBody(*body); !why.empty())
      return Error{fmt::format("{}: bodies[{}]: {}", where, i, why)};
    shape.bodies.push_back(std::move(*body));
  }
  auto certainty = certaintyFromJson(object, where);
  if (!certainty) return certainty.error();
  shape.certainty = certainty->value_or(Certainty::rough);
  auto total = optionalNumber(object, "total_mass_kg", where + ": shape");
  if (!total) return total.error();
  shape.totalMass = *total;
  if (const std::string why = whyInvalid(shape); !why.empty()) return Error{fmt::format("{}: {}", where, why)};
  return shape;
}

Result<Shape> readShapeFile(const std::filesystem::path& file) {
  auto object = readJsonFile(file);
  if (!object) return object.error();
  return shapeFromJson(*object, displayName(file), file.parent_path());
}

nlohmann::json toJson(const Shape& shape) {
  const auto vector = [](const Vector3d& v) { return json{v.x(), v.y(), v.z()}; };
  const auto number = [](const std::optional<double>& value) { return value ? json(*value) : json(); };
  json bodies = json::array();
  for (const ShapeBody& body : shape.bodies) {
    json entry{{"kind", toString(body.kind)},
               {"xyz_m", vector(body.X_SB.translation())},
               {"rpy_rad", vector(rpyFromRotation(body.X_SB.linear()))},
               {"mass_kg", number(body.mass)},
               {"density_kg_m3", number(body.density)}};
    if (body.wall) entry["wall_m"] = *body.wall;
    if (body.kind == BodyKind::mesh) {
      entry["file"] = displayName(body.file);
      for (const UnitInfo& unit : kUnits)
        if (std::abs(body.unit - unit.metres) <= 1e-9 * unit.metres) entry["unit"] = unit.name;
    } else {
      entry["dims_m"] = body.dims;
    }
    bodies.push_back(std::move(entry));
  }
  return {{"bodies", std::move(bodies)},
          {"certainty", toString(shape.certainty)},
          {"total_mass_kg", number(shape.totalMass)}};
}

}  // namespace heft
