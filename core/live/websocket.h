#pragma once
// A WebSocket client (RFC 6455) over TCP without encryption, for bridges on one's own network.
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace heft {

struct WebSocketMessage {
  std::string bytes;
  bool binary = false;
};

/// Not safe to use from several threads at once. Messages of up to 16 MB.
class WebSocketClient {
 public:
  /// `protocols`: subprotocols offered, separated by ", ", or empty. Gives up after `seconds`.
  static Result<WebSocketClient> connect(const std::string& host, std::uint16_t port, const std::string& protocols,
                                         double seconds);
  WebSocketClient(WebSocketClient&&) noexcept;
  WebSocketClient& operator=(WebSocketClient&&) noexcept;
  ~WebSocketClient();

  /// The next message, or nothing after `seconds` or once the connection is gone: see connected().
  std::optional<WebSocketMessage> receive(double seconds);
  bool send(std::string_view text);
  bool connected() const;

 private:
  struct Impl;
  explicit WebSocketClient(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace heft
