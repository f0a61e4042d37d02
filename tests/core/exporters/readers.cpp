#include "tests/core/exporters/readers.h"

#include <charconv>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace heft {

namespace {

/// Without comments that start with `sign` and run to the end of the line.
std::string withoutComments(const std::string& text, std::string_view sign) {
  std::string out;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    out += line.substr(0, line.find(sign)) + "\n";
    at = end + 1;
  }
  return out;
}

std::string withoutXmlComments(std::string text) {
  for (auto from = text.find("<!--"); from != std::string::npos; from = text.find("<!--")) {
    const auto to = text.find("-->", from);
    if (to == std::string::npos) throw std::runtime_error("a comment does not end");
    if (text.substr(from + 4, to - from - 4).find("--") != std::string::npos)
      throw std::runtime_error("XML forbids -- in a comment");
    text.erase(from, to + 3 - from);
  }
  return text;
}

/// `count` numbers that follow the first `key`, with any of " ,[]{}<=\n" between them.
std::vector<double> numbersAfter(const std::string& text, std::string_view key, std::size_t count) {
  std::size_t at = text.find(key);
  if (at == std::string::npos) throw std::runtime_error("no " + std::string(key) + " in\n" + text);
  at += key.size();
  std::vector<double> values;
  while (values.size() < count) {
    at = text.find_first_not_of(" ,[]{}<=\"\n", at);
    if (at == std::string::npos) throw std::runtime_error("too few numbers after " + std::string(key));
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), value);
    if (error != std::errc()) throw std::runtime_error("no number after " + std::string(key) + " in\n" + text);
    values.push_back(value);
    at = static_cast<std::size_t>(end - text.data());
  }
  return values;
}

double numberAfter(const std::string& text, std::string_view key) { return numbersAfter(text, key, 1)[0]; }

Vector3d vectorAfter(const std::string& text, std::string_view key) {
  const auto v = numbersAfter(text, key, 3);
  return {v[0], v[1], v[2]};
}

Matrix3d fromColumns(const std::vector<double>& v) { return Eigen::Map<const Matrix3d>(v.data()); }

Matrix3d symmetric(double xx, double yy, double zz, double xy, double xz, double yz) {
  Matrix3d I;
  I << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return I;
}

Matrix3d turned(const Matrix3d& R, const Vector3d& moments) { return R * moments.asDiagonal() * R.transpose(); }

Payload readXml(std::string_view format, const std::string& file) {
  const std::string text = withoutXmlComments(file);
  if (format == "urdf") {
    if (vectorAfter(text, "rpy=\"").norm() != 0.0) throw std::runtime_error("rpy is expected to be zero");
    const auto at = [&](const char* key) { return numberAfter(text, std::string(key) + "=\""); };
    return {numberAfter(text, "<mass value=\""), vectorAfter(text, "<origin xyz=\""),
            symmetric(at("ixx"), at("iyy"), at("izz"), at("ixy"), at("ixz"), at("iyz"))};
  }
  if (format == "sdf") {
    const auto pose = numbersAfter(text, "<pose>", 6);
    const Matrix3d R = rotationFromRpy({pose[3], pose[4], pose[5]});
    const auto at = [&](const char* key) { return numberAfter(text, std::string("<") + key + ">"); };
    const Matrix3d I = symmetric(at("ixx"), at("iyy"), at("izz"), at("ixy"), at("ixz"), at("iyz"));
    return {at("mass"), {pose[0], pose[1], pose[2]}, R * I * R.transpose()};
  }
  const auto I = numbersAfter(text, "fullinertia=\"", 6);
  return {numberAfter(text, "mass=\""), vectorAfter(text, "pos=\""), symmetric(I[0], I[1], I[2], I[3], I[4], I[5])};
}

Payload readJsonFormats(std::string_view format, const std::string& file) {
  const nlohmann::json json = nlohmann::json::parse(file);
  if (format == "franka-desk")
    return {json.at("mass").get<double>(), Vector3d(json.at("centerOfMass").get<std::vector<double>>().data()),
            fromColumns(json.at("inertia").get<std::vector<double>>())};
  if (format == "franka-profile") {
    const auto& body = json.at("inertial");
    const auto& c = body.at("centerOfMass");
    const auto& i = body.at("inertia");
    return {body.at("mass").get<double>(),
            {c.at("x").get<double>(), c.at("y").get<double>(), c.at("z").get<double>()},
            symmetric(i.at("x11"), i.at("x22"), i.at("x33"), i.at("x12"), i.at("x13"), i.at("x23"))};
  }
  if (json.at("frame") != "flange") throw std::runtime_error("the frame must be the flange");
  return payloadFromJson(json, "file").value();
}

Payload readKuka(const std::string& file) {
  const std::string text = withoutComments(file, ";");
  const std::string cm = text.substr(text.find("CM {"), text.find("},J") - text.find("CM {"));
  const std::string j = text.substr(text.find(",J {"));
  const auto angle = [&](const char* key) { return numberAfter(cm, key) * std::numbers::pi / 180.0; };
  using Eigen::AngleAxisd;
  const Matrix3d R = (AngleAxisd(angle("A "), Vector3d::UnitZ()) * AngleAxisd(angle("B "), Vector3d::UnitY()) *
                      AngleAxisd(angle("C "), Vector3d::UnitX()))
                         .toRotationMatrix();
  return {numberAfter(text, "{M "),
          Vector3d(numberAfter(cm, "X "), numberAfter(cm, "Y "), numberAfter(cm, "Z ")) / 1000.0,
          turned(R, {numberAfter(j, "X "), numberAfter(j, "Y "), numberAfter(j, "Z ")})};
}

Payload readAbb(const std::string& file) {
  const auto v = numbersAfter(withoutComments(file, "!"), ":=", 11);
  const Quaterniond q(v[4], v[5], v[6], v[7]);
  if (std::abs(q.norm() - 1.0) > 1e-8) throw std::runtime_error("the quaternion is not of unit length");
  return {v[0], Vector3d(v[1], v[2], v[3]) / 1000.0, turned(q.normalized().toRotationMatrix(), {v[8], v[9], v[10]})};
}

Payload readFanuc(const std::string& file) {
  const std::string text = withoutComments(file, "#");
  const auto three = [&](const std::string& what, const std::string& unit) {
    Vector3d v;
    for (int i = 0; i < 3; ++i) v(i) = numberAfter(text, "PAYLOAD " + what + " " + "XYZ"[i] + " [" + unit + "] =");
    return v;
  };
  // 1 kgf cm s2 = 9.80665 N * 0.01 m * s2
  return {numberAfter(text, "PAYLOAD [kg] ="), three("CENTER", "cm") / 100.0,
          Matrix3d((three("INERTIA", "kgf cm s2") * 0.0980665).asDiagonal())};
}

Payload readWithoutInertia(std::string_view format, const std::string& file) {
  const std::string text = withoutComments(file, "#");
  const Matrix3d none = Matrix3d::Zero();
  if (format == "xarm") {
    const auto v = numbersAfter(text, "set_tcp_load(", 4);
    return {v[0], Vector3d(v[1], v[2], v[3]) / 1000.0, none};
  }
  if (format == "ros2-control") return {numberAfter(text, "mass:"), vectorAfter(text, "pos:"), none};
  if (format == "force-torque-tools")
    return {numberAfter(text, "gripper_mass:"), vectorAfter(text, "gripper_com_pose:"), none};
  const auto v = numbersAfter("\n" + text, "\n", 13);
  return {v[0], {v[4], v[5], v[6]}, none};
}

}  // namespace

Payload readBack(std::string_view format, const std::string& text) {
  if (format == "franka-desk" || format == "franka-profile" || format == "json") return readJsonFormats(format, text);
  if (format == "urdf" || format == "sdf" || format == "mjcf") return readXml(format, text);
  if (format == "libfranka") {
    const std::string code = withoutComments(text, "//");
    return {numberAfter(code, "load_mass ="), vectorAfter(code, "F_x_Cload"),
            fromColumns(numbersAfter(code, "load_inertia", 9))};
  }
  if (format == "franka-ros" || format == "franka-ros2") {
    const std::string yaml = withoutComments(text, "#");
    return {numberAfter(yaml, "mass:"),
            vectorAfter(yaml, format == "franka-ros" ? "F_x_center_load:" : "center_of_mass:"),
            fromColumns(numbersAfter(yaml, "load_inertia:", 9))};
  }
  if (format == "ur") {
    const auto v = numbersAfter(withoutComments(text, "#"), "set_target_payload(", 11);
    if (v[10] != 0.0) throw std::runtime_error("no transition time is expected");
    return {v[0], {v[1], v[2], v[3]}, symmetric(v[4], v[5], v[6], v[7], v[8], v[9])};
  }
  if (format == "kuka") return readKuka(text);
  if (!holdsInertia(format)) return readWithoutInertia(format, text);
  if (format == "abb") return readAbb(text);
  if (format == "fanuc") return readFanuc(text);
  throw std::runtime_error("no reader for " + std::string(format));
}

}  // namespace heft
