// HDF5: every dataset of numbers with one or two dimensions is a group of channels; those of equal length in one group
// of the file share its dataset of times.
#include <fmt/format.h>
#include <hdf5.h>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>

#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/streams.h"
#include "core/import/time_column.h"

namespace heft {

namespace {

constexpr hsize_t kMostChannels = 64;  ///< A second dimension that is longer is no set of channels.
constexpr std::size_t kMostDatasets = 4096;

/// Closes whatever an HDF5 call opened.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  hid_t id() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

struct Dataset {
  std::string path;   ///< "robot/q"
  std::string group;  ///< "robot"; empty for the root
  std::string name;   ///< "q"
  hsize_t rows = 0;
  hsize_t channels = 1;
  int rank = 1;
  bool rowsLast = false;  ///< channels x rows, as MATLAB writes
};

herr_t collectPath(hid_t, const char* name, const H5O_info_t* info, void* data) {
  auto& paths = *static_cast<std::vector<std::string>*>(data);
  if (info->type == H5O_TYPE_DATASET) paths.emplace_back(name);
  return paths.size() < kMostDatasets ? 0 : 1;
}

/// What a dataset holds instead of plain numbers, in words; empty for numbers.
std::string oddType(H5T_class_t kind) {
  switch (kind) {
    case H5T_INTEGER:
    case H5T_FLOAT:
      return {};
    case H5T_STRING:
      return heft::say("text");
    case H5T_COMPOUND:
      return heft::say("a compound type");
    case H5T_VLEN:
      return heft::say("lists of different lengths");
    case H5T_ARRAY:
      return heft::say("an array type");
    case H5T_ENUM:
      return heft::say("names of states");
    default:
      return heft::say("no plain numbers");
  }
}

/// Nothing for what is no table of numbers; `odd` says then what it is, unless the file is damaged there.
std::optional<Dataset> describe(hid_t file, const std::string& path, double mostBytes, std::string& odd) {
  const Handle dataset(H5Dopen2(file, path.c_str(), H5P_DEFAULT), &H5Dclose);
  if (!dataset) return std::nullopt;
  const Handle type(H5Dget_type(dataset.id()), &H5Tclose);
  const Handle space(H5Dget_space(dataset.id()), &H5Sclose);
  if (!type || !space) return std::nullopt;
  odd = oddType(H5Tget_class(type.id()));
  if (!odd.empty()) return std::nullopt;
  const int rank = H5Sget_simple_extent_ndims(space.id());
  if (rank > 2) odd = heft::say("{} dimensions", rank);
  if (rank != 1 && rank != 2) return std::nullopt;
  hsize_t sizes[2] = {0, 1};
  if (H5Sget_simple_extent_dims(space.id(), sizes, nullptr) != rank) return std::nullopt;
  Dataset out;
  out.path = path;
  const auto slash = path.rfind('/');
  out.group = slash == std::string::npos ? "" : path.substr(0, slash);
  out.name = slash == std::string::npos ? path : path.substr(slash + 1);
  out.rank = rank;
  out.rows = sizes[0];
  if (rank == 2) {
    out.rowsLast = sizes[0] < sizes[1] && sizes[0] <= kMostChannels;
    out.channels = out.rowsLast ? sizes[0] : sizes[1];
    out.rows = out.rowsLast ? sizes[1] : sizes[0];
  }
  if (static_cast<double>(out.rows) * static_cast<double>(out.channels) * static_cast<double>(H5Tget_size(type.id())) >
      mostBytes)
    return std::nullopt;
  if (out.rows < 2 || out.rows > kMaxStreamNumbers || out.channels == 0 || out.channels > kMostChannels)
    return std::nullopt;
  return out;
}

/// One channel of a dataset, or nothing if it is damaged.
std::vector<double> readChannel(hid_t file, const Dataset& what, hsize_t channel) {
  const Handle dataset(H5Dopen2(file, what.path.c_str(), H5P_DEFAULT), &H5Dclose);
  if (!dataset) return {};
  const Handle space(H5Dget_space(dataset.id()), &H5Sclose);
  const Handle memory(H5Screate_simple(1, &what.rows, nullptr), &H5Sclose);
  if (!space || !memory) return {};
  if (what.rank == 2) {
    const hsize_t start[2] = {what.rowsLast ? channel : 0, what.rowsLast ? 0 : channel};
    const hsize_t count[2] = {what.rowsLast ? 1 : what.rows, what.rowsLast ? what.rows : 1};
    if (H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, count, nullptr) < 0) return {};
  }
  std::vector<double> out(static_cast<std::size_t>(what.rows));
  if (H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, memory.id(), space.id(), H5P_DEFAULT, out.data()) < 0) return {};
  return out;
}

/// The dataset of times for those of `group` with `rows`: in the group itself or the nearest one around it.
const Dataset* findTimes(const std::vector<Dataset>& all, std::string group, hsize_t rows, const TimeChoice& choice,
                         double& unit, bool& unitKnown) {
  for (;;) {
    std::vector<std::string> names;
    std::vector<const Dataset*> candidates;
    for (const auto& each : all) {
      const bool chosen = !choice.column.empty() && (each.path == choice.column || "/" + each.path == choice.column);
      if (each.rows != rows || each.channels != 1 || (each.group != group && !chosen)) continue;
      names.push_back(chosen ? choice.column : each.name);
      candidates.push_back(&each);
    }
    if (const auto found = findTime(names, choice)) {
      unit = found->unit;
      unitKnown = found->unitKnown;
      return candidates[found->index];
    }
    if (group.empty()) return nullptr;
    const auto slash = group.rfind('/');
    group = slash == std::string::npos ? "" : group.substr(0, slash);
  }
}

}  // namespace

Result<StreamSet> readHdf5Streams(const std::filesystem::path& path, const FieldFilter& filter,
                                  const TimeChoice& choice, const Progress& progress) {
  static std::mutex mutex;  // the library is not made for several threads
  const std::lock_guard lock(mutex);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // failures are told in findings, not on stderr
  StreamSet set;
  set.file = displayName(path);
  set.kind = FileKind::hdf5;
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), &H5Fclose);
  if (!file)
    return errorAt(
        {set.file, 0, 0}, heft::say("this HDF5 file cannot be opened: it is cut off or damaged."),
        heft::say("Close the file in the recording program before copying it; \"h5clear -s FILE\" may mend it."));
  std::vector<std::string> paths;
  if (H5Ovisit(file.id(), H5_INDEX_NAME, H5_ITER_NATIVE, &collectPath, &paths) < 0)
    set.findings.push_back({Severity::warning,
                            "file_cut_off",
                            heft::say("The HDF5 file is damaged; the datasets that can be reached were read."),
                            {},
                            {set.file, 0, 0}});
  // No filter packs numbers to less than a thousandth: larger sizes are damage.
  std::error_code code;
  const double mostBytes = 1e3 * static_cast<double>(std::filesystem::file_size(path, code)) + 1e6;
  std::vector<Dataset> all;
  std::vector<std::string> odd;
  for (const auto& each : paths) {
    std::string what;
    if (auto dataset = describe(file.id(), each, mostBytes, what))
      all.push_back(std::move(*dataset));
    else if (!what.empty())
      odd.push_back(fmt::format("/{} ({})", printable(each, 100), what));
  }
  if (!odd.empty()) {
    const auto count = odd.size();
    if (count > 5) {
      odd.resize(5);
      odd.push_back(heft::say("{} more", count - 5));
    }
    const auto names = fmt::format("{}", fmt::join(odd, ", "));
    const std::string rewrite = heft::say("Write each quantity as a dataset of numbers with one row a sample.");
    if (all.empty())
      return errorAt({set.file, 0, 0}, heft::say("no dataset of this HDF5 file is a table of numbers: {}.", names),
                     rewrite);
    set.findings.push_back({Severity::info,
                            "dataset_odd",
                            heft::say("Left out, as they are no tables of numbers: {}.", names),
                            rewrite,
                            {set.file, 0, 0}});
  }

  for (const auto& each : all)
    if (each.channels == 1) set.timeCandidates.push_back("/" + each.path);
  std::map<std::pair<std::string, hsize_t>, std::vector<const Dataset*>> groups;
  for (const auto& each : all) groups[{each.group, each.rows}].push_back(&each);
  std::size_t numbers = 0;
  std::set<std::string> damaged;
  for (const auto& [key, members] : groups) {
    if (progress.cancelled()) return Error{heft::say("Reading was stopped."), true};
    double unit = 1.0;
    bool unitKnown = false;
    const Dataset* const times = findTimes(all, key.first, key.second, choice, unit, unitKnown);
    if (times == nullptr) {
      set.findings.push_back({Severity::info,
                              "no_time",
                              heft::say("The datasets of {} rows in /{} have no dataset of times beside them and "
                                        "were left out.",
                                        key.second, printable(key.first)),
                              remedy(Remedy::chooseTime),
                              {set.file, 0, 0}});
      continue;
    }
    Stream stream;
    stream.name = "/" + printable(key.first, 200);
    stream.file = set.file;
    stream.samples = static_cast<std::size_t>(key.second);
    for (const auto* each : members) {
      if (each == times) continue;
      for (hsize_t c = 0; c < each->channels; ++c)
        stream.fields.push_back(each->rank == 1 ? printable(each->name, 100)
                                                : fmt::format("{}[{}]", printable(each->name, 100), c));
    }
    if (stream.fields.empty()) continue;
    numbers += stream.samples;
    if (numbers > kMaxStreamNumbers) break;
    const auto clock = readChannel(file.id(), *times, 0);
    if (clock.empty()) {
      damaged.insert(times->path);
      continue;
    }
    if (!unitKnown) unit = unitOfTimes(clock);
    stream.received.reserve(clock.size());
    for (const double t : clock) stream.received.push_back(nanoseconds(t * unit));
    const auto [low, high] = std::minmax_element(stream.received.begin(), stream.received.end());
    stream.first = *low;
    stream.last = *high;
    stream.stamps.assign(stream.received.size(), 0);
    stream.values.resize(stream.fields.size());
    std::size_t field = 0;
    for (const auto* each : members) {
      if (each == times) continue;
      for (hsize_t c = 0; c < each->channels; ++c, ++field) {
        if (!filter || !filter(stream, field)) continue;
        numbers += stream.samples;
        if (numbers > kMaxStreamNumbers) break;
        stream.values[field] = readChannel(file.id(), *each, c);
        if (stream.values[field].empty()) damaged.insert(each->path);
      }
    }
    set.streams.push_back(std::move(stream));
  }
  if (numbers > kMaxStreamNumbers)
    set.findings.push_back({Severity::warning,
                            "file_too_large",
                            heft::say("The selected datasets hold more than {} million numbers; the rest was not "
                                      "read.",
                                      kMaxStreamNumbers / 1'000'000),
                            {},
                            {set.file, 0, 0}});
  for (const auto& each : damaged)
    set.findings.push_back({Severity::warning,
                            "dataset_damaged",
                            heft::say("The dataset /{} is damaged or cut off.", printable(each)),
                            {},
                            {set.file, 0, 0}});
  return set;
}

}  // namespace heft
