#include "core/import/matlab_heads.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace heft {

namespace {

/// The bytes of one variable, front to back, as they are or unpacked.
class VariableBytes {
 public:
  VariableBytes(const ByteFile& file, std::uint64_t at, std::uint64_t count, bool packed)
      : file_(file), at_(at), end_(at + count), packed_(packed) {
    if (packed_ && inflateInit(&stream_) != Z_OK) failed_ = true;
  }
  ~VariableBytes() {
    if (packed_) inflateEnd(&stream_);
  }
  VariableBytes(const VariableBytes&) = delete;
  VariableBytes& operator=(const VariableBytes&) = delete;

  /// The next bytes, exactly so many; empty where there are fewer.
  std::string take(std::uint64_t count) {
    std::string out;
    while (out.size() < count && fill()) {
      const auto some = static_cast<std::size_t>(std::min<std::uint64_t>(count - out.size(), ready_.size() - used_));
      out.append(ready_, used_, some);
      used_ += some;
    }
    return out.size() == count ? out : std::string();
  }
  /// Steps over bytes; false where there are fewer.
  bool skip(std::uint64_t count) {
    while (count > 0 && fill()) {
      const auto some = std::min<std::uint64_t>(count, ready_.size() - used_);
      used_ += static_cast<std::size_t>(some);
      count -= some;
    }
    return count == 0;
  }
  /// Whether all bytes can be had and, of a packed variable, agree with their checksum.
  bool endsWell(const Progress& progress) {
    while (!progress.cancelled() && fill()) used_ = ready_.size();
    return !failed_ && at_ == end_ && (!packed_ || finished_);
  }

 private:
  static constexpr std::uint64_t kPiece = 1 << 18;

  /// Has at least one byte ready; false at the end.
  bool fill() {
    while (used_ == ready_.size() && !failed_ && !finished_) {
      used_ = 0;
      if (packed_) {
        unpack();
      } else {
        ready_ = nextPiece();
        if (ready_.empty()) return false;
      }
    }
    return used_ < ready_.size();
  }
  std::string nextPiece() {
    std::string piece = file_.read(at_, std::min(kPiece, end_ - at_));
    failed_ = failed_ || (piece.empty() && at_ < end_);
    at_ += piece.size();
    return piece;
  }
  void unpack() {
    if (stream_.avail_in == 0) {
      piece_ = nextPiece();
      stream_.next_in = reinterpret_cast<Bytef*>(piece_.data());
      stream_.avail_in = static_cast<uInt>(piece_.size());
    }
    ready_.resize(kPiece);
    stream_.next_out = reinterpret_cast<Bytef*>(ready_.data());
    stream_.avail_out = static_cast<uInt>(ready_.size());
    const int status = inflate(&stream_, Z_NO_FLUSH);
    ready_.resize(ready_.size() - stream_.avail_out);
    finished_ = status == Z_STREAM_END;
    failed_ = failed_ || (status != Z_OK && !finished_);
  }

  const ByteFile& file_;
  std::uint64_t at_, end_;
  bool packed_, failed_ = false, finished_ = false;
  z_stream stream_{};
  std::string piece_, ready_;
  std::size_t used_ = 0;
};

/// The head of a data element: its type, miINT8 and so on, and how many bytes its data have.
struct Tag {
  std::uint32_t type = 0;
  std::uint64_t bytes = 0;
  bool small = false;  ///< Its data are in the tag.
  std::string data;    ///< Of a small element.
};

constexpr std::uint64_t kTag = 8;
constexpr std::uint32_t kInt8 = 1, kInt32 = 5, kUint32 = 6, kMatrix = 14, kPacked = 15;
/// No recording nests deeper; the library reads structures in structures by calling itself.
constexpr int kDeepestVariable = 32;

/// Bytes of a number by the type of its data element; 0: no numbers.
std::uint64_t bytesOfNumber(std::uint32_t type) {
  constexpr std::array<std::uint8_t, 19> kBytes{0, 1, 1, 2, 2, 4, 4, 4, 0, 8, 0, 0, 8, 8, 0, 0, 1, 2, 4};
  return type < kBytes.size() ? kBytes[type] : 0;
}

/// Walks over the parts of one variable and compares what they say with the bytes that they have.
class VariableWalk {
 public:
  VariableWalk(VariableBytes& bytes, bool bigEndian) : bytes_(bytes), bigEndian_(bigEndian) {}

  /// What follows a tag miMATRIX of so many bytes.
  bool matrix(std::uint64_t left, int depth) {
    if (left == 0) return true;  // An empty cell or field
    if (depth > kDeepestVariable) return false;
    std::string data;
    Tag tag;
    if (!element(left, tag, data) || tag.type != kUint32 || data.size() != 8) return false;
    const unsigned kind = ByteReader(data, bigEndian_).read<std::uint32_t>() & 0xff;
    if (kind < kCell || kind > kOpaque) return false;
    double count = 1.0;
    if (kind != kOpaque) {  // Tables and other objects of classes say no sizes
      if (!element(left, tag, data) || tag.type != kInt32 || data.size() % 4 != 0) return false;
      for (ByteReader sizes(data, bigEndian_); !sizes.atEnd();) {
        const auto size = sizes.read<std::int32_t>();
        if (size < 0) return false;
        count *= size;
      }
    }
    if (!element(left, tag, data) || tag.type != kInt8) return false;  // The name
    if (kind >= kFunction) return bytes_.skip(left);
    if (kind == kCell) return matrices(count, left, depth);
    if (kind == kObject && !element(left, tag, data)) return false;  // The name of its class
    if (kind == kStruct || kind == kObject) {
      if (!element(left, tag, data) || data.size() != 4) return false;
      const auto longest = ByteReader(data, bigEndian_).read<std::int32_t>();
      if (!element(left, tag, data) || longest <= 0) return false;
      const double fields = std::floor(static_cast<double>(data.size()) / longest);
      return matrices(fields * count, left, depth);
    }
    if (kind == kText || kind == kSparse) return bytes_.skip(left);  // As long as their tags say
    if (!head(left, tag)) return false;
    const auto size = static_cast<double>(bytesOfNumber(tag.type));
    return count * size <= static_cast<double>(tag.bytes) && (count == 0.0 || size > 0.0) && bytes_.skip(left);
  }

 private:
  enum Kind : unsigned { kCell = 1, kStruct = 2, kObject = 3, kText = 4, kSparse = 5, kFunction = 16, kOpaque = 17 };

  /// The next tag of a variable that has `left` bytes more; its data have to lie in them.
  bool head(std::uint64_t& left, Tag& out) {
    const std::string bytes = left < kTag ? std::string() : bytes_.take(kTag);
    if (bytes.empty()) return false;
    left -= kTag;
    ByteReader reader(bytes, bigEndian_);
    const auto first = reader.read<std::uint32_t>();
    out.small = first >> 16 != 0;
    out.type = first & 0xffff;
    out.bytes = out.small ? first >> 16 : reader.read<std::uint32_t>();
    out.data = out.small ? bytes.substr(4, out.bytes) : std::string();
    return out.small ? out.bytes <= 4 : out.bytes <= left;
  }
  /// A short element with its data and what fills them up to eight bytes.
  bool element(std::uint64_t& left, Tag& tag, std::string& data) {
    constexpr std::uint64_t kMost = 1 << 22;  // Names of a structure's fields
    if (!head(left, tag) || tag.bytes > kMost) return false;
    data = tag.small ? tag.data : bytes_.take(tag.bytes);
    if (data.size() != tag.bytes) return false;
    if (tag.small) return true;
    left -= tag.bytes;
    const std::uint64_t filling = std::min(left, (8 - tag.bytes % 8) % 8);
    left -= filling;
    return bytes_.skip(filling);
  }
  /// Cells or fields: so many matrices, each of which has a tag at least.
  bool matrices(double count, std::uint64_t left, int depth) {
    if (count * static_cast<double>(kTag) > static_cast<double>(left)) return false;
    for (double done = 0.0; done < count; done += 1.0) {
      Tag tag;
      if (!head(left, tag) || tag.small || tag.type != kMatrix || !matrix(tag.bytes, depth + 1)) return false;
      left -= tag.bytes;
    }
    return bytes_.skip(left);
  }

  VariableBytes& bytes_;
  bool bigEndian_;
};

/// Version 4. A head: type, rows, columns, 0 or 1 for imaginary parts, length of the name.
bool headsAreSound(const ByteFile& file) {
  constexpr std::uint64_t kHead = 20;
  constexpr std::array<std::uint64_t, 6> kBytes{8, 4, 4, 2, 2, 1};  // Of a number, by the type's second digit
  for (std::uint64_t at = 0; at + kHead <= file.size();) {
    const std::string head = file.read(at, kHead);
    ByteReader reader(head);
    const auto type = reader.read<std::uint32_t>();
    const double rows = reader.read<std::uint32_t>(), columns = reader.read<std::uint32_t>();
    const auto imaginary = reader.read<std::uint32_t>(), name = reader.read<std::uint32_t>();
    if (!reader.ok() || type / 10 >= kBytes.size() || imaginary > 1 || name == 0 || name > file.size() - at)
      return false;
    const double size = rows * columns * static_cast<double>(kBytes[type / 10] * (1 + imaginary));
    if (size > static_cast<double>(file.size())) return true;  // Cut off: the library finds no more heads
    at += kHead + name + static_cast<std::uint64_t>(size);
  }
  return true;
}

}  // namespace

SoundVariables soundVariables(const ByteFile& file, const Progress& progress) {
  constexpr std::uint64_t kHead = 128;
  if (file.read(0, 10) != "MATLAB 5.0") {
    const bool sound = headsAreSound(file);
    return {sound ? std::numeric_limits<std::size_t>::max() : 0, sound};
  }
  const bool bigEndian = file.read(126, 2) == "MI";
  SoundVariables out;
  for (std::uint64_t at = kHead; at + kTag <= file.size(); ++out.count) {
    const std::string tag = file.read(at, kTag);
    ByteReader reader(tag, bigEndian);
    const auto type = reader.read<std::uint32_t>();
    const std::uint64_t count = reader.read<std::uint32_t>();
    at += kTag;
    // One without a byte has no head, and the library would take what follows it for one.
    out.all = (type == kMatrix || type == kPacked) && count > 0 && count <= file.size() - at && !progress.cancelled();
    if (!out.all) break;
    VariableBytes bytes(file, at, count, type == kPacked);
    VariableWalk walk(bytes, bigEndian);
    if (type == kPacked) {
      const std::string inner = bytes.take(kTag);
      ByteReader packed(inner, bigEndian);
      const bool matrix = packed.read<std::uint32_t>() == kMatrix;
      const std::uint64_t unpacked = packed.read<std::uint32_t>();
      out.all = matrix && unpacked > 0 && walk.matrix(unpacked, 0) && bytes.endsWell(progress);
    } else {
      out.all = walk.matrix(count, 0);
    }
    if (!out.all) break;
    at += count;
  }
  return out;
}

}  // namespace heft
