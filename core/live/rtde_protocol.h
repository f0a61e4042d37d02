#pragma once
// Universal Robots' Real-Time Data Exchange, protocol version 2, by the RTDE guide of Universal Robots, as functions of
// bytes: big-endian. A package is its size (16 bits, header included), a type (8 bits) and the content. After the
// version is agreed on, the client names the outputs it wants, the controller answers with a recipe's number and their
// types, and sends them at the frequency asked for once it is started.
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/live/source.h"
#include "core/recording/configured_payload.h"

namespace heft::rtde {

/// The types of packages that this client sends or reads. Those that write inputs (I, and U towards the robot) are none
/// of ours.
enum Package : char {
  kProtocolVersion = 'V',
  kControllerVersion = 'v',
  kTextMessage = 'M',
  kData = 'U',
  kSetUpOutputs = 'O',
  kStart = 'S',
  kPause = 'P',
};

std::string package(Package type, const std::string& content);

struct Received {
  char type = 0;
  std::string content;
};

/// Finds the packages in what arrives.
class PackageReader {
 public:
  void add(std::string_view bytes) { waiting_ += bytes; }
  /// The next whole package; nothing until it is all there.
  std::optional<Received> next();
  /// A size that none has came: there is no way to find the next package.
  bool broken() const { return broken_; }

 private:
  std::string waiting_;  ///< Received, not yet a whole package; at most 64 KiB more than was added last.
  bool broken_ = false;
};

/// The message of a text package.
std::string textOf(std::string_view content);

/// What is asked for, without those outputs.
std::vector<std::string> outputsWithout(const std::vector<std::string>& left);
/// Whether nothing can be done without it.
bool isNeeded(std::string_view output);
/// Content of the package that asks for outputs at a frequency [Hz].
std::string outputRequest(double frequencyHz, const std::vector<std::string>& outputs);

/// Which outputs a controller sends, in their order.
struct Recipe {
  char number = 0;
  std::vector<std::string> outputs;
};
/// Of the outputs `wanted` those that the controller's `answer` does not promise.
std::vector<std::string> missingIn(std::string_view answer, const std::vector<std::string>& wanted);

/// Numbers by the names of their outputs, each as many as the guide says, finite or not.
using Row = std::map<std::string, std::vector<double>>;

/// The numbers of a data package; nothing where it is none of the recipe's.
std::optional<Row> rowOf(std::string_view content, const Recipe& recipe);
/// [s] The controller's clock; nothing where the row has none.
std::optional<double> stampOf(const Row& row);
/// Joints, velocities and wrench of the row, in SI units and in the tool flange's axes, without a time; nothing without
/// joints. An output that holds what is no number is left out.
std::optional<LiveSample> sampleOf(const Row& row);
/// What the controller was told that it carries; nothing where the row does not say.
std::optional<ConfiguredPayload> configuredIn(const Row& row);

}  // namespace heft::rtde
