#pragma once
// Devices and bridges for tests of live sources: on the loopback alone, any free port.
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace heft::testing_support {

/// A Net F/T as far as RDT goes: keeps what it is asked, sends what the test says.
class FakeNetFt {
 public:
  FakeNetFt();
  ~FakeNetFt();
  std::uint16_t port() const;
  /// Requests so far, byte by byte.
  std::vector<std::string> requests() const;
  /// To the client that asked last.
  void send(const std::string& bytes);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// One RDT record from the specification: big-endian numbers.
std::string rdtRecord(std::uint32_t sequence, std::uint32_t status, const std::vector<std::int32_t>& counts);

/// A listening TCP socket on any free port of the loopback, which is put into `port`; the caller closes it.
int listenOnLoopback(std::uint16_t& port);

/// Answers every HTTP request with one page.
class FakeWebPage {
 public:
  explicit FakeWebPage(std::string page);
  ~FakeWebPage();
  std::uint16_t port() const { return port_; }

 private:
  std::string page_;
  int listener_ = -1;
  std::uint16_t port_ = 0;
  std::jthread thread_;
};

/// A WebSocket server for one client at a time.
class FakeBridge {
 public:
  using OnText = std::function<void(FakeBridge&, const std::string&)>;
  /// `protocol`: the subprotocol that it chooses; `onConnect` and `onText` run in the server's thread.
  FakeBridge(std::string protocol, std::function<void(FakeBridge&)> onConnect, OnText onText);
  ~FakeBridge();
  std::uint16_t port() const;
  void sendText(const std::string& text);
  void sendBinary(const std::string& bytes);
  /// Breaks the connection without a word.
  void drop();
  /// Breaks it after the first `sent` bytes of the frame that would carry `bytes` as a binary message.
  void dropInFrame(const std::string& bytes, std::size_t sent);
  int connections() const;
  std::vector<std::string> texts() const;  ///< Received so far.
  std::string offered() const;             ///< Subprotocols that the client offered last.

 private:
  struct Impl;
  std::shared_ptr<Impl> impl_;
  std::jthread thread_;
};

/// Waits up to ten seconds until `done` holds.
bool eventually(const std::function<bool()>& done);

}  // namespace heft::testing_support
