#include "tests/cases/cases.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

namespace heft::test {

using nlohmann::json;
namespace fs = std::filesystem;

fs::path sharedCases() {
  const char* given = std::getenv("HEFT_SHARED");
  const fs::path folder = (given ? fs::path(given) : fs::path(HEFT_SOURCE_DIR "/../shared")) / "cases";
  return fs::is_directory(folder) ? folder : fs::path();
}

namespace {

void copyFolder(const fs::path& from, const fs::path& to) {
  fs::create_directories(to);
  fs::copy(from, to, fs::copy_options::recursive);
  for (const auto& entry : fs::recursive_directory_iterator(to))
    fs::permissions(entry.path(), fs::perms::owner_all, fs::perm_options::add);
}

}  // namespace

bool CaseTest::enter(const std::string& name) {
  const auto shared = sharedCases();
  if (shared.empty()) return false;
  folder_ = path(name);
  copyFolder(shared / name, folder_);
  return true;
}

json CaseTest::expectTruth(const std::vector<std::string>& arguments, double massShare, double centreMm) const {
  std::vector<std::string> all{"estimate"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  all.insert(all.end(), {"--json", "-"});
  const Outcome run = heftHere(all);
  EXPECT_EQ(run.exitCode, 0) << arguments[0] << ": " << run.err;
  if (run.exitCode != 0) return {};
  const json result = json::parse(run.out);
  std::ifstream in(folder_ / "truth.json");
  const json truth = json::parse(in);
  EXPECT_NE(result["trust"], "none") << arguments[0] << ": " << result["findings"].dump(1);
  const double mass = truth["mass_kg"].get<double>();
  EXPECT_NEAR(result["payload"]["mass_kg"].get<double>(), mass, massShare * mass) << arguments[0];
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(result["payload"]["com_m"][i].get<double>(), truth["com_m"][i].get<double>(), 1e-3 * centreMm)
        << arguments[0] << " axis " << i;
  return result;
}

void CaseTest::expectRefusal(const std::vector<std::string>& arguments, const std::vector<std::string>& says) const {
  const Outcome run = heftHere(arguments);
  EXPECT_EQ(run.exitCode, 1) << run.out;
  for (const auto& each : says) EXPECT_THAT(run.err, testing::HasSubstr(each)) << arguments[1];
}

}  // namespace heft::test
