// A decimal comma in the environment changes neither how numbers are read nor how they are written.
#include <clocale>
#include <cstdlib>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

/// The environment of a locale with a decimal comma: an installed German one, or one built for this test.
std::vector<std::pair<std::string, std::string>> commaLocale(const std::filesystem::path& folder) {
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"}) {
    const bool installed = std::setlocale(LC_NUMERIC, name) != nullptr;
    std::setlocale(LC_NUMERIC, "C");
    if (installed) return {{"LC_ALL", name}};
  }
  const auto built = (folder / "de_DE").string();
  const std::string command = "localedef --no-archive -i de_DE -f UTF-8 " + built + " >/dev/null 2>&1";
  if (std::system(command.c_str()) == -1 || !std::filesystem::exists(built + "/LC_NUMERIC")) return {};
  return {{"LOCPATH", folder.string()}, {"LC_ALL", "de_DE"}};
}

class LocaleTest : public CliTest {};

TEST_F(LocaleTest, DecimalCommaChangesNothing) {
  std::filesystem::create_directory(path("locales"));
  const auto environment = commaLocale(path("locales"));
  if (environment.empty()) GTEST_SKIP() << "This machine has no locale with a decimal comma and cannot build one";
  simulate("rec");
  const std::vector<std::string> again{"simulate", "--motion",    "excitation", "-o",      "german.csv",
                                       "--truth",  "german.json", "--duration", "6",       "--rate",
                                       "250",      "--xyz",       "0,0,0.04",   "--speed", "1.0"};
  const Outcome simulated = runHeft(again, path(""), environment);
  ASSERT_EQ(simulated.exitCode, 0) << simulated.err;
  EXPECT_EQ(read("german.csv"), read("rec.csv"));
  EXPECT_EQ(read("german.json"), read("rec.truth.json"));

  const Outcome plain = heft({"estimate", "rec.csv", "--trim", "0.15", "--cutoff", "12.5", "--json", "plain.json"});
  const Outcome german =
      runHeft({"estimate", "rec.csv", "--trim", "0.15", "--cutoff", "12.5", "--json", "german.result.json"}, path(""),
              environment);
  ASSERT_EQ(german.exitCode, 0) << german.err;
  auto first = readJson("plain.json"), second = readJson("german.result.json");
  first.erase("timing_s");
  second.erase("timing_s");
  EXPECT_EQ(first, second);
  for (const std::string format : {"urdf", "franka-desk"}) {
    EXPECT_EQ(runHeft({"export", "plain.json", "--format", format}, path(""), environment).out,
              heft({"export", "plain.json", "--format", format}).out);
  }
}

}  // namespace
}  // namespace heft::test
