// Recording to CSV and setup file. Doubles are written in the shortest form that reads back to the same bits.
#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/base/json_file.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/recording/columns.h"
#include "core/recording/csv_reader.h"
#include "core/recording/meta_file.h"

namespace heft {

namespace {

/// One column of doubles as it goes to the file.
struct Series {
  std::string name;
  const double* numbers;
  double sign;
};

template <class Matrix>
std::optional<Error> addSeries(std::vector<Series>& series, const Matrix& values, Role role, Eigen::Index rows,
                               double sign = 1.0) {
  if (values.rows() == 0) return std::nullopt;
  if (values.rows() != rows)
    return Error{heft::say("The recording cannot be written: {} has {} rows but time has {}.", columnName(role, 0),
                           values.rows(), rows)};
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    const auto name = columnName(role, static_cast<int>(c));
    if (!values.col(c).allFinite())
      return Error{heft::say("The recording cannot be written: {} holds values that are not finite.", name)};
    series.push_back({name, values.col(c).data(), sign});
  }
  return std::nullopt;
}

void appendNumber(std::string& out, double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  out.append(buffer, end);
}

void appendText(std::string& out, std::string_view cell) {
  const bool plain =
      cell.find_first_of(",\"\r\n") == std::string_view::npos &&
      (cell.empty() || (cell.front() != ' ' && cell.front() != '\t' && cell.back() != ' ' && cell.back() != '\t'));
  if (plain) {
    out += cell;
    return;
  }
  out += '"';
  for (const char c : cell) {
    if (c == '"') out += '"';
    out += c == '\n' || c == '\r' ? ' ' : c;  // cells hold no line breaks when read
  }
  out += '"';
}

nlohmann::ordered_json vectorJson(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// A path below the setup file's folder is written relative to it, so that both can move together.
std::string robotText(const std::string& robot, const std::filesystem::path& metaFile) {
  const std::filesystem::path path(robot);
  if (!path.is_absolute()) return robot;
  std::error_code ec;
  const auto folder = std::filesystem::absolute(metaFile, ec).parent_path().lexically_normal();
  const auto relative = ec ? std::filesystem::path() : path.lexically_relative(folder);
  return relative.empty() || *relative.begin() == ".." ? robot : relative.string();
}

}  // namespace

Result<std::string> metaText(const RecordingMeta& meta, const std::filesystem::path& metaFile) {
  nlohmann::ordered_json root;
  root["robot"] = nullptr;
  if (meta.robot) root["robot"] = robotText(*meta.robot, metaFile);
  root["kind"] = meta.kind == RecordingKind::poses ? "poses" : "motion";
  auto& sensor = root["sensor"];
  sensor["mount"]["parent"] = meta.mount.parent;
  sensor["mount"]["xyz_m"] = vectorJson(meta.mount.xyz);
  sensor["mount"]["rpy_rad"] = vectorJson(meta.mount.rpy);
  if (!meta.sensorModel.empty()) sensor["model"] = meta.sensorModel;
  sensor["wrench_sign"] = meta.wrenchSign == WrenchSign::payloadOnSensor ? "payload_on_sensor" : "sensor_on_payload";
  const nlohmann::json conventions = metaPatch(meta.conventions);
  // The sensor's first: a further key of an ordered object moves what `sensor` refers to.
  if (conventions.contains("sensor"))
    for (const auto& [key, value] : conventions["sensor"].items()) sensor[key] = value;
  for (const auto& [key, value] : conventions.items())
    if (key != "sensor") root[key] = value;
  root["gravity_m_s2"] = vectorJson(meta.gravity);
  const auto& known = meta.knownPayload;
  if (known.mass) root["known_payload"]["mass_kg"] = *known.mass;
  if (known.com) root["known_payload"]["com_m"] = vectorJson(*known.com);
  if (known.inertiaCom) {
    auto& rows = root["known_payload"]["inertia_com_kgm2"];
    for (int r = 0; r < 3; ++r) rows.push_back(vectorJson(known.inertiaCom->row(r).transpose()));
  }
  if (meta.clockAlignmentStd) root["clock_alignment_std_s"] = *meta.clockAlignmentStd;
  for (const auto& mark : meta.marks)
    root["marks"].push_back({{"from_s", mark.from}, {"to_s", mark.to}, {"label", toString(mark.label)}});
  if (!meta.note.empty()) root["note"] = meta.note;
  try {
    return root.dump(1) + "\n";
  } catch (const nlohmann::json::exception&) {
    return Error{heft::say("{} cannot be written: a text in it, perhaps the robot's path, is not valid UTF-8.",
                           displayName(metaFile))};
  }
}

Result<std::string> recordingText(const Recording& recording) {
  const auto rows = recording.rows();
  if (rows == 0) return Error{heft::say("The recording cannot be written: it has no rows.")};
  if (recording.wrenchNeedsPose)
    throw std::logic_error("a recording whose wrench is not in sensor axes is written; see toSensorAxes()");
  const double sign = recording.meta.wrenchSign == WrenchSign::payloadOnSensor ? -1.0 : 1.0;
  std::vector<Series> series;
  if (auto error = addSeries(series, recording.time, Role::time, rows)) return *error;
  if (auto error = addSeries(series, recording.q, Role::joint, rows)) return *error;
  if (auto error = addSeries(series, recording.dq, Role::jointVelocity, rows)) return *error;
  if (auto error = addSeries(series, recording.position, Role::position, rows)) return *error;
  if (auto error = addSeries(series, recording.quaternion, Role::quaternion, rows)) return *error;
  if (auto error = addSeries(series, recording.twist, Role::twist, rows)) return *error;
  if (auto error = addSeries(series, recording.accelerometer, Role::accelerometer, rows)) return *error;
  if (auto error = addSeries(series, recording.gyroscope, Role::gyroscope, rows)) return *error;
  if (auto error = addSeries(series, recording.wrench, Role::wrench, rows, sign)) return *error;
  const auto count = static_cast<std::size_t>(rows);
  const bool labels = !recording.labels.empty();
  if (labels && recording.labels.size() != count)
    return Error{
        heft::say("The recording cannot be written: it has {} labels for {} rows.", recording.labels.size(), rows)};
  for (const auto& extra : recording.extra)
    if (extra.cells.size() != count)
      return Error{heft::say("The recording cannot be written: column {} has {} cells for {} rows.",
                             printable(extra.name), extra.cells.size(), rows)};

  std::string out;
  out.reserve(count * (series.size() * 18 + 12 * recording.extra.size() + 10));
  for (const auto& each : series) out += each.name + ',';
  if (labels) out += "label,";
  for (const auto& extra : recording.extra) {
    appendText(out, extra.name.empty() ? "unnamed" : extra.name);
    out += ',';
  }
  out.back() = '\n';
  for (std::size_t row = 0; row < count; ++row) {
    for (const auto& each : series) {
      appendNumber(out, each.sign * each.numbers[row]);
      out += ',';
    }
    if (labels) {
      if (recording.labels[row]) out += toString(*recording.labels[row]);
      out += ',';
    }
    for (const auto& extra : recording.extra) {
      appendText(out, extra.cells[row]);
      out += ',';
    }
    out.back() = '\n';
  }
  return out;
}

Result<bool> writeMeta(const RecordingMeta& meta, const std::filesystem::path& file) {
  const auto text = metaText(meta, file);
  if (!text) return text.error();
  return writeTextFile(file, *text);
}

Result<bool> writeRecording(const Recording& recording, const std::filesystem::path& csv) {
  const auto text = recordingText(recording);
  if (!text) return text.error();
  if (csv == "-") return writeTextFile(csv, *text);
  if (auto written = writeTextFile(csv, *text); !written) return written;
  RecordingMeta meta = recording.meta;
  meta.conventions = {};  // The numbers are in the plain form, but for the wrench's sign.
  return writeMeta(meta, metaFileOf(csv));
}

}  // namespace heft
