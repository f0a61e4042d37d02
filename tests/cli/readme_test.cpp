// Every `heft` command that the README shows runs as it stands there, one after the other, in an empty folder.
#include <fstream>
#include <sstream>

#include "tests/cli/process.h"

namespace heft::test {
namespace {

/// The lines that begin with "heft " inside ```sh blocks, split at spaces.
std::vector<std::vector<std::string>> readmeCommands() {
  std::ifstream readme(HEFT_SOURCE_DIR "/README.md");
  std::vector<std::vector<std::string>> commands;
  bool inShell = false;
  for (std::string line; std::getline(readme, line);) {
    if (line.starts_with("```")) inShell = line == "```sh";
    if (!inShell || !line.starts_with("heft ")) continue;
    std::istringstream words(line.substr(5));
    auto& command = commands.emplace_back();
    for (std::string word; words >> word;) command.push_back(word);
  }
  return commands;
}

class ReadmeTest : public CliTest {};

TEST_F(ReadmeTest, EveryCommandWorks) {
  const auto commands = readmeCommands();
  ASSERT_GE(commands.size(), 4u);
  for (const auto& command : commands) {
    const Outcome run = heft(command);
    EXPECT_EQ(run.exitCode, 0) << testing::PrintToString(command) << "\n" << run.err;
  }
}

}  // namespace
}  // namespace heft::test
