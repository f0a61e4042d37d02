#include "tests/support/live_servers.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>

#include "core/live/network.h"

namespace heft::testing_support {

struct FakeNetFt::Impl {
  UdpSocket socket = UdpSocket::listening("127.0.0.1", 0).value();
  mutable std::mutex mutex;
  std::vector<std::string> requests;
  std::jthread thread;
};

FakeNetFt::FakeNetFt() : impl_(std::make_unique<Impl>()) {
  impl_->thread = std::jthread([impl = impl_.get()](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      {
        // The lock also covers the sender's address, which receive() changes.
        const std::lock_guard lock(impl->mutex);
        if (auto bytes = impl->socket.receive(0.0)) impl->requests.emplace_back(*bytes);
      }
      std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
  });
}
FakeNetFt::~FakeNetFt() = default;

std::uint16_t FakeNetFt::port() const { return impl_->socket.port(); }

std::vector<std::string> FakeNetFt::requests() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->requests;
}

void FakeNetFt::send(const std::string& bytes) {
  const std::lock_guard lock(impl_->mutex);
  impl_->socket.reply(bytes);
}

std::string rdtRecord(std::uint32_t sequence, std::uint32_t status, const std::vector<std::int32_t>& counts) {
  std::string out;
  const auto put = [&](std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(value >> shift & 0xFF);
  };
  put(sequence);
  put(sequence * 7);
  put(status);
  for (const auto count : counts) put(static_cast<std::uint32_t>(count));
  return out;
}

int listenOnLoopback(std::uint16_t& port) {
  const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof(address);
  if (::bind(listener, reinterpret_cast<sockaddr*>(&address), length) == 0 && ::listen(listener, 4) == 0 &&
      ::getsockname(listener, reinterpret_cast<sockaddr*>(&address), &length) == 0)
    port = ntohs(address.sin_port);
  return listener;
}

FakeWebPage::FakeWebPage(std::string page) : page_(std::move(page)) {
  listener_ = listenOnLoopback(port_);
  thread_ = std::jthread([this](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      pollfd descriptor{listener_, POLLIN, 0};
      if (::poll(&descriptor, 1, 20) <= 0) continue;
      const int client = ::accept(listener_, nullptr, nullptr);
      if (client < 0) continue;
      std::string request(2048, '\0');
      (void)::recv(client, request.data(), request.size(), 0);
      const std::string answer = "HTTP/1.0 200 OK\r\nContent-Type: text/xml\r\n\r\n" + page_;
      (void)::send(client, answer.data(), answer.size(), MSG_NOSIGNAL);
      ::close(client);
    }
  });
}

FakeWebPage::~FakeWebPage() {
  thread_.request_stop();
  thread_.join();
  ::close(listener_);
}

bool eventually(const std::function<bool()>& done) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!done()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

}  // namespace heft::testing_support
