#pragma once
// Files that hold messages of several topics: ROS 1 bags, MCAP files, ROS 2 bags. They are scanned from front to back;
// the listener learns of each topic before its first message. A damaged or cut-off file gives what it holds, and a
// finding.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "core/base/findings.h"
#include "core/base/progress.h"
#include "core/base/result.h"

namespace heft {

enum class PayloadEncoding { ros1, cdr, json, other };

struct TopicInfo {
  std::string name;
  std::string type;        ///< "geometry_msgs/WrenchStamped"
  std::string definition;  ///< As the file has it; empty if it has none.
  PayloadEncoding encoding = PayloadEncoding::other;
  std::string encodingName;    ///< As the file has it: "protobuf".
  std::string schemaEncoding;  ///< Of the definition, where the file says it: "ros2idl". `definition` is then empty if
                               ///< it is none of ROS's .msg texts.
  std::string publisher;       ///< The node that sends, where the file knows it; else empty.
};

/// [bytes] What is larger may be a picture; smaller messages are always looked at.
constexpr std::size_t kLargeMessage = 16u << 10;

/// A message as it stands in the file: a picture that nobody wants is passed over without being read.
struct MessageBody {
  std::uint64_t size = 0;                   ///< [bytes]
  std::function<std::string_view()> bytes;  ///< Reads them; fewer where the file is cut off.
};

class MessageListener {
 public:
  virtual ~MessageListener() = default;
  /// `id` is unique within one scan.
  virtual void topic(std::uint64_t id, const TopicInfo& info) = 0;
  /// `received`: when the recorder got it [ns]. The body holds during the call only. False stops the scan.
  virtual bool message(std::uint64_t id, std::int64_t received, const MessageBody& body) = 0;
};

/// Each returns true, or why the file cannot be read at all.
Result<bool> scanRosBag(const std::filesystem::path& file, MessageListener& listener, Findings& findings,
                        const Progress& progress);
Result<bool> scanMcap(const std::filesystem::path& file, MessageListener& listener, Findings& findings,
                      const Progress& progress);
/// A .db3 file, such a file compressed with zstd, or the folder of a bag with metadata.yaml.
Result<bool> scanSqliteBag(const std::filesystem::path& file, MessageListener& listener, Findings& findings,
                           const Progress& progress);
Result<bool> scanRos2Folder(const std::filesystem::path& folder, MessageListener& listener, Findings& findings,
                            const Progress& progress);

}  // namespace heft
