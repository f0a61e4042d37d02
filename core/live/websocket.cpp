#include "core/live/websocket.h"

#include <fmt/format.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <exception>

#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;

constexpr std::size_t kLargestMessage = 16u << 20;
constexpr double kSendPatience = 2.0;  ///< [s]

std::chrono::duration<double> inSeconds(double seconds) { return std::chrono::duration<double>(seconds); }

}  // namespace

struct WebSocketClient::Impl {
  asio::io_context context;
  beast::websocket::stream<beast::tcp_stream> stream{context};
  beast::flat_buffer buffer;
  bool connected = false;
  bool reading = false;  ///< A read is under way; it goes on over several calls of receive().
  bool arrived = false;

  /// Lets the operation under way go on for some time.
  void runFor(double seconds) {
    context.restart();
    context.run_for(std::chrono::duration_cast<std::chrono::nanoseconds>(inSeconds(seconds)));
  }

  void close() {
    connected = false;
    beast::get_lowest_layer(stream).close();
    runFor(0.1);
  }
};

WebSocketClient::WebSocketClient(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
WebSocketClient::WebSocketClient(WebSocketClient&&) noexcept = default;
WebSocketClient& WebSocketClient::operator=(WebSocketClient&&) noexcept = default;
WebSocketClient::~WebSocketClient() {
  if (!impl_) return;
  try {
    impl_->close();
  } catch (const std::exception&) {
    // A connection that cannot even be closed is gone.
  }
}

Result<WebSocketClient> WebSocketClient::connect(const std::string& host, std::uint16_t port,
                                                 const std::string& protocols, double seconds) {
  auto impl = std::make_unique<Impl>();
  auto& stream = impl->stream;
  const auto failure = [&](const std::string& why) {
    impl->close();
    return Error{heft::say("{}:{} cannot be reached over WebSocket ({}). Does the bridge run, and is the port open?",
                           printable(host), port, printable(why))};
  };
  beast::error_code code;
  asio::ip::tcp::resolver resolver(impl->context);
  const auto addresses = resolver.resolve(host, std::to_string(port), code);
  if (code) return failure(code.message());

  code = asio::error::would_block;
  beast::get_lowest_layer(stream).async_connect(addresses,
                                                [&](beast::error_code result, const asio::ip::tcp::endpoint&) {
                                                  code = result;
                                                  impl->context.stop();
                                                });
  impl->runFor(seconds);
  if (code) return failure(code == asio::error::would_block ? heft::say("no answer") : code.message());
  beast::get_lowest_layer(stream).socket().set_option(asio::ip::tcp::no_delay(true));

  stream.read_message_max(kLargestMessage);
  auto timeouts = beast::websocket::stream_base::timeout::suggested(beast::role_type::client);
  timeouts.idle_timeout = std::chrono::seconds(5);  // a cable that was pulled is noticed by an unanswered ping
  timeouts.keep_alive_pings = true;
  stream.set_option(timeouts);
  if (!protocols.empty())
    stream.set_option(beast::websocket::stream_base::decorator([protocols](beast::websocket::request_type& request) {
      request.set(beast::http::field::sec_websocket_protocol, protocols);
    }));
  code = asio::error::would_block;
  stream.async_handshake(fmt::format("{}:{}", host, port), "/", [&](beast::error_code result) {
    code = result;
    impl->context.stop();
  });
  impl->runFor(seconds);
  if (code) return failure(code == asio::error::would_block ? heft::say("no answer") : code.message());
  impl->connected = true;
  return WebSocketClient(std::move(impl));
}

std::optional<WebSocketMessage> WebSocketClient::receive(double seconds) {
  Impl& impl = *impl_;
  if (!impl.connected) return std::nullopt;
  if (!impl.reading) {
    impl.reading = true;
    impl.arrived = false;
    impl.stream.async_read(impl.buffer, [&impl](beast::error_code result, std::size_t) {
      impl.reading = false;
      impl.arrived = !result;
      if (result) impl.connected = false;
      impl.context.stop();
    });
  }
  impl.runFor(seconds);
  if (!impl.arrived) return std::nullopt;
  impl.arrived = false;
  WebSocketMessage out{beast::buffers_to_string(impl.buffer.data()), impl.stream.got_binary()};
  impl.buffer.consume(impl.buffer.size());
  return out;
}

bool WebSocketClient::send(std::string_view text) {
  Impl& impl = *impl_;
  if (!impl.connected) return false;
  bool done = false;
  bool sent = false;
  impl.stream.text(true);
  const std::string copy(text);
  impl.stream.async_write(asio::buffer(copy), [&](beast::error_code result, std::size_t) {
    done = true;
    sent = !result;
    impl.context.stop();
  });
  const auto deadline = std::chrono::steady_clock::now() + inSeconds(kSendPatience);
  while (!done && std::chrono::steady_clock::now() < deadline) impl.runFor(0.1);
  if (!done) impl.close();
  return sent;
}

bool WebSocketClient::connected() const { return impl_->connected; }

}  // namespace heft
