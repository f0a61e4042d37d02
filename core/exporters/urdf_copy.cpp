#include "core/exporters/urdf_copy.h"

#include <algorithm>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/exporters/writing.h"
#include "core/robot/robot_model.h"
#include "core/robot/xml_tree.h"

namespace heft {

namespace {

/// Where an element's '<' stands, from its line and column.
std::size_t offsetOf(std::string_view text, const XmlElement& element) {
  std::size_t start = element.line == 1 && text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  for (long line = 1; line < element.line; ++line) start = text.find('\n', start) + 1;
  return text.find('<', start + static_cast<std::size_t>(element.column - 1));
}

/// Behind the tag that begins at `at`; '>' may stand in quotes.
std::size_t tagEnd(std::string_view text, std::size_t at) {
  char quote = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return at + 1;
    }
  }
  return text.size();
}

/// Behind the element that begins at `at`, of a text that parseXml() took.
std::size_t elementEnd(std::string_view text, std::size_t at) {
  int depth = 0;
  while (at < text.size()) {
    at = text.find('<', at);
    if (at == std::string_view::npos) break;
    const auto rest = text.substr(at);
    if (rest.starts_with("<!--")) {
      at = text.find("-->", at) + 3;
    } else if (rest.starts_with("<![CDATA[")) {
      at = text.find("]]>", at) + 3;
    } else if (rest.starts_with("<?")) {
      at = text.find("?>", at) + 2;
    } else {
      const auto end = tagEnd(text, at);
      if (rest.starts_with("</"))
        --depth;
      else if (text[end - 2] != '/')
        ++depth;
      at = end;
      if (depth == 0) return at;
    }
  }
  return text.size();
}

/// The blanks before `at` back to the line's beginning; nothing if other characters stand there.
std::string indentAt(std::string_view text, std::size_t at) {
  const auto line = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  const auto before = text.substr(line, at - line);
  return before.find_first_not_of(" \t") == std::string_view::npos ? std::string(before) : std::string();
}

/// Pose of the mount's parent link in `link`, of a robot that has both.
Result<std::optional<Isometry3d>> parentInLink(const std::string& urdf, const std::string& file,
                                               const std::string& link, const std::string& parent) {
  if (parent == link) return std::optional(Isometry3d(Isometry3d::Identity()));
  Findings aside;
  const auto robot = RobotModel::fromUrdfText(urdf, {}, aside, parent);
  if (!robot) return std::optional<Isometry3d>();  // a tool alone, without a joint that moves
  const auto from = robot->findLink(link);
  const auto to = robot->findLink(parent);
  if (!from || !to) return std::optional<Isometry3d>();
  const VectorXd q = robot->homePosture();
  const VectorXd moved = q + VectorXd::Constant(q.size(), 0.3);
  const Isometry3d X_LP = robot->linkPose(q, *from).inverse() * robot->linkPose(q, *to);
  if (!X_LP.isApprox(robot->linkPose(moved, *from).inverse() * robot->linkPose(moved, *to), 1e-9))
    return errorAt({file, 0, 0},
                   heft::say("the link \"{}\" moves against \"{}\", which carries the sensor.", printable(link),
                             printable(parent)),
                   heft::say("Name a link behind the last joint."));
  return std::optional(X_LP);
}

const XmlElement* linkNamed(const XmlElement& robot, const std::string& name) {
  const auto found = std::ranges::find_if(robot.children, [&](const XmlElement& element) {
    return element.name == "link" && element.attributeOr("name") == name;
  });
  return found == robot.children.end() ? nullptr : &*found;
}

}  // namespace

Result<std::string> payloadIntoUrdf(const std::string& urdf, const std::string& file, const std::string& link,
                                    const FlangePayload& payload, Findings& findings) {
  const auto root = parseXml(urdf, file);
  if (!root) return root.error();
  const XmlElement* element = linkNamed(*root, link);
  if (root->name != "robot" || element == nullptr) {
    std::vector<std::string> names;
    for (const auto& child : root->children)
      if (child.name == "link") names.push_back(printable(child.attributeOr("name")));
    return errorAt({file, 0, 0}, heft::say("there is no link \"{}\".", printable(link)),
                   heft::say("Name one of: {}.", joined(names)));
  }
  Payload own = payload.input.payload;
  std::optional<Isometry3d> X_LP;
  if (payload.mount && !payload.mount->parent.empty()) {
    const auto found = parentInLink(urdf, file, link, payload.mount->parent);
    if (!found) return found.error();
    X_LP = *found;
  }
  if (X_LP) {
    const Isometry3d X_PF = poseFromXyzRpy(payload.mount->xyz, payload.mount->rpy) * payload.X_FS.inverse();
    own = transformed(own, *X_LP * X_PF);
  } else {
    findings.push_back({Severity::warning,
                        "link_taken_for_flange",
                        heft::say("The URDF has no link that the sensor is known to be mounted on, so \"{}\" was taken "
                                  "for the flange.",
                                  printable(link)),
                        heft::say("Check that its axes are the flange's."),
                        {file, element->line, element->column}});
  }
  const Payload rounded = roundedForExport(own);
  if (const auto physical = checkPhysical(rounded); !physical.physical)
    return Error{heft::say("This payload cannot exist, so no {} file is written: {}", findExportFormat("urdf")->id,
                           physical.reason)};

  const std::string newline = urdf.find("\r\n") == std::string::npos ? "\n" : "\r\n";
  const auto start = offsetOf(urdf, *element);
  const std::string indent = indentAt(urdf, start);
  if (const XmlElement* old = element->child("inertial")) {
    const auto* mass = old->child("mass");
    findings.push_back({Severity::warning,
                        "inertial_replaced",
                        heft::say("The link \"{}\" weighed {} kg in the URDF; the payload replaces it.",
                                  printable(link), mass ? printable(mass->attributeOr("value")) : std::string("?")),
                        heft::say("If that was the arm's own mass, put the payload on a link of its own."),
                        {file, old->line, old->column}});
    const auto from = offsetOf(urdf, *old);
    std::string text = urdfInertial(rounded, indentAt(urdf, from), newline);
    text.resize(text.size() - newline.size());
    text.erase(0, indentAt(urdf, from).size());
    return urdf.substr(0, from) + text + urdf.substr(elementEnd(urdf, from));
  }
  const auto head = tagEnd(urdf, start);
  const std::string inertial = newline + urdfInertial(rounded, indent + "  ", newline);
  if (urdf[head - 2] != '/') {
    std::string text = inertial;
    text.resize(text.size() - newline.size());
    return urdf.substr(0, head) + text + urdf.substr(head);
  }
  auto slash = head - 2;
  while (slash > 0 && (urdf[slash - 1] == ' ' || urdf[slash - 1] == '\t')) --slash;
  return urdf.substr(0, slash) + ">" + inertial + indent + "</link>" + urdf.substr(head);
}

}  // namespace heft
