#include "core/import/own_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/base/said_again.h"
#include "core/base/say.h"
#include "core/base/stop.h"
#include "core/base/text.h"

namespace heft {

namespace {

using nlohmann::json;

/// What the copy sends: a kind, the length of a head (CBOR), the head, and after a result the numbers of its streams.
enum class Message : std::uint8_t { progress = 1, result, error };

/// A text with what it was made of, for a reader of another language.
json textToJson(const std::string& text) { return {{"text", text}, {"making", makingOf(text)}}; }
std::string textFromJson(const json& said) { return sayFrom(said.at("making"), said.at("text").get<std::string>()); }

/// The end of the pipe in the copy, which ends where nobody reads.
class Sender {
 public:
  explicit Sender(int file) : file_(file) {}

  void head(Message kind, const json& head) const {
    const auto bytes = json::to_cbor(head);
    const std::uint64_t length = bytes.size();
    send(&kind, sizeof kind);
    send(&length, sizeof length);
    send(bytes.data(), bytes.size());
  }
  template <class T>
  void numbers(const std::vector<T>& values) const {
    const std::uint64_t count = values.size();
    send(&count, sizeof count);
    send(values.data(), values.size() * sizeof(T));
  }

 private:
  void send(const void* data, std::size_t count) const {
    for (const auto* at = static_cast<const char*>(data); count > 0;) {
      const ssize_t sent = ::write(file_, at, count);
      if (sent < 0 && errno == EINTR) continue;
      if (sent <= 0) ::_exit(1);
      at += sent;
      count -= static_cast<std::size_t>(sent);
    }
  }
  int file_;
};

/// The end of the pipe in this process. Throws Broken where the copy has ended, Stopped where the user asked for it.
class Receiver {
 public:
  struct Broken {};

  Receiver(int file, const Progress& progress) : file_(file), progress_(progress) {}

  Message kind() const {
    Message out{};
    receive(&out, sizeof out);
    return out;
  }
  json head() const {
    std::vector<std::uint8_t> bytes(count(kMostOfHead));
    receive(bytes.data(), bytes.size());
    return json::from_cbor(bytes);
  }
  template <class T>
  void numbers(std::vector<T>& out) const {
    out.resize(count(kMaxStreamNumbers));
    receive(out.data(), out.size() * sizeof(T));
  }

 private:
  static constexpr std::uint64_t kMostOfHead = 1 << 28;  // [bytes]
  static constexpr int kLooksAgain = 50;                 // [ms] Whether to stop

  std::uint64_t count(std::uint64_t most) const {
    std::uint64_t out = 0;
    receive(&out, sizeof out);
    if (out > most) throw Broken{};
    return out;
  }
  void receive(void* data, std::size_t count) const {
    for (auto* at = static_cast<char*>(data); count > 0;) {
      if (progress_.cancelled()) throw Stopped{};
      pollfd ready{file_, POLLIN, 0};
      if (::poll(&ready, 1, kLooksAgain) <= 0) continue;
      const ssize_t got = ::read(file_, at, count);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) throw Broken{};
      at += got;
      count -= static_cast<std::size_t>(got);
    }
  }
  int file_;
  const Progress& progress_;
};

json headOf(const StreamSet& set) {
  json findings = json::array(), streams = json::array();
  for (const Finding& each : set.findings)
    findings.push_back({{"severity", each.severity},
                        {"code", each.code},
                        {"text", textToJson(each.text)},
                        {"remedy", textToJson(each.remedy)},
                        {"file", each.where.file},
                        {"line", each.where.line},
                        {"column", each.where.column}});
  for (const Stream& each : set.streams)
    streams.push_back({{"name", each.name},
                       {"type", each.type},
                       {"file", each.file},
                       {"samples", each.samples},
                       {"first", each.first},
                       {"last", each.last},
                       {"fields", each.fields},
                       {"clockless", each.clockless},
                       {"senders", each.senders},
                       {"values", each.values.size()}});
  return {{"file", set.file},
          {"kind", set.kind},
          {"time_candidates", set.timeCandidates},
          {"findings", std::move(findings)},
          {"streams", std::move(streams)}};
}

void send(const StreamSet& set, const Sender& sender) {
  sender.head(Message::result, headOf(set));
  for (const Stream& each : set.streams) {
    sender.numbers(each.received);
    sender.numbers(each.stamps);
    for (const auto& values : each.values) sender.numbers(values);
    sender.numbers(each.sender);
  }
}

StreamSet received(const Receiver& receiver) {
  const json head = receiver.head();
  StreamSet set;
  set.file = head.at("file").get<std::string>();
  set.kind = head.at("kind").get<FileKind>();
  set.timeCandidates = head.at("time_candidates").get<std::vector<std::string>>();
  for (const json& each : head.at("findings"))
    set.findings.push_back(
        {each.at("severity").get<Severity>(),
         each.at("code").get<std::string>(),
         textFromJson(each.at("text")),
         textFromJson(each.at("remedy")),
         {each.at("file").get<std::string>(), each.at("line").get<long>(), each.at("column").get<long>()}});
  for (const json& each : head.at("streams")) {
    Stream& stream = set.streams.emplace_back();
    stream.name = each.at("name").get<std::string>();
    stream.type = each.at("type").get<std::string>();
    stream.file = each.at("file").get<std::string>();
    stream.samples = each.at("samples").get<std::size_t>();
    stream.first = each.at("first").get<std::int64_t>();
    stream.last = each.at("last").get<std::int64_t>();
    stream.fields = each.at("fields").get<std::vector<std::string>>();
    stream.clockless = each.at("clockless").get<bool>();
    stream.senders = each.at("senders").get<std::vector<std::string>>();
    receiver.numbers(stream.received);
    receiver.numbers(stream.stamps);
    stream.values.resize(std::min(each.at("values").get<std::size_t>(), kMaxStreamNumbers));
    for (auto& values : stream.values) receiver.numbers(values);
    receiver.numbers(stream.sender);
  }
  return set;
}

/// The copy's life. Nothing of the program's own runs at its end.
[[noreturn]] void readAndSend(int file, const StreamReader& read) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGINT, SIGTERM, SIGHUP, SIGPIPE})
    ::signal(signal, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  constexpr std::size_t kSentences = 4096;  // More than one file's findings
  setTranslator({});                        // The window's translations may be in another thread's hands
  rememberSentences(kSentences);
  try {
    const Sender sender(file);
    Progress progress;
    progress.report = [&](double fraction, std::string_view what) {
      sender.head(Message::progress, {{"fraction", fraction}, {"what", textToJson(std::string(what))}});
    };
    const auto result = read(progress);
    if (result)
      send(*result, sender);
    else
      sender.head(Message::error, textToJson(result.error().message));
  } catch (...) {  // As a crash: the other side is told nothing
  }
  ::_exit(0);
}

Result<StreamSet> listen(const Receiver& receiver, const Progress& progress) {
  for (;;) {
    switch (receiver.kind()) {
      case Message::progress: {
        const json head = receiver.head();
        progress(head.at("fraction").get<double>(), textFromJson(head.at("what")));
        continue;
      }
      case Message::result:
        return received(receiver);
      case Message::error:
        return Error{textFromJson(receiver.head())};
    }
    throw Receiver::Broken{};
  }
}

}  // namespace

Result<StreamSet> readInOwnProcess(const std::filesystem::path& path, const StreamReader& read,
                                   const Progress& progress) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return errorAt({displayName(path), 0, 0}, std::strerror(errno));
  const pid_t copy = ::fork();
  if (copy == 0) {
    ::close(ends[0]);
    readAndSend(ends[1], read);
  }
  const int failure = errno;
  ::close(ends[1]);
  if (copy < 0) {
    ::close(ends[0]);
    return errorAt({displayName(path), 0, 0}, std::strerror(failure));
  }
  auto out = [&]() -> Result<StreamSet> {
    try {
      return listen(Receiver(ends[0], progress), progress);
    } catch (const Stopped&) {
      return Error{heft::say("Reading was stopped."), true};
    } catch (const Receiver::Broken&) {
    } catch (const json::exception&) {
    }
    return errorAt({displayName(path), 0, 0},
                   heft::say("the file is damaged: the library that reads files of this kind crashed on it."),
                   heft::say("Copy it again from where it was recorded, or save it again there."));
  }();
  ::kill(copy, SIGKILL);
  while (::waitpid(copy, nullptr, 0) < 0 && errno == EINTR) {
  }
  ::close(ends[0]);
  return out;
}

}  // namespace heft
