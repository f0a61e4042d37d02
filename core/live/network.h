#pragma once
// Sockets that can be left at any time.
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace heft {

/// UDP over IPv4. Movable.
class UdpSocket {
 public:
  /// Receives what is sent to `host`:`port` of this machine; port 0 takes any free one.
  static Result<UdpSocket> listening(const std::string& host, std::uint16_t port);
  /// Exchanges datagrams with one other address; those of others are not received.
  static Result<UdpSocket> connected(const std::string& host, std::uint16_t port);

  UdpSocket(UdpSocket&& other) noexcept;
  UdpSocket& operator=(UdpSocket&& other) noexcept;
  ~UdpSocket();

  /// One datagram, or nothing after `seconds`; valid until the next call. Longer ones than 64 KB cannot be. In a stream
  /// it comes up to ten milliseconds late, together with those that follow it: see arrival().
  std::optional<std::string_view> receive(double seconds);
  /// When the datagram received last reached this machine, in the time of hostNow() [s].
  double arrival() const { return arrival_; }
  bool send(std::string_view bytes);
  /// To whoever sent the datagram received last.
  bool reply(std::string_view bytes);
  std::uint16_t port() const;

 private:
  struct Batch;
  explicit UdpSocket(int number);
  bool receiveMore(double seconds);

  int number_ = -1;
  std::unique_ptr<Batch> batch_;
  std::string sender_;    ///< Of the datagram received last: its socket address
  double arrival_ = 0.0;  ///< [s] Of the datagram received last
};

/// A connection over TCP and IPv4. Movable.
class TcpConnection {
 public:
  /// Gives up after `seconds`.
  static Result<TcpConnection> connect(const std::string& host, std::uint16_t port, double seconds);

  TcpConnection(TcpConnection&& other) noexcept;
  TcpConnection& operator=(TcpConnection&& other) noexcept;
  ~TcpConnection();

  /// What has come, at most 64 KB; empty after `seconds` or once the connection is gone: see open(). Valid until the
  /// next call. In a stream it comes up to ten milliseconds late, together with what follows.
  std::string_view receive(double seconds);
  bool send(std::string_view bytes);
  bool open() const { return open_; }

 private:
  explicit TcpConnection(int number) : number_(number) {}
  int number_ = -1;
  bool open_ = true;
  bool streams_ = false;  ///< Something came when it was asked last.
  std::string bytes_;     ///< Received last.
};

/// The body of http://host:port/path, at most 1 MB, within two seconds.
Result<std::string> httpGet(const std::string& host, std::uint16_t port, const std::string& path);

}  // namespace heft
