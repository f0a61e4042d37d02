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
constexpr std::chrono::duration<double> kGathered{0.01};
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

/// Lets more come, but no longer than `seconds`.
void gather(double seconds) {
  if (seconds > 0.0) std::this_thread::sleep_for(std::min(kGathered, std::chrono::duration<double>(seconds)));
}

/// A UDP socket with room for what comes between two looks, whose datagrams bear the time of their arrival.
int udpSocket() {
  const int number = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const int room = 1 << 22, stamped = 1;
  ::setsockopt(number, SOL_SOCKET, SO_RCVBUF, &room, sizeof(room));
  ::setsockopt(number, SOL_SOCKET, SO_TIMESTAMPNS, &stamped, sizeof(stamped));
  return number;
}

double secondsOf(const timespec& time) {
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// When a datagram arrived by the wall clock [s], if the system says.
std::optional<double> stampOf(msghdr& message) {
  for (cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr; part = CMSG_NXTHDR(&message, part)) {
    if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_TIMESTAMPNS) continue;
    timespec arrived{};
    std::memcpy(&arrived, CMSG_DATA(part), sizeof(arrived));
    return secondsOf(arrived);
  }
  return std::nullopt;
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

/// Datagrams that one call of the system gave.
struct UdpSocket::Batch {
  static constexpr unsigned kMost = 16;
  struct alignas(cmsghdr) Stamp {
    std::array<char, CMSG_SPACE(sizeof(timespec))> bytes;
  };

  /// With what is there already.
  void fill(int socket);

  std::array<std::array<char, kLongestBlock>, kMost> bytes;
  std::array<sockaddr_storage, kMost> senders;
  std::array<Stamp, kMost> stamps;
  std::array<iovec, kMost> blocks;
  std::array<mmsghdr, kMost> messages;
  unsigned count, next;   ///< Those from `next` on are to be taken.
  double readAt, wallAt;  ///< When they were read, by hostNow() and by the wall clock [s]
};

void UdpSocket::Batch::fill(int socket) {
  for (unsigned i = 0; i < kMost; ++i) {
    blocks[i] = {bytes[i].data(), kLongestBlock};
    msghdr message{};
    message.msg_name = &senders[i];
    message.msg_namelen = sizeof(sockaddr_storage);
    message.msg_iov = &blocks[i];
    message.msg_iovlen = 1;
    message.msg_control = stamps[i].bytes.data();
    message.msg_controllen = stamps[i].bytes.size();
    messages[i] = {message, 0};
  }
  const int got = ::recvmmsg(socket, messages.data(), kMost, MSG_DONTWAIT, nullptr);
  count = static_cast<unsigned>(std::max(got, 0));  // an ICMP message that nobody listens is no datagram either
  next = 0;
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  wallAt = secondsOf(now);
  readAt = hostNow();
}

UdpSocket::UdpSocket(int number) : number_(number), batch_(std::make_unique_for_overwrite<Batch>()) {
  batch_->count = batch_->next = 0;
}
UdpSocket::UdpSocket(UdpSocket&& other) noexcept
    : number_(std::exchange(other.number_, -1)),
      batch_(std::move(other.batch_)),
      sender_(std::move(other.sender_)),
      arrival_(other.arrival_) {}
UdpSocket& UdpSocket::operator=(UdpSocket&& other) noexcept {
  std::swap(number_, other.number_);
  std::swap(batch_, other.batch_);
  std::swap(sender_, other.sender_);
  std::swap(arrival_, other.arrival_);
  return *this;
}
UdpSocket::~UdpSocket() {
  if (number_ >= 0) ::close(number_);
}

/// False where nothing came within `seconds`.
bool UdpSocket::receiveMore(double seconds) {
  // In a stream the next ones are about to come; where all places were taken, they are there.
  const bool streams = batch_->count > 0 && batch_->count < Batch::kMost;
  if (streams) gather(seconds);
  batch_->fill(number_);
  if (batch_->count == 0 && seconds > 0.0 && waitFor(number_, POLLIN, seconds)) batch_->fill(number_);
  return batch_->count > 0;
}

std::optional<std::string_view> UdpSocket::receive(double seconds) {
  Batch& batch = *batch_;
  if (batch.next == batch.count && !receiveMore(seconds)) return std::nullopt;
  const unsigned i = batch.next++;
  msghdr& message = batch.messages[i].msg_hdr;
  sender_.assign(static_cast<const char*>(message.msg_name), message.msg_namelen);
  arrival_ = batch.readAt;
  // A wall clock that was set meanwhile says nothing.
  if (const auto stamp = stampOf(message); stamp && *stamp <= batch.wallAt && *stamp > batch.wallAt - kOldest)
    arrival_ -= batch.wallAt - *stamp;
  return std::string_view(batch.bytes[i].data(), batch.messages[i].msg_len);
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
      streams_(other.streams_),
      bytes_(std::move(other.bytes_)) {}
TcpConnection& TcpConnection::operator=(TcpConnection&& other) noexcept {
  std::swap(number_, other.number_);
  std::swap(open_, other.open_);
  std::swap(streams_, other.streams_);
  std::swap(bytes_, other.bytes_);
  return *this;
}
TcpConnection::~TcpConnection() {
  if (number_ >= 0) ::close(number_);
}

std::string_view TcpConnection::receive(double seconds) {
  if (!open_) return {};
  if (streams_) gather(seconds);
  streams_ = false;
  if (!waitFor(number_, POLLIN, seconds)) return {};
  bytes_.resize(kLongestBlock);
  const auto got = ::recv(number_, bytes_.data(), bytes_.size(), 0);
  streams_ = got > 0;
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
