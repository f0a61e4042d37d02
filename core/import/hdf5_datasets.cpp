#include "core/import/hdf5_datasets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "core/base/say.h"
#include "core/import/streams.h"

namespace heft::hdf5 {

namespace {

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

bool isNumber(H5T_class_t kind) { return kind == H5T_INTEGER || kind == H5T_FLOAT; }

/// The members of a compound type that are numbers, or short arrays of them, as channels.
void describeMembers(hid_t type, Dataset& out) {
  const int count = H5Tget_nmembers(type);
  for (int m = 0; m < count && out.members.size() <= kMostArrayChannels; ++m) {
    const std::unique_ptr<char, herr_t (*)(void*)> name(H5Tget_member_name(type, static_cast<unsigned>(m)),
                                                        H5free_memory);
    const Handle member(H5Tget_member_type(type, static_cast<unsigned>(m)), H5Tclose);
    if (!name || !member) continue;
    const auto kind = H5Tget_class(member.id());
    if (isNumber(kind)) {
      out.members.emplace_back(name.get());
      out.elements.push_back(0);
      out.array.columns.emplace_back(name.get());
    } else if (kind == H5T_ARRAY) {
      const Handle base(H5Tget_super(member.id()), H5Tclose);
      hsize_t size = 0;
      if (!base || !isNumber(H5Tget_class(base.id())) || H5Tget_array_ndims(member.id()) != 1 ||
          H5Tget_array_dims2(member.id(), &size) != 1)
        continue;
      for (hsize_t e = 0; e < size && out.members.size() <= kMostArrayChannels; ++e) {
        out.members.emplace_back(name.get());
        out.elements.push_back(e);
        out.array.columns.push_back(fmt::format("{}[{}]", name.get(), e));
      }
    }
  }
}

/// Texts of fixed length, or of any, of a dataset with one dimension.
std::vector<std::string> readTexts(hid_t file, const std::string& path) {
  const Handle dataset(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset) return {};
  const Handle type(H5Dget_type(dataset.id()), H5Tclose);
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  hsize_t count = 0;
  if (!type || !space || H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) > 0 ||
      H5Sget_simple_extent_ndims(space.id()) != 1 || H5Sget_simple_extent_dims(space.id(), &count, nullptr) != 1)
    return {};
  const auto size = H5Tget_size(type.id());
  if (size == 0 || size > 1024 || count > kMostArrayChannels) return {};
  std::string bytes(size * count, '\0');
  if (H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) < 0) return {};
  std::vector<std::string> out;
  for (hsize_t i = 0; i < count; ++i) {
    const auto text = std::string_view(bytes).substr(i * size, size);
    out.emplace_back(text.substr(0, text.find('\0')));
  }
  return out;
}

/// The lines "V..." of a list of texts as Python 2 and PyTables pickle it (protocol 0), from an attribute.
std::vector<std::string> pickledTexts(hid_t dataset, const std::string& name) {
  if (H5Aexists(dataset, name.c_str()) <= 0) return {};
  const Handle attribute(H5Aopen(dataset, name.c_str(), H5P_DEFAULT), H5Aclose);
  if (!attribute) return {};
  const Handle type(H5Aget_type(attribute.id()), H5Tclose);
  if (!type || H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) > 0) return {};
  const auto size = H5Tget_size(type.id());
  if (size == 0 || size > (1u << 20)) return {};
  std::string bytes(size, '\0');
  if (H5Aread(attribute.id(), type.id(), bytes.data()) < 0) return {};
  std::vector<std::string> out;
  for (std::size_t at = 0; at < bytes.size();) {
    const auto stop = std::min(bytes.find('\n', at), bytes.size());
    auto line = std::string_view(bytes).substr(at, stop - at);
    // A line may begin with marks of the list before the text's own.
    const auto mark = line.find_first_not_of("(lpa");
    if (mark != std::string_view::npos && line[mark] == 'V') out.emplace_back(line.substr(mark + 1));
    at = stop + 1;
  }
  return out;
}

/// Names of columns that pandas keeps beside its blocks of numbers.
void nameBlocks(hid_t file, Dataset& dataset) {
  auto& array = dataset.array;
  if (array.name.starts_with("block") && array.name.ends_with("_values")) {
    auto names = readTexts(file, array.path.substr(0, array.path.size() - 6) + "items");
    if (names.size() == array.channels) array.columns = std::move(names);
    return;
  }
  if (dataset.members.empty() || array.name != "table") return;
  const Handle opened(H5Dopen2(file, array.path.c_str(), H5P_DEFAULT), H5Dclose);
  if (!opened) return;
  for (std::size_t c = 0; c < array.columns.size(); ++c) {
    if (!dataset.members[c].starts_with("values_block_")) continue;
    const auto names = pickledTexts(opened.id(), dataset.members[c] + "_kind");
    if (dataset.elements[c] < names.size()) array.columns[c] = names[dataset.elements[c]];
  }
}

/// Filters that HDF5 itself does not have: what they are called, and the Debian 12 package whose file list holds their
/// plug-in (hdf5-filter-plugin has bzip2 and LZ4 only). Without one there is pip's hdf5plugin, which has them all.
std::string missingFilter(hid_t dataset) {
  struct Known {
    H5Z_filter_t id;
    const char* name;
    const char* package;
  };
  static constexpr std::array<Known, 9> kKnown = {{{307, "bzip2", "hdf5-filter-plugin"},
                                                   {32000, "LZF", "hdf5-plugin-lzf"},
                                                   {32001, "Blosc", "hdf5-filter-plugin-blosc-serial"},
                                                   {32004, "LZ4", "hdf5-filter-plugin"},
                                                   {32008, "bitshuffle", ""},
                                                   {32013, "ZFP", "hdf5-filter-plugin-zfp-serial"},
                                                   {32015, "Zstandard", ""},
                                                   {32026, "Blosc 2", ""},
                                                   {4, "SZIP", "libsz2"}}};
  const Handle plan(H5Dget_create_plist(dataset), H5Pclose);
  if (!plan) return {};
  const int count = H5Pget_nfilters(plan.id());
  for (int f = 0; f < count; ++f) {
    unsigned flags = 0;
    std::size_t values = 0;
    const auto id = H5Pget_filter2(plan.id(), static_cast<unsigned>(f), &flags, &values, nullptr, 0, nullptr, nullptr);
    if (id < 0 || H5Zfilter_avail(id) > 0) continue;
    const auto known = std::find_if(kKnown.begin(), kKnown.end(), [&](const Known& each) { return each.id == id; });
    if (known == kKnown.end()) return heft::say("filter {} of HDF5, which this machine does not have", id);
    if (*known->package == '\0')
      return heft::say("{}, which this machine cannot unpack (pip: hdf5plugin, with HDF5_PLUGIN_PATH at its plugins)",
                       known->name);
    return heft::say("{}, which this machine cannot unpack (Debian: {})", known->name, known->package);
  }
  return {};
}

}  // namespace

std::optional<Dataset> describe(hid_t file, const std::string& path, double mostBytes, std::string& odd) {
  const Handle dataset(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset) return std::nullopt;
  const Handle type(H5Dget_type(dataset.id()), H5Tclose);
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  if (!type || !space) return std::nullopt;
  Dataset out;
  const auto kind = H5Tget_class(type.id());
  if (kind == H5T_COMPOUND) describeMembers(type.id(), out);
  if (out.members.empty()) odd = oddType(kind);
  if (!odd.empty()) return std::nullopt;
  const int rank = H5Sget_simple_extent_ndims(space.id());
  if (rank > 3 || (rank > 1 && !out.members.empty())) odd = heft::say("{} dimensions", rank);
  if (rank < 1 || rank > 3 || !odd.empty()) return std::nullopt;
  if (H5Sget_simple_extent_dims(space.id(), out.sizes, nullptr) != rank) return std::nullopt;
  placeArray(out.array, path);
  out.rank = rank;
  out.array.vector = rank == 1;
  out.array.rows = out.sizes[0];
  out.array.channels = std::max<std::size_t>(out.members.size(), 1);
  if (rank == 2) {
    out.rowsLast = out.sizes[0] < out.sizes[1] && out.sizes[0] <= kMostArrayChannels;
    out.array.channels = out.rowsLast ? out.sizes[0] : out.sizes[1];
    out.array.rows = out.rowsLast ? out.sizes[1] : out.sizes[0];
  } else if (rank == 3) {
    if (out.sizes[1] > kMostArrayChannels || out.sizes[2] > kMostArrayChannels) return std::nullopt;
    out.array.channels = out.sizes[1] * out.sizes[2];
  }
  const auto rows = out.array.rows;
  if (static_cast<double>(rows) * static_cast<double>(out.array.channels) *
          static_cast<double>(H5Tget_size(type.id())) >
      mostBytes * static_cast<double>(out.members.empty() ? 1 : out.array.channels))
    return std::nullopt;
  if (rows < 2 || rows > kMaxStreamNumbers || out.array.channels == 0 || out.array.channels > kMostArrayChannels)
    return std::nullopt;
  nameBlocks(file, out);
  return out;
}

std::vector<double> readChannel(hid_t file, const Dataset& what, hsize_t channel, std::string& filter) {
  const Handle dataset(H5Dopen2(file, what.array.path.c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset) return {};
  const hsize_t rows = what.array.rows;
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const Handle memory(H5Screate_simple(1, &rows, nullptr), H5Sclose);
  if (!space || !memory) return {};
  if (what.rank > 1) {
    hsize_t start[3] = {0, 0, 0};
    hsize_t count[3] = {rows, 1, 1};
    if (what.rowsLast) {
      start[0] = channel;
      count[0] = 1;
      count[1] = rows;
    } else if (what.rank == 2) {
      start[1] = channel;
    } else {
      start[1] = channel / what.sizes[2];
      start[2] = channel % what.sizes[2];
    }
    if (H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start, nullptr, count, nullptr) < 0) return {};
  }
  std::vector<double> out(static_cast<std::size_t>(rows));
  herr_t done = -1;
  if (what.members.empty()) {
    done = H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, memory.id(), space.id(), H5P_DEFAULT, out.data());
  } else {
    // A member by itself, converted by the library; of an array member, all elements at once.
    const auto& name = what.members[channel];
    const auto wide = static_cast<hsize_t>(std::count(what.members.begin(), what.members.end(), name));
    const bool array = wide > 1 || what.array.columns[channel] == fmt::format("{}[0]", name);
    const Handle element(array ? H5Tarray_create2(H5T_NATIVE_DOUBLE, 1, &wide) : H5Tcopy(H5T_NATIVE_DOUBLE), H5Tclose);
    const Handle type(H5Tcreate(H5T_COMPOUND, wide * sizeof(double)), H5Tclose);
    if (!element || !type || H5Tinsert(type.id(), name.c_str(), 0, element.id()) < 0) return {};
    std::vector<double> all(out.size() * wide);
    done = H5Dread(dataset.id(), type.id(), memory.id(), space.id(), H5P_DEFAULT, all.data());
    for (std::size_t r = 0; r < out.size(); ++r) out[r] = all[r * wide + what.elements[channel]];
  }
  if (done < 0) {
    if (filter.empty()) filter = missingFilter(dataset.id());
    return {};
  }
  return out;
}

}  // namespace heft::hdf5
