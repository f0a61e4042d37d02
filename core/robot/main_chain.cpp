#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/robot/urdf_reader.h"

#include "core/base/say.h"

namespace heft {
namespace {

constexpr int kArmJoints = 4;      ///< An arm has at least so many joints before a branching may be its hand.
constexpr int kFingerJoints = 4;   ///< A finger has at most so many joints in a row.
constexpr int kCoupledJoints = 2;  ///< The same for a gripper whose other fingers mimic the first.

/// What hangs on a link, along its deepest path.
struct Below {
  int turning = 0;      ///< Independent revolute joints on the path that has most of them.
  int independent = 0;  ///< Most independent moving joints on one path.
  bool moves = false;   ///< Anything moves at all, mimics included.
};

std::vector<Below> measure(const UrdfTree& tree) {
  std::vector<Below> below(tree.links.size());
  for (auto joint = tree.joints.rbegin(); joint != tree.joints.rend(); ++joint) {  // Children stand after parents.
    const Below& child = below[joint->joint.childLink];
    Below& parent = below[joint->joint.parentLink];
    const bool moves = joint->joint.type != JointType::fixed;
    const bool independent = moves && joint->mimics.empty();
    const bool turns = independent && joint->joint.type == JointType::revolute;
    parent.turning = std::max(parent.turning, child.turning + (turns ? 1 : 0));
    parent.independent = std::max(parent.independent, child.independent + (independent ? 1 : 0));
    parent.moves = parent.moves || child.moves || moves;
  }
  return below;
}

/// Which links the way from the root to the link of that name passes; none if there is no such link.
std::vector<bool> leadsTo(const UrdfTree& tree, std::string_view name) {
  std::vector<bool> leads(tree.links.size(), false);
  const auto found = std::ranges::find(tree.links, name, &Link::name);
  if (name.empty() || found == tree.links.end()) return leads;
  for (auto link = static_cast<std::size_t>(found - tree.links.begin());;) {
    leads[link] = true;
    const int joint = tree.links[link].parentJoint;
    if (joint < 0) return leads;
    link = static_cast<std::size_t>(tree.joints[static_cast<std::size_t>(joint)].joint.parentLink);
  }
}

struct Branch {
  int joint;
  int turning;
  int independent;
  bool carriesSensor;
};

bool isHand(const std::vector<Branch>& branches, int jointsSoFar) {
  if (branches.size() < 2) return false;
  int deepest = 0, deepestTurning = 0, independentBranches = 0;
  for (const Branch& branch : branches) {
    deepest = std::max(deepest, branch.independent);
    deepestTurning = std::max(deepestTurning, branch.turning);
    if (branch.independent > 0) ++independentBranches;
  }
  if (deepestTurning == 0 && jointsSoFar > 0) return true;  // Two jaws that slide.
  if (jointsSoFar < kArmJoints) return false;
  return deepest <= (independentBranches > 1 ? kFingerJoints : kCoupledJoints);
}

}  // namespace

std::vector<int> chooseColumns(const UrdfTree& tree, std::string_view sensorLink) {
  const std::vector<Below> below = measure(tree);
  const std::vector<bool> leads = leadsTo(tree, sensorLink);
  std::vector<std::vector<int>> children(tree.links.size());
  for (std::size_t k = 0; k < tree.joints.size(); ++k) {
    children[tree.joints[k].joint.parentLink].push_back(static_cast<int>(k));
  }
  std::vector<int> columns;
  for (int link = 0;;) {
    std::vector<Branch> branches;
    for (const int k : children[link]) {
      const UrdfJoint& joint = tree.joints[k];
      const Below& child = below[joint.joint.childLink];
      const bool moves = joint.joint.type != JointType::fixed;
      if (!moves && !child.moves) continue;
      const bool independent = moves && joint.mimics.empty();
      branches.push_back({k, child.turning + (independent && joint.joint.type == JointType::revolute ? 1 : 0),
                          child.independent + (independent ? 1 : 0), leads[joint.joint.childLink]});
    }
    if (branches.empty() || isHand(branches, static_cast<int>(columns.size()))) break;
    const Branch& best = *std::max_element(branches.begin(), branches.end(), [](const Branch& a, const Branch& b) {
      if (a.carriesSensor != b.carriesSensor) return b.carriesSensor;
      return a.turning != b.turning ? a.turning < b.turning : a.independent < b.independent;
    });
    const UrdfJoint& next = tree.joints[best.joint];
    if (next.joint.type != JointType::fixed && next.mimics.empty()) columns.push_back(best.joint);
    link = next.joint.childLink;
  }
  return columns;
}

void followMimics(UrdfTree& tree) {
  std::map<std::string, const UrdfJoint*> byName;
  for (const UrdfJoint& joint : tree.joints) byName[joint.joint.name] = &joint;
  for (UrdfJoint& joint : tree.joints) {
    if (joint.mimics.empty() || joint.joint.type == JointType::fixed) continue;
    double ratio = joint.joint.ratio, offset = joint.joint.offset;
    auto leader = byName.find(joint.mimics);
    // A mimic may follow a mimic; a ring of them ends after as many steps as there are joints.
    for (std::size_t step = 0; step < tree.joints.size() && leader != byName.end(); ++step) {
      const UrdfJoint& other = *leader->second;
      const bool known = other.joint.index >= 0;
      if (!known && other.mimics.empty()) break;  // Held still.
      offset += ratio * other.joint.offset;
      ratio *= other.joint.ratio;
      if (known) {
        joint.joint.index = other.joint.index;
        joint.joint.ratio = ratio;
        joint.joint.offset = offset;
        break;
      }
      leader = byName.find(other.mimics);
    }
  }
}

void holdOthers(UrdfTree& tree, const std::string& file, Findings& findings) {
  std::vector<std::string> held;
  const UrdfJoint* first = nullptr;
  for (UrdfJoint& entry : tree.joints) {
    Joint& joint = entry.joint;
    if (joint.type == JointType::fixed || joint.index >= 0) continue;
    const double value = std::clamp(0.0, joint.limits.lower, joint.limits.upper);
    if (joint.type == JointType::revolute) joint.X_PJ = joint.X_PJ * Eigen::AngleAxisd(value, joint.axis);
    if (joint.type == JointType::prismatic) joint.X_PJ = joint.X_PJ * Eigen::Translation3d(value * joint.axis);
    joint.type = JointType::fixed;
    joint.ratio = 1.0;
    joint.offset = 0.0;
    held.push_back(joint.name);
    if (!first) first = &entry;
  }
  if (held.empty()) return;
  findings.push_back(findingAt(first->where, file, Severity::info, "joints_held",
                               heft::say("{} joint(s) are not on the arm's main chain and are held still: {}",
                                         held.size(), fmt::join(held, ", ")),
                               heft::say("Recordings need no column for them")));
}

}  // namespace heft
