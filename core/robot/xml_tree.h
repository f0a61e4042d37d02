#pragma once
// A small XML reader that remembers where everything stood. urdfdom keeps no lines and accepts much that it should not;
// our own checks of a URDF walk this tree, so that every finding names its place.
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace heft {

struct XmlAttribute {
  std::string name;
  std::string value;  ///< Entities replaced.
};

struct XmlElement {
  std::string name;
  std::vector<XmlAttribute> attributes;
  std::vector<XmlElement> children;
  long line = 0;    ///< Of its '<', from 1.
  long column = 0;  ///< In characters (bytes), from 1.

  /// The value, or null if there is no such attribute.
  const std::string* attribute(std::string_view attributeName) const;
  /// The value, or "" if there is no such attribute.
  std::string_view attributeOr(std::string_view attributeName) const;
  /// The first child of that name, or null.
  const XmlElement* child(std::string_view childName) const;
};

/// The root element. Text between tags, comments, CDATA, DOCTYPE and processing instructions are skipped; entities
/// beyond the five of XML and numeric ones are refused, and so is nesting deeper than 64 elements (urdfdom recurses).
/// `name` stands in the message ("arm.urdf:3:7: ...").
Result<XmlElement> parseXml(std::string_view text, const std::string& name);

}  // namespace heft
