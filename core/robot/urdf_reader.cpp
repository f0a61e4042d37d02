#include "core/robot/urdf_reader.h"

#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <mutex>

#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {
namespace {

/// Keeps what urdfdom would print to the console.
class LogCatcher : public console_bridge::OutputHandler {
 public:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first_.empty()) first_ = text;
  }
  const std::string& first() const { return first_; }

 private:
  std::string first_;
};

struct Parsed {
  urdf::ModelInterfaceSharedPtr model;
  std::string problem;
};

Parsed parseWithUrdfdom(const std::string& text) {
  static std::mutex oneAtATime;  // The output handler is global to the process.
  const std::lock_guard lock(oneAtATime);
  LogCatcher catcher;
  Parsed parsed;
  console_bridge::useOutputHandler(&catcher);
  try {
    parsed.model = urdf::parseURDF(text);
  } catch (const std::exception& problem) {
    parsed.problem = problem.what();
  }
  console_bridge::restorePreviousOutputHandler();
  if (parsed.problem.empty()) parsed.problem = catcher.first();
  return parsed;
}

class TreeBuilder {
 public:
  TreeBuilder(const XmlElement& robot, const urdf::ModelInterface& model) : model_(model) {
    for (const XmlElement& element : robot.children) {
      if (element.name == "joint") elements_[std::string(element.attributeOr("name"))] = &element;
    }
  }

  UrdfTree run(std::map<std::string, std::vector<Visual>> visuals,
               std::map<std::string, std::vector<Visual>> collisions) {
    tree_.name = model_.getName();
    // An own stack instead of recursion: a chain may be as long as the file allows.
    struct Pending {
      urdf::LinkConstSharedPtr link;
      int parent;
    };
    std::vector<Pending> pending{{model_.getRoot(), -1}};
    while (!pending.empty()) {
      const Pending next = pending.back();
      pending.pop_back();
      const int index = static_cast<int>(tree_.links.size());
      Link link;
      link.name = next.link->name;
      link.visuals = std::move(visuals[link.name]);
      link.collisions = std::move(collisions[link.name]);
      link.inertia = inertiaOf(*next.link);
      if (next.link->parent_joint) {
        link.parentJoint = static_cast<int>(tree_.joints.size());
        tree_.joints.push_back(jointOf(*next.link->parent_joint, next.parent, index));
      }
      tree_.links.push_back(std::move(link));
      for (auto child = next.link->child_links.rbegin(); child != next.link->child_links.rend(); ++child) {
        pending.push_back({*child, index});
      }
    }
    return std::move(tree_);
  }

 private:
  UrdfJoint jointOf(const urdf::Joint& source, int parent, int child) {
    UrdfJoint result;
    const XmlElement& element = *elements_.at(source.name);
    result.where.line = element.line;
    result.where.column = element.column;
    Joint& joint = result.joint;
    joint.name = source.name;
    joint.parentLink = parent;
    joint.childLink = child;
    joint.X_PJ = originOf(element, source);
    if (source.type == urdf::Joint::REVOLUTE || source.type == urdf::Joint::CONTINUOUS)
      joint.type = JointType::revolute;
    if (source.type == urdf::Joint::PRISMATIC) joint.type = JointType::prismatic;
    if (joint.type == JointType::fixed) return result;
    joint.axis = Vector3d(source.axis.x, source.axis.y, source.axis.z).stableNormalized();
    readLimits(element, source, joint.limits);
    if (source.mimic) {
      result.mimics = source.mimic->joint_name;
      joint.ratio = source.mimic->multiplier;
      joint.offset = source.mimic->offset;
    }
    return result;
  }

  /// What the checks warn of as unphysical is kept: the link is still as heavy as stated.
  static std::optional<BodyInertia> inertiaOf(const urdf::Link& link) {
    if (!link.inertial || !(link.inertial->mass > 0.0)) return std::nullopt;
    const urdf::Inertial& given = *link.inertial;
    const urdf::Rotation& r = given.origin.rotation;
    const Matrix3d turned = Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
    Matrix3d tensor;
    tensor << given.ixx, given.ixy, given.ixz, given.ixy, given.iyy, given.iyz, given.ixz, given.iyz, given.izz;
    return BodyInertia{given.mass,
                       {given.origin.position.x, given.origin.position.y, given.origin.position.z},
                       turned * tensor * turned.transpose()};
  }

  static Isometry3d originOf(const XmlElement& element, const urdf::Joint& source) {
    const urdf::Pose& given = source.parent_to_joint_origin_transform;
    const urdf::Rotation& r = given.rotation;
    const XmlElement* origin = element.child("origin");
    // Straight from the file's rpy: by way of urdfdom's quaternion the last digits would be lost.
    const auto rpy = origin ? parseNumbers(origin->attributeOr("rpy"), 3) : std::nullopt;
    Isometry3d pose = Isometry3d::Identity();
    pose.linear() =
        rpy ? rotationFromRpy(Vector3d(rpy->data())) : Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
    pose.translation() = Vector3d(given.position.x, given.position.y, given.position.z);
    return pose;
  }

  static void readLimits(const XmlElement& element, const urdf::Joint& source, JointLimits& limits) {
    if (!source.limits) return;
    const bool bounded =
        source.type != urdf::Joint::CONTINUOUS && (source.limits->lower != 0.0 || source.limits->upper != 0.0);
    if (bounded) {
      limits.lower = std::min(source.limits->lower, source.limits->upper);
      limits.upper = std::max(source.limits->lower, source.limits->upper);
    }
    if (source.limits->velocity > 0.0) limits.velocity = source.limits->velocity;
    if (source.limits->effort > 0.0) limits.effort = source.limits->effort;
    // Newer URDFs may give an acceleration limit, which urdfdom does not read.
    const XmlElement* limit = element.child("limit");
    const auto acceleration = limit ? parseNumbers(limit->attributeOr("acceleration"), 1) : std::nullopt;
    if (acceleration && acceleration->front() > 0.0) limits.acceleration = acceleration->front();
  }

  const urdf::ModelInterface& model_;
  std::map<std::string, const XmlElement*> elements_;
  UrdfTree tree_;
};

Error firstError(const Findings& findings, std::size_t from) {
  std::size_t count = 0;
  const Finding* first = nullptr;
  for (std::size_t k = from; k < findings.size(); ++k) {
    if (findings[k].severity != Severity::error) continue;
    if (!first) first = &findings[k];
    ++count;
  }
  const std::string more = count > 1 ? heft::say("{} more error(s) in this file.", count - 1) : std::string();
  return errorAt(first->where, first->text + (first->remedy.empty() ? "" : " " + first->remedy), more);
}

}  // namespace

Result<UrdfTree> readUrdf(const std::string& text, const std::string& file, const std::filesystem::path& baseFolder,
                          Findings& findings) {
  const Result<XmlElement> root = parseXml(text, file);
  if (!root) return root.error();
  const std::size_t before = findings.size();
  checkUrdf(*root, file, findings);
  if (std::any_of(findings.begin() + static_cast<std::ptrdiff_t>(before), findings.end(),
                  [](const Finding& finding) { return finding.severity == Severity::error; })) {
    return firstError(findings, before);
  }
  const Parsed parsed = parseWithUrdfdom(text);
  if (!parsed.model || !parsed.model->getRoot()) {
    std::string reason = printable(parsed.problem, 200);
    if (!reason.empty() && reason.back() != '.') reason += '.';
    return errorAt({file, 0, 0}, heft::say("The URDF cannot be read."), reason);
  }
  UrdfTree tree = TreeBuilder(*root, *parsed.model)
                      .run(readVisuals(*root, file, baseFolder, findings), readCollisions(*root, file, baseFolder));
  for (const auto& [name, link] : parsed.model->links_) {  // A detached loop owns itself and would never be freed.
    link->child_links.clear();
    link->child_joints.clear();
  }
  return tree;
}

}  // namespace heft
