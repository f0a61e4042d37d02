#pragma once
// Runs the real program, as a user or a script would.
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace heft::test {

struct Outcome {
  int exitCode = -1;  ///< 128 + n where signal n ended it.
  std::string out, err;
};

/// Runs `heft` with these arguments in `folder`; `environment` is added to this process's own.
Outcome runHeft(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                const std::vector<std::pair<std::string, std::string>>& environment = {});

/// A `heft` that runs beside the test; it is killed where the test forgets it.
class Running {
 public:
  struct Limits {
    std::uint64_t fileSize = 0;  ///< [bytes] No file may grow beyond it, as on a full disk; 0: no limit.
    int terminal = -1;           ///< A descriptor for stdout and stderr instead of files.
  };
  Running(const std::vector<std::string>& arguments, const std::filesystem::path& folder, const std::string& name,
          Limits limits);
  Running(const std::vector<std::string>& arguments, const std::filesystem::path& folder, const std::string& name)
      : Running(arguments, folder, name, Limits()) {}
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  void signal(int number) const;
  /// What has come on stderr so far.
  std::string said() const;
  Outcome wait();

 private:
  std::filesystem::path out_, err_;
  int process_ = -1;
};

/// A fresh folder for each test, removed after it.
class CliTest : public testing::Test {
 protected:
  CliTest();
  ~CliTest() override;

  Outcome heft(const std::vector<std::string>& arguments) const { return runHeft(arguments, folder_); }
  std::filesystem::path path(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) const;
  std::string read(const std::string& name) const;
  nlohmann::json readJson(const std::string& name) const { return nlohmann::json::parse(read(name)); }
  bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
  /// Makes NAME.csv, NAME.meta.json and NAME.truth.json; short and at a low rate unless the arguments say otherwise.
  void simulate(const std::string& name,
                std::vector<std::string> arguments = {"--duration", "6", "--rate", "250"}) const;

 private:
  std::filesystem::path folder_;
};

/// Exit code, and exactly one line on stderr that begins with "heft": no trace, no second sentence from elsewhere.
testing::AssertionResult failedWithOneSentence(const Outcome& run, const std::string& mustSay);

}  // namespace heft::test
