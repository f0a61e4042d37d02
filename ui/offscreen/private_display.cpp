#include "ui/offscreen/private_display.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace heft {
namespace {

constexpr int kStartMilliseconds = 15000;

/// The number that Xvfb writes once it listens; empty if it ended or stayed silent.
std::string readDisplayNumber(int fd) {
  std::string text;
  while (true) {
    pollfd wait{fd, POLLIN, 0};
    const int ready = poll(&wait, 1, kStartMilliseconds);
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return {};
    char c;
    const ssize_t got = read(fd, &c, 1);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return {};
    if (c == '\n') return text;
    text.push_back(c);
  }
}

void stop(pid_t pid) {
  kill(pid, SIGTERM);
  while (waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace

Result<std::unique_ptr<PrivateDisplay>> PrivateDisplay::start(int width, int height) {
  std::array<int, 2> numberPipe{}, errorPipe{};
  // The number pipe is inherited under its own number; the error pipe closes by itself when exec succeeds.
  if (pipe(numberPipe.data()) != 0 || pipe2(errorPipe.data(), O_CLOEXEC) != 0) {
    return Error{fmt::format("The private X server could not be started: {}.", std::strerror(errno))};
  }
  const std::string screen = fmt::format("{}x{}x24", width, height);
  const std::string displayFd = std::to_string(numberPipe[1]);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid < 0) return Error{fmt::format("The private X server could not be started: {}.", std::strerror(errno))};
  if (pid == 0) {
    // Only calls that are safe after fork.
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(1);
    close(numberPipe[0]);
    const int nothing = open("/dev/null", O_RDWR);
    if (nothing >= 0) {
      dup2(nothing, 0);
      dup2(nothing, 1);
      dup2(nothing, 2);
    }
    // Own group: Ctrl+C in the terminal must not take the server away before the program.
    setpgid(0, 0);
    execlp("Xvfb", "Xvfb", "-displayfd", displayFd.c_str(), "-screen", "0", screen.c_str(), "-nolisten", "tcp",
           "-noreset", "+extension", "GLX", static_cast<char*>(nullptr));
    const int reason = errno;
    [[maybe_unused]] const ssize_t written = write(errorPipe[1], &reason, sizeof reason);
    _exit(127);
  }
  close(numberPipe[1]);
  close(errorPipe[1]);
  int reason = 0;
  const bool failed = read(errorPipe[0], &reason, sizeof reason) == static_cast<ssize_t>(sizeof reason);
  close(errorPipe[0]);
  const std::string number = failed ? std::string() : readDisplayNumber(numberPipe[0]);
  close(numberPipe[0]);
  if (failed || number.empty()) {
    stop(pid);
    if (reason == ENOENT) {
      return Error{
          "Pictures without a screen need the program Xvfb, which is not installed: install the package xvfb."};
    }
    return Error{failed ? fmt::format("Xvfb could not be started: {}.", std::strerror(reason))
                        : std::string("Xvfb was started but gave no display: run 'Xvfb :99' by hand to see why.")};
  }
  std::string name = ":" + number;
  setenv("DISPLAY", name.c_str(), 1);
  setenv("QT_QPA_PLATFORM", "xcb", 1);
  unsetenv("WAYLAND_DISPLAY");
  unsetenv("XAUTHORITY");
  return std::unique_ptr<PrivateDisplay>(new PrivateDisplay(pid, std::move(name)));
}

PrivateDisplay::~PrivateDisplay() { stop(pid_); }

Result<bool> displayAnswers() {
  const char* display = std::getenv("DISPLAY");
  if (display == nullptr || *display == '\0') {
    return Error{
        "There is no screen to open a window on (DISPLAY is not set): use --offscreen FILE -o PICTURE.png instead."};
  }
  // Qt ends the process where no X server answers, so ask before Qt does. libxcb is there whenever Qt's xcb plugin is.
  void* library = dlopen("libxcb.so.1", RTLD_LAZY | RTLD_LOCAL);
  if (library == nullptr) return true;
  using Connect = void* (*)(const char*, int*);
  using HasError = int (*)(void*);
  using Disconnect = void (*)(void*);
  const auto connect = reinterpret_cast<Connect>(dlsym(library, "xcb_connect"));
  const auto hasError = reinterpret_cast<HasError>(dlsym(library, "xcb_connection_has_error"));
  const auto disconnect = reinterpret_cast<Disconnect>(dlsym(library, "xcb_disconnect"));
  bool answers = true;
  if (connect && hasError && disconnect) {
    void* connection = connect(nullptr, nullptr);
    answers = hasError(connection) == 0;
    disconnect(connection);
  }
  dlclose(library);
  if (answers) return true;
  return Error{
      fmt::format("The screen {} does not answer: start the program from a desktop session, or use --offscreen FILE "
                  "-o PICTURE.png.",
                  display)};
}

}  // namespace heft
