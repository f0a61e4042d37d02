#include "core/import/message_definition.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>

#include "core/base/hash.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/bytes.h"

namespace heft {

namespace {

constexpr std::uint64_t kLongestArray = 256;  ///< Longer arrays are pictures or point clouds, not channels.
constexpr std::size_t kMostFields = 4096;     ///< Of one message.
constexpr int kDeepestMessage = 16;

enum class Scalar { boolean, int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };
enum class Kind { scalar, text, time, message };

struct ScalarName {
  std::string_view name;
  Scalar scalar;
};
constexpr std::array<ScalarName, 14> kScalars = {{{"bool", Scalar::boolean},
                                                  {"int8", Scalar::int8},
                                                  {"uint8", Scalar::uint8},
                                                  {"byte", Scalar::uint8},
                                                  {"char", Scalar::uint8},
                                                  {"octet", Scalar::uint8},
                                                  {"int16", Scalar::int16},
                                                  {"uint16", Scalar::uint16},
                                                  {"int32", Scalar::int32},
                                                  {"uint32", Scalar::uint32},
                                                  {"int64", Scalar::int64},
                                                  {"uint64", Scalar::uint64},
                                                  {"float32", Scalar::float32},
                                                  {"float64", Scalar::float64}}};

std::size_t sizeOf(Scalar scalar) {
  switch (scalar) {
    case Scalar::boolean:
    case Scalar::int8:
    case Scalar::uint8:
      return 1;
    case Scalar::int16:
    case Scalar::uint16:
      return 2;
    case Scalar::int32:
    case Scalar::uint32:
    case Scalar::float32:
      return 4;
    case Scalar::int64:
    case Scalar::uint64:
    case Scalar::float64:
      return 8;
  }
  return 1;
}

double readScalar(ByteReader& reader, Scalar scalar) {
  switch (scalar) {
    case Scalar::boolean:
    case Scalar::uint8:
      return reader.read<std::uint8_t>();
    case Scalar::int8:
      return reader.read<std::int8_t>();
    case Scalar::int16:
      return reader.read<std::int16_t>();
    case Scalar::uint16:
      return reader.read<std::uint16_t>();
    case Scalar::int32:
      return reader.read<std::int32_t>();
    case Scalar::uint32:
      return reader.read<std::uint32_t>();
    case Scalar::float32:
      return static_cast<double>(reader.read<float>());
    case Scalar::int64:
      return static_cast<double>(reader.read<std::int64_t>());
    case Scalar::uint64:
      return static_cast<double>(reader.read<std::uint64_t>());
    case Scalar::float64:
      return reader.read<double>();
  }
  return 0.0;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const auto first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// Calls `act` with every line, without its line break.
template <class Act>
void forEachLine(std::string_view text, Act act) {
  while (!text.empty()) {
    const auto stop = text.find('\n');
    act(text.substr(0, stop));
    text = stop == std::string_view::npos ? std::string_view() : text.substr(stop + 1);
  }
}

}  // namespace

struct MessageDecoder::Type {
  struct Field {
    std::string name;
    Kind kind = Kind::scalar;
    Scalar scalar = Scalar::float64;
    std::shared_ptr<const Type> type;  ///< Of kind message.
    bool array = false;
    std::uint64_t fixedLength = 0;  ///< 0 for a sequence that states its own.
  };
  std::string name;
  std::vector<Field> fields;
  bool header = false;
};

namespace {

using Texts = std::map<std::string, std::string, std::less<>>;

/// Splits a bag's definition into the texts of its types.
Texts splitDefinition(std::string_view type, std::string_view definition) {
  Texts texts;
  std::string current = plainTypeName(type);
  bool border = false;
  forEachLine(definition, [&](std::string_view line) {
    const auto content = trimmed(line);
    if (content.size() >= 20 && content.find_first_not_of('=') == std::string_view::npos) {
      border = true;
    } else if (border && content.starts_with("MSG:")) {
      current = plainTypeName(trimmed(content.substr(4)));
      texts.try_emplace(current);
      border = false;
    } else {
      texts[current].append(line).push_back('\n');
    }
  });
  texts.try_emplace(plainTypeName(type));
  return texts;
}

}  // namespace

struct MessageDecoder::Walk {
  Walk(MessageDecoder& decoder, ByteReader bytes, bool isCdr) : out(decoder), reader(bytes), cdr(isCdr) {}

  MessageDecoder& out;
  ByteReader reader;
  const bool cdr;
  bool naming = false;
  std::vector<std::uint64_t> shape;
  std::vector<std::string> names;
  std::string_view child;  ///< The child frame that was read last.
  bool stampFound = false;
  std::uint64_t steps = 0;
  /// Types without content would let a short message state endless work.
  const std::uint64_t mostSteps = 1000 + 4 * reader.remaining();

  void fail() { reader.take(reader.remaining() + 1); }

  void alignTo(std::size_t size) {
    if (cdr && size > 1) reader.align(size);
  }

  std::string_view text() {
    alignTo(4);
    auto content = reader.text();
    if (cdr && !content.empty() && content.back() == '\0') content.remove_suffix(1);
    return content;
  }

  void add(const std::string& path, double value) {
    if (out.values_.size() >= kMostFields) return;
    out.values_.push_back(value);
    if (naming) names.push_back(path);
  }

  void time(const std::string& path, bool ownHeader) {
    alignTo(4);
    const auto seconds = cdr ? static_cast<std::int64_t>(reader.read<std::int32_t>())
                             : static_cast<std::int64_t>(reader.read<std::uint32_t>());
    const auto nanoseconds = static_cast<std::int64_t>(reader.read<std::uint32_t>());
    const std::int64_t stamp = seconds * 1000000000 + nanoseconds;
    if (ownHeader && !stampFound) {
      out.stamp_ = stamp;
      stampFound = true;
    }
    add(path, 1e-9 * static_cast<double>(stamp));
  }

  static std::string element(const std::string& path, std::uint64_t index,
                             const std::vector<std::string_view>& labels) {
    if (index < labels.size()) return fmt::format("{}[{}]", path, printable(labels[static_cast<std::size_t>(index)]));
    return fmt::format("{}[{}]", path, index);
  }

  void message(const Type& type, const std::string& prefix, int depth) {
    std::vector<std::string_view> labels;  // of a JointState's arrays
    if (type.fields.empty() && cdr) reader.take(1);
    if (++steps > mostSteps) return fail();
    for (const auto& field : type.fields) {
      if (!reader.ok()) return;
      const std::string path = naming ? (prefix.empty() ? field.name : prefix + "." + field.name) : std::string();
      std::uint64_t count = 1;
      if (field.array) {
        count = field.fixedLength;
        if (count == 0) {
          alignTo(4);
          count = reader.read<std::uint32_t>();
          shape.push_back(count);
        }
      }
      const bool named = naming && field.array;
      switch (field.kind) {
        case Kind::scalar: {
          const std::size_t size = sizeOf(field.scalar);
          if (count > 0) alignTo(size);
          if (count > reader.remaining() / size) return fail();
          if (count > kLongestArray) {
            reader.take(count * size);
            break;
          }
          for (std::uint64_t i = 0; i < count; ++i)
            add(named ? element(path, i, labels.size() == count ? labels : std::vector<std::string_view>()) : path,
                readScalar(reader, field.scalar));
          break;
        }
        case Kind::text:
          for (std::uint64_t i = 0; i < count && reader.ok(); ++i) {
            const auto content = text();
            if (!field.array && field.name == "child_frame_id") {
              child = content;
              shape.push_back(hashOf(content));
            }
            if (!field.array || field.name != "name" || count > kLongestArray) continue;
            labels.push_back(content);
            shape.push_back(hashOf(content));
          }
          break;
        case Kind::time:
          for (std::uint64_t i = 0; i < count && reader.ok(); ++i)
            time(named ? element(path, i, {}) : path, depth == 1 && type.header && !field.array);
          break;
        case Kind::message:
          for (std::uint64_t i = 0; i < count && reader.ok(); ++i) {
            child = {};
            const std::size_t first = names.size();
            const std::string own = named ? element(path, i, {}) : path;
            message(*field.type, own, depth + 1);
            if (!named || child.empty()) continue;
            // Transforms come in any order; each is called after its child frame.
            for (std::size_t n = first; n < names.size(); ++n)
              names[n] = element(path, 0, {child}) + names[n].substr(own.size());
          }
          break;
      }
    }
  }
};

Result<MessageDecoder> MessageDecoder::make(std::string_view type, std::string_view definition,
                                            MessageEncoding encoding) {
  const Texts texts = splitDefinition(type, definition);
  std::map<std::string, std::shared_ptr<const Type>> known;
  std::optional<Error> failure;

  const std::function<std::shared_ptr<const Type>(const std::string&, int)> build =
      [&](const std::string& name, int depth) -> std::shared_ptr<const Type> {
    if (const auto found = known.find(name); found != known.end()) return found->second;
    const auto text = texts.find(name);
    if (text == texts.end() || depth > kDeepestMessage) {
      failure = Error{heft::say("The definition of {} lacks {}.", printable(type), printable(name))};
      return nullptr;
    }
    auto built = std::make_shared<Type>();
    built->name = name;
    built->header = name == "std_msgs/Header";
    forEachLine(text->second, [&](std::string_view line) {
      line = trimmed(line.substr(0, line.find('#')));
      const auto blank = line.find_first_of(" \t");
      if (failure || blank == std::string_view::npos) return;
      auto typeName = line.substr(0, blank);
      auto rest = trimmed(line.substr(blank));
      auto fieldName = rest.substr(0, rest.find_first_of(" \t="));
      const auto after = trimmed(rest.substr(fieldName.size()));
      if (after.starts_with('=')) return;  // a constant
      Type::Field field;
      field.name = printable(fieldName);
      if (const auto open = typeName.find('['); open != std::string_view::npos) {
        const auto close = typeName.find(']', open);
        if (close == std::string_view::npos) {
          failure = Error{heft::say("The definition of {} has an array without an end.", printable(name))};
          return;
        }
        field.array = true;
        const auto length = typeName.substr(open + 1, close - open - 1);
        if (!length.empty() && !length.starts_with("<=")) {
          const auto [end, code] = std::from_chars(length.data(), length.data() + length.size(), field.fixedLength);
          if (code != std::errc() || end != length.data() + length.size() || field.fixedLength == 0) {
            failure = Error{heft::say("The definition of {} has an array of odd length.", printable(name))};
            return;
          }
        }
        typeName = typeName.substr(0, open);
      }
      if (const auto bound = typeName.find("<="); bound != std::string_view::npos) typeName = typeName.substr(0, bound);
      const auto scalar =
          std::find_if(kScalars.begin(), kScalars.end(), [&](const ScalarName& each) { return each.name == typeName; });
      if (scalar != kScalars.end()) {
        field.scalar = scalar->scalar;
      } else if (typeName == "string") {
        field.kind = Kind::text;
      } else if (typeName == "time" || typeName == "duration" || plainTypeName(typeName) == "builtin_interfaces/Time" ||
                 plainTypeName(typeName) == "builtin_interfaces/Duration") {
        field.kind = Kind::time;
      } else {
        std::string full = plainTypeName(typeName);
        if (full == "Header") full = "std_msgs/Header";
        if (full.find('/') == std::string::npos) full = name.substr(0, name.find('/') + 1) + full;
        field.kind = Kind::message;
        field.type = build(full, depth + 1);
        if (!field.type) return;
      }
      built->fields.push_back(std::move(field));
    });
    if (failure) return nullptr;
    known[name] = built;
    return built;
  };

  MessageDecoder decoder;
  decoder.encoding_ = encoding;
  decoder.root_ = build(plainTypeName(type), 0);
  if (failure) return *failure;
  return decoder;
}

bool MessageDecoder::decode(std::string_view message) {
  bool bigEndian = false;
  const bool cdr = encoding_ == MessageEncoding::cdr;
  if (cdr) {
    // 00 00 big-endian, 00 01 little-endian CDR; parameter lists and XCDR 2 are other layouts.
    if (message.size() < 4 || message[0] != 0 || (message[1] != 0 && message[1] != 1)) return false;
    bigEndian = message[1] == 0;
    message.remove_prefix(4);
  }
  values_.clear();
  stamp_ = 0;
  Walk walk(*this, ByteReader(message, bigEndian), cdr);
  walk.message(*root_, {}, 0);
  if (!walk.reader.ok()) return false;
  namesChanged_ = names_.size() != values_.size() || walk.shape != shape_;
  if (namesChanged_) {
    values_.clear();
    Walk named(*this, ByteReader(message, bigEndian), cdr);
    named.naming = true;
    named.message(*root_, {}, 0);
    names_ = std::move(named.names);
    shape_ = std::move(named.shape);
  }
  return true;
}

std::string plainTypeName(std::string_view type) {
  std::string out(type);
  if (const auto at = out.find("/msg/"); at != std::string::npos) out.erase(at, 4);
  return out;
}

}  // namespace heft
