#pragma once
// The sources that Heft has; makeLiveSource() finds the right one for an address.
#include <filesystem>

#include "core/live/source.h"

namespace heft {

struct RdtSettings {
  std::string host;
  std::uint16_t port = 49152;
  double countsPerNewton = 0.0;       ///< 0: asked of the sensor (netftapi2.xml)
  double countsPerNewtonMetre = 0.0;  ///< 0: asked of the sensor
  std::uint16_t httpPort = 80;
};

/// ATI and Schunk Net F/T: asks for real-time streaming and for its end, and nothing else. The sensor serves one client
/// only: what follows a silence of one second is asked for again.
std::unique_ptr<LiveSource> makeRdtSource(const RdtSettings& settings);

/// A controller of Universal Robots over RTDE, protocol version 2: joint angles, velocities, and the wrench of the
/// flange's own sensor (ft_raw_wrench) where the controller has it. Asks for outputs and for nothing else: no input is
/// ever set up or written.
std::unique_ptr<LiveSource> makeRtdeSource(const std::string& host, std::uint16_t port);

/// JSON objects with a CSV's column names, one a datagram; nested objects are paths ("a.b[0]"). `jointNames` here and
/// below: of the arm, from base to tip, or none. `conventions`: which the samples keep, but for units that names state.
std::unique_ptr<LiveSource> makeJsonUdpSource(const std::string& host, std::uint16_t port,
                                              const std::vector<std::string>& jointNames = {},
                                              const Conventions& conventions = {});

/// Foxglove WebSocket protocol: subscribes to joint states, wrenches, poses and robot states.
std::unique_ptr<LiveSource> makeFoxgloveSource(const std::string& host, std::uint16_t port,
                                               const std::vector<std::string>& jointNames = {},
                                               const Conventions& conventions = {});

struct RosbridgeTopics {
  std::string wrench;  ///< geometry_msgs/WrenchStamped; empty: what rosapi lists
  std::string joints;  ///< sensor_msgs/JointState
};
std::unique_ptr<LiveSource> makeRosbridgeSource(const std::string& host, std::uint16_t port,
                                                const RosbridgeTopics& topics,
                                                const std::vector<std::string>& jointNames = {},
                                                const Conventions& conventions = {});

/// A recording of any kind that openRecording reads, `speed` times as fast as it was recorded; the
/// samples' times stay those of the motion, and they are in the plain form. `metaFile` may be empty: its own.
std::unique_ptr<LiveSource> makeReplaySource(const std::filesystem::path& file, double speed,
                                             const std::filesystem::path& metaFile = {});

}  // namespace heft
