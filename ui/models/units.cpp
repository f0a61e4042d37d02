#include "ui/models/units.h"

#include <algorithm>
#include <cmath>

#include "ui/models/numbers.h"

namespace heft {
namespace {

constexpr double kInch = 0.0254;  ///< [m] By definition

UnitChoice& chosen() {
  static UnitChoice choice;
  return choice;
}

}  // namespace

const UnitChoice& units() { return chosen(); }

void setUnits(const UnitChoice& choice) { chosen() = choice; }

ShownUnit massUnit() {
  return units().grams ? ShownUnit{QStringLiteral("g"), 1e3, -3} : ShownUnit{QStringLiteral("kg"), 1.0, 0};
}

ShownUnit lengthUnit() {
  return units().inches ? ShownUnit{QStringLiteral("in"), 1.0 / kInch, 2} : ShownUnit{QStringLiteral("mm"), 1e3, 0};
}

ShownUnit torqueUnit() {
  return units().newtonMillimetres ? ShownUnit{QStringLiteral("N mm"), 1e3, -3}
                                   : ShownUnit{QStringLiteral("N m"), 1.0, 0};
}

ShownUnit angleUnit() {
  return units().radians ? ShownUnit{QStringLiteral("rad"), 1.0, 2} : ShownUnit{QStringLiteral("°"), 180.0 / M_PI, 0};
}

ShownUnit wrenchUnit(bool torque) { return torque ? torqueUnit() : ShownUnit{QStringLiteral("N"), 1.0, 0}; }

namespace {

QString shownText(const ShownUnit& unit, double value, int decimals) {
  return numberText(unit.scale * value, std::max(0, decimals + unit.decimals)) + QChar(' ') + unit.name;
}

}  // namespace

QString massText(double kilograms, int decimals) { return shownText(massUnit(), kilograms, decimals); }

QString torqueText(double newtonMetres, int decimals) { return shownText(torqueUnit(), newtonMetres, decimals); }

}  // namespace heft
