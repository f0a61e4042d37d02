#pragma once
// The numbers of a JSON object by their paths: files of JSON lines, JSON in MCAP files, datagrams.
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace heft {

using NamedNumbers = std::vector<std::pair<std::string, double>>;

/// {"a": {"b": [1, 2]}} gives a.b[0] and a.b[1]; true and false are 1 and 0; text is left out; null, NaN and Infinity
/// are NaN. An array beside an array `name` of as many texts is named by it, as in a JointState:
/// position[panda_joint1]. False if the text is no JSON object, nests deeper than 32, or holds more than 4096 numbers.
bool flattenJson(std::string_view text, NamedNumbers& out);

/// The rows of a table that is one JSON value, each as the text of an object for flattenJson(): an array of objects, or
/// an object whose arrays of equal length, at any depth of objects, are columns. Empty for anything else and for fewer
/// than ten rows: what is shorter is no recording.
std::vector<std::string> rowsOfJsonTable(std::string_view text);

/// JSON's text with null for the words NaN, Infinity and -Infinity, which Python writes and JSON does not have.
std::string withoutBareNaN(std::string_view text);

}  // namespace heft
