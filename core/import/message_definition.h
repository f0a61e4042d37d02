#pragma once
// ROS message definitions and the numbers in messages that were written by them.
//
// A definition is the .msg text as bags carry it: the type's own fields, then for every type it uses a line of '='
// characters, "MSG: package/Type" and that type's fields. ROS 1 packs the values without gaps, little-endian; ROS 2
// writes CDR (a header of four bytes, every value aligned to its size, strings with a closing zero).
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace heft {

enum class MessageEncoding { ros1, cdr };

/// Numbers of one message. A field's name is its path: "wrench.force.x", "position[panda_joint1]" (array elements of a
/// message with `string[] name` are named by it), "O_T_EE[12]".
class MessageDecoder {
 public:
  /// Fails where the definition lacks a type or has one that Heft does not know.
  static Result<MessageDecoder> make(std::string_view type, std::string_view definition, MessageEncoding encoding);

  /// Decodes `message`; false if it ends early or states impossible lengths. The results below hold until the next
  /// call.
  bool decode(std::string_view message);

  const std::vector<std::string>& names() const { return names_; }
  const std::vector<double>& values() const { return values_; }  ///< One a name.
  bool namesChanged() const { return namesChanged_; }            ///< Since the message before.
  /// Stamp of the message's own header [ns]; 0 if there is none.
  std::int64_t stamp() const { return stamp_; }

 private:
  struct Type;
  struct Walk;
  std::shared_ptr<const Type> root_;
  MessageEncoding encoding_ = MessageEncoding::ros1;
  std::vector<std::string> names_;
  std::vector<double> values_;
  std::vector<std::uint64_t> shape_;  ///< Lengths and joint names that the names were made from.
  std::int64_t stamp_ = 0;
  bool namesChanged_ = false;
};

/// Definition of a type that recordings without definitions may hold; empty if Heft does not know it. `type` with or
/// without "/msg/".
std::string builtInDefinition(std::string_view type);

/// "geometry_msgs/msg/Wrench" and "geometry_msgs/Wrench" become the latter.
std::string plainTypeName(std::string_view type);

}  // namespace heft
