#pragma once
// A controller of Universal Robots as far as RTDE's outputs go, after Universal Robots' guide: for tests.
#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace heft::testing_support {

/// Listens on the loopback, for one client at a time. Sends a row of outputs when the test says so; what the client
/// sends is kept by type, so that a test can see that no input was ever set up or written.
class RtdeServer {
 public:
  struct Options {
    std::uint32_t majorVersion = 5;
    bool knowsVersion2 = true;
    std::vector<std::string> unknown;  ///< Outputs that are NOT_FOUND
  };
  explicit RtdeServer(Options options);
  ~RtdeServer();

  std::uint16_t port() const { return port_; }
  /// Types of the packages that came, one letter each, over all connections.
  std::string types() const;
  /// The frequency that was asked for [Hz].
  double frequency() const { return frequency_; }
  bool started() const { return started_; }
  int connections() const { return connections_; }

  /// One data package: `timestamp` [s], and for every other output of the recipe `first`, first + 1, ... by its place.
  void sendRow(double timestamp, double first);
  void sendBytes(const std::string& bytes);
  void sendText(const std::string& text);
  /// Breaks the connection.
  void drop();

 private:
  void serve(const std::stop_token& stop);
  void answer(char type, const std::string& content);
  std::string setUp(const std::string& content);

  Options options_;
  int listener_ = -1;
  std::uint16_t port_ = 0;
  mutable std::mutex mutex_;
  int client_ = -1;
  std::string types_;
  std::vector<std::string> recipe_;
  std::atomic<double> frequency_ = 0.0;
  std::atomic<bool> started_ = false;
  std::atomic<int> connections_ = 0;
  std::jthread thread_;
};

}  // namespace heft::testing_support
