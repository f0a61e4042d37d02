#include "ui/models/method_table.h"

#include <QCoreApplication>
#include <algorithm>

#include "ui/models/numbers.h"

namespace heft {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(MethodTable)
};

QString percent(bool has, double value) {
  return has ? numberText(100 * value, value < 0.1 ? 2 : 1) : QString(QChar(0x2014));
}

}  // namespace

QString methodName(Method method) {
  switch (method) {
    case Method::map:
      return Words::tr("Heft (MAP)");
    case Method::ls:
      return Words::tr("least squares");
    case Method::wls:
      return Words::tr("weighted least squares");
    case Method::tls:
      return Words::tr("total least squares");
    case Method::tlsFast:
      return Words::tr("total least squares, fast");
    case Method::tlsExact:
      return Words::tr("total least squares, exact");
    case Method::ceres:
      return Words::tr("Ceres");
    case Method::eigenLm:
      return Words::tr("Levenberg-Marquardt");
    case Method::bruteForce:
      return Words::tr("brute force");
  }
  return {};
}

MethodTable methodTable(const std::vector<ComparedMethod>& methods, Method chosen) {
  MethodTable table;
  const bool known = std::any_of(methods.begin(), methods.end(), [](const ComparedMethod& method) {
    return method.report && method.report->relativeError;
  });
  const auto column = [&](const QString& header, const QString& tip) {
    table.headers << header;
    table.headerTips << tip;
  };
  column(Words::tr("Method"), Words::tr("How the values were determined"));
  column(Words::tr("Mass [kg]"), Words::tr("With half the width of its 95 % interval"));
  column(Words::tr("Centre x, y, z [mm]"), Words::tr("From the sensor’s origin, sensor axes"));
  column(Words::tr("Inertia [kg cm²]"), Words::tr("Sum of Ixx, Iyy and Izz about the centre of mass"));
  column(Words::tr("Held-out force [N]"), Words::tr("Error on segments that were not used for fitting"));
  column(Words::tr("Held-out torque [N m]"), Words::tr("Error on segments that were not used for fitting"));
  if (known) {
    column(Words::tr("Mass error [%]"), Words::tr("Relative error with respect to the reference value"));
    column(Words::tr("Centre error [%]"), Words::tr("Relative error with respect to the reference value"));
    column(Words::tr("Inertia error [%]"),
           Words::tr("Relative error about the sensor’s origin, with respect to the reference value"));
  }
  column(Words::tr("Time [ms]"), Words::tr("From the prepared motion to the result"));
  column(Words::tr("Physical?"), Words::tr("Whether a real body can have these values"));
  for (const ComparedMethod& method : methods) {
    MethodRow row;
    row.chosen = method.method == chosen;
    row.cells << methodName(method.method);
    if (!method.report) {
      row.cells << Words::tr("no result");
      while (row.cells.size() < table.headers.size()) row.cells << QString();
      row.tip = QString::fromStdString(method.failure);
      table.rows.push_back(row);
      continue;
    }
    const EstimateReport& r = *method.report;
    const double half = 0.5 * (r.interval95.mass.upper - r.interval95.mass.lower);
    const int decimals = decimalsFor(half, 4);
    row.cells << QStringLiteral("%1 ± %2").arg(numberText(r.payload.mass, decimals), numberText(half, decimals));
    row.cells << QStringLiteral("%1, %2, %3")
                     .arg(numberText(1e3 * r.payload.com.x(), 1), numberText(1e3 * r.payload.com.y(), 1),
                          numberText(1e3 * r.payload.com.z(), 1));
    row.cells << numberText(1e4 * r.payload.inertiaCom.trace(), 1) << numberText(r.heldoutForceRms, 3)
              << numberText(r.heldoutTorqueRms, 4);
    if (known) {
      const RelativeError e = r.relativeError.value_or(RelativeError{});
      row.cells << percent(e.hasMass, e.mass) << percent(e.hasCom, e.com) << percent(e.hasInertia, e.inertiaOrigin);
    }
    row.cells << numberText(1e3 * r.timing.solve, 1) << (r.physicallyConsistent ? Words::tr("yes") : Words::tr("no"));
    row.usable = r.termination.usable && r.physicallyConsistent;
    row.tip = QString::fromStdString(r.termination.why);
    table.rows.push_back(row);
  }
  return table;
}

}  // namespace heft
