#pragma once
// The shapes of the Panda's links, drawn by us as smooth solids around the joint axes of the DH table.
#include <string>
#include <vector>

#include "resources/robots/panda/generator/glb.h"

namespace heft::panda_maker {

struct LinkShape {
  std::string name;  ///< "link0" to "link7", "sensor", "hand"
  std::vector<Part> parts;
};

/// All links that have a shape, in the order from base to tip.
std::vector<LinkShape> allLinks();

// The lower and the upper half of the arm, each in a source file of its own.
LinkShape baseLink();
LinkShape shoulderLink(int number);  ///< 1 and 2, which are one shape turned
LinkShape elbowLink();               ///< 3
LinkShape forearmLink();             ///< 4
LinkShape wristArmLink();            ///< 5
LinkShape headLink();                ///< 6
LinkShape flangeLink();              ///< 7
LinkShape sensorLink();
LinkShape handLink();

}  // namespace heft::panda_maker
