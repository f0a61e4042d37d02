#pragma once
// What is said and known of a cause, whatever was found of it.
#include <string_view>

namespace heft::diagnosis {

/// Causes of one family act at the same place in the signal's way and compete with each other first.
enum class Family {
  sensorZero,     ///< Adds to the readings whatever the load: offset, drift
  timing,         ///< Readings or motion late or smoothed
  dynamicGain,    ///< Makes fast forces larger or smaller than the motion says
  sensor,         ///< The sensor's gains, and what it does with a load
  geometry,       ///< Where the sensor and the arm stand
  externalForce,  ///< The world acts on the tool throughout
  load,           ///< The payload itself changes
  contact,        ///< The world acts on the tool for a while
  dataQuality,    ///< Single readings or their stamps are wrong
  convention,     ///< Frames, signs or units are mixed up
};

struct CauseInfo {
  std::string_view id{};
  Family family{};
  const char* title = "";             ///< "Readings late"; texts are English templates, said by heft::say()
  const char* check = "";             ///< What to look at on the rig
  const char* decides = "";           ///< The motion that tells it from its look-alikes
  const char* looks = "";             ///< How a difference from it looks in the plots
  std::string_view decidingMotion{};  ///< That motion's name for the coach; empty: none
  std::string_view effect{};          ///< What the simulator calls it; empty: it has none
  bool begins = false;                ///< Acts from one moment on, or may
  bool scalesWithLoad = false;        ///< Fits as well as a change of all loads by a share
  bool placesSensor = false;          ///< Means that the sensor sits elsewhere, or turned another way, than stated
  bool zeroMoves = false;             ///< A way that the zero took: each recording has another one
};

}  // namespace heft::diagnosis
