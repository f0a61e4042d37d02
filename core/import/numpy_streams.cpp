// NumPy's .npy (numpy.lib.format: magic, length, a Python dictionary that describes the array, the numbers) and .npz, a
// ZIP archive of such files.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "core/base/json_file.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/array_streams.h"
#include "core/import/bytes.h"
#include "core/import/compression.h"
#include "core/import/zip_file.h"
#include "core/recording/csv_reader.h"

namespace heft {

namespace {

constexpr std::string_view kNpyMagic = "\x93NUMPY";

/// One kind of number, as in "<f8".
struct NpyType {
  bool bigEndian = false;
  char kind = 'f';  ///< f, i, u, b; M: a date as int64
  std::size_t size = 8;
  double scale = 1.0;  ///< [s] of a date's count
};

/// A field of a structured array, or the whole of a plain one.
struct NpyField {
  std::string name;
  NpyType type;
  std::size_t offset = 0;
  std::size_t count = 1;
};

struct NpyHeader {
  std::vector<NpyField> fields;
  std::vector<std::size_t> shape;
  std::size_t itemSize = 0;
  bool fortran = false;
  bool structured = false;
  std::size_t dataAt = 0;
};

/// Reads the few forms of Python literals that a header holds.
class Literal {
 public:
  explicit Literal(std::string_view text) : rest_(text) {}

  bool take(char c) {
    blanks();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  bool sees(char c) {
    blanks();
    return !rest_.empty() && rest_.front() == c;
  }
  std::optional<std::string> text() {
    blanks();
    if (!rest_.empty() && (rest_.front() == 'u' || rest_.front() == 'b')) rest_.remove_prefix(1);
    if (rest_.empty() || (rest_.front() != '\'' && rest_.front() != '"')) return std::nullopt;
    const auto stop = rest_.find(rest_.front(), 1);
    if (stop == std::string_view::npos) return std::nullopt;
    std::string out(rest_.substr(1, stop - 1));
    rest_.remove_prefix(stop + 1);
    return out;
  }
  std::optional<std::size_t> number() {
    blanks();
    std::size_t value = 0;
    const auto [end, failure] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (failure != std::errc()) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    take('L');  // Python 2
    return value;
  }
  bool word(std::string_view expected) {
    blanks();
    if (!rest_.starts_with(expected)) return false;
    rest_.remove_prefix(expected.size());
    return true;
  }
  /// "(3, 4)" or "(3,)" or "()".
  std::optional<std::vector<std::size_t>> tuple() {
    if (!take('(')) return std::nullopt;
    std::vector<std::size_t> out;
    while (!take(')')) {
      const auto value = number();
      if (!value || out.size() > 8) return std::nullopt;
      out.push_back(*value);
      take(',');
    }
    return out;
  }

 private:
  void blanks() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\n' || rest_.front() == '\t'))
      rest_.remove_prefix(1);
  }
  std::string_view rest_;
};

/// "<f8", "|b1", "<M8[ns]"; nothing for texts and objects, whose size is then still needed: `size`.
std::optional<NpyType> typeOf(std::string_view descr, std::size_t& size) {
  size = 0;
  if (descr.size() < 3) return std::nullopt;
  NpyType out;
  out.bigEndian = descr[0] == '>';
  out.kind = descr[1];
  const auto digits = descr.substr(2, descr.find('[') - 2);
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), out.size);
  if (failure != std::errc() || out.size > (1u << 20)) return std::nullopt;
  size = out.kind == 'U' ? 4 * out.size : out.size;
  const auto is = [&](std::initializer_list<std::size_t> sizes) {
    return std::find(sizes.begin(), sizes.end(), out.size) != sizes.end();
  };
  if (out.kind == 'M' && out.size == 8) {
    const auto unit = descr.find('[');
    const auto name = unit == std::string_view::npos ? std::string_view() : descr.substr(unit);
    out.scale = name == "[ns]" ? 1e-9 : name == "[us]" ? 1e-6 : name == "[ms]" ? 1e-3 : name == "[s]" ? 1.0 : 0.0;
    if (out.scale > 0.0) return out;
  }
  if (out.kind == 'f' && is({2, 4, 8})) return out;
  if ((out.kind == 'i' || out.kind == 'u') && is({1, 2, 4, 8})) return out;
  if (out.kind == 'b' && is({1})) return out;
  return std::nullopt;
}

/// `descr` of a structured array: [('t', '<f8'), ('q', '<f8', (7,))]. Fields that are no numbers are passed over.
bool readFields(Literal& literal, NpyHeader& out) {
  while (!literal.take(']')) {
    if (!literal.take('(')) return false;
    const auto name = literal.text();
    if (!name || !literal.take(',')) return false;
    const auto descr = literal.text();
    if (!descr) return false;  // nested structures
    std::size_t count = 1;
    if (literal.take(',') && literal.sees('(')) {
      const auto shape = literal.tuple();
      if (!shape) return false;
      for (const auto length : *shape) {
        if (length == 0 || length > 4096 || count > 4096) return false;
        count *= length;
      }
    }
    if (!literal.take(')')) return false;
    literal.take(',');
    std::size_t size = 0;
    const auto type = typeOf(*descr, size);
    if (size == 0) return false;
    if (type && !name->empty()) out.fields.push_back({*name, *type, out.itemSize, count});
    out.itemSize += size * count;
    if (out.fields.size() > 1024 || out.itemSize > (1u << 24)) return false;
  }
  return true;
}

/// Nothing for what is no array of numbers; `odd` then says what it is, where it is something.
std::optional<NpyHeader> readNpyHeader(std::string_view bytes, std::string& odd) {
  ByteReader reader(bytes);
  if (reader.take(6) != kNpyMagic) return std::nullopt;
  const auto version = reader.read<std::uint8_t>();
  reader.read<std::uint8_t>();
  const std::uint64_t length = version >= 2 ? reader.read<std::uint32_t>() : reader.read<std::uint16_t>();
  const auto text = reader.take(length);
  if (!reader.ok()) return std::nullopt;
  NpyHeader out;
  out.dataAt = reader.position();
  Literal literal(text);
  if (!literal.take('{')) return std::nullopt;
  while (!literal.take('}')) {
    const auto key = literal.text();
    if (!key || !literal.take(':')) return std::nullopt;
    if (*key == "descr" && literal.take('[')) {
      out.structured = true;
      if (!readFields(literal, out)) {
        odd = heft::say("a structure in a structure");
        return std::nullopt;
      }
    } else if (*key == "descr") {
      const auto descr = literal.text();
      if (!descr) return std::nullopt;
      const auto type = typeOf(*descr, out.itemSize);
      if (!type) {
        odd = descr->find('O') != std::string::npos ? heft::say("pickled Python objects") : heft::say("no numbers");
        return std::nullopt;
      }
      out.fields.push_back({"", *type, 0, 1});
    } else if (*key == "fortran_order") {
      out.fortran = literal.word("True");
      if (!out.fortran && !literal.word("False")) return std::nullopt;
    } else if (*key == "shape") {
      const auto shape = literal.tuple();
      if (!shape) return std::nullopt;
      out.shape = *shape;
    } else {
      return std::nullopt;
    }
    literal.take(',');
  }
  if (out.fields.empty() || out.itemSize == 0) return std::nullopt;
  return out;
}

double halfFloat(std::uint16_t bits) {
  const int exponent = (bits >> 10) & 31;
  const double mantissa = bits & 1023;
  const double sign = (bits & 0x8000) != 0 ? -1.0 : 1.0;
  if (exponent == 31) return mantissa != 0 ? std::numeric_limits<double>::quiet_NaN() : sign * HUGE_VAL;
  return sign * (exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024.0 + mantissa, exponent - 25));
}

double numberAt(std::string_view bytes, const NpyType& type) {
  ByteReader reader(bytes, type.bigEndian);
  switch (type.kind) {
    case 'f':
      if (type.size == 2) return halfFloat(reader.read<std::uint16_t>());
      return type.size == 4 ? static_cast<double>(reader.read<float>()) : reader.read<double>();
    case 'M': {
      const auto count = reader.read<std::int64_t>();
      if (count == std::numeric_limits<std::int64_t>::min()) return std::numeric_limits<double>::quiet_NaN();  // NaT
      return type.scale * static_cast<double>(count);
    }
    case 'i':
      if (type.size == 1) return reader.read<std::int8_t>();
      if (type.size == 2) return reader.read<std::int16_t>();
      if (type.size == 4) return reader.read<std::int32_t>();
      return static_cast<double>(reader.read<std::int64_t>());
    default:
      if (type.size == 1) return reader.read<std::uint8_t>();
      if (type.size == 2) return reader.read<std::uint16_t>();
      if (type.size == 4) return reader.read<std::uint32_t>();
      return static_cast<double>(reader.read<std::uint64_t>());
  }
}

/// An array in memory with what a channel of it is.
struct NpyArray {
  std::string bytes;
  NpyHeader header;
  std::vector<std::pair<std::size_t, std::size_t>> channels;  ///< Structured: field and element.
  bool cut = false;                                           ///< Rows are missing at its end.
};

/// The array as channels; nothing if it is none, `odd` then says why, where there is something to say.
std::optional<NumberArray> describeNpy(NpyArray& npy, const std::string& path, bool alone, std::string& odd) {
  auto header = readNpyHeader(npy.bytes, odd);
  if (!header) return std::nullopt;
  npy.header = std::move(*header);
  const auto& shape = npy.header.shape;
  if (shape.empty()) return std::nullopt;  // a single number
  if (shape.size() > 3) {
    odd = heft::say("{} dimensions", shape.size());
    return std::nullopt;
  }
  NumberArray out;
  placeArray(out, path);
  out.rows = shape[0];
  out.vector = shape.size() == 1;
  out.channels = 1;
  for (std::size_t d = 1; d < shape.size(); ++d) {
    if (shape[d] == 0 || shape[d] > kMostArrayChannels) return std::nullopt;
    out.channels *= shape[d];
  }
  if (npy.header.structured) {
    if (!out.vector) return std::nullopt;
    for (std::size_t f = 0; f < npy.header.fields.size(); ++f) {
      const auto& field = npy.header.fields[f];
      for (std::size_t e = 0; e < field.count && npy.channels.size() <= kMostArrayChannels; ++e) {
        npy.channels.emplace_back(f, e);
        out.columns.push_back(field.count == 1 ? field.name : fmt::format("{}[{}]", field.name, e));
      }
    }
    out.channels = npy.channels.size();
  } else if (alone && shape.size() == 2) {
    for (std::size_t c = 1; c <= out.channels; ++c) out.columns.push_back(fmt::format("column{}", c));
  }
  if (out.rows < 2 || out.channels == 0 || out.channels > kMostArrayChannels) return std::nullopt;
  const std::size_t perRow = npy.header.structured ? 1 : out.channels;
  const std::size_t there = (npy.bytes.size() - npy.header.dataAt) / npy.header.itemSize / perRow;
  if (there < out.rows && npy.header.fortran && out.channels > 1) return std::nullopt;
  npy.cut = there < out.rows;
  out.rows = std::min(out.rows, there);
  if (out.rows < 2) return std::nullopt;
  return out;
}

std::vector<double> readNpyChannel(const NpyArray& npy, const NumberArray& array, std::size_t channel) {
  const auto& header = npy.header;
  const auto& field = header.fields[header.structured ? npy.channels[channel].first : 0];
  const std::size_t element = header.structured ? npy.channels[channel].second : 0;
  const std::string_view data = std::string_view(npy.bytes).substr(header.dataAt);
  // In Fortran's order the first index runs fastest, and so do those that channels count.
  std::size_t fortranChannel = channel;
  if (header.shape.size() == 3)
    fortranChannel = channel / header.shape[2] + header.shape[1] * (channel % header.shape[2]);
  std::vector<double> out;
  out.reserve(array.rows);
  for (std::size_t r = 0; r < array.rows; ++r) {
    std::size_t item = r;
    if (!header.structured) item = header.fortran ? fortranChannel * header.shape[0] + r : r * array.channels + channel;
    out.push_back(numberAt(
        data.substr(item * header.itemSize + field.offset + element * field.type.size, field.type.size), field.type));
  }
  return out;
}

}  // namespace

Result<StreamSet> readNumpyStreams(const std::filesystem::path& path, const FieldFilter& filter,
                                   const TimeChoice& choice, const Progress& progress) {
  StreamSet set;
  set.file = displayName(path);
  set.kind = FileKind::numpy;
  auto bytes = readTextFile(path, kMaxRecordingBytes);
  if (!bytes) return bytes.error();
  std::vector<NpyArray> arrays;
  std::vector<NumberArray> described;
  std::vector<std::string> odd;
  const auto note = [&](const char* code, std::string text) {
    set.findings.push_back({Severity::warning, code, std::move(text), {}, {set.file, 0, 0}});
  };
  const auto add = [&](std::string content, const std::string& name, bool alone, bool toItsEnd = true) {
    NpyArray npy{std::move(content), {}, {}, false};
    std::string why;
    auto array = describeNpy(npy, name, alone, why);
    if (!array && !why.empty() && odd.size() < 5) odd.push_back(fmt::format("{} ({})", printable(name, 100), why));
    if (!array) return;
    if (npy.cut && toItsEnd)
      note("dataset_damaged", heft::say("The dataset /{} is damaged or cut off.", printable(array->path)));
    arrays.push_back(std::move(npy));
    described.push_back(std::move(*array));
  };
  if (std::string_view(*bytes).starts_with(kNpyMagic)) {
    add(std::move(*bytes), path.stem().string(), true);
  } else {
    UnpackBudget budget(bytes->size());
    for (const auto& member : zipMembers(*bytes)) {
      if (!member.name.ends_with(".npy")) continue;
      auto content = readZipMember(*bytes, member, budget.most(std::numeric_limits<std::size_t>::max()), progress);
      if (progress.cancelled()) return Error{heft::say("Reading was stopped."), true};
      const bool all = budget.spend(content.bytes.size());
      if (!all) note("file_too_large", budgetText(bytes->size()));
      add(std::move(content.bytes), member.name.substr(0, member.name.size() - 4), false, all);
      if (!all) break;
    }
  }
  if (!odd.empty())
    set.findings.push_back({Severity::info,
                            "dataset_odd",
                            heft::say("Skipped, since they are not tables of numbers: {}.", fmt::join(odd, ", ")),
                            heft::say("Save each quantity as an array of numbers with one row per sample."),
                            {set.file, 0, 0}});
  const auto added = addArrayStreams(
      described,
      [&](std::size_t index, std::size_t channel) { return readNpyChannel(arrays[index], described[index], channel); },
      filter, choice, progress, set);
  if (!added) return added.error();
  return set;
}

}  // namespace heft
