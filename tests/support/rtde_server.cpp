#include "tests/support/rtde_server.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <map>

#include "tests/support/live_servers.h"

namespace heft::testing_support {

namespace {

std::string big(std::uint64_t bits, int bytes) {
  std::string out;
  for (int k = bytes - 1; k >= 0; --k) out += static_cast<char>(bits >> (8 * k) & 0xFF);
  return out;
}
std::string bigDouble(double value) { return big(std::bit_cast<std::uint64_t>(value), 8); }

std::string rtdePackage(char type, const std::string& content) { return big(3 + content.size(), 2) + type + content; }

const std::map<std::string, std::pair<std::string, int>> kOutputTypes = {
    {"timestamp", {"DOUBLE", 1}},        {"actual_q", {"VECTOR6D", 6}}, {"actual_qd", {"VECTOR6D", 6}},
    {"ft_raw_wrench", {"VECTOR6D", 6}},  {"payload", {"DOUBLE", 1}},    {"payload_cog", {"VECTOR3D", 3}},
    {"payload_inertia", {"VECTOR6D", 6}}};

}  // namespace

RtdeServer::RtdeServer(Options options) : options_(std::move(options)) {
  listener_ = listenOnLoopback(port_);
  thread_ = std::jthread([this](const std::stop_token& stop) { serve(stop); });
}

RtdeServer::~RtdeServer() {
  thread_.request_stop();
  thread_.join();
  drop();
  ::close(listener_);
}

void RtdeServer::serve(const std::stop_token& stop) {
  std::string waiting;
  while (!stop.stop_requested()) {
    int client = -1;
    {
      const std::lock_guard lock(mutex_);
      client = client_;
    }
    pollfd descriptor{client >= 0 ? client : listener_, POLLIN, 0};
    if (::poll(&descriptor, 1, 10) <= 0) continue;
    if (client < 0) {
      waiting.clear();
      started_ = false;
      const std::lock_guard lock(mutex_);
      client_ = ::accept(listener_, nullptr, nullptr);
      if (client_ >= 0) ++connections_;
      continue;
    }
    std::string bytes(4096, '\0');
    const auto got = ::recv(client, bytes.data(), bytes.size(), 0);
    if (got <= 0) {
      drop();
      continue;
    }
    waiting.append(bytes, 0, static_cast<std::size_t>(got));
    while (waiting.size() >= 3) {
      const auto size = static_cast<std::size_t>(static_cast<unsigned char>(waiting[0])) << 8 |
                        static_cast<unsigned char>(waiting[1]);
      if (size < 3 || waiting.size() < size) break;
      answer(waiting[2], waiting.substr(3, size - 3));
      waiting.erase(0, size);
    }
  }
}

void RtdeServer::answer(char type, const std::string& content) {
  {
    const std::lock_guard lock(mutex_);
    types_ += type;
  }
  if (type == 'V') sendBytes(rtdePackage('V', std::string(1, options_.knowsVersion2 ? '\1' : '\0')));
  if (type == 'v') sendBytes(rtdePackage('v', big(options_.majorVersion, 4) + big(12, 4) + big(0, 4) + big(0, 4)));
  if (type == 'O') sendBytes(rtdePackage('O', setUp(content)));
  if (type == 'S') {
    sendBytes(rtdePackage('S', std::string(1, '\1')));
    started_ = true;
  }
  if (type == 'P') sendBytes(rtdePackage('P', std::string(1, '\1')));
}

std::string RtdeServer::setUp(const std::string& content) {
  std::uint64_t bits = 0;
  for (int k = 0; k < 8; ++k) bits = bits << 8 | static_cast<unsigned char>(content[static_cast<std::size_t>(k)]);
  frequency_ = std::bit_cast<double>(bits);
  const std::lock_guard lock(mutex_);
  recipe_.clear();
  std::string types;
  bool whole = true;
  std::string rest = content.substr(8) + ",";
  while (!rest.empty()) {
    const auto name = rest.substr(0, rest.find(','));
    rest.erase(0, name.size() + 1);
    const bool known = kOutputTypes.contains(name) &&
                       std::find(options_.unknown.begin(), options_.unknown.end(), name) == options_.unknown.end();
    whole = whole && known;
    recipe_.push_back(name);
    types += (types.empty() ? "" : ",") + (known ? kOutputTypes.at(name).first : std::string("NOT_FOUND"));
  }
  return (whole ? '\7' : '\0') + types;
}

std::string RtdeServer::types() const {
  const std::lock_guard lock(mutex_);
  return types_;
}

void RtdeServer::sendRow(double timestamp, double first) {
  std::string content(1, '\7');
  {
    const std::lock_guard lock(mutex_);
    for (const auto& name : recipe_) {
      if (name == "timestamp") content += bigDouble(timestamp);
      if (name != "timestamp")
        for (int k = 0; k < kOutputTypes.at(name).second; ++k) content += bigDouble(first + k);
    }
  }
  sendBytes(rtdePackage('U', content));
}

void RtdeServer::sendText(const std::string& text) {
  sendBytes(rtdePackage('M', static_cast<char>(text.size()) + text + std::string("\4RTDE\3", 6)));
}

void RtdeServer::sendBytes(const std::string& bytes) {
  const std::lock_guard lock(mutex_);
  if (client_ >= 0) (void)::send(client_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
}

void RtdeServer::drop() {
  const std::lock_guard lock(mutex_);
  if (client_ >= 0) ::close(client_);
  client_ = -1;
}

}  // namespace heft::testing_support
