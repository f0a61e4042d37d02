#include "core/live/network.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <ctime>
#include <memory>
#include <thread>
#include <utility>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/live/source.h"

namespace heft {

namespace {

constexpr std::size_t kLargestBody = 1u << 20;
constexpr std::size_t kLongestBlock = 1u << 16;  ///< That is received at once; no datagram is longer.
/// Between two looks at a stream. To wake up for each datagram took a third of what `heft live` took at 1 kHz; nobody
/// sees the delay, and the smallest buffer that Linux gives (208 kB) takes what comes in 100 ms.
constexpr std::chrono::milliseconds kGathered{10};
constexpr double kOldest = 10.0;  ///< [s] No datagram waits longer.

using Addresses = std::unique_ptr<addrinfo, void (*)(addrinfo*)>;

Addresses resolve(const std::string& host, std::uint16_t port, int type) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = type;
  addrinfo* found = nullptr;
  if (::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) found = nullptr;
  return {found, &::freeaddrinfo};
}

Error unreachable(const std::string& host, std::uint16_t port, const std::string& what) {
  return Error{heft::say("{}:{} {}. Check the name, the cable and the firewall.", printable(host), port, what)};
}

/// True if the socket becomes ready in time.
bool waitFor(int number, short events, double seconds) {
  pollfd descriptor{number, events, 0};
  const int milliseconds = static_cast<int>(std::ceil(1000.0 * std::max(seconds, 0.0)));
  return ::poll(&descriptor, 1, milliseconds) > 0 && (descriptor.revents & (events | POLLERR | POLLHUP)) != 0;
}

/// A UDP socket with room for what comes between two looks, whose datagrams bear the time of their arrival.
int udpSocket() {
  const int number = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const int room = 1 << 22, stamped = 1;
  ::setsockopt(number, SOL_SOCKET, SO_RCVBUF, &room, sizeof(room));
  ::setsockopt(number, SOL_SOCKET, SO_TIMESTAMPNS, &stamped, sizeof(stamped));
  return number;
}

/// How long ago a datagram arrived [s]; 0 where the system does not say.
double ageOf(msghdr& message) {
  for (cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr; part = CMSG_NXTHDR(&message, part)) {
    if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_TIMESTAMPNS) continue;
    timespec arrived{}, now{};
    std::memcpy(&arrived, CMSG_DATA(part), sizeof(arrived));
    ::clock_gettime(CLOCK_REALTIME, &now);
    const double age =
        static_cast<double>(now.tv_sec - arrived.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec - arrived.tv_nsec);
    // A wall clock that was set meanwhile says nothing.
    return age >= 0.0 && age < kOldest ? age : 0.0;
  }
  return 0.0;
}

}  // namespace

Result<UdpSocket> UdpSocket::listening(const std::string& host, std::uint16_t port) {
  const auto addresses = resolve(host, port, SOCK_DGRAM);
  if (!addresses) return unreachable(host, port, heft::say("is not an address of this machine"));
  UdpSocket out(udpSocket());
  if (out.number_ < 0 || ::bind(out.number_, addresses->ai_addr, addresses->ai_addrlen) != 0)
    return Error{
        heft::say("Port {} of {} cannot be opened; does another program listen there?", port, printable(host))};
  return out;
}

Result<UdpSocket> UdpSocket::connected(const std::string& host, std::uint16_t port) {
  const auto addresses = resolve(host, port, SOCK_DGRAM);
  if (!addresses) return unreachable(host, port, heft::say("cannot be found"));
  UdpSocket out(udpSocket());
  if (out.number_ < 0 || ::connect(out.number_, addresses->ai_addr, addresses->ai_addrlen) != 0)
    return unreachable(host, port, heft::say("cannot be reached"));
  return out;
}

UdpSocket::UdpSocket(UdpSocket&& other) noexcept
    : number_(std::exchange(other.number_, -1)),
      sender_(std::move(other.sender_)),
      bytes_(std::move(other.bytes_)),
      arrival_(other.arrival_),
      timeout_(other.timeout_),
      streaming_(other.streaming_) {}
UdpSocket& UdpSocket::operator=(UdpSocket&& other) noexcept {
  std::swap(number_, other.number_);
  std::swap(sender_, other.sender_);
  std::swap(bytes_, other.bytes_);
  std::swap(arrival_, other.arrival_);
  std::swap(timeout_, other.timeout_);
  std::swap(streaming_, other.streaming_);
  return *this;
}
UdpSocket::~UdpSocket() {
  if (number_ >= 0) ::close(number_);
}

std::optional<std::string_view> UdpSocket::take(int flags) {
  bytes_.resize(kLongestBlock);
  sockaddr_storage from{};
  iovec block{bytes_.data(), bytes_.size()};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(timespec))> stamp{};
  msghdr message{};
  message.msg_name = &from;
  message.msg_namelen = sizeof(from);
  message.msg_iov = &block;
  message.msg_iovlen = 1;
  message.msg_control = stamp.data();
  message.msg_controllen = stamp.size();
  const auto got = ::recvmsg(number_, &message, flags);
  if (got < 0) return std::nullopt;  // an ICMP message that nobody listens is no datagram either
  sender_.assign(reinterpret_cast<const char*>(&from), message.msg_namelen);
  arrival_ = hostNow() - ageOf(message);
  return std::string_view(bytes_).substr(0, static_cast<std::size_t>(got));
}

std::optional<std::string_view> UdpSocket::receive(double seconds) {
  auto bytes = take(MSG_DONTWAIT);
  if (!bytes && streaming_ && seconds > 0.0) {
    streaming_ = false;
    std::this_thread::sleep_for(
        std::min<std::chrono::duration<double>>(kGathered, std::chrono::duration<double>(seconds)));
    bytes = take(MSG_DONTWAIT);
  }
  if (!bytes && seconds > 0.0) {
    if (seconds != timeout_) {
      timeval wait{};
      wait.tv_sec = static_cast<time_t>(seconds);
      wait.tv_usec = std::max<suseconds_t>(1, static_cast<suseconds_t>(1e6 * (seconds - std::floor(seconds))));
      if (::setsockopt(number_, SOL_SOCKET, SO_RCVTIMEO, &wait, sizeof(wait)) == 0)
        timeout_ = seconds;
      else if (!waitFor(number_, POLLIN, seconds))
        return std::nullopt;
    }
    bytes = take(0);
  }
  streaming_ = streaming_ || bytes;
  return bytes;
}

bool UdpSocket::send(std::string_view bytes) {
  return ::send(number_, bytes.data(), bytes.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(bytes.size());
}

bool UdpSocket::reply(std::string_view bytes) {
  if (sender_.empty()) return false;
  return ::sendto(number_, bytes.data(), bytes.size(), MSG_NOSIGNAL, reinterpret_cast<const sockaddr*>(sender_.data()),
                  static_cast<socklen_t>(sender_.size())) == static_cast<ssize_t>(bytes.size());
}

std::uint16_t UdpSocket::port() const {
  sockaddr_in address{};
  socklen_t length = sizeof(address);
  if (::getsockname(number_, reinterpret_cast<sockaddr*>(&address), &length) != 0) return 0;
  return ntohs(address.sin_port);
}

Result<TcpConnection> TcpConnection::connect(const std::string& host, std::uint16_t port, double seconds) {
  const auto addresses = resolve(host, port, SOCK_STREAM);
  if (!addresses) return unreachable(host, port, heft::say("cannot be found"));
  TcpConnection out(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (out.number_ < 0) return unreachable(host, port, heft::say("cannot be reached"));
  if (::connect(out.number_, addresses->ai_addr, addresses->ai_addrlen) == 0) return out;
  int failure = errno;
  socklen_t length = sizeof(failure);
  if (failure == EINPROGRESS && waitFor(out.number_, POLLOUT, seconds))
    ::getsockopt(out.number_, SOL_SOCKET, SO_ERROR, &failure, &length);
  if (failure != 0) return unreachable(host, port, heft::say("cannot be reached"));
  return out;
}

TcpConnection::TcpConnection(TcpConnection&& other) noexcept
    : number_(std::exchange(other.number_, -1)),
      open_(std::exchange(other.open_, false)),
      bytes_(std::move(other.bytes_)) {}
TcpConnection& TcpConnection::operator=(TcpConnection&& other) noexcept {
  std::swap(number_, other.number_);
  std::swap(open_, other.open_);
  std::swap(bytes_, other.bytes_);
  return *this;
}
TcpConnection::~TcpConnection() {
  if (number_ >= 0) ::close(number_);
}

std::string_view TcpConnection::receive(double seconds) {
  if (!open_ || !waitFor(number_, POLLIN, seconds)) return {};
  bytes_.resize(kLongestBlock);
  const auto got = ::recv(number_, bytes_.data(), bytes_.size(), 0);
  if (got == 0 || (got < 0 && errno != EAGAIN && errno != EINTR)) open_ = false;
  return std::string_view(bytes_).substr(0, got > 0 ? static_cast<std::size_t>(got) : 0);
}

bool TcpConnection::send(std::string_view bytes) {
  while (open_ && !bytes.empty()) {
    const auto sent = ::send(number_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    } else if (sent < 0 && errno == EAGAIN && waitFor(number_, POLLOUT, 1.0)) {
      continue;
    } else {
      open_ = false;
    }
  }
  return open_;
}

Result<std::string> httpGet(const std::string& host, std::uint16_t port, const std::string& path) {
  const double deadline = hostNow() + 2.0;
  const auto addresses = resolve(host, port, SOCK_STREAM);
  if (!addresses) return unreachable(host, port, heft::say("cannot be found"));
  struct Closer {
    int number;
    ~Closer() {
      if (number >= 0) ::close(number);
    }
  } const socket{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)};
  if (socket.number < 0) return unreachable(host, port, heft::say("cannot be reached"));
  if (::connect(socket.number, addresses->ai_addr, addresses->ai_addrlen) != 0) {
    int failure = errno;
    socklen_t length = sizeof(failure);
    if (failure == EINPROGRESS && waitFor(socket.number, POLLOUT, deadline - hostNow()))
      ::getsockopt(socket.number, SOL_SOCKET, SO_ERROR, &failure, &length);
    if (failure != 0) return unreachable(host, port, heft::say("does not answer over HTTP"));
  }
  const std::string request = fmt::format("GET {} HTTP/1.0\r\nHost: {}\r\nConnection: close\r\n\r\n", path, host);
  if (::send(socket.number, request.data(), request.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(request.size()))
    return unreachable(host, port, heft::say("does not answer over HTTP"));
  std::string answer;
  std::string block(4096, '\0');
  while (answer.size() < kLargestBody && waitFor(socket.number, POLLIN, deadline - hostNow())) {
    const auto got = ::recv(socket.number, block.data(), block.size(), 0);
    if (got <= 0) break;
    answer.append(block, 0, static_cast<std::size_t>(got));
  }
  const auto body = answer.find("\r\n\r\n");
  const auto status = answer.substr(0, answer.find("\r\n"));
  if (body == std::string::npos || status.find(" 200") == std::string::npos)
    return Error{heft::say("http://{}:{}{} does not answer as expected (\"{}\").", printable(host), port, path,
                           printable(status))};
  return answer.substr(body + 4);
}

}  // namespace heft
