// Objects that differ in nothing but their numbers are read at the places of those before: with what result?
#include "core/import/json_numbers.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

namespace heft {
namespace {

using nlohmann::json;
using testing::ElementsAre;

/// What a reader says that has seen nothing before.
std::optional<NamedNumbers> alone(const std::string& text) {
  JsonNumbers fresh;
  const auto* const numbers = fresh.read(text);
  return numbers ? std::optional(*numbers) : std::nullopt;
}

void expectSame(const std::string& text, const NamedNumbers* read) {
  const auto expected = alone(text);
  ASSERT_EQ(read != nullptr, expected.has_value()) << text;
  if (read == nullptr) return;
  EXPECT_EQ(read->names, expected->names) << text;
  ASSERT_EQ(read->values.size(), expected->values.size()) << text;
  for (std::size_t i = 0; i < read->values.size(); ++i) {
    const double a = read->values[i], b = expected->values[i];
    EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << read->names[i] << ": " << a << ", " << b << "\n" << text;
  }
}

class RandomJson {
 public:
  explicit RandomJson(unsigned seed) : random_(seed) {}
  int upTo(int most) { return std::uniform_int_distribution(0, most)(random_); }
  std::string number() {
    switch (upTo(7)) {
      case 0:
        return std::to_string(upTo(100) - 50);
      case 1:
        return json(std::normal_distribution(0.0, 1e3)(random_)).dump();
      case 2:
        return json(std::normal_distribution(0.0, 1e-9)(random_)).dump();
      case 3:
        return "1764547200123456789";
      case 4:
        return upTo(9) > 0 ? "-0.0" : "1e999";
      case 5:
        return upTo(9) > 0 ? "6.02E+23" : "01";
      case 6:
        return upTo(9) > 0 ? "0" : "NaN";
      default:
        return upTo(9) > 0 ? "5e-1" : "-Infinity";
    }
  }
  std::string text() {
    static const std::vector<std::string> kTexts = {"\"a\"", "\"1.5\"", "\"say \\\"7\\\" 8\"",
                                                    "true",  "null",    "\"\\\\\""};
    return kTexts[static_cast<std::size_t>(upTo(static_cast<int>(kTexts.size()) - 1))];
  }
  /// With a '#' where a number belongs.
  std::string pattern(int depth) {
    const int kind = depth > 0 ? upTo(5) : upTo(2);
    if (kind < 2) return "#";
    if (kind == 2) return text();
    std::string out = kind == 3 ? "[" : "{";
    const int count = upTo(4);
    if (kind == 5) out += R"("name":["x","y","z"],"position":[#, #, #])" + std::string(count > 0 ? "," : "");
    for (int i = 0; i < count; ++i) {
      if (i > 0) out += upTo(1) == 0 ? "," : " , ";
      if (kind != 3) out += "\"k" + std::to_string(upTo(3)) + "\": ";
      out += pattern(depth - 1);
    }
    return out + (kind == 3 ? "]" : "}");
  }
  std::string filled(const std::string& pattern) {
    std::string out;
    for (const char c : pattern) out += c == '#' ? number() : std::string(1, c);
    return out;
  }

 private:
  std::mt19937 random_;
};

TEST(JsonNumbers, SaysTheSameHoweverManyObjectsCameBefore) {
  RandomJson random(20261130);
  for (int round = 0; round < 60; ++round) {
    JsonNumbers reader;
    std::vector<std::string> patterns;
    for (int i = 0; i < 4; ++i) patterns.push_back("{\"t\": #, \"v\": " + random.pattern(3) + "}");
    for (int k = 0; k < 40; ++k) {
      const std::string text = random.filled(patterns[static_cast<std::size_t>(random.upTo(3))]);
      expectSame(text, reader.read(text));
    }
  }
}

TEST(JsonNumbers, WhatIsCutOffOrChangedIsNotReadByTheOldPlaces) {
  const std::string text = R"({"name":["a","b"],"q":[1.5, -2e1],"seq":"7","on":true})";
  JsonNumbers reader;
  ASSERT_NE(reader.read(text), nullptr);
  ASSERT_NE(reader.read(text), nullptr);
  for (std::size_t i = 0; i < text.size(); ++i)
    for (const char c : std::string("0-.e,}\" x")) {
      std::string changed = text;
      changed[i] = c;
      expectSame(changed, reader.read(changed));
      expectSame(text.substr(0, i), reader.read(text.substr(0, i)));
    }
  const auto* const numbers = reader.read(R"({"name":["a","b"],"q":[2.5, 3],"seq":"7","on":true})");
  ASSERT_NE(numbers, nullptr);
  EXPECT_THAT(numbers->names, ElementsAre("on", "q[a]", "q[b]", "seq"));
  EXPECT_THAT(numbers->values, ElementsAre(1.0, 2.5, 3.0, 7.0));
}

}  // namespace
}  // namespace heft
