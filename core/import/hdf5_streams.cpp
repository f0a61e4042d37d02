// HDF5: every dataset of numbers with one or two dimensions is a group of channels; those of equal length in one group
// of the file share its dataset of times.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/hdf5_datasets.h"
#include "core/import/own_process.h"
#include "core/import/streams.h"

namespace heft {

using namespace hdf5;

namespace {

constexpr std::size_t kMostDatasets = 4096;

/// Paths of all datasets, through hard, soft and external links. A group is not entered inside itself, and one that
/// soft or external links lead to not again; the same holds for tables (compound types). What pandas keeps to search
/// its tables is left out.
class LinkWalk {
 public:
  explicit LinkWalk(hid_t file) {
    H5O_info_t root;
    if (H5Oget_info_by_name(file, "/", &root, H5P_DEFAULT) >= 0) seen_.insert({root.fileno, root.addr});
    group(file, "", 0);
    for (std::size_t i = 0; i < later_.size(); ++i) {
      const auto link = later_[i];
      enter(file, link.path.c_str(), link.path, link.depth, true);
    }
  }
  const std::vector<std::string>& paths() const { return paths_; }
  const std::vector<std::string>& broken() const { return broken_; }
  bool damaged() const { return damaged_; }

 private:
  static constexpr int kDeepestGroup = 16;
  static constexpr std::size_t kMostLinks = 16384;

  struct Level {
    LinkWalk* walk;
    std::string path;
    int depth;
  };

  struct Later {
    std::string path;
    int depth;
  };

  static herr_t visit(hid_t parent, const char* name, const H5L_info_t* link, void* data) {
    auto& level = *static_cast<Level*>(data);
    level.walk->link(parent, name, *link, level.path, level.depth);
    return level.walk->paths_.size() < kMostDatasets && level.walk->links_ < kMostLinks ? 0 : 1;
  }

  void link(hid_t parent, const char* name, const H5L_info_t& info, const std::string& folder, int depth) {
    ++links_;
    const std::string path = folder.empty() ? name : folder + "/" + name;
    if (std::string_view(name).starts_with("_i_")) return;  // PyTables' indices
    if (info.type == H5L_TYPE_HARD)
      enter(parent, name, path, depth, false);
    else
      later_.push_back({path, depth});
  }

  void enter(hid_t parent, const char* name, const std::string& path, int depth, bool soft) {
    if (paths_.size() >= kMostDatasets) return;
    H5O_info_t object;
    if (H5Oget_info_by_name(parent, name, &object, H5P_DEFAULT) < 0) {
      if (!soft)
        damaged_ = true;
      else if (broken_.size() < 20)
        broken_.push_back(path);
      return;
    }
    const std::pair key(object.fileno, object.addr);
    const bool seen = !seen_.insert(key).second;
    if (object.type == H5O_TYPE_DATASET && !(soft && seen && isTable(parent, name))) paths_.push_back(path);
    if (object.type != H5O_TYPE_GROUP || depth >= kDeepestGroup || (soft && seen)) return;
    if (std::find(inside_.begin(), inside_.end(), key) != inside_.end()) return;
    const Handle inner(H5Gopen2(parent, name, H5P_DEFAULT), H5Gclose);
    if (!inner) {
      damaged_ = true;
      return;
    }
    inside_.push_back(key);
    group(inner.id(), path, depth + 1);
    inside_.pop_back();
  }

  static bool isTable(hid_t parent, const char* name) {
    const Handle dataset(H5Dopen2(parent, name, H5P_DEFAULT), H5Dclose);
    if (!dataset) return false;
    const Handle type(H5Dget_type(dataset.id()), H5Tclose);
    return type && H5Tget_class(type.id()) == H5T_COMPOUND;
  }

  void group(hid_t id, const std::string& path, int depth) {
    Level level{this, path, depth};
    hsize_t at = 0;
    if (H5Literate(id, H5_INDEX_NAME, H5_ITER_NATIVE, &at, &visit, &level) < 0) damaged_ = true;
  }

  std::vector<std::string> paths_, broken_;
  std::vector<std::pair<unsigned long, haddr_t>> inside_;
  std::set<std::pair<unsigned long, haddr_t>> seen_;
  std::vector<Later> later_;
  std::size_t links_ = 0;
  bool damaged_ = false;
};

}  // namespace

Result<StreamSet> readHdf5Streams(const std::filesystem::path& path, const FieldFilter& filter,
                                  const TimeChoice& choice, const Progress& progress) {
  // Loaded here once: each copy would load it again.
  if (const std::string problem = hdf5Library.problem(); !problem.empty()) return Error{problem};
  return readInOwnProcess(
      path, [&](const Progress& own) { return readHdf5StreamsHere(path, filter, choice, own); }, progress);
}

Result<StreamSet> readHdf5StreamsHere(const std::filesystem::path& path, const FieldFilter& filter,
                                      const TimeChoice& choice, const Progress& progress) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // failures are told in findings, not on stderr
  StreamSet set;
  set.file = displayName(path);
  set.kind = FileKind::hdf5;
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!file)
    return errorAt(
        {set.file, 0, 0}, heft::say("this HDF5 file cannot be opened: it is cut off or damaged."),
        heft::say("Close the file in the recording program before copying it; \"h5clear -s FILE\" may repair it."));
  const LinkWalk walk(file.id());
  if (walk.damaged())
    set.findings.push_back({Severity::warning,
                            "file_cut_off",
                            heft::say("The HDF5 file is damaged; only the datasets that could be reached were read."),
                            {},
                            {set.file, 0, 0}});
  for (const auto& each : walk.broken())
    set.findings.push_back({Severity::warning,
                            "link_broken",
                            heft::say("The link /{} is broken.", printable(each, 100)),
                            heft::say("Copy the file that it refers to beside this one."),
                            {set.file, 0, 0}});
  // No filter packs numbers to less than a thousandth: larger sizes are damage.
  std::error_code code;
  const double mostBytes = 1e3 * static_cast<double>(std::filesystem::file_size(path, code)) + 1e6;
  std::vector<Dataset> all;
  std::vector<std::string> odd;
  for (const auto& each : walk.paths()) {
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
    const std::string rewrite = heft::say("Write each quantity as a dataset of numbers with one row per sample.");
    if (all.empty())
      return errorAt({set.file, 0, 0}, heft::say("no dataset of this HDF5 file is a table of numbers: {}.", names),
                     rewrite);
    set.findings.push_back({Severity::info,
                            "dataset_odd",
                            heft::say("Skipped, since they are not tables of numbers: {}.", names),
                            rewrite,
                            {set.file, 0, 0}});
  }

  std::vector<NumberArray> arrays;
  for (const auto& each : all) arrays.push_back(each.array);
  std::string filterMissing;
  const auto added = addArrayStreams(
      arrays,
      [&](std::size_t index, std::size_t channel) {
        return readChannel(file.id(), all[index], channel, filterMissing);
      },
      filter, choice, progress, set);
  if (!added) return added.error();
  if (!filterMissing.empty()) {
    // What cannot be unpacked is not damaged.
    std::erase_if(set.findings, [](const Finding& finding) { return finding.code == "dataset_damaged"; });
    set.findings.push_back({Severity::error,
                            "filter_missing",
                            heft::say("datasets of the file are packed with {}.", filterMissing),
                            heft::say("Install that package, or rewrite the file with \"h5repack -f GZIP=4 IN OUT\" "
                                      "where the filter is at hand."),
                            {set.file, 0, 0}});
  }
  return set;
}

}  // namespace heft
