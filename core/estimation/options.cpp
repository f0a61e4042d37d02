#include "core/estimation/options.h"

#include <utility>

namespace heft {

namespace {
constexpr std::pair<Method, std::string_view> kMethods[] = {{Method::map, "map"},
                                                            {Method::ls, "ls"},
                                                            {Method::wls, "wls"},
                                                            {Method::tls, "tls"},
                                                            {Method::tlsFast, "tls-fast"},
                                                            {Method::tlsExact, "tls-exact"},
                                                            {Method::ceres, "ceres"},
                                                            {Method::eigenLm, "eigen-lm"},
                                                            {Method::bruteForce, "brute-force"}};
constexpr std::pair<ParameterSet, std::string_view> kSets[] = {
    {ParameterSet::mass, "mass"}, {ParameterSet::massCom, "mass-com"}, {ParameterSet::full, "full"}};

template <class Table, class Value>
std::string_view nameIn(const Table& table, Value value) {
  for (const auto& [key, name] : table)
    if (key == value) return name;
  return "";
}

template <class Value, class Table>
std::optional<Value> valueIn(const Table& table, std::string_view text) {
  for (const auto& [key, name] : table)
    if (name == text) return key;
  return std::nullopt;
}
}  // namespace

std::string_view toString(Method method) { return nameIn(kMethods, method); }
std::optional<Method> methodFromString(std::string_view text) { return valueIn<Method>(kMethods, text); }
std::string_view toString(ParameterSet set) { return nameIn(kSets, set); }
std::optional<ParameterSet> parameterSetFromString(std::string_view text) { return valueIn<ParameterSet>(kSets, text); }

std::string_view toString(ConventionChoice choice) {
  return choice == ConventionChoice::suggested ? "suggested" : "as-stated";
}

}  // namespace heft
