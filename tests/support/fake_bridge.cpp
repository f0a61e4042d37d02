#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <optional>

#include "tests/support/live_servers.h"

namespace heft::testing_support {

namespace asio = boost::asio;
namespace beast = boost::beast;
using tcp = asio::ip::tcp;
using Stream = beast::websocket::stream<tcp::socket>;

struct FakeBridge::Impl : std::enable_shared_from_this<FakeBridge::Impl> {
  FakeBridge* owner = nullptr;
  std::string protocol;
  std::function<void(FakeBridge&)> onConnect;
  OnText onText;
  asio::io_context context;
  tcp::acceptor acceptor{context, tcp::endpoint(asio::ip::address_v4::loopback(), 0)};
  std::shared_ptr<Stream> stream;
  beast::flat_buffer buffer;
  beast::http::request<beast::http::string_body> request;
  std::deque<std::pair<std::string, bool>> outgoing;
  std::atomic<int> connections = 0;
  mutable std::mutex mutex;
  std::vector<std::string> texts;
  std::string offered;

  void accept() {
    acceptor.async_accept([self = shared_from_this()](beast::error_code code, tcp::socket socket) {
      if (code) return;
      self->stream = std::make_shared<Stream>(std::move(socket));
      self->buffer.clear();
      self->outgoing.clear();
      self->request = {};
      beast::http::async_read(self->stream->next_layer(), self->buffer, self->request,
                              [self](beast::error_code failed, std::size_t) { self->shake(failed); });
      self->accept();
    });
  }

  void shake(beast::error_code code) {
    if (code) return;
    {
      const std::lock_guard lock(mutex);
      offered = std::string(request[beast::http::field::sec_websocket_protocol]);
    }
    stream->set_option(beast::websocket::stream_base::decorator([this](beast::websocket::response_type& response) {
      if (!protocol.empty()) response.set(beast::http::field::sec_websocket_protocol, protocol);
    }));
    stream->async_accept(request, [self = shared_from_this(), mine = stream](beast::error_code failed) {
      if (failed || mine != self->stream) return;
      self->buffer.clear();
      ++self->connections;
      if (self->onConnect) self->onConnect(*self->owner);
      self->read();
    });
  }

  void read() {
    stream->async_read(buffer, [self = shared_from_this(), mine = stream](beast::error_code code, std::size_t) {
      if (code || mine != self->stream) return;
      const auto text = beast::buffers_to_string(self->buffer.data());
      self->buffer.consume(self->buffer.size());
      {
        const std::lock_guard lock(self->mutex);
        self->texts.push_back(text);
      }
      if (self->onText) self->onText(*self->owner, text);
      self->read();
    });
  }

  void write() {
    stream->binary(outgoing.front().second);
    stream->async_write(asio::buffer(outgoing.front().first),
                        [self = shared_from_this(), mine = stream](beast::error_code code, std::size_t) {
                          if (code || mine != self->stream) return;
                          self->outgoing.pop_front();
                          if (!self->outgoing.empty()) self->write();
                        });
  }

  void enqueue(std::string bytes, bool binary) {
    asio::post(context, [self = shared_from_this(), text = std::move(bytes), binary] {
      if (!self->stream) return;
      self->outgoing.emplace_back(text, binary);
      if (self->outgoing.size() == 1) self->write();
    });
  }
};

FakeBridge::FakeBridge(std::string protocol, std::function<void(FakeBridge&)> onConnect, OnText onText)
    : impl_(std::make_shared<Impl>()) {
  impl_->owner = this;
  impl_->protocol = std::move(protocol);
  impl_->onConnect = std::move(onConnect);
  impl_->onText = std::move(onText);
  impl_->accept();
  thread_ = std::jthread([impl = impl_] { impl->context.run(); });
}

FakeBridge::~FakeBridge() {
  impl_->context.stop();
  thread_.join();
  impl_->stream.reset();
}

std::uint16_t FakeBridge::port() const { return impl_->acceptor.local_endpoint().port(); }
void FakeBridge::sendText(const std::string& text) { impl_->enqueue(text, false); }
void FakeBridge::sendBinary(const std::string& bytes) { impl_->enqueue(bytes, true); }
void FakeBridge::drop() {
  asio::post(impl_->context, [impl = impl_] {
    beast::error_code code;
    if (impl->stream) impl->stream->next_layer().close(code);
  });
}
void FakeBridge::dropInFrame(const std::string& bytes, std::size_t sent) {
  // RFC 6455: last fragment, binary; a length of 16 bits; no mask from a server.
  std::string frame{'\x82', '\x7e', static_cast<char>(bytes.size() >> 8), static_cast<char>(bytes.size() & 0xff)};
  frame = (frame + bytes).substr(0, sent);
  asio::post(impl_->context, [impl = impl_, frame] {
    beast::error_code code;
    if (!impl->stream) return;
    asio::write(impl->stream->next_layer(), asio::buffer(frame), code);
    impl->stream->next_layer().close(code);
  });
}
int FakeBridge::connections() const { return impl_->connections; }
std::vector<std::string> FakeBridge::texts() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->texts;
}
std::string FakeBridge::offered() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->offered;
}

}  // namespace heft::testing_support
