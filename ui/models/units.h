#pragma once
// In which units numbers are shown. Files, sessions and everything inside are SI whatever is chosen here.
#include <QMetaType>
#include <QString>

namespace heft {

struct UnitChoice {
  bool grams = false;              ///< Masses in g, else kg
  bool inches = false;             ///< Lengths in inch, else mm
  bool newtonMillimetres = false;  ///< Torques in N mm, else N m
  bool radians = false;            ///< Angles in rad, else degrees

  bool operator==(const UnitChoice&) const = default;
};

/// For the whole program, like the theme. What is already shown must be rebuilt.
const UnitChoice& units();
void setUnits(const UnitChoice& choice);

/// How a quantity is shown: the SI value times `scale`, and with this many more decimals than in kg, mm, N m or
/// degrees.
struct ShownUnit {
  QString name;
  double scale = 1.0;
  int decimals = 0;
};
ShownUnit massUnit();
ShownUnit lengthUnit();
ShownUnit torqueUnit();
ShownUnit angleUnit();
/// Of forces, which are in N whatever is chosen, or of torques.
ShownUnit wrenchUnit(bool torque);

/// "0.812 kg", "812 g"; `decimals` are those in kg.
QString massText(double kilograms, int decimals);
/// "0.012 N m", "12 N mm"; `decimals` are those in N m.
QString torqueText(double newtonMetres, int decimals);

}  // namespace heft

Q_DECLARE_METATYPE(heft::UnitChoice)
