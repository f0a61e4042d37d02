#include <Eigen/Eigenvalues>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/robot/urdf_reader.h"

namespace heft {
namespace {

constexpr std::size_t kMaxSentence = 400;  ///< [bytes]

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool isMovingType(std::string_view type) { return type == "revolute" || type == "continuous" || type == "prismatic"; }

class Checker {
 public:
  Checker(const XmlElement& robot, const std::string& file, Findings& findings)
      : robot_(robot), file_(file), findings_(findings) {}

  void run() {
    if (!isUrdf()) return;
    for (const XmlElement& element : robot_.children) {
      if (element.name == "link") checkLink(element);
    }
    for (const XmlElement& element : robot_.children) {
      if (element.name == "joint") checkJoint(element);
    }
    if (links_.empty()) error(robot_, "no_links", heft::say("the robot has no link"), {});
    for (const auto& [name, joint] : joints_) checkMimic(*joint);
    checkTree();
  }

 private:
  void error(const XmlElement& where, const char* code, std::string text, std::string remedy) {
    findings_.push_back(findingAt(where, file_, Severity::error, code, std::move(text), std::move(remedy)));
  }
  void warn(const XmlElement& where, const char* code, std::string text, std::string remedy) {
    findings_.push_back(findingAt(where, file_, Severity::warning, code, std::move(text), std::move(remedy)));
  }

  bool isUrdf() {
    if (robot_.name == "sdf" || robot_.name == "mujoco" || robot_.name == "COLLADA") {
      error(robot_, "not_urdf", heft::say("this is a {} file, not a URDF", robot_.name),
            heft::say("Convert it to a URDF first"));
      return false;
    }
    if (robot_.name != "robot") {
      error(robot_, "not_urdf", heft::say("the root element is <{}>, not <robot>", robot_.name),
            heft::say("Give a URDF"));
      return false;
    }
    if (const XmlElement* macro = findXacro(robot_)) {
      error(*macro, "xacro", heft::say("<{}> is a xacro macro that was not expanded", macro->name),
            heft::say("Run \"xacro FILE.urdf.xacro > FILE.urdf\" and give its output"));
      return false;
    }
    if (robot_.attributeOr("name").empty()) {
      error(robot_, "no_name", heft::say("<robot> has no name"), heft::say("Write <robot name=\"...\">"));
    }
    if (const std::string* version = robot_.attribute("version"); version && *version != "1.0" && *version != "1") {
      error(robot_, "version", heft::say("URDF version \"{}\" is not known", *version),
            heft::say("Version 1.0 is read"));
    }
    return true;
  }

  static const XmlElement* findXacro(const XmlElement& element) {
    if (element.name.starts_with("xacro:")) return &element;
    for (const XmlAttribute& attribute : element.attributes) {
      if (attribute.value.find("${") != std::string::npos || attribute.value.find("$(") != std::string::npos) {
        return &element;
      }
    }
    for (const XmlElement& child : element.children) {
      if (const XmlElement* found = findXacro(child)) return found;
    }
    return nullptr;
  }

  bool checkName(const XmlElement& element, std::map<std::string, const XmlElement*>& known) {
    const std::string name(element.attributeOr("name"));
    if (name.empty()) {
      error(element, "no_name", heft::say("this {} has no name", element.name), {});
      return false;
    }
    const auto [place, isNew] = known.emplace(name, &element);
    if (!isNew) {
      error(element, "duplicate_name",
            heft::say("{} \"{}\" is already defined in line {}", element.name, name, place->second->line),
            heft::say("Give each its own name"));
    }
    return isNew;
  }

  /// The numbers of an attribute, `standard` where it is absent, or nothing after an error finding.
  std::optional<std::vector<double>> numbers(const XmlElement& element, const char* attribute,
                                             const std::vector<double>& standard) {
    const std::string* text = element.attribute(attribute);
    if (!text) return standard;
    auto values = parseNumbers(*text, standard.size());
    if (!values) {
      const bool comma = text->find(',') != std::string::npos;
      error(element, "bad_number",
            heft::say(
                "{}=\"{}\" of <{}> is not {}", attribute, *text, element.name,
                standard.size() == 1 ? heft::say("a finite number") : heft::say("{} finite numbers", standard.size())),
            comma ? heft::say("Write a decimal point and separate numbers by blanks") : std::string());
    }
    return values;
  }

  void checkLink(const XmlElement& link) {
    if (!checkName(link, links_)) return;
    if (const XmlElement* inertial = link.child("inertial")) checkInertial(link, *inertial);
  }

  void checkInertial(const XmlElement& link, const XmlElement& inertial) {
    const std::string name(link.attributeOr("name"));
    const std::string remedy = heft::say("Heft uses only the robot's motion, so the result is not affected");
    const XmlElement* mass = inertial.child("mass");
    const XmlElement* inertia = inertial.child("inertia");
    if (!mass || !inertia) {
      warn(inertial, "bad_inertial", heft::say("the inertial of link \"{}\" lacks its mass or inertia", name), remedy);
      return;
    }
    const auto m = parseNumbers(mass->attributeOr("value"), 1);
    std::array<double, 6> i{};
    constexpr std::array<const char*, 6> kNames{"ixx", "iyy", "izz", "ixy", "ixz", "iyz"};
    bool readable = m.has_value();
    for (std::size_t k = 0; k < 6; ++k) {
      const auto value = parseNumbers(inertia->attributeOr(kNames[k]), 1);
      readable = readable && value;
      if (value) i[k] = value->front();
    }
    if (!readable) {
      warn(inertial, "bad_inertial", heft::say("the inertial of link \"{}\" has a missing or bad number", name),
           remedy);
      return;
    }
    if (m->front() < 0.0) {
      warn(*mass, "negative_mass", heft::say("link \"{}\" has a mass of {} kg", name, m->front()), remedy);
    }
    Matrix3d tensor;
    tensor << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
    const Vector3d principal = Eigen::SelfAdjointEigenSolver<Matrix3d>(tensor, Eigen::EigenvaluesOnly).eigenvalues();
    const double slack = 1e-9 * principal.cwiseAbs().maxCoeff();
    if (principal[0] < -slack) {
      warn(*inertia, "unphysical_inertia",
           heft::say("the inertia of link \"{}\" has a negative principal moment, {:.3g} kg m2", name, principal[0]),
           remedy);
    } else if (principal[2] > principal[0] + principal[1] + slack) {
      warn(*inertia, "unphysical_inertia",
           heft::say("the inertia of link \"{}\" breaks the triangle inequality: {:.3g} > {:.3g} + {:.3g} kg m2", name,
                     principal[2], principal[0], principal[1]),
           remedy);
    }
  }

  void checkJoint(const XmlElement& joint) {
    if (!checkName(joint, joints_)) return;
    const std::string name(joint.attributeOr("name"));
    const std::string_view type = joint.attributeOr("type");
    static const std::set<std::string_view> kTypes{"fixed",     "revolute", "continuous",
                                                   "prismatic", "floating", "planar"};
    if (!kTypes.contains(type)) {
      error(joint, "joint_type", heft::say("joint \"{}\" has the unknown type \"{}\"", name, type),
            heft::say("A URDF knows fixed, revolute, continuous, prismatic, floating and planar"));
    } else if (type == "floating" || type == "planar") {
      warn(joint, "joint_type", heft::say("joint \"{}\" is {}, which no column of q can describe", name, type),
           heft::say("It is held at zero"));
    }
    checkEnds(joint, name);
    checkOrigin(joint, name);
    if (!isMovingType(type)) return;
    checkAxis(joint, name);
    checkLimits(joint, name, type);
  }

  void checkEnds(const XmlElement& joint, const std::string& name) {
    std::string ends[2];
    const char* const kinds[2] = {"parent", "child"};
    for (int k = 0; k < 2; ++k) {
      const XmlElement* end = joint.child(kinds[k]);
      ends[k] = end ? end->attributeOr("link") : std::string_view();
      if (ends[k].empty()) {
        error(joint, "no_link", heft::say("joint \"{}\" names no {} link", name, kinds[k]),
              heft::say("Write <{} link=\"...\"/>", kinds[k]));
      } else if (!links_.contains(ends[k])) {
        error(*end, "unknown_link", heft::say("joint \"{}\" names link \"{}\", which does not exist", name, ends[k]),
              {});
        ends[k].clear();
      }
    }
    if (ends[0].empty() || ends[1].empty()) return;
    if (ends[0] == ends[1]) {
      error(joint, "loop", heft::say("joint \"{}\" joins link \"{}\" to itself", name, ends[0]), {});
      return;
    }
    const auto [place, isNew] = parentJoint_.emplace(ends[1], &joint);
    if (!isNew) {
      error(joint, "two_parents",
            heft::say("link \"{}\" has two parents: joints \"{}\" (line {}) and \"{}\"", ends[1],
                      place->second->attributeOr("name"), place->second->line, name),
            heft::say("A URDF is a tree; remove one of the joints"));
      return;
    }
    children_[ends[0]].push_back(ends[1]);
  }

  void checkOrigin(const XmlElement& joint, const std::string& name) {
    const XmlElement* origin = joint.child("origin");
    if (!origin) return;
    const auto xyz = numbers(*origin, "xyz", {0, 0, 0});
    const auto rpy = numbers(*origin, "rpy", {0, 0, 0});
    if (xyz && Vector3d(xyz->data()).cwiseAbs().maxCoeff() > 10.0) {
      warn(*origin, "origin_in_mm",
           heft::say("joint \"{}\" lies {:.4g} m from its parent", name, Vector3d(xyz->data()).norm()),
           heft::say("A URDF is in metres; this looks like millimetres"));
    }
    if (rpy && Vector3d(rpy->data()).cwiseAbs().maxCoeff() > 6.3) {
      warn(*origin, "angle_in_degrees",
           heft::say("joint \"{}\" has an rpy of {:.4g} rad", name, Vector3d(rpy->data()).cwiseAbs().maxCoeff()),
           heft::say("A URDF is in radians; this looks like degrees"));
    }
  }

  void checkAxis(const XmlElement& joint, const std::string& name) {
    const XmlElement* axis = joint.child("axis");
    if (!axis) return;
    if (!axis->attribute("xyz")) {
      error(*axis, "axis_zero", heft::say("the axis of joint \"{}\" has no xyz", name),
            heft::say("Give the direction, for instance xyz=\"0 0 1\""));
      return;
    }
    const auto xyz = numbers(*axis, "xyz", {1, 0, 0});
    if (!xyz) return;
    const double length = Vector3d(xyz->data()).stableNorm();
    if (length < 1e-6) {
      error(*axis, "axis_zero", heft::say("the axis of joint \"{}\" is zero", name),
            heft::say("Give the direction, for instance xyz=\"0 0 1\""));
    } else if (std::abs(length - 1.0) > 1e-3) {  // Four written digits stay below that.
      warn(*axis, "axis_not_unit", heft::say("the axis of joint \"{}\" has length {:.4g}", name, length),
           heft::say("It is taken as a direction"));
    }
  }

  void checkLimits(const XmlElement& joint, const std::string& name, std::string_view type) {
    const XmlElement* limit = joint.child("limit");
    if (!limit) {
      if (type != "continuous") {
        error(joint, "no_limits", heft::say("{} joint \"{}\" has no limits", type, name),
              heft::say("Write <limit lower= upper= velocity= effort=/> or type=\"continuous\""));
      }
      return;
    }
    for (const char* attribute : {"velocity", "effort"}) {
      if (limit->attribute(attribute)) continue;
      error(*limit, "no_limits", heft::say("the limit of joint \"{}\" has no {}", name, attribute),
            heft::say("A URDF demands it"));
    }
    const auto lower = numbers(*limit, "lower", {0});
    const auto upper = numbers(*limit, "upper", {0});
    const auto velocity = numbers(*limit, "velocity", {0});
    numbers(*limit, "effort", {0});
    numbers(*limit, "acceleration", {0});
    if (velocity && velocity->front() <= 0.0) {
      warn(*limit, "velocity_limit", heft::say("joint \"{}\" has a velocity limit of {}", name, velocity->front()),
           heft::say("It is taken as unlimited"));
    }
    if (!lower || !upper || type == "continuous") return;
    const double low = lower->front(), high = upper->front();
    if (low == 0.0 && high == 0.0) {
      warn(*limit, "limits_empty", heft::say("joint \"{}\" has no range: lower and upper are 0", name),
           heft::say("It is taken as unlimited"));
    } else if (low > high) {
      warn(*limit, "limits_inverted", heft::say("joint \"{}\" has lower {} above upper {}", name, low, high),
           heft::say("They are taken the other way round"));
    }
    const double reach = std::max(std::abs(low), std::abs(high));
    if (type == "revolute" && reach > 15.0 && reach <= 720.0) {
      warn(*limit, "limits_in_degrees", heft::say("joint \"{}\" may turn from {} to {} rad", name, low, high),
           heft::say("A URDF is in radians; this looks like degrees"));
    }
  }

  void checkMimic(const XmlElement& joint) {
    const XmlElement* mimic = joint.child("mimic");
    if (!mimic) return;
    numbers(*mimic, "multiplier", {1});
    numbers(*mimic, "offset", {0});
    const std::string leader(mimic->attributeOr("joint"));
    if (leader != joint.attributeOr("name") && joints_.contains(leader)) return;
    warn(*mimic, "bad_mimic",
         heft::say("joint \"{}\" mimics \"{}\", which is not another joint", joint.attributeOr("name"), leader),
         heft::say("It is held at zero"));
  }

  void checkTree() {
    std::vector<std::string> roots;
    for (const auto& [name, link] : links_) {
      if (!parentJoint_.contains(name)) roots.push_back(name);
    }
    if (roots.empty() && !links_.empty()) {
      error(robot_, "loop", heft::say("no link is the root: the joints form a closed loop"),
            heft::say("A URDF is a tree; remove a joint"));
    }
    if (roots.size() > 1) {
      error(*links_[roots[1]], "two_roots",
            heft::say("links \"{}\" and \"{}\"{} have no parent; a robot has one root", roots[0], roots[1],
                      roots.size() > 2 ? heft::say(" and {} more", roots.size() - 2) : std::string()),
            heft::say("Join them by a (fixed) joint"));
    }
    if (roots.size() != 1) return;
    std::set<std::string> reached;
    std::vector<std::string> pending{roots.front()};
    while (!pending.empty()) {
      const std::string link = pending.back();
      pending.pop_back();
      reached.insert(link);
      for (const std::string& child : children_[link]) pending.push_back(child);
    }
    for (const auto& [name, link] : links_) {
      if (reached.contains(name)) continue;
      warn(*link, "detached", heft::say("link \"{}\" is in a closed loop that is connected to nothing", name),
           heft::say("It is left out"));
    }
  }

  const XmlElement& robot_;
  const std::string& file_;
  Findings& findings_;
  std::map<std::string, const XmlElement*> links_, joints_, parentJoint_;
  std::map<std::string, std::vector<std::string>> children_;
};

}  // namespace

std::optional<std::vector<double>> parseNumbers(std::string_view text, std::size_t count) {
  std::vector<double> values;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  while (true) {
    while (at != end && isBlank(*at)) ++at;
    if (at == end) break;
    if (*at == '+' && at + 1 != end && *(at + 1) != '-') ++at;
    double value = 0.0;
    const auto [rest, problem] = std::from_chars(at, end, value);
    if (problem != std::errc() || !std::isfinite(value) || (rest != end && !isBlank(*rest))) return std::nullopt;
    values.push_back(value);
    if (values.size() > count) return std::nullopt;
    at = rest;
  }
  if (values.size() != count) return std::nullopt;
  return values;
}

Finding findingAt(const XmlElement& element, const std::string& file, Severity severity, std::string code,
                  std::string text, std::string remedy) {
  // Written without capital and full stop where they are made, since the place stands before them.
  for (std::string* sentence : {&text, &remedy}) {
    if (sentence->empty()) continue;
    char& first = sentence->front();
    if (first >= 'a' && first <= 'z') first = static_cast<char>(first - 'a' + 'A');
    if (sentence->back() != '.') *sentence += '.';
    *sentence = printable(*sentence, kMaxSentence);  // Names stand in it, and a file may hold anything.
  }
  return {severity, std::move(code), std::move(text), std::move(remedy), {file, element.line, element.column}};
}

void checkUrdf(const XmlElement& robot, const std::string& file, Findings& findings) {
  Checker(robot, file, findings).run();
}

}  // namespace heft
