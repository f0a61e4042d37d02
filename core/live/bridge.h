#pragma once
// What bridges to ROS over WebSocket have in common: connecting, connecting again, samples from messages.
#include <map>
#include <string>
#include <vector>

#include "core/import/json_numbers.h"
#include "core/live/field_mapper.h"
#include "core/live/source.h"
#include "core/live/websocket.h"
#include "core/recording/clock.h"

namespace heft {

class BridgeSource : public ThreadedSource {
 public:
  /// What happens to a message of the connection; false if it is malformed.
  bool receive(const WebSocketMessage& arrived) { return message(arrived); }

 protected:
  BridgeSource(const std::string& what, std::string host, std::uint16_t port, std::string protocols,
               std::vector<std::string> jointNames, const Conventions& conventions);

  /// After each connection; may send().
  virtual void connected() = 0;
  /// False if the message is malformed.
  virtual bool message(const WebSocketMessage& message) = 0;

  bool send(const std::string& text);
  /// A sentence for the status, once.
  void note(const std::string& sentence);
  /// Numbers of a message measured at `stamp` [ns] on the sender's clock.
  void take(const std::string& topic, const std::string& type, const std::vector<std::string>& names,
            const std::vector<double>& values, std::int64_t stamp);
  /// The stamp is the one in the numbers' own header, else `fallback` [ns]; 0: when it arrives.
  void take(const std::string& topic, const std::string& type, const NamedNumbers& numbers, std::int64_t fallback);

 private:
  void run(const std::stop_token& stopping) final;
  void tellConfigured(const std::string& type, const std::vector<std::string>& names,
                      const std::vector<double>& values);
  bool talk(const std::stop_token& stopping);

  const std::string host_;
  const std::uint16_t port_;
  const std::string protocols_;
  const std::vector<std::string> jointNames_;
  const Conventions conventions_;
  std::optional<WebSocketClient> client_;
  FieldMapper mapper_;
  StampClock clock_;
  std::map<std::string, std::int64_t> lastStamp_;
  bool configuredTold_ = false;  ///< On this connection
};

}  // namespace heft
