#pragma once
// The numbers of a JSON object by their paths: files of JSON lines, JSON in MCAP files, datagrams.
#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace heft {

/// As many values as names.
struct NamedNumbers {
  std::vector<std::string> names;
  std::vector<double> values;
};

/// Reads the numbers of one JSON object after another. Senders write objects that differ in nothing but their numbers;
/// of such only the numbers are read, at the places where those of an earlier object stood.
class JsonNumbers {
 public:
  /// {"a": {"b": [1, 2]}} gives a.b[0] and a.b[1]; true and false are 1 and 0; text is left out; null, NaN and Infinity
  /// are NaN. An array beside an array `name` of as many texts is named by it, as in a JointState:
  /// position[panda_joint1]. Valid until the next call. Null if the text is no JSON object, nests deeper than 32, or
  /// holds more than 4096 numbers.
  const NamedNumbers* read(std::string_view text);

 private:
  /// The places of the numbers in objects that are alike but for these.
  struct Layout {
    std::vector<std::string> between;  ///< Text before each number, and after the last.
    /// Of each named number: which one in the text; none if it is constant (true, null, a number as text).
    std::vector<std::optional<std::size_t>> source;
    NamedNumbers numbers;
    std::vector<double> inText;

    /// False if the text is laid out otherwise.
    bool read(std::string_view text);
  };
  static std::optional<Layout> layoutOf(std::string_view text, const NamedNumbers& numbers);

  std::deque<Layout> layouts_;  ///< The one that was needed last stands first.
  std::size_t learned_ = 0, useful_ = 0;
  NamedNumbers other_;
};

/// The rows of a table that is one JSON value, each as the text of an object for JsonNumbers: an array of objects, or
/// an object whose arrays of equal length, at any depth of objects, are columns. Empty for anything else and for fewer
/// than ten rows: what is shorter is no recording.
std::vector<std::string> rowsOfJsonTable(std::string_view text);

/// JSON's text with null for the words NaN, Infinity and -Infinity, which Python writes and JSON does not have.
std::string withoutBareNaN(std::string_view text);

}  // namespace heft
