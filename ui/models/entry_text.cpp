#include "ui/models/entry_text.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "ui/models/numbers.h"
#include "ui/models/said_now.h"
#include "ui/models/units.h"

namespace heft {
namespace {

struct EntryWords {
  Q_DECLARE_TR_FUNCTIONS(Entry)
};

constexpr double kInterval = 1.96;    // Standard deviations of a 95 % interval
constexpr double kVisible = 0.05e-3;  // [m] The least sag that is mentioned

QString newtons(double force) { return EntryWords::tr("%1 N").arg(numberText(force, force < 10.0 ? 1 : 0)); }

/// "2.94 ± 0.02", in decimals that the interval leaves meaningful.
QString withInterval(double value, double std) {
  const double half = kInterval * std;
  const int decimals = decimalsFor(half, 4);
  return QStringLiteral("%1 ± %2").arg(numberText(value, decimals), numberText(half, decimals));
}

QString percentOf(double share) { return EntryWords::tr("%1 %").arg(numberText(100.0 * share, share < 0.1 ? 1 : 0)); }

/// What is left of a threshold for touches with and against the phantom.
QString collisions(const EntryCost& cost, const ControllerLimits& limits) {
  const bool byTorque = cost.torqueShare > cost.forceShare;
  const double phantom = byTorque ? cost.torque : cost.force;
  const double limit = byTorque ? limits.collisionTorque : limits.collisionForce;
  const auto size = [&](double value) {
    return byTorque ? EntryWords::tr("%1 N m").arg(numberText(value, 1)) : newtons(value);
  };
  if (cost.share() >= 1.0)
    return EntryWords::tr("That is more than the collision threshold of %1: the arm stops although nothing touches it.")
        .arg(size(limit));
  return EntryWords::tr("A push along it stops the arm at %1 instead of %2, a push against it only at %3.")
      .arg(size(limit - phantom), size(limit), size(limit + phantom));
}

QString sagging(const EntryCost& cost, const ControllerLimits& limits) {
  if (std::abs(cost.sag) < kVisible) return {};
  const ShownUnit unit = lengthUnit();
  const QString by =
      QStringLiteral("%1 %2").arg(numberText(unit.scale * std::abs(cost.sag), 1 + unit.decimals), unit.name);
  const QString stiffness = numberText(limits.stiffness, 0);
  return cost.sag > 0.0
             ? EntryWords::tr("With a stiffness of %1 N/m it sinks by %2 when it stands still.").arg(stiffness, by)
             : EntryWords::tr("With a stiffness of %1 N/m it rises by %2 when it stands still.").arg(stiffness, by);
}

std::vector<DetailText> rowsOf(const EntryCost& cost) {
  std::vector<DetailText> out;
  out.push_back(
      {EntryWords::tr("Weight: set, estimated"),
       QStringLiteral("%1, %2").arg(massText(cost.told.mass, 3), massText(cost.actual.mass, 3)),
       EntryWords::tr("Everything beyond the flange: the tool, and what you listed under Export as mounted")});
  if (cost.centreTold && cost.told.mass > 0.0) {
    const ShownUnit unit = lengthUnit();
    out.push_back({EntryWords::tr("Centre off by"),
                   QStringLiteral("%1 %2").arg(
                       numberText(unit.scale * (cost.told.com - cost.actual.com).norm(), 1 + unit.decimals), unit.name),
                   EntryWords::tr("Distance between the two centres of mass")});
  }
  out.push_back(
      {EntryWords::tr("Phantom force"),
       EntryWords::tr("%1 N, %2 of the limit").arg(withInterval(cost.force, cost.forceStd), percentOf(cost.forceShare)),
       EntryWords::tr("For 99 % of this motion it is not larger. The limit is the collision threshold.")});
  ShownUnit unit = torqueUnit();
  unit.name.replace(' ', QChar::Nbsp);  // It stands in one line.
  out.push_back(
      {EntryWords::tr("Phantom torque"),
       EntryWords::tr("%1 %2, %3 of the limit")
           .arg(withInterval(unit.scale * cost.torque, unit.scale * cost.torqueStd), unit.name,
                percentOf(cost.torqueShare)),
       EntryWords::tr(
           "About the flange; for 99 % of this motion it is not larger. The limit is the collision threshold.")});
  return out;
}

}  // namespace

EntryText describeEntry(const EntryCost& cost, const ControllerLimits& limits) {
  EntryText out;
  out.rows = rowsOf(cost);
  QStringList missing;
  if (!cost.centreTold) missing << EntryWords::tr("No centre of mass is set, so the estimated one is used.");
  if (!cost.inertiaTold) missing << EntryWords::tr("No inertia is set, so the estimated one is used.");
  if (!cost.centreTold && !cost.inertiaTold)
    missing = QStringList{EntryWords::tr("No centre of mass and no inertia are set, so the estimated ones are used.")};
  for (const Finding& finding : cost.findings) missing << saidNow(finding.text + " " + finding.remedy).trimmed();
  out.note = missing.join(' ');
  if (!cost.differs) {
    out.headline = EntryWords::tr("The entry agrees with this recording.");
    out.consequence = EntryWords::tr("The differences are within the intervals of the estimate.");
    return out;
  }
  out.grade = cost.share() >= 1.0 ? EntryText::Grade::stops : EntryText::Grade::costs;
  out.headline =
      cost.torqueShare > cost.forceShare
          ? EntryWords::tr("The controller sees up to %1 N m of phantom torque.").arg(numberText(cost.torque, 2))
          : EntryWords::tr("The controller sees a phantom force of up to %1.").arg(newtons(cost.force));
  out.consequence = (collisions(cost, limits) + " " + sagging(cost, limits)).trimmed();
  return out;
}

}  // namespace heft
