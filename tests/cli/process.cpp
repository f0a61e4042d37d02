#include "tests/cli/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace heft::test {
namespace {

std::string slurp(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void redirect(int descriptor, const char* file, int flags) {
  const int opened = open(file, flags, 0600);
  if (opened < 0 || dup2(opened, descriptor) < 0) _exit(126);
}

}  // namespace

Outcome runHeft(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                const std::vector<std::pair<std::string, std::string>>& environment) {
  // Files instead of pipes: no output is so large that it blocks the child.
  const auto out = folder / ".stdout", err = folder / ".stderr";
  std::vector<std::string> words{HEFT_BINARY};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0) {
    if (chdir(folder.c_str()) != 0) _exit(126);
    redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    redirect(STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
    redirect(STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
    for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
    execv(HEFT_BINARY, argv.data());
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), slurp(out), slurp(err)};
}

Running::Running(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                 const std::string& name, Limits limits)
    : out_(folder / ("." + name + ".stdout")), err_(folder / ("." + name + ".stderr")) {
  std::vector<std::string> words{HEFT_BINARY};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  process_ = fork();
  if (process_ < 0) throw std::runtime_error("fork failed");
  if (process_ > 0) return;
  if (chdir(folder.c_str()) != 0) _exit(126);
  redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
  if (limits.terminal >= 0) {
    // The terminal of this process and no other: closing it ends with SIGHUP.
    setsid();
    ioctl(limits.terminal, TIOCSCTTY, 0);
    if (dup2(limits.terminal, STDOUT_FILENO) < 0 || dup2(limits.terminal, STDERR_FILENO) < 0) _exit(126);
    close(limits.terminal);
  } else {
    redirect(STDOUT_FILENO, out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
    redirect(STDERR_FILENO, err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC);
  }
  if (limits.fileSize > 0) {
    const rlimit limit{limits.fileSize, limits.fileSize};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  execv(HEFT_BINARY, argv.data());
  _exit(127);
}

Running::~Running() {
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

void Running::signal(int number) const { kill(process_, number); }

std::string Running::said() const { return slurp(err_); }

Outcome Running::wait() {
  int status = 0;
  waitpid(process_, &status, 0);
  process_ = -1;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), slurp(out_), slurp(err_)};
}

CliTest::CliTest() {
  std::string name = (std::filesystem::temp_directory_path() / "heft-cli-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
  folder_ = name;
}

CliTest::~CliTest() {
  std::error_code ec;
  std::filesystem::remove_all(folder_, ec);
}

void CliTest::write(const std::string& name, const std::string& text) const {
  std::ofstream out(path(name), std::ios::binary);
  out << text;
}

std::string CliTest::read(const std::string& name) const { return slurp(path(name)); }

void CliTest::simulate(const std::string& name, std::vector<std::string> arguments) const {
  std::vector<std::string> all{"simulate", "-o", name + ".csv", "--truth", name + ".truth.json"};
  if (std::find(arguments.begin(), arguments.end(), "--motion") == arguments.end())
    all.insert(all.end(), {"--motion", "excitation"});
  all.insert(all.end(), arguments.begin(), arguments.end());
  const Outcome run = heft(all);
  ASSERT_EQ(run.exitCode, 0) << run.err;
}

testing::AssertionResult failedWithOneSentence(const Outcome& run, const std::string& mustSay) {
  if (run.exitCode != 1) return testing::AssertionFailure() << "exit code " << run.exitCode << ", stderr: " << run.err;
  if (!run.out.empty()) return testing::AssertionFailure() << "stdout is not empty: " << run.out;
  if (!run.err.starts_with("heft: ") || std::count(run.err.begin(), run.err.end(), '\n') != 1 || run.err.back() != '\n')
    return testing::AssertionFailure() << "not one line that begins with 'heft: ': " << run.err;
  if (run.err.find(mustSay) == std::string::npos)
    return testing::AssertionFailure() << "'" << mustSay << "' is not in: " << run.err;
  return testing::AssertionSuccess();
}

}  // namespace heft::test
