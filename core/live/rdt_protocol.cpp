#include "core/live/rdt_protocol.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/bytes.h"

namespace heft::rdt {

namespace {

constexpr std::size_t kRecordBytes = 36;
constexpr std::size_t kMostRecords = 40;     ///< In one packet, by the specification
constexpr std::uint32_t kRemembered = 1000;  ///< Missing numbers that may still come late

/// The text of the first element `name`.
std::string_view element(std::string_view xml, const std::string& name) {
  const auto open = xml.find("<" + name + ">");
  if (open == std::string_view::npos) return {};
  const auto start = open + name.size() + 2;
  const auto close = xml.find("</" + name + ">", start);
  return close == std::string_view::npos ? std::string_view() : xml.substr(start, close - start);
}

/// Counts per unit; 0 where the text is no number that counts can be divided by.
double countsOf(std::string_view text) {
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = code == std::errc() && end == text.data() + text.size();
  constexpr double kMost = std::numeric_limits<std::int32_t>::max();
  return whole && value > 0.0 && std::isfinite(value) && std::isfinite(kMost / value) ? value : 0.0;
}

}  // namespace

std::string request(Command command) {
  return {'\x12', '\x34', '\0', static_cast<char>(command), '\0', '\0', '\0', '\0'};
}

Result<Units> unitsIn(std::string_view page) {
  const auto force = element(page, "scfgfu");
  const auto torque = element(page, "scfgtu");
  if ((!force.empty() && force != "N") || (!torque.empty() && torque != "N-m" && torque != "Nm"))
    return Error{heft::say("The sensor is set to {} and {}: choose N and N-m on its web page.", printable(force),
                           printable(torque))};
  const Units units{countsOf(element(page, "cfgcpf")), countsOf(element(page, "cfgcpt"))};
  if (units.countsPerNewton == 0.0 || units.countsPerNewtonMetre == 0.0)
    return Error{heft::say("The sensor does not state its counts per newton; give them: rdt:HOST?cpf=N&cpt=N.")};
  return units;
}

bool RecordReader::follows(std::uint32_t number, Counts& counts) {
  if (!started_) {
    started_ = true;
    missing_.clear();
    ++sequence_;
  } else {
    // The difference modulo 2^32, with sign, tells later from earlier over the wrap.
    const auto step = static_cast<std::int32_t>(number - number_);
    if (step <= 0) {
      counts.late += missing_.erase(number);
      ++counts.reordered;
      // A sensor that was switched off and on counts from the start.
      if (step < -100000 || ++old_ > 100) started_ = false;
      return false;
    }
    counts.lost += static_cast<std::uint64_t>(step - 1);
    for (std::uint32_t n = number - std::min(static_cast<std::uint32_t>(step) - 1, kRemembered); n != number; ++n)
      missing_.insert(n);
    while (missing_.size() > kRemembered) missing_.erase(missing_.begin());
    sequence_ += step;
  }
  old_ = 0;
  number_ = number;
  return true;
}

std::vector<LiveSample> RecordReader::read(std::string_view datagram, const Units& units, double now, Counts& counts) {
  std::vector<LiveSample> samples;
  // Boxes that know buffered streaming alone send several records at once, whatever was asked for.
  if (datagram.empty() || datagram.size() % kRecordBytes != 0 || datagram.size() > kMostRecords * kRecordBytes) {
    ++counts.malformed;
    return samples;
  }
  for (std::size_t at = 0; at < datagram.size(); at += kRecordBytes) {
    ByteReader reader(datagram.substr(at, kRecordBytes), true);
    const auto number = reader.read<std::uint32_t>();
    reader.read<std::uint32_t>();  // the sensor's own sequence runs faster than the transfer
    const auto state = reader.read<std::uint32_t>();
    if (!follows(number, counts)) continue;
    counts.flagged += state != 0 ? 1 : 0;
    LiveSample sample;
    sample.time = clock_.timeOf(sequence_, now);
    Vector6d wrench;
    for (int a = 0; a < 6; ++a)
      wrench(a) = reader.read<std::int32_t>() / (a < 3 ? units.countsPerNewton : units.countsPerNewtonMetre);
    sample.wrench = wrench;
    samples.push_back(std::move(sample));
  }
  return samples;
}

}  // namespace heft::rdt
