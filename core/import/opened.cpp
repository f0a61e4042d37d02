#include "core/import/opened.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/json_file.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/motion/motion.h"
#include "core/motion/mount_link.h"
#include "core/recording/robot_name.h"

namespace heft {

namespace {

TimeChoice timeChoice(const MappingWishes& wishes) {
  TimeChoice out;
  if (const auto found = wishes.use.find("time"); found != wishes.use.end()) out.column = found->second;
  if (const auto found = wishes.scale.find("time"); found != wishes.scale.end()) out.unit = found->second;
  out.rateHz = wishes.rateHz;
  return out;
}

/// A scale of the map file and a unit that is stated would both be applied.
std::optional<Error> refuseTwoScales(const MappingWishes& wishes, const Conventions& conventions,
                                     const std::string& file) {
  for (const auto& [target, factor] : wishes.scale) {
    const char first = target[0];
    const bool quaternion = target == "quaternion" || (first == 'q' && target.find_first_of("xyzw") == 1);
    const bool angle =
        (first == 'i' || first == 'j' || first == 'v' || first == 'd' || first == 'q' || first == 'g') && !quaternion;
    const bool wrench = first == 'w' || first == 'f' || (first == 't' && target != "time");
    const char* key = nullptr;
    if (first == 'a' && conventions.mPerS2PerAcceleration != 1.0) key = "acceleration_unit";
    if (angle && conventions.radPerAngle != 1.0) key = "angle_unit";
    if (first == 'p' && conventions.mPerLength != 1.0) key = "length_unit";
    if (wrench && conventions.force.si != 1.0) key = "force_unit";
    if (wrench && conventions.torque.si != 1.0) key = "torque_unit";
    if (key != nullptr)
      return errorAt({file, 0, 0},
                     heft::say("the map file scales {} by {}, and {} is stated, too.", target, factor, key),
                     heft::say("State only one of them."));
  }
  return std::nullopt;
}

}  // namespace

Result<std::string> robotWished(const ImportOptions& options) { return robotNamed(options.robot, {}, "--robot"); }

Result<bool> readAll(Opened& opened, const FieldFilter& filter, const Progress& progress) {
  opened.streams.clear();
  opened.timeCandidates.clear();
  Findings findings;
  for (std::size_t i = 0; i < opened.files.size(); ++i) {
    const auto& [path, kind] = opened.files[i];
    // A column chosen for the time may stand in one of several files.
    TimeChoice time = timeChoice(opened.wishes);
    time.clockNeeded = opened.meta.kind == RecordingKind::motion;
    if (time.rateHz > 0.0 && opened.files.size() > 1) {
      // Of several files it is the rate of those that have no clock.
      TimeChoice own = time;
      own.rateHz = 0.0;
      const auto look = readStreams(path, kind, {}, own, progress);
      if (look && !hasErrors(look->findings) && std::ranges::none_of(look->streams, &Stream::clockless))
        time.rateHz = 0.0;
    }
    auto set = readStreams(path, kind, filter, time, progress);
    if ((!set || hasErrors(set->findings)) && opened.files.size() > 1 && !time.column.empty()) {
      time.column.clear();
      set = readStreams(path, kind, filter, time, progress);
    }
    if (!set) return set.error();
    for (auto& stream : set->streams) opened.streams.push_back(std::move(stream));
    opened.timeCandidates.insert(opened.timeCandidates.end(), set->timeCandidates.begin(), set->timeCandidates.end());
    findings.insert(findings.end(), set->findings.begin(), set->findings.end());
  }
  // Without a filter it is a first look, and all is read once more if there is anything.
  if (filter || opened.streams.empty() || hasErrors(findings)) {
    opened.findings.insert(opened.findings.end(), findings.begin(), findings.end());
    opened.look.clear();
  } else {
    opened.look = std::move(findings);
  }
  return true;
}

Result<Opened> openAll(const std::filesystem::path& path, FileKind kind, const ImportOptions& options,
                       const Progress& progress) {
  Opened opened;
  std::error_code there;
  auto mapFile = options.mapFile;
  if (mapFile.empty() && std::filesystem::exists(mapFileOf(path), there)) mapFile = mapFileOf(path);
  if (options.wishes) {
    opened.wishes = *options.wishes;
  } else if (!mapFile.empty()) {
    auto read = readMapFile(mapFile);
    if (!read) return read.error();
    opened.wishes = std::move(*read);
    if (options.mapFile.empty())
      opened.findings.push_back({Severity::info,
                                 "map_file",
                                 heft::say("Columns and topics are taken as {} says.", displayName(mapFile.filename())),
                                 {},
                                 {displayName(path), 0, 0}});
  }
  for (const auto& wish : options.use)
    if (const auto added = addWish(opened.wishes, wish); !added) return added.error();
  opened.wishes.join.insert(opened.wishes.join.end(), options.join.begin(), options.join.end());
  if (options.rateHz > 0.0) opened.wishes.rateHz = options.rateHz;

  opened.files.emplace_back(path, kind == FileKind::contractCsv ? FileKind::table : kind);
  for (const auto& other : opened.wishes.join) {
    const auto otherKind = recognise(other);
    if (!otherKind) return otherKind.error();
    opened.files.emplace_back(other, *otherKind == FileKind::contractCsv ? FileKind::table : *otherKind);
  }

  std::error_code code;
  auto metaFile = options.metaFile;
  if (metaFile.empty() && std::filesystem::exists(metaFileOf(path), code)) metaFile = metaFileOf(path);
  if (metaFile.empty()) {
    opened.findings.push_back({Severity::info,
                               "no_meta",
                               heft::say("There is no {} beside the recording; defaults are used: wrench of the sensor "
                                         "on the payload, gravity (0, 0, -9.81) m/s2.",
                                         displayName(metaFileOf(path).filename())),
                               {},
                               {displayName(path), 0, 0}});
  } else {
    auto read = readMeta(metaFile, opened.findings);
    if (!read) return read.error();
    opened.meta = std::move(*read);
    if (const auto root = readJsonFile(metaFile))
      if (auto stated = readConventions(*root, displayName(metaFile))) opened.stated = std::move(stated->keys);
  }
  opened.stated.insert(opened.wishes.conventions.keys.begin(), opened.wishes.conventions.keys.end());
  if (!options.robot.empty()) {
    auto wished = robotWished(options);
    if (!wished) return wished.error();
    opened.meta.robot = std::move(*wished);
  }
  takeOver(opened.wishes.conventions, opened.meta.conventions);
  if (auto failure = refuseTwoScales(opened.wishes, opened.meta.conventions, displayName(path))) return *failure;
  if (opened.meta.robot) {
    Findings aside;
    if (const auto robot = robotFor(opened.meta, aside)) {
      mountOnFlange(opened.meta, *robot, opened.findings);
      for (const int joint : robot->movingJoints())
        opened.jointNames.push_back(robot->joints()[static_cast<std::size_t>(joint)].name);
    }
  }
  if (const auto read = readAll(opened, {}, progress); !read) return read.error();
  return opened;
}

void settleUnits(std::vector<ColumnSource>& columns, Opened& opened) {
  std::vector<std::string> named;
  for (auto& column : columns) {
    if (column.unitNamed && column.scale != 1.0 && named.size() < 4) named.push_back(column.column);
    column.scale = scaleWithin(column, opened.meta.conventions);
  }
  if (!named.empty())
    opened.findings.push_back({Severity::info,
                               "units_named",
                               heft::say("Units were taken from the columns' names ({}{}).", fmt::join(named, ", "),
                                         named.size() == 4 ? ", ..." : ""),
                               {},
                               {opened.streams.empty() ? "" : opened.streams[0].file, 0, 0}});
}

void settleAxes(const std::vector<ColumnSource>& columns, Opened& opened, const std::string& file) {
  const bool base = std::any_of(columns.begin(), columns.end(), [](const auto& column) { return column.inBaseAxes; });
  if (!base || opened.stated.contains("wrench_axes")) return;
  opened.meta.conventions.wrenchAxes = Conventions::WrenchAxes::base;
  opened.findings.push_back(
      {Severity::warning,
       "base_axes_known",
       heft::say("UR's actual_TCP_force is in the robot's base axes, about the TCP, and without the payload that the "
                 "controller has configured; it was read so."),
       heft::say(
           "State sensor.wrench_point in the setup file if the TCP is not at the sensor, or record ft_raw_wrench."),
       {file, 0, 0}});
}

}  // namespace heft
