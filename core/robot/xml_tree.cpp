#include "core/robot/xml_tree.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {
namespace {

constexpr std::size_t kMaxDepth = 64;
constexpr std::size_t kMaxAttributes = 256;

bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool isNameEnd(char c) { return isSpace(c) || c == '/' || c == '>' || c == '=' || c == '<' || c == '"' || c == '\''; }

void appendUtf8(std::string& out, unsigned code) {
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xC0 | (code >> 6));
    out += static_cast<char>(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    out += static_cast<char>(0xE0 | (code >> 12));
    out += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
    out += static_cast<char>(0x80 | (code & 0x3F));
  } else {
    out += static_cast<char>(0xF0 | (code >> 18));
    out += static_cast<char>(0x80 | ((code >> 12) & 0x3F));
    out += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
    out += static_cast<char>(0x80 | (code & 0x3F));
  }
}

class Parser {
 public:
  Parser(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Result<XmlElement> run() {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") pos_ = lineStart_ = 3;
    if (text_.find('\0') != std::string_view::npos) return Error{heft::say("{} is a binary file, not XML.", name_)};
    while (true) {
      skipText();
      if (pos_ >= text_.size()) break;
      if (!markup()) return Error{error_};
    }
    if (!open_.empty()) {
      const XmlElement& last = open_.back();
      return Error{heft::say("{}:{}:{}: <{}> is never closed; the file may be cut off.", name_, last.line, last.column,
                             last.name)};
    }
    if (!root_) return Error{heft::say("{} contains no XML element.", name_)};
    return std::move(*root_);
  }

 private:
  bool fail(const std::string& message) {
    if (error_.empty())
      error_ = fmt::format("{}:{}:{}: {}", name_, line_, pos_ - lineStart_ + 1, printable(message, 200));
    return false;
  }
  bool startsWith(std::string_view what) const { return text_.substr(pos_, what.size()) == what; }

  void advance(std::size_t count) {
    for (const std::size_t end = std::min(pos_ + count, text_.size()); pos_ < end; ++pos_) {
      if (text_[pos_] != '\n') continue;
      ++line_;
      lineStart_ = pos_ + 1;
    }
  }
  void skipText() {
    const std::size_t next = text_.find('<', pos_);
    advance((next == std::string_view::npos ? text_.size() : next) - pos_);
  }
  void skipSpace() {
    while (pos_ < text_.size() && isSpace(text_[pos_])) advance(1);
  }
  bool skipPast(std::string_view end, const std::string& what) {
    const std::size_t found = text_.find(end, pos_);
    if (found == std::string_view::npos) return fail(heft::say("this {} is never closed.", what));
    advance(found + end.size() - pos_);
    return true;
  }
  bool skipDoctype() {
    int brackets = 0;
    while (pos_ < text_.size()) {
      const char c = text_[pos_];
      advance(1);
      if (c == '[') ++brackets;
      if (c == ']') --brackets;
      if (c == '>' && brackets <= 0) return true;
    }
    return fail(heft::say("this DOCTYPE is never closed."));
  }

  bool markup() {
    if (startsWith("<!--")) return skipPast("-->", heft::say("comment"));
    if (startsWith("<![CDATA[")) return skipPast("]]>", heft::say("CDATA block"));
    if (startsWith("<?")) return skipPast("?>", heft::say("processing instruction"));
    if (startsWith("<!")) return skipDoctype();
    if (startsWith("</")) return closingTag();
    return openingTag();
  }

  std::string readName() {
    const std::size_t begin = pos_;
    while (pos_ < text_.size() && !isNameEnd(text_[pos_])) advance(1);
    return std::string(text_.substr(begin, pos_ - begin));
  }

  bool closingTag() {
    if (open_.empty()) return fail(heft::say("this closing tag has no opening one."));
    const XmlElement& last = open_.back();
    const std::string_view rest = text_.substr(pos_ + 2);
    const bool matches =
        rest.starts_with(last.name) && (rest.size() == last.name.size() || isNameEnd(rest[last.name.size()]));
    if (!matches) return fail(heft::say("this closing tag does not match <{}> of line {}.", last.name, last.line));
    advance(2);
    readName();
    skipSpace();
    if (pos_ >= text_.size() || text_[pos_] != '>')
      return fail(heft::say("'>' is missing after a closing tag's name."));
    advance(1);
    XmlElement done = std::move(open_.back());
    open_.pop_back();
    return finish(std::move(done));
  }

  bool finish(XmlElement done) {
    if (!open_.empty()) {
      open_.back().children.push_back(std::move(done));
    } else if (root_) {
      return fail(heft::say("there is a second root element; an XML file has one."));
    } else {
      root_ = std::move(done);
    }
    return true;
  }

  bool openingTag() {
    XmlElement element;
    element.line = line_;
    element.column = static_cast<long>(pos_ - lineStart_) + 1;
    advance(1);
    element.name = readName();
    if (element.name.empty())
      return fail(heft::say("a tag's name is missing after '<' (a plain '<' is written &lt;)."));
    if (open_.size() >= kMaxDepth) return fail(heft::say("elements are nested deeper than {}.", kMaxDepth));
    while (true) {
      skipSpace();
      if (pos_ >= text_.size()) return fail(heft::say("the tag <{}> is never closed.", element.name));
      if (startsWith("/>")) {
        advance(2);
        return finish(std::move(element));
      }
      if (text_[pos_] == '>') {
        advance(1);
        open_.push_back(std::move(element));
        return true;
      }
      if (!attribute(element)) return false;
    }
  }

  bool attribute(XmlElement& element) {
    if (element.attributes.size() >= kMaxAttributes)
      return fail(heft::say("<{}> has too many attributes.", element.name));
    XmlAttribute found;
    found.name = readName();
    if (found.name.empty()) return fail(heft::say("an attribute's name is missing in <{}>.", element.name));
    if (element.attribute(found.name)) {
      return fail(heft::say("attribute \"{}\" appears twice in <{}>.", found.name, element.name));
    }
    skipSpace();
    if (pos_ >= text_.size() || text_[pos_] != '=') return fail(heft::say("'=' is missing after \"{}\".", found.name));
    advance(1);
    skipSpace();
    if (pos_ >= text_.size() || (text_[pos_] != '"' && text_[pos_] != '\'')) {
      return fail(heft::say("the value of \"{}\" is not in quotation marks.", found.name));
    }
    const char quote = text_[pos_];
    const std::size_t end = text_.find(quote, pos_ + 1);
    if (end == std::string_view::npos) return fail(heft::say("the value of \"{}\" is never closed.", found.name));
    if (!decode(text_.substr(pos_ + 1, end - pos_ - 1), found.value)) return false;
    advance(end + 1 - pos_);
    element.attributes.push_back(std::move(found));
    return true;
  }

  bool decode(std::string_view raw, std::string& out) {
    for (std::size_t i = 0; i < raw.size(); ++i) {
      if (raw[i] != '&') {
        out += raw[i];
        continue;
      }
      const std::size_t end = raw.find(';', i);
      if (end == std::string_view::npos) return fail(heft::say("a plain '&' is written &amp;."));
      const std::string_view entity = raw.substr(i + 1, end - i - 1);
      if (entity == "amp") {
        out += '&';
      } else if (entity == "lt") {
        out += '<';
      } else if (entity == "gt") {
        out += '>';
      } else if (entity == "quot") {
        out += '"';
      } else if (entity == "apos") {
        out += '\'';
      } else if (!numericEntity(entity, out)) {
        return fail(heft::say("\"&{}\" is not a known entity (a plain '&' is written &amp;).", entity.substr(0, 20)));
      }
      i = end;
    }
    return true;
  }

  static bool numericEntity(std::string_view entity, std::string& out) {
    if (entity.size() < 2 || entity[0] != '#') return false;
    const bool hex = entity[1] == 'x';
    const std::string_view digits = entity.substr(hex ? 2 : 1);
    unsigned code = 0;
    const auto [rest, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), code, hex ? 16 : 10);
    if (problem != std::errc() || rest != digits.data() + digits.size() || code == 0 || code > 0x10FFFF) return false;
    appendUtf8(out, code);
    return true;
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t pos_ = 0;
  std::size_t lineStart_ = 0;
  long line_ = 1;
  std::vector<XmlElement> open_;
  std::optional<XmlElement> root_;
  std::string error_;
};

}  // namespace

const std::string* XmlElement::attribute(std::string_view attributeName) const {
  for (const XmlAttribute& candidate : attributes) {
    if (candidate.name == attributeName) return &candidate.value;
  }
  return nullptr;
}

std::string_view XmlElement::attributeOr(std::string_view attributeName) const {
  const std::string* value = attribute(attributeName);
  return value ? std::string_view(*value) : std::string_view();
}

const XmlElement* XmlElement::child(std::string_view childName) const {
  for (const XmlElement& candidate : children) {
    if (candidate.name == childName) return &candidate;
  }
  return nullptr;
}

Result<XmlElement> parseXml(std::string_view text, const std::string& name) { return Parser(text, name).run(); }

}  // namespace heft
