#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/compensation/compensation.h"
#include "core/recording/columns.h"

namespace heft {

namespace {

template <class Vector>
nlohmann::json listOf(const Vector& v) {
  auto list = nlohmann::json::array();
  for (Eigen::Index i = 0; i < v.size(); ++i) list.push_back(v(i));
  return list;
}

}  // namespace

nlohmann::json toJson(const Compensated& out, const Recording& recording) {
  auto phases = nlohmann::json::array();
  for (const auto& s : out.segments) {
    nlohmann::json phase{{"from_s", s.from},
                         {"to_s", s.to},
                         {"phase", toString(s.phase)},
                         {"reason", s.reason},
                         {"confidence", s.confidence}};
    if (s.phase == Phase::contact)
      phase["on_tool"] = {{"mean_force_n", listOf(s.meanForce)},
                          {"mean_torque_nm", listOf(s.meanTorque)},
                          {"peak_force_n", s.peakForce}};
    if (s.phase == Phase::approach && s.distance > 0.0)
      phase["travel"] = {{"direction_base", listOf(s.direction_B)}, {"distance_m", s.distance}, {"speed_m_s", s.speed}};
    phases.push_back(std::move(phase));
  }
  return {{"schema", "heft.compensate/1"},
          {"recording",
           {{"file", recording.file},
            {"samples", recording.rows()},
            {"rate_hz", recording.rateHz()},
            {"duration_s", recording.duration()}}},
          {"wrench_sign", "sensor_on_payload"},
          {"bias",
           {{"force_n", listOf(out.bias.head<3>())},
            {"torque_nm", listOf(out.bias.tail<3>())},
            {"from", out.ownBias ? "recording" : "result"}}},
          {"free_motion",
           {{"force_rms_n", out.freeForceRms},
            {"torque_rms_nm", out.freeTorqueRms},
            {"noise_force_n", out.noiseForce},
            {"noise_torque_nm", out.noiseTorque}}},
          {"phases", phases}};
}

std::string toCsv(const Compensated& out, const Recording& recording) {
  std::string text = "time";
  const auto header = [&](Role role, Eigen::Index count) {
    for (Eigen::Index c = 0; c < count; ++c) text += "," + columnName(role, static_cast<int>(c));
  };
  header(Role::joint, recording.q.rows() > 0 ? recording.q.cols() : 0);
  header(Role::position, recording.position.rows() > 0 ? 3 : 0);
  header(Role::quaternion, recording.quaternion.rows() > 0 ? 4 : 0);
  header(Role::wrench, 6);
  text += ",phase\n";
  const auto numbers = [&](const auto& series, Eigen::Index row) {
    if (series.rows() == 0) return;
    for (Eigen::Index c = 0; c < series.cols(); ++c)
      fmt::format_to(std::back_inserter(text), ",{:.9g}", series(row, c));
  };
  for (Eigen::Index i = 0; i < out.time.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{:.9g}", out.time(i));
    numbers(recording.q, i);
    numbers(recording.position, i);
    numbers(recording.quaternion, i);
    for (int c = 0; c < 6; ++c) fmt::format_to(std::back_inserter(text), ",{:.6g}", out.wrench(i, c));
    text += ",";
    text += toString(out.phase[static_cast<std::size_t>(i)]);
    text += "\n";
  }
  return text;
}

std::string toText(const Compensated& out, const Recording& recording) {
  double free = 0.0, contact = 0.0;
  for (const auto& s : out.segments) {
    if (s.phase == Phase::contact) contact += s.to - s.from;
    if (s.phase == Phase::free || s.phase == Phase::approach) free += s.to - s.from;
  }
  std::string text = fmt::format(
      "Without the payload's share {:.3f} N and {:.4f} N m remain in free motion; the sensor's own scatter is {:.3f} N "
      "and {:.4f} N m.\n{:.1f} s of {:.1f} s are free, {:.1f} s contact.\n\n      from        to   phase      force on "
      "the tool, sensor axes\n",
      out.freeForceRms, out.freeTorqueRms, out.noiseForce, out.noiseTorque, free, recording.duration(), contact);
  for (const auto& s : out.segments) {
    text += fmt::format("  {:8.2f}  {:8.2f} s {:<10}", std::max(0.0, s.from), s.to, toString(s.phase));
    if (s.phase == Phase::contact)
      text += fmt::format(" {:6.2f} {:6.2f} {:6.2f} N, up to {:.1f} N", s.meanForce(0), s.meanForce(1), s.meanForce(2),
                          s.peakForce);
    if (s.phase == Phase::approach && s.distance > 0.0)
      text += fmt::format(" {:.0f} mm at {:.0f} mm/s along {:.2f} {:.2f} {:.2f} (base axes)", 1e3 * s.distance,
                          1e3 * s.speed, s.direction_B(0), s.direction_B(1), s.direction_B(2));
    text += "\n";
  }
  text += fmt::format("\n  Bias {:.3f} {:.3f} {:.3f} N, {:.4f} {:.4f} {:.4f} N m, from {}.\n", out.bias(0), out.bias(1),
                      out.bias(2), out.bias(3), out.bias(4), out.bias(5),
                      out.ownBias ? "this recording's free parts" : "the result");
  if (!out.findings.empty()) text += "\n";
  for (const auto& finding : out.findings) text += "  " + toLine(finding) + "\n";
  return text;
}

}  // namespace heft
