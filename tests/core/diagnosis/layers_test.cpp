// How core/diagnosis is built: folders use only those before them, units include each other in no circle, and causes
// are named in their own folder only.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/diagnosis/causes/catalogue.h"

namespace heft::test {
namespace {

namespace fs = std::filesystem;

const std::string kFolder = "core/diagnosis/";

std::string textOf(const fs::path& file) {
  std::ifstream in(file);
  std::stringstream out;
  out << in.rdbuf();
  return out.str();
}

/// Code of each header and source, by its path from the project's root.
std::map<std::string, std::string> sources() {
  std::map<std::string, std::string> out;
  const fs::path root(HEFT_SOURCE_DIR);
  for (const auto& entry : fs::recursive_directory_iterator(root / kFolder))
    if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
      out[fs::relative(entry.path(), root).generic_string()] = textOf(entry.path());
  return out;
}

/// What a unit includes of the diagnosis, without endings.
std::map<std::string, std::set<std::string>> includes() {
  static const std::regex kInclude("#include \"(core/diagnosis/[a-z_/]+)\\.h\"");
  std::map<std::string, std::set<std::string>> out;
  for (const auto& [file, text] : sources()) {
    const std::string unit = file.substr(0, file.rfind('.'));
    auto& all = out[unit];
    for (std::sregex_iterator it(text.begin(), text.end(), kInclude), end; it != end; ++it)
      if ((*it)[1] != unit) all.insert((*it)[1]);
  }
  return out;
}

/// The folders in the order in which CMake adds them; "result" and "" stand for the files beside them.
std::vector<std::string> folders() {
  static const std::regex kAdds("add_subdirectory\\((\\w+)\\)|heft_module\\(diagnosis_?(\\w*)");
  const std::string text = textOf(fs::path(HEFT_SOURCE_DIR) / kFolder / "CMakeLists.txt");
  std::vector<std::string> out;
  for (std::sregex_iterator it(text.begin(), text.end(), kAdds), end; it != end; ++it)
    out.push_back((*it)[1].matched ? (*it)[1] : (*it)[2]);
  return out;
}

std::string folderOf(const std::string& unit) {
  const std::string within = unit.substr(kFolder.size());
  if (const auto slash = within.find('/'); slash != std::string::npos) return within.substr(0, slash);
  return within == "result" || within == "frames" ? "result" : "";
}

TEST(Layers, FoldersUseOnlyThoseBeforeThem) {
  const auto order = folders();
  ASSERT_GT(order.size(), 10u);
  const auto place = [&](const std::string& unit) { return std::ranges::find(order, folderOf(unit)) - order.begin(); };
  for (const auto& [unit, all] : includes()) {
    EXPECT_LT(place(unit), std::ssize(order)) << unit << " is in no folder that CMake adds";
    for (const auto& other : all) {
      if (other == kFolder + "options" || other == kFolder + "calibration") continue;  // What all of them are given
      EXPECT_LE(place(other), place(unit)) << unit << " includes " << other;
    }
  }
}

TEST(Layers, NoUnitsIncludeEachOtherInACircle) {
  const auto all = includes();
  std::set<std::string> done, open;
  std::function<void(const std::string&)> visit = [&](const std::string& unit) {
    if (done.contains(unit)) return;
    EXPECT_TRUE(open.insert(unit).second) << unit << " is part of a circle";
    if (testing::Test::HasFailure()) return;
    if (const auto at = all.find(unit); at != all.end())
      for (const auto& other : at->second) visit(other);
    open.erase(unit);
    done.insert(unit);
  };
  for (const auto& [unit, others] : all) visit(unit);
}

TEST(Layers, CausesAreNamedByTextInTheirOwnFolderOnly) {
  constexpr int kMost = 20;
  int count = 0;
  std::string where;
  for (const auto& [file, text] : sources()) {
    if (file.starts_with(kFolder + "causes/")) continue;
    for (const auto* list : {&diagnosis::catalogue(), &diagnosis::seenDirectly()})
      for (const auto& cause : *list) {
        const std::string literal = '"' + std::string(cause->id()) + '"';
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
          if (line.substr(0, line.find("//")).find(literal) == std::string::npos) continue;
          ++count;
          where += file + ": " + line + '\n';
        }
      }
  }
  EXPECT_LE(count, kMost) << where;
}

}  // namespace
}  // namespace heft::test
