#include "core/import/import.h"

#include <algorithm>
#include <new>
#include <set>

#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/bytes.h"
#include "core/import/configured.h"
#include "core/import/join.h"
#include "core/import/opened.h"

namespace heft {

namespace {

constexpr double kClearlyBetter = 0.05;  ///< Share of the force's variance that decides between two wrenches.

std::optional<Error> firstError(const Findings& findings) {
  for (const auto& finding : findings)
    if (finding.severity == Severity::error) return errorAt(finding.where, finding.text, finding.remedy);
  return std::nullopt;
}

Error tooLarge(const std::filesystem::path& path) {
  return errorAt({displayName(path), 0, 0}, heft::say("the recording does not fit into memory."),
                 heft::say("Split it, or record fewer topics."));
}

/// The failure that a chosen stream has no clock; nothing if all have.
std::optional<Error> withoutClock(const std::vector<Stream>& streams, const std::vector<ColumnSource>& columns) {
  for (const auto& column : columns) {
    const auto& stream = streams[column.stream];
    if (!stream.clockless) continue;
    return errorAt({stream.file, 0, 0},
                   heft::say("{} has no clock: nothing in the file gives its times.",
                             stream.name.empty() || stream.name == "/" ? stream.file : stream.name),
                   remedy(Remedy::stateRate) + " " + remedy(Remedy::chooseTime));
  }
  return std::nullopt;
}

/// Of every part the best source, whether or not they make a recording together; poses where there are no joints.
std::vector<ColumnSource> bestOfEach(const std::vector<ColumnCandidate>& candidates) {
  const auto has = [&](const char* part) {
    return std::ranges::any_of(candidates, [&](const auto& c) { return c.part == part && c.score >= 0; });
  };
  std::set<std::string> parts;
  if (has("joints")) parts = {"quaternion", "rotation", "position"};
  if (has("quaternion")) parts.insert("rotation");
  std::vector<ColumnSource> out;
  for (const auto& candidate : candidates)
    if (candidate.score >= 0 && parts.insert(candidate.part).second)
      out.insert(out.end(), candidate.columns.begin(), candidate.columns.end());
  return out;
}

Result<RecordingContents> inspect(const std::filesystem::path& path, const ImportOptions& options,
                                  const Progress& progress) {
  const auto kind = recognise(path);
  if (!kind) return kind.error();
  auto opened = openAll(path, *kind, options, progress);
  if (!opened) return opened.error();
  RecordingContents out;
  out.kind = *kind;
  out.timeCandidates = std::move(opened->timeCandidates);
  out.wishes = opened->wishes;
  out.findings = std::move(opened->findings);
  out.candidates = findCandidates(opened->streams, opened->jointNames);
  out.findings.insert(out.findings.end(), opened->look.begin(), opened->look.end());
  const auto failure = firstError(out.findings);
  auto chosen = chooseColumns(opened->streams, opened->wishes, opened->jointNames, out.findings);
  if (failure)
    out.missing = failure->message;
  else if (!chosen)
    out.missing = chosen.error().message;
  else if (const auto lost = withoutClock(opened->streams, *chosen))
    out.missing = lost->message;
  if (out.missing.empty())
    out.chosen = std::move(*chosen);
  else
    out.proposed = chosen ? std::move(*chosen) : bestOfEach(out.candidates);
  for (auto& stream : opened->streams) {
    stream.values.clear();
    stream.received.clear();
    stream.stamps.clear();
  }
  out.streams = std::move(opened->streams);
  return out;
}

/// The failure with every finding that may explain it, in the same line, and how to see what there is.
Error explained(Error error, const Findings& first, const Findings& second = {}) {
  if (error.cancelled) return error;
  static const std::set<std::string> kTelling = {"topic_unreadable", "no_time",       "dataset_odd",  "filter_missing",
                                                 "link_broken",      "names_missing", "schema_unread"};
  std::size_t told = 0;
  for (const auto* findings : {&first, &second}) {
    for (const auto& finding : *findings) {
      const bool tells = finding.severity != Severity::info || kTelling.contains(finding.code);
      if (!tells || error.message.find(finding.text) != std::string::npos || told == 6) continue;
      error.message += " " + finding.text;
      if (!finding.remedy.empty() && error.message.find(finding.remedy) == std::string::npos)
        error.message += " " + finding.remedy;
      ++told;
    }
  }
  return error;
}

/// Why the file is no recording in the contract's form, judged by its head and first rows: other names, other units, or
/// cells that need another reader. Nothing for one that its own reader should have.
std::optional<Error> otherThanContract(const std::filesystem::path& path, const ImportOptions& options) {
  std::error_code code;
  if (std::filesystem::status(path, code).type() != std::filesystem::file_type::regular) return std::nullopt;
  const auto file = ByteFile::open(path);
  if (!file) return std::nullopt;
  const auto head = file->read(0, 256u << 10);
  RecordingMeta meta;
  Findings aside;
  auto metaFile = options.metaFile;
  if (metaFile.empty() && std::filesystem::exists(metaFileOf(path), code)) metaFile = metaFileOf(path);
  if (!metaFile.empty()) {
    auto read = readMeta(metaFile, aside);
    if (!read) return std::nullopt;
    meta = std::move(*read);
  }
  if (!options.robot.empty())
    if (auto wished = robotWished(options)) meta.robot = std::move(*wished);
  return contractMisfit(head, displayName(path), meta);
}

/// Of several wrenches that names alone do not tell apart, the one that follows the motion best. The choice comes first
/// among what is told.
void letMotionDecide(std::vector<ColumnSource>& columns, const std::vector<std::vector<ColumnSource>>& others,
                     const Opened& opened, Findings& findings) {
  if (others.empty()) return;
  const auto nameOf = [&](const std::vector<ColumnSource>& sources) {
    const auto fx = std::find_if(sources.begin(), sources.end(), [](const auto& c) { return c.column == "fx"; });
    const auto& stream = opened.streams[fx->stream];
    return stream.type.empty() ? stream.fields[fx->field] : stream.name;
  };
  const auto explainedBy = [&](const std::vector<ColumnSource>& sources) {
    return explainedByMotion(opened.streams, sources, opened.wishes, opened.meta);
  };
  const auto mine = explainedBy(columns);
  std::string names;
  const std::vector<ColumnSource>* best = &columns;
  double bestShare = mine.value_or(0.0);
  for (const auto& other : others) {
    names += (names.empty() ? "" : ", ") + nameOf(other);
    const auto share = explainedBy(other);
    if (!mine || !share || *share < bestShare + kClearlyBetter) continue;
    best = &other;
    bestShare = *share;
  }
  const bool moved = best != &columns;
  const auto was = nameOf(columns);
  if (moved) columns = *best;
  findings.insert(
      findings.begin(),
      {Severity::warning,
       "wrench_of_several",
       moved ? heft::say("Several wrenches are possible; {} was used, since the motion explains {:.0f} % of its force, "
                         "and {:.0f} % of that of {}.",
                         nameOf(columns), 100.0 * bestShare, 100.0 * mine.value_or(0.0), was)
             : heft::say("Several wrenches are possible; {} was used, and it could also be {}.", was, names),
       remedy(Remedy::chooseSource, "wrench"),
       {opened.streams[columns[0].stream].file, 0, 0}});
}

// NOLINTNEXTLINE(readability-function-size): steps over one state, still to be split
Result<ReadRecording> readAny(const std::filesystem::path& path, const ImportOptions& options,
                              const Progress& progress) {
  const auto kind = recognise(path);
  if (!kind) return kind.error();
  std::error_code code;
  std::optional<Error> misfit;
  if (*kind == FileKind::contractCsv && options.empty() && !std::filesystem::exists(mapFileOf(path), code)) {
    misfit = otherThanContract(path, options);
    std::string robot;
    if (!options.robot.empty()) {
      auto wished = robotWished(options);
      if (!wished) return wished.error();
      robot = std::move(*wished);
    }
    if (!misfit) return readRecording(path, {options.metaFile, robot}, progress);
  }

  auto opened = openAll(path, *kind, options, progress);
  const auto withWays = [](Error error, std::initializer_list<Remedy> ways = {Remedy::addFile, Remedy::showContents}) {
    for (const auto way : ways)
      if (const auto text = remedy(way); error.message.find(text) == std::string::npos) error.message += " " + text;
    return error;
  };
  if (!opened) return misfit ? *misfit : opened.error();
  if (auto failure = firstError(opened->findings))
    return withWays(explained(*failure, opened->findings), {Remedy::showContents});
  const auto listed = std::move(opened->streams);
  const auto cutOff = [](const Finding& finding) {
    return finding.code == "file_cut_off" || finding.code == "chunk_damaged";
  };
  if (listed.empty() && std::any_of(opened->findings.begin(), opened->findings.end(), cutOff))
    return errorAt({displayName(path), 0, 0},
                   heft::say("it is cut off or damaged before the first message that could be read."),
                   heft::say("Copy it again from where it was recorded."));
  if (listed.empty())
    return explained(errorAt({displayName(path), 0, 0}, heft::say("it contains nothing that Heft can read."),
                             heft::say("Record the sensor's wrench and the joints or the pose.") + " " +
                                 remedy(Remedy::showContents)),
                     opened->findings);
  auto columns = chooseColumns(listed, opened->wishes, opened->jointNames, opened->findings, !opened->meta.robot);
  if (!columns) return withWays(misfit ? *misfit : explained(columns.error(), opened->findings, opened->look));
  if (const auto lost = withoutClock(listed, *columns)) return *lost;
  settleUnits(*columns, *opened);
  settleAxes(*columns, *opened, displayName(path));

  // Streams are known again by file, name and type, fields by name.
  std::set<std::tuple<std::string, std::string, std::string, std::string>> wanted;
  const auto keyOf = [](const Stream& stream, std::size_t field) {
    return std::tuple(stream.file, stream.name, stream.type, stream.fields[field]);
  };
  for (const auto& column : *columns) wanted.insert(keyOf(listed[column.stream], column.field));
  const auto rivals = rivalWrenches(listed, opened->wishes, *columns);
  for (const auto& rival : rivals)
    for (const auto& column : rival.columns) wanted.insert(keyOf(listed[column.stream], column.field));
  const FieldFilter filter = [&](const Stream& stream, std::size_t field) {
    return wanted.contains(keyOf(stream, field)) || tellsConfiguredPayload(stream, field);
  };
  if (const auto read = readAll(*opened, filter, progress); !read) return read.error();

  // Where they stand after the second read; false where one is gone.
  const auto findAgain = [&](std::vector<ColumnSource>& sources) {
    for (auto& column : sources) {
      const auto key = keyOf(listed[column.stream], column.field);
      bool there = false;
      for (std::size_t s = 0; s < opened->streams.size() && !there; ++s) {
        for (std::size_t f = 0; f < opened->streams[s].fields.size() && !there; ++f) {
          if (keyOf(opened->streams[s], f) != key) continue;
          column.stream = s;
          column.field = f;
          there = true;
        }
      }
      if (!there) return false;
    }
    return true;
  };
  auto found = *columns;
  if (!findAgain(found))
    return errorAt({listed[(*columns)[0].stream].file, 0, 0}, heft::say("its columns could not be read again."),
                   heft::say("Was the file changed in the meantime?"));
  std::vector<std::vector<ColumnSource>> others;
  for (const auto& rival : rivals) {
    auto other = *columns;
    std::erase_if(other, [](const auto& column) { return column.column[0] == 'f' || column.column[0] == 't'; });
    other.insert(other.end(), rival.columns.begin(), rival.columns.end());
    if (findAgain(other)) others.push_back(std::move(other));
  }
  Findings choice;
  letMotionDecide(found, others, *opened, choice);
  opened->findings.insert(opened->findings.begin(), choice.begin(), choice.end());
  auto joined = joinStreams(opened->streams, found, opened->wishes, std::move(opened->meta), opened->findings);
  if (!joined) return explained(joined.error(), opened->findings);
  joined->file = displayName(path);
  joined->configured = configuredPayload(opened->streams);
  auto checked = checkRecording(std::move(*joined), NumberForm::plain);
  if (!checked) return explained(checked.error(), opened->findings);
  checked->findings.insert(checked->findings.begin(), opened->findings.begin(), opened->findings.end());
  return checked;
}

}  // namespace

Result<RecordingContents> inspectRecording(const std::filesystem::path& path, const ImportOptions& options,
                                           const Progress& progress) {
  try {
    return inspect(path, options, progress);
  } catch (const std::bad_alloc&) {
    return tooLarge(path);
  }
}

Result<ReadRecording> openRecording(const std::filesystem::path& path, const ImportOptions& options,
                                    const Progress& progress) {
  try {
    return readAny(path, options, progress);
  } catch (const std::bad_alloc&) {
    return tooLarge(path);
  }
}

}  // namespace heft
