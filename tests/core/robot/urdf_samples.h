#pragma once
// URDF texts put together from short pieces.
#include <string>

namespace heft::samples {

inline std::string link(const std::string& name, const std::string& inside = "") {
  return "<link name=\"" + name + "\">" + inside + "</link>\n";
}

/// `inside` stands for everything but parent and child.
inline std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                         const std::string& child, const std::string& inside = "") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent + "\"/><child link=\"" + child +
         "\"/>" + inside + "</joint>\n";
}

inline const char* const kLimit = R"(<limit lower="-1" upper="1" velocity="1" effort="1"/>)";

/// A chain b, l1, l2 ... of `types` (r revolute, c continuous, p prismatic, f fixed), joints and links named by
/// `prefix`, hung on link `root`.
inline std::string chain(const std::string& types, const std::string& root = "b", const std::string& prefix = "") {
  std::string text, parent = root;
  for (std::size_t k = 0; k < types.size(); ++k) {
    const std::string name = prefix + "l" + std::to_string(k + 1);
    const std::string type = types[k] == 'r'   ? "revolute"
                             : types[k] == 'p' ? "prismatic"
                             : types[k] == 'c' ? "continuous"
                                               : "fixed";
    text += link(name) + joint(prefix + "j" + std::to_string(k + 1), type, parent, name,
                               std::string("<axis xyz=\"0 0 1\"/>") + (types[k] == 'f' ? "" : kLimit));
    parent = name;
  }
  return text;
}

inline std::string robot(const std::string& inside) { return "<robot name=\"test\">\n" + inside + "</robot>\n"; }

}  // namespace heft::samples
