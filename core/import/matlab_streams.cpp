// MATLAB's files of versions 4 to 7, by libmatio: variables, fields of structures, and timeseries-like structures with
// Time and Data. Version 7.3 is HDF5 and read as that.
#include <fmt/format.h>
#include <matio.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>

#include "core/base/library_on_demand.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/array_streams.h"
#include "core/import/bytes.h"
#include "core/import/matlab_heads.h"

namespace heft {

namespace {

// matio's functions, which hide the declarations of its header (core/base/library_on_demand.h).
const LibraryOnDemand matioLibrary{HEFT_MATIO_LIBRARY, HEFT_MATIO_PACKAGE};
#define HEFT_OF_MATIO(name) const FunctionOnDemand<decltype(::name)> name(matioLibrary, #name)
HEFT_OF_MATIO(Mat_Close);
HEFT_OF_MATIO(Mat_LogInitFunc);
HEFT_OF_MATIO(Mat_Open);
HEFT_OF_MATIO(Mat_VarFree);
HEFT_OF_MATIO(Mat_VarGetNumberOfFields);
HEFT_OF_MATIO(Mat_VarGetStructFieldnames);
HEFT_OF_MATIO(Mat_VarReadDataAll);
HEFT_OF_MATIO(Mat_VarReadNextInfo);
#undef HEFT_OF_MATIO

constexpr int kDeepestStruct = 8;
constexpr std::size_t kMostVariables = 4096;
constexpr std::size_t kMostTextBytes = 1u << 16;

using MatFile = std::unique_ptr<mat_t, int (*)(mat_t*)>;
using MatVariable = std::unique_ptr<matvar_t, void (*)(matvar_t*)>;

struct MatArray {
  NumberArray array;
  const matvar_t* variable = nullptr;  ///< Belongs to one of the variables that are held open.
  bool rowsLast = false;
  std::size_t stride = 0;  ///< Numbers in a column of the matrix.
};

/// One number of a matrix of any class.
double matNumber(const matvar_t& variable, std::size_t at) {
  switch (variable.data_type) {
    case MAT_T_DOUBLE:
      return static_cast<const double*>(variable.data)[at];
    case MAT_T_SINGLE:
      return static_cast<double>(static_cast<const float*>(variable.data)[at]);
    case MAT_T_INT8:
      return static_cast<const std::int8_t*>(variable.data)[at];
    case MAT_T_UINT8:
      return static_cast<const std::uint8_t*>(variable.data)[at];
    case MAT_T_INT16:
      return static_cast<const std::int16_t*>(variable.data)[at];
    case MAT_T_UINT16:
      return static_cast<const std::uint16_t*>(variable.data)[at];
    case MAT_T_INT32:
      return static_cast<const std::int32_t*>(variable.data)[at];
    case MAT_T_UINT32:
      return static_cast<const std::uint32_t*>(variable.data)[at];
    case MAT_T_INT64:
      return static_cast<double>(static_cast<const std::int64_t*>(variable.data)[at]);
    case MAT_T_UINT64:
      return static_cast<double>(static_cast<const std::uint64_t*>(variable.data)[at]);
    default:
      return 0.0;
  }
}

bool isMatNumber(const matvar_t& variable) {
  switch (variable.class_type) {
    case MAT_C_DOUBLE:
    case MAT_C_SINGLE:
    case MAT_C_INT8:
    case MAT_C_UINT8:
    case MAT_C_INT16:
    case MAT_C_UINT16:
    case MAT_C_INT32:
    case MAT_C_UINT32:
    case MAT_C_INT64:
    case MAT_C_UINT64:
      break;
    default:
      return false;
  }
  switch (variable.data_type) {
    case MAT_T_DOUBLE:
    case MAT_T_SINGLE:
    case MAT_T_INT8:
    case MAT_T_UINT8:
    case MAT_T_INT16:
    case MAT_T_UINT16:
    case MAT_T_INT32:
    case MAT_T_UINT32:
    case MAT_T_INT64:
    case MAT_T_UINT64:
      return variable.data != nullptr && variable.isComplex == 0 && variable.data_size > 0;
    default:
      return false;
  }
}

class MatWalk {
 public:
  void add(const matvar_t& variable, const std::string& path, int depth) {
    if (arrays_.size() >= kMostVariables || depth > kDeepestStruct) return;
    if (variable.class_type == MAT_C_STRUCT) return addStruct(variable, path, depth);
    if (!isMatNumber(variable)) {
      const char* what = variable.class_type == MAT_C_CELL     ? heft::toSay("a cell array")
                         : variable.class_type == MAT_C_OBJECT ? heft::toSay("an object")
                         : variable.class_type == MAT_C_SPARSE ? heft::toSay("a sparse matrix")
                         : variable.class_type == MAT_C_OPAQUE ? heft::toSay("a table or another object")
                                                               : nullptr;
      if (what != nullptr && odd_.size() < 5)
        odd_.push_back(fmt::format("{} ({})", printable(path, 100), heft::say(fmt::runtime(what))));
      return;
    }
    std::size_t count = 1;
    for (int d = 0; d < variable.rank; ++d) {
      if (variable.dims[d] == 0 || variable.dims[d] > kMaxStreamNumbers) return;
      count *= variable.dims[d];
      if (count > kMaxStreamNumbers) return;
    }
    if (variable.rank < 2 || variable.rank > 3) return;
    if (variable.nbytes / static_cast<std::size_t>(variable.data_size) < count) return;
    MatArray out;
    placeArray(out.array, path);
    out.variable = &variable;
    const std::size_t rows = variable.dims[0];
    // Three dimensions are matrices over time, the last one being time.
    const std::size_t columns = count / rows / (variable.rank == 3 ? variable.dims[2] : 1);
    if (variable.rank == 3) {
      out.rowsLast = true;
      out.stride = rows * columns;
      out.array.rows = variable.dims[2];
      out.array.channels = out.stride;
      out.array.vector = false;
    } else {
      out.rowsLast = rows < columns && rows <= kMostArrayChannels;
      out.stride = rows;
      out.array.rows = out.rowsLast ? columns : rows;
      out.array.channels = out.rowsLast ? rows : columns;
      out.array.vector = out.array.channels == 1;
    }
    if (out.array.rows < 2 || out.array.channels > kMostArrayChannels) return;
    arrays_.push_back(std::move(out));
  }

  const std::vector<MatArray>& arrays() const { return arrays_; }
  const std::vector<std::string>& odd() const { return odd_; }

 private:
  void addStruct(const matvar_t& variable, const std::string& path, int depth) {
    const unsigned fields = Mat_VarGetNumberOfFields(const_cast<matvar_t*>(&variable));
    char* const* const names = Mat_VarGetStructFieldnames(&variable);
    if (names == nullptr || variable.data == nullptr || variable.data_size == 0) return;
    std::size_t elements = 1;
    for (int d = 0; d < variable.rank; ++d) elements *= std::min<std::size_t>(variable.dims[d], 1000);
    const auto held = variable.nbytes / sizeof(matvar_t*);
    auto* const* const inner = static_cast<matvar_t* const*>(variable.data);
    for (std::size_t e = 0; e < std::min<std::size_t>(elements, 64); ++e) {
      for (unsigned f = 0; f < fields; ++f) {
        const std::size_t at = e * fields + f;
        if (at >= held || inner[at] == nullptr || names[f] == nullptr) continue;
        const std::string folder = elements == 1 ? path : fmt::format("{}({})", path, e + 1);
        add(*inner[at], folder + "/" + names[f], depth + 1);
      }
    }
  }

  std::vector<MatArray> arrays_;
  std::vector<std::string> odd_;
};

std::vector<double> readMatChannel(const MatArray& what, std::size_t channel) {
  std::vector<double> out;
  out.reserve(what.array.rows);
  for (std::size_t r = 0; r < what.array.rows; ++r)
    out.push_back(matNumber(*what.variable, what.rowsLast ? r * what.stride + channel : channel * what.stride + r));
  return out;
}

}  // namespace

Result<StreamSet> readMatlabStreams(const std::filesystem::path& path, const FieldFilter& filter,
                                    const TimeChoice& choice, const Progress& progress) {
  static std::mutex mutex;  // the library keeps its own log function
  const std::lock_guard lock(mutex);
  if (const std::string problem = matioLibrary.problem(); !problem.empty()) return Error{problem};
  Mat_LogInitFunc(nullptr, [](int, char*) {});  // failures are told in findings, not on stderr
  StreamSet set;
  set.file = displayName(path);
  set.kind = FileKind::matlab;
  const auto heads = ByteFile::open(path);
  if (!heads) return heads.error();
  const SoundVariables sound = soundVariables(*heads, progress);
  const MatFile file(sound.count > 0 ? Mat_Open(path.c_str(), MAT_ACC_RDONLY) : nullptr, Mat_Close);
  if (progress.cancelled()) return Error{heft::say("Reading was stopped."), true};
  if (!file)
    return errorAt({set.file, 0, 0}, heft::say("this MATLAB file cannot be opened: it is cut off or damaged."),
                   heft::say("Save it again, for instance with save('FILE', '-v7')."));
  // A variable says its size before its numbers; what the file cannot hold is damage.
  std::error_code code;
  const auto fileBytes = std::filesystem::file_size(path, code);
  if (code) return errorAt({set.file, 0, 0}, code.message());
  const double mostBytes = 1e3 * static_cast<double>(fileBytes) + 1e6;
  // Damage can send the library back to the same variable without end. None has fewer bytes than a header of version 4.
  constexpr std::size_t kLeastBytesOfVariable = 20;
  if (!sound.all)
    set.findings.push_back(
        {Severity::warning,
         "variable_damaged",
         heft::say("Variable {} of the file is damaged; it and those after it were not read.", sound.count + 1),
         heft::say("Save it again, for instance with save('FILE', '-v7')."),
         {set.file, 0, 0}});
  const auto mostVariables =
      std::min({kMostVariables, static_cast<std::size_t>(fileBytes / kLeastBytesOfVariable + 1), sound.count});
  std::vector<MatVariable> held;
  MatWalk walk;
  double bytes = 0.0;
  for (std::size_t seen = 0; seen < mostVariables; ++seen) {
    if (progress.cancelled()) return Error{heft::say("Reading was stopped."), true};
    MatVariable variable(Mat_VarReadNextInfo(file.get()), Mat_VarFree);
    if (!variable) break;
    double size = 8.0;
    for (int d = 0; d < variable->rank; ++d) size *= static_cast<double>(variable->dims[d]);
    bytes += size;
    if (variable->name == nullptr || bytes > mostBytes) break;
    const bool wanted = variable->class_type == MAT_C_STRUCT || size > 8.0;
    const std::string name(std::string_view(variable->name).substr(0, kMostTextBytes));
    if (!wanted) continue;
    if (Mat_VarReadDataAll(file.get(), variable.get()) != 0) continue;
    walk.add(*variable, name, 0);
    held.push_back(std::move(variable));
  }
  if (!walk.odd().empty())
    set.findings.push_back(
        {Severity::info,
         "dataset_odd",
         heft::say("Skipped, since they are not tables of numbers: {}.", fmt::join(walk.odd(), ", ")),
         heft::say("Save each quantity as a matrix of numbers with one row per sample."),
         {set.file, 0, 0}});
  std::vector<NumberArray> arrays;
  for (const auto& each : walk.arrays()) arrays.push_back(each.array);
  const auto added = addArrayStreams(
      arrays, [&](std::size_t index, std::size_t channel) { return readMatChannel(walk.arrays()[index], channel); },
      filter, choice, progress, set);
  if (!added) return added.error();
  return set;
}

}  // namespace heft
