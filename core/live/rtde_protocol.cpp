#include "core/live/rtde_protocol.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/base/text.h"
#include "core/import/bytes.h"

namespace heft::rtde {

namespace {

constexpr std::size_t kHeader = 3;

/// What is asked for, and how many numbers each has by the guide.
struct Output {
  const char* name;
  const char* type;
  std::size_t numbers;
  bool needed;
};
constexpr std::array<Output, 7> kOutputs{{{"timestamp", "DOUBLE", 1, true},
                                          {"actual_q", "VECTOR6D", 6, true},
                                          {"actual_qd", "VECTOR6D", 6, false},
                                          {"ft_raw_wrench", "VECTOR6D", 6, false},
                                          {"payload", "DOUBLE", 1, false},
                                          {"payload_cog", "VECTOR3D", 3, false},
                                          {"payload_inertia", "VECTOR6D", 6, false}}};

const Output* outputCalled(std::string_view name) {
  const auto found = std::find_if(kOutputs.begin(), kOutputs.end(), [&](const Output& o) { return o.name == name; });
  return found == kOutputs.end() ? nullptr : &*found;
}

std::string bigEndian(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  std::string out;
  for (int shift = 56; shift >= 0; shift -= 8) out += static_cast<char>(bits >> shift & 0xFF);
  return out;
}

std::vector<std::string> split(std::string_view list) {
  std::vector<std::string> out;
  for (;;) {
    const auto comma = list.find(',');
    out.emplace_back(list.substr(0, comma));
    if (comma == std::string_view::npos) return out;
    list.remove_prefix(comma + 1);
  }
}

/// Null where the row lacks it, or where it holds what is no number.
const std::vector<double>* finite(const Row& row, const char* output) {
  const auto found = row.find(output);
  const bool sound = found != row.end() &&
                     std::all_of(found->second.begin(), found->second.end(), [](double x) { return std::isfinite(x); });
  return sound ? &found->second : nullptr;
}

std::array<double, 7> sixOf(const std::vector<double>& values) {
  std::array<double, 7> out{};
  std::copy_n(values.begin(), std::min<std::size_t>(values.size(), 6), out.begin());
  return out;
}

}  // namespace

std::string package(Package type, const std::string& content) {
  const auto size = kHeader + content.size();
  std::string out{static_cast<char>(size >> 8 & 0xFF), static_cast<char>(size & 0xFF), type};
  return out + content;
}

std::optional<Received> PackageReader::next() {
  if (broken_ || waiting_.size() < kHeader) return std::nullopt;
  const auto size =
      static_cast<std::size_t>(static_cast<unsigned char>(waiting_[0])) << 8 | static_cast<unsigned char>(waiting_[1]);
  if (size < kHeader) {
    broken_ = true;
    waiting_.clear();
    return std::nullopt;
  }
  if (waiting_.size() < size) return std::nullopt;
  Received out{waiting_[2], waiting_.substr(kHeader, size - kHeader)};
  waiting_.erase(0, size);
  return out;
}

std::string textOf(std::string_view content) {
  if (content.empty()) return {};
  return printable(content.substr(1, static_cast<unsigned char>(content[0])), 200);
}

std::vector<std::string> outputsWithout(const std::vector<std::string>& left) {
  std::vector<std::string> out;
  for (const auto& output : kOutputs)
    if (std::find(left.begin(), left.end(), output.name) == left.end()) out.emplace_back(output.name);
  return out;
}

bool isNeeded(std::string_view output) {
  const auto* found = outputCalled(output);
  return found != nullptr && found->needed;
}

std::string outputRequest(double frequencyHz, const std::vector<std::string>& outputs) {
  return bigEndian(frequencyHz) + fmt::format("{}", fmt::join(outputs, ","));
}

std::vector<std::string> missingIn(std::string_view answer, const std::vector<std::string>& wanted) {
  const auto types = split(answer.substr(std::min<std::size_t>(1, answer.size())));
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const auto* output = outputCalled(wanted[i]);
    if (output == nullptr || i >= types.size() || types[i] != output->type) missing.push_back(wanted[i]);
  }
  return missing;
}

std::optional<Row> rowOf(std::string_view content, const Recipe& recipe) {
  std::size_t numbers = 0;
  for (const auto& name : recipe.outputs) {
    const auto* output = outputCalled(name);
    if (output == nullptr) return std::nullopt;
    numbers += output->numbers;
  }
  if (content.size() != 1 + 8 * numbers || content[0] != recipe.number) return std::nullopt;
  ByteReader reader(content.substr(1), true);
  Row row;
  for (const auto& name : recipe.outputs) {
    auto& into = row[name];
    for (std::size_t i = 0; i < outputCalled(name)->numbers; ++i) into.push_back(reader.read<double>());
  }
  return row;
}

std::optional<double> stampOf(const Row& row) {
  const auto* stamp = finite(row, "timestamp");
  return stamp == nullptr ? std::nullopt : std::optional(stamp->front());
}

std::optional<LiveSample> sampleOf(const Row& row) {
  const auto* joints = finite(row, "actual_q");
  if (joints == nullptr) return std::nullopt;
  LiveSample sample;
  sample.joints = 6;
  sample.q = sixOf(*joints);
  if (const auto* velocities = finite(row, "actual_qd")) sample.dq = sixOf(*velocities);
  if (const auto* wrench = finite(row, "ft_raw_wrench")) sample.wrench = Vector6d(wrench->data());
  return sample;
}

std::optional<ConfiguredPayload> configuredIn(const Row& row) {
  const auto* mass = finite(row, "payload");
  if (mass == nullptr) return std::nullopt;
  ConfiguredPayload told;
  told.source = "payload";
  told.flange = "tool0";
  told.payload.mass = mass->front();
  if (const auto* com = finite(row, "payload_cog")) told.payload.com = Vector3d(com->data());
  if (const auto* inertia = finite(row, "payload_inertia")) {
    const auto& v = *inertia;  // Ixx, Iyy, Izz, Ixy, Ixz, Iyz
    Matrix3d I;
    I << v[0], v[3], v[4], v[3], v[1], v[5], v[4], v[5], v[2];
    told.payload.inertiaCom = I;
  }
  return told;
}

}  // namespace heft::rtde
