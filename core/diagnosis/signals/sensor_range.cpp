#include "core/diagnosis/signals/sensor_range.h"

#include <array>
#include <cctype>
#include <string>

namespace heft::diagnosis {

namespace {

struct Range {
  std::string_view family, calibration;  ///< As plain() has them; no calibration: of the family as such
  double forceXy, forceZ;                ///< [N]
  double torqueXy, torqueZ;              ///< [N m]
};

/// Of a family the calibrations come first, then the family as such with the largest of them. Sources: ATI Industrial
/// Automation, F/T Transducer Manual 9620-05-Transducer Section (calibration ranges of Nano17, Mini40, Mini45, Gamma,
/// Delta) and Ethernet Axia manual 9610-05 (Axia80, calibration range 0); Robotiq, FT 300 manual, specifications;
/// OnRobot, HEX-E QC and HEX-H QC data sheets, nominal capacity.
constexpr std::array kRanges{
    Range{"nano17", "si120.12", 12.0, 17.0, 0.12, 0.12}, Range{"nano17", "si250.25", 25.0, 35.0, 0.25, 0.25},
    Range{"nano17", "", 50.0, 70.0, 0.5, 0.5},           Range{"mini40", "si201", 20.0, 60.0, 1.0, 1.0},
    Range{"mini40", "si402", 40.0, 120.0, 2.0, 2.0},     Range{"mini40", "", 80.0, 240.0, 4.0, 4.0},
    Range{"mini45", "si1455", 145.0, 290.0, 5.0, 5.0},   Range{"mini45", "si29010", 290.0, 580.0, 10.0, 10.0},
    Range{"mini45", "", 580.0, 1160.0, 20.0, 20.0},      Range{"gamma", "si322.5", 32.0, 100.0, 2.5, 2.5},
    Range{"gamma", "si655", 65.0, 200.0, 5.0, 5.0},      Range{"gamma", "", 130.0, 400.0, 10.0, 10.0},
    Range{"delta", "si16515", 165.0, 495.0, 15.0, 15.0}, Range{"delta", "si33030", 330.0, 990.0, 30.0, 30.0},
    Range{"delta", "", 660.0, 1980.0, 60.0, 60.0},       Range{"axia80", "m8", 150.0, 470.0, 8.0, 8.0},
    Range{"axia80", "", 500.0, 900.0, 20.0, 20.0},       Range{"ft300", "", 300.0, 300.0, 30.0, 30.0},
    Range{"hexe", "", 200.0, 200.0, 10.0, 6.5},          Range{"hexh", "", 200.0, 200.0, 20.0, 13.0}};

/// Small letters, digits and points.
std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.')
      out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

}  // namespace

std::optional<Vector6d> sensorRange(std::string_view model) {
  const std::string name = plain(model);
  for (const Range& range : kRanges) {
    if (name.find(range.family) == std::string::npos || name.find(range.calibration) == std::string::npos) continue;
    Vector6d out;
    out << range.forceXy, range.forceXy, range.forceZ, range.torqueXy, range.torqueXy, range.torqueZ;
    return out;
  }
  return std::nullopt;
}

}  // namespace heft::diagnosis
