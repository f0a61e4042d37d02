#pragma once
// The parts of reading a URDF, one a source file; RobotModel puts them together. Private to core/robot.
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/findings.h"
#include "core/base/result.h"
#include "core/robot/robot_model.h"
#include "core/robot/xml_tree.h"

namespace heft {

struct UrdfJoint {
  Joint joint;         ///< index is not set yet, and axis is of unit length for a joint that moves.
  std::string mimics;  ///< Name of the joint that it follows; empty if none.
  XmlElement where;    ///< Its place only.
};

/// Links in depth-first order from the root, joints so that a parent stands before its children.
struct UrdfTree {
  std::string name;
  std::vector<Link> links;
  std::vector<UrdfJoint> joints;
};

/// Reads the text with urdfdom after checkUrdf. Fails if anything found is an error. `file` stands in findings.
Result<UrdfTree> readUrdf(const std::string& text, const std::string& file, const std::filesystem::path& baseFolder,
                          Findings& findings);

/// What urdfdom would accept silently, or refuse without saying where: xacro, numbers, duplicates, parents, loops,
/// axes, limits, inertials. `robot` is the root element.
void checkUrdf(const XmlElement& robot, const std::string& file, Findings& findings);

/// Which joints are q's columns, from base to tip (see RobotModel). Empty if nothing moves.
std::vector<int> chooseColumns(const UrdfTree& tree, std::string_view sensorLink);

/// Lets every joint that mimics one with a column follow it: index, ratio and offset.
void followMimics(UrdfTree& tree);

/// Makes every moving joint without a column a fixed one at zero or its nearest limit, with one finding for all.
void holdOthers(UrdfTree& tree, const std::string& file, Findings& findings);

/// The visuals of every link, by link name. A visual that cannot be understood is left out with a warning.
std::map<std::string, std::vector<Visual>> readVisuals(const XmlElement& robot, const std::string& file,
                                                       const std::filesystem::path& baseFolder, Findings& findings);
/// The collision bodies of every link. A link of which one cannot be understood has none: what it looks like stands in.
std::map<std::string, std::vector<Visual>> readCollisions(const XmlElement& robot, const std::string& file,
                                                          const std::filesystem::path& baseFolder);

/// Exactly `count` finite numbers separated by blanks, or nullopt.
std::optional<std::vector<double>> parseNumbers(std::string_view text, std::size_t count);

/// A finding at an element's place.
Finding findingAt(const XmlElement& element, const std::string& file, Severity severity, std::string code,
                  std::string text, std::string remedy);

}  // namespace heft
