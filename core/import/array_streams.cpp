#include "core/import/array_streams.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/field_name.h"
#include "core/import/time_column.h"

namespace heft {

namespace {

constexpr std::size_t kFewRows = 10;  ///< Fewer are no recording whose times were missed.

/// Where a group's times stand.
struct ArrayClock {
  std::size_t times = 0;
  TimeColumn column;
  std::optional<std::size_t> parts;
  bool elsewhere = false;  ///< Not in the group or around it.
};

/// The first two parts of a group's path: what belongs to one demonstration.
std::string demonstrationOf(const std::string& group) {
  const auto first = group.find('/');
  if (first == std::string::npos) return group;
  return group.substr(0, group.find('/', first + 1));
}

class ArrayStreams {
 public:
  ArrayStreams(const std::vector<NumberArray>& arrays, const ChannelReader& read, const FieldFilter& filter,
               const TimeChoice& choice, StreamSet& set)
      : arrays_(arrays), read_(read), filter_(filter), choice_(choice), set_(set) {}

  Result<bool> run(const Progress& progress) {
    for (const auto& each : arrays_)
      if (each.channels == 1) set_.timeCandidates.push_back("/" + each.path);
    std::map<std::pair<std::string, std::size_t>, std::vector<std::size_t>> groups;
    // Tables of one form in one group are several recordings, each a stream of its own.
    const auto hasTwin = [&](const NumberArray& table) {
      return !table.columns.empty() && std::ranges::count_if(arrays_, [&](const NumberArray& other) {
                                         return other.group == table.group && other.columns == table.columns;
                                       }) > 1;
    };
    for (std::size_t a = 0; a < arrays_.size(); ++a)
      groups[{hasTwin(arrays_[a]) ? arrays_[a].path : arrays_[a].group, arrays_[a].rows}].push_back(a);
    for (const auto& [key, members] : groups) {
      if (progress.cancelled()) return Error{heft::say("Reading was stopped."), true};
      if (!addGroup(key.first, key.second, members)) break;
    }
    finish();
    return true;
  }

 private:
  void note(Severity severity, const char* code, std::string text, std::string way = {}) {
    set_.findings.push_back({severity, code, std::move(text), std::move(way), {set_.file, 0, 0}});
  }

  /// Of the candidates, the array of times (and of parts of seconds) by name.
  std::optional<ArrayClock> pick(const std::vector<std::size_t>& candidates) const {
    std::vector<std::string> names;
    TimeChoice choice = choice_;
    for (const auto a : candidates) {
      const bool chosen =
          !choice.column.empty() && (arrays_[a].path == choice.column || "/" + arrays_[a].path == choice.column);
      names.push_back(chosen ? choice.column : arrays_[a].name);
    }
    const auto found = findTime(names, choice);
    if (!found) return std::nullopt;
    ArrayClock out{candidates[found->index], *found, std::nullopt, false};
    if (found->fraction) out.parts = candidates[*found->fraction];
    return out;
  }

  /// In the group itself, the nearest one around it, or a group "timestamp" of the same demonstration.
  std::optional<ArrayClock> findClock(std::string group, std::size_t rows) const {
    const std::string demonstration = demonstrationOf(group);
    const bool inDemonstration = group.find('/') != std::string::npos;
    for (;;) {
      std::vector<std::size_t> candidates;
      for (std::size_t a = 0; a < arrays_.size(); ++a) {
        const auto& each = arrays_[a];
        const bool chosen =
            !choice_.column.empty() && (each.path == choice_.column || "/" + each.path == choice_.column);
        if (each.rows == rows && each.channels == 1 && (each.group == group || chosen)) candidates.push_back(a);
      }
      if (auto found = pick(candidates)) return found;
      if (group.empty()) break;
      const auto slash = group.rfind('/');
      group = slash == std::string::npos ? "" : group.substr(0, slash);
    }
    if (!choice_.column.empty()) return std::nullopt;
    for (std::size_t a = 0; a < arrays_.size(); ++a) {
      const auto& each = arrays_[a];
      if (each.rows != rows || each.channels != 1) continue;
      if (inDemonstration && demonstrationOf(each.group) != demonstration &&
          each.group.substr(0, each.group.find('/')) != demonstration.substr(0, demonstration.find('/')))
        continue;
      const auto words = wordsOf(each.group);
      if (std::none_of(words.begin(), words.end(), [](const std::string& w) {
            return w == "timestamp" || w == "timestamps" || w == "time" || w == "times";
          }))
        continue;
      const auto values = read_(a, 0);
      bool rises = values.size() > 1;
      for (std::size_t k = 1; k < values.size() && rises; ++k) rises = values[k] > values[k - 1];
      if (!rises) continue;
      TimeColumn column;
      const auto unit = unitSi(readFieldName(each.name).unit, Quantity::time);
      column.unit = unit.value_or(1.0);
      column.unitKnown = unit.has_value();
      return ArrayClock{a, column, std::nullopt, true};
    }
    return std::nullopt;
  }

  /// The index that pandas keeps beside its blocks ("index" of a table, "axis1"), where it holds dates.
  void takeIndex(const std::vector<std::size_t>& members, std::optional<std::pair<std::size_t, std::size_t>>& inTable,
                 std::optional<ArrayClock>& alone) const {
    const auto isDates = [&](std::size_t a, std::size_t c) {
      const auto values = read_(a, c);
      return values.size() > 1 && unitOfTimes(values) < 1e-3 && values.back() > values.front();
    };
    for (const auto a : members) {
      const auto& array = arrays_[a];
      const auto index = std::find(array.columns.begin(), array.columns.end(), "index");
      const auto column = static_cast<std::size_t>(index - array.columns.begin());
      if (index != array.columns.end() && isDates(a, column)) {
        inTable = {a, column};
        return;
      }
      if (array.name == "axis1" && array.channels == 1 && isDates(a, 0)) {
        alone = ArrayClock{a, {}, std::nullopt, false};
        return;
      }
    }
  }

  static std::string fieldOf(const NumberArray& array, std::size_t channel) {
    if (channel < array.columns.size()) return printable(array.columns[channel], 100);
    return array.vector ? printable(array.name, 100) : fmt::format("{}[{}]", printable(array.name, 100), channel);
  }

  /// False where the numbers are too many.
  // NOLINTNEXTLINE(readability-function-size): steps over one state, still to be split
  bool addGroup(const std::string& group, std::size_t rows, const std::vector<std::size_t>& members) {
    // Columns of one table have their time among them.
    std::optional<std::pair<std::size_t, std::size_t>> timeInTable;
    std::optional<ArrayClock> clock;
    std::vector<double> times;
    TimeColumn column;
    bool clockless = false;
    std::vector<double> parts;
    std::optional<std::pair<std::size_t, std::size_t>> partsInTable;
    if (choice_.rateHz > 0.0) {
      times.reserve(rows);
      for (std::size_t r = 0; r < rows; ++r) times.push_back(static_cast<double>(r) / choice_.rateHz);
      column.unitKnown = true;
      if (!rateSaid_) noteRate(set_, choice_.rateHz);
      rateSaid_ = true;
    } else {
      for (const auto a : members) {
        if (arrays_[a].columns.empty()) continue;
        const auto found = findTime(arrays_[a].columns, choice_);
        if (!found) continue;
        column = *found;
        timeInTable = {a, found->index};
        times = read_(a, found->index);
        if (found->fraction) {
          partsInTable = {a, *found->fraction};
          parts = read_(a, *found->fraction);
        }
        break;
      }
      if (!timeInTable) {
        clock = findClock(group, rows);
        if (!clock && choice_.column.empty()) takeIndex(members, timeInTable, clock);
        if (timeInTable) times = read_(timeInTable->first, timeInTable->second);
      }
      if (!timeInTable) {
        clockless = !clock;
        if (clockless) {
          if (choice_.clockNeeded && rows >= kFewRows) withoutClock_.emplace_back(group, rows);
          times.reserve(rows);
          for (std::size_t r = 0; r < rows; ++r) times.push_back(static_cast<double>(r));
          column.unitKnown = true;
        } else {
          column = clock->column;
          times = read_(clock->times, 0);
        }
        if (clock && clock->parts) parts = read_(*clock->parts, 0);
        if (clock && clock->elsewhere)
          note(Severity::info, "time_elsewhere",
               heft::say("The times of /{} were taken from /{}.", printable(group),
                         printable(arrays_[clock->times].path)));
      }
      if (times.empty()) {
        damaged_.insert(arrays_[clock ? clock->times : timeInTable->first].path);
        return true;
      }
    }
    const auto isTime = [&](std::size_t a, std::size_t c) {
      const std::pair here(a, c);
      if (clock) return a == clock->times || a == clock->parts;
      return here == timeInTable || here == partsInTable;
    };
    Stream stream;
    stream.name = "/" + printable(group, 200);
    stream.file = set_.file;
    stream.samples = rows;
    stream.clockless = clockless && choice_.clockNeeded;
    std::vector<std::pair<std::size_t, std::size_t>> sources;
    for (const auto a : members)
      for (std::size_t c = 0; c < arrays_[a].channels; ++c) {
        if (isTime(a, c)) continue;
        stream.fields.push_back(fieldOf(arrays_[a], c));
        sources.emplace_back(a, c);
      }
    if (stream.fields.empty()) return true;
    numbers_ += rows;
    if (numbers_ > kMaxStreamNumbers) return false;
    if (!column.unitKnown) column.unit = unitOfTimes(times);
    stream.received = timesOf(times, parts, column);
    const auto [low, high] = std::minmax_element(stream.received.begin(), stream.received.end());
    stream.first = *low;
    stream.last = *high;
    stream.stamps.assign(stream.received.size(), 0);
    stream.values.resize(stream.fields.size());
    for (std::size_t field = 0; field < sources.size(); ++field) {
      if (!filter_ || !filter_(stream, field)) continue;
      numbers_ += rows;
      if (numbers_ > kMaxStreamNumbers) return false;
      stream.values[field] = read_(sources[field].first, sources[field].second);
      if (stream.values[field].empty()) damaged_.insert(arrays_[sources[field].first].path);
    }
    set_.streams.push_back(std::move(stream));
    return true;
  }

  void finish() {
    for (const auto& [group, rows] : withoutClock_)
      note(Severity::info, "no_time",
           heft::say("The datasets of {} rows in /{} have no dataset of times beside them.", rows, printable(group)),
           remedy(Remedy::chooseTime) + " " + remedy(Remedy::stateRate));
    if (numbers_ > kMaxStreamNumbers)
      note(Severity::warning, "file_too_large",
           heft::say("The selected datasets hold more than {} million numbers; the rest was not read.",
                     kMaxStreamNumbers / 1'000'000));
    for (const auto& each : damaged_)
      note(Severity::warning, "dataset_damaged", heft::say("The dataset /{} is damaged or cut off.", printable(each)));
  }

  const std::vector<NumberArray>& arrays_;
  const ChannelReader& read_;
  const FieldFilter& filter_;
  const TimeChoice& choice_;
  StreamSet& set_;
  std::vector<std::pair<std::string, std::size_t>> withoutClock_;
  std::set<std::string> damaged_;
  std::size_t numbers_ = 0;
  bool rateSaid_ = false;
};

}  // namespace

void placeArray(NumberArray& array, const std::string& path) {
  const auto slash = path.rfind('/');
  array.path = path;
  array.group = slash == std::string::npos ? "" : path.substr(0, slash);
  array.name = slash == std::string::npos ? path : path.substr(slash + 1);
}

Result<bool> addArrayStreams(const std::vector<NumberArray>& arrays, const ChannelReader& read,
                             const FieldFilter& filter, const TimeChoice& choice, const Progress& progress,
                             StreamSet& set) {
  return ArrayStreams(arrays, read, filter, choice, set).run(progress);
}

void noteRate(StreamSet& set, double rateHz) {
  set.findings.push_back({Severity::info,
                          "rate_stated",
                          heft::say("Times count from 0 at the stated rate, {:g} Hz.", rateHz),
                          {},
                          {set.file, 0, 0}});
}

}  // namespace heft
