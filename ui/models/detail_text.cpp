#include "ui/models/detail_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "core/math/linear_algebra.h"
#include "ui/models/numbers.h"
#include "ui/models/said_now.h"
#include "ui/models/units.h"

namespace heft {
namespace {

struct DetailWords {
  Q_DECLARE_TR_FUNCTIONS(ResultText)
};

QString triple(const Vector3d& v, int decimals) {
  return QStringLiteral("%1  %2  %3")
      .arg(numberText(v.x(), decimals), numberText(v.y(), decimals), numberText(v.z(), decimals));
}

/// Root mean square of measured − simulated per channel over the free parts [N], [N m]; NaN without any.
Vector6d channelRms(const EstimateReport& r) {
  Vector6d sum = Vector6d::Zero();
  Eigen::Index count = 0;
  auto segment = r.segments.begin();
  for (Eigen::Index n = 0; n < std::min(r.series.simulated.rows(), r.series.time.size()); ++n) {
    while (segment != r.segments.end() && segment->to < r.series.time(n)) ++segment;
    if (segment == r.segments.end()) break;
    if (segment->label != MarkLabel::free || segment->from > r.series.time(n)) continue;
    sum += (r.series.measured.row(n) - r.series.simulated.row(n)).transpose().cwiseAbs2();
    ++count;
  }
  return (sum / static_cast<double>(count)).cwiseSqrt();
}

/// Principal moments about the centre of mass, each with its axis in the frame; nothing where the inertia is not known.
void addPrincipalAxes(const Payload& payload, std::vector<DetailText>& rows) {
  if (!payload.inertiaCom.allFinite() || payload.inertiaCom.isZero()) return;
  const SymmetricEigen principal = symmetricEigen(payload.inertiaCom);
  QStringList lines;
  for (int k = 2; k >= 0; --k) {
    const Vector3d axis = principal.vectors.col(k);
    // One of the two directions, so that it does not flip from one estimate to the next.
    Eigen::Index largest = 0;
    axis.cwiseAbs().maxCoeff(&largest);
    const Vector3d shown = axis(largest) < 0 ? Vector3d(-axis) : axis;
    lines << DetailWords::tr("%1 kg cm² about (%2, %3, %4)")
                 .arg(numberText(1e4 * principal.values(k), 2), numberText(shown.x(), 2), numberText(shown.y(), 2),
                      numberText(shown.z(), 2));
  }
  rows.push_back(
      {DetailWords::tr("Principal moments"), lines.join('\n'),
       DetailWords::tr(
           "Moments about the principal axes through the centre of mass, and these axes in the frame chosen")});
}

/// What the motion determined and what it did not: the ten directions, the best determined first.
void addDirections(const EstimateReport& r, std::vector<DetailText>& rows) {
  if (r.identifiability.directions.empty()) return;
  QStringList lines;
  constexpr double kWhole = 0.995;  // Rounds to 100 %
  int whole = 0;
  for (const auto& direction : r.identifiability.directions) whole += direction.dataShare >= kWhole ? 1 : 0;
  if (whole > 0)
    lines << DetailWords::tr("100 %, %1 of %2 directions").arg(whole).arg(r.identifiability.directions.size());
  for (const auto& direction : r.identifiability.directions)
    if (direction.dataShare < kWhole)
      lines << DetailWords::tr("%1 %, %2").arg(numberText(100 * direction.dataShare, 0), saidNow(direction.about));
  rows.push_back({DetailWords::tr("Determined by the motion"), lines.join('\n'),
                  DetailWords::tr("Ten independent directions among the parameters, and the share of the data in each; "
                                  "the rest comes from what was assumed")});
}

}  // namespace

std::vector<DetailText> detailTexts(const EstimateReport& r) {
  std::vector<DetailText> rows;
  const auto add = [&](const QString& name, const QString& value, const QString& tip) {
    rows.push_back({name, value, tip});
  };
  add(DetailWords::tr("Method"),
      QString::fromUtf8(toString(r.method).data(), static_cast<int>(toString(r.method).size())),
      r.termination.why.empty() ? DetailWords::tr("How the values were determined")
                                : QString::fromStdString(r.termination.why));
  add(DetailWords::tr("Used"),
      DetailWords::tr("%1 of %2 s, %3 Hz")
          .arg(numberText(r.usedDuration, 1), numberText(r.duration, 1), numberText(r.rateHz, 0)),
      DetailWords::tr("Free segments, without the trimmed ends"));
  add(DetailWords::tr("Residual force"), DetailWords::tr("%1 N").arg(numberText(r.forceRms, 3)),
      DetailWords::tr("Root mean square of the residual on free segments"));
  const ShownUnit torque = torqueUnit();
  const auto torqueText = [&](double newtonMetres, int decimals) {
    return numberText(torque.scale * newtonMetres, decimals + torque.decimals);
  };
  add(DetailWords::tr("Residual torque"), QStringLiteral("%1 %2").arg(torqueText(r.torqueRms, 4), torque.name),
      DetailWords::tr("Root mean square of the residual on free segments"));
  if (const Vector6d rms = channelRms(r); rms.allFinite()) {
    add(DetailWords::tr("Force by channel"),
        DetailWords::tr("%1 N\nnoise %2").arg(triple(rms.head<3>(), 3), triple(r.noiseStd.head<3>(), 3)),
        DetailWords::tr("Root mean square of the residual in x, y, z, and the sensor’s noise"));
    const auto three = [&](const Vector3d& v) { return triple(torque.scale * v, 4 + torque.decimals); };
    add(DetailWords::tr("Torque by channel"),
        DetailWords::tr("%1 %2\nnoise %3").arg(three(rms.tail<3>()), torque.name, three(r.noiseStd.tail<3>())),
        DetailWords::tr("Root mean square of the residual in x, y, z, and the sensor’s noise"));
  }
  if (r.heldoutForceRms > 0) {
    add(DetailWords::tr("Held-out error"),
        QStringLiteral("%1 N, %2 %3")
            .arg(numberText(r.heldoutForceRms, 3), torqueText(r.heldoutTorqueRms, 4), torque.name),
        DetailWords::tr("The same on segments that were not used for fitting"));
  }
  add(DetailWords::tr("Sensor bias, force"), DetailWords::tr("%1 N").arg(triple(r.forceBias, 2)),
      DetailWords::tr("Constant offset x, y, z of the sensor"));
  add(DetailWords::tr("Sensor bias, torque"),
      QStringLiteral("%1 %2").arg(triple(torque.scale * r.torqueBias, 3 + torque.decimals), torque.name),
      DetailWords::tr("Constant offset x, y, z of the sensor"));
  if (r.identifiability.conditionNumber > 0) {
    add(DetailWords::tr("Condition number"), numberText(r.identifiability.conditionNumber, 0),
        DetailWords::tr("Of the scaled, whitened regressor: how unevenly the motion determines the ten parameters"));
  }
  if (r.identifiability.singularValues.size() > 0) {
    QStringList values;
    for (const double value : r.identifiability.singularValues)
      values << numberText(value, value < 0.0995 ? 4 : value < 0.995 ? 3 : 2);
    add(DetailWords::tr("Singular values"), values.join(QStringLiteral("  ")),
        DetailWords::tr("Of the same matrix: a small one is a combination that the motion hardly determines"));
  }
  addDirections(r, rows);
  if (r.relativeError) {
    QStringList errors;
    if (r.relativeError->hasMass)
      errors << DetailWords::tr("mass %1 %").arg(numberText(100 * r.relativeError->mass, 2));
    if (r.relativeError->hasCom)
      errors << DetailWords::tr("centre %1 %").arg(numberText(100 * r.relativeError->com, 2));
    if (r.relativeError->hasInertia)
      errors << DetailWords::tr("inertia %1 %").arg(numberText(100 * r.relativeError->inertiaCom, 1));
    if (!errors.isEmpty())
      add(DetailWords::tr("Deviation from reference"), errors.join(", "),
          DetailWords::tr("Relative error |estimate − stated| / |stated|"));
  }
  add(DetailWords::tr("Physically consistent"), r.physicallyConsistent ? DetailWords::tr("yes") : DetailWords::tr("no"),
      DetailWords::tr("Positive mass, and an inertia that a real mass distribution can have"));
  add(DetailWords::tr("Computation time"),
      DetailWords::tr("%1 s").arg(numberText(r.timing.prepare + r.timing.solve, 2)),
      DetailWords::tr("Preparing and solving"));
  return rows;
}

std::vector<DetailText> frameTexts(const EstimateReport& r, DetailFrame frame) {
  const bool flange = frame == DetailFrame::flange;
  const Payload payload = flange ? transformed(r.payload, poseFromXyzRpy(r.mount.xyz, r.mount.rpy)) : r.payload;
  const ShownUnit length = lengthUnit();
  std::vector<DetailText> rows;
  rows.push_back({DetailWords::tr("Centre of mass"),
                  QStringLiteral("%1 %2").arg(triple(length.scale * payload.com, 1 + length.decimals), length.name),
                  flange
                      ? DetailWords::tr("x, y, z from the flange’s origin along its axes, with the sensor’s mount as "
                                        "stated")
                      : DetailWords::tr("x, y, z from the sensor’s origin along its axes")});
  const auto six = [](const Matrix3d& I) {
    return DetailWords::tr("%1\n%2 kg cm²")
        .arg(triple(1e4 * I.diagonal(), 2), triple(1e4 * Vector3d(I(0, 1), I(0, 2), I(1, 2)), 2));
  };
  const Matrix3d& I = payload.inertiaCom;
  rows.push_back({DetailWords::tr("Inertia about the centre"), six(I),
                  DetailWords::tr("About the centre of mass: xx, yy, zz; xy, xz, yz")});
  rows.push_back({DetailWords::tr("Inertia about the origin"), six(inertiaAboutOrigin(payload)),
                  DetailWords::tr("About the frame’s origin: xx, yy, zz; xy, xz, yz")});
  addPrincipalAxes(payload, rows);
  return rows;
}

MatrixText matrixText(const EstimateReport& r) {
  MatrixText out;
  out.names = QStringList{QStringLiteral("m"),   QStringLiteral("x"),   QStringLiteral("y"),   QStringLiteral("z"),
                          QStringLiteral("Ixx"), QStringLiteral("Ixy"), QStringLiteral("Ixz"), QStringLiteral("Iyy"),
                          QStringLiteral("Iyz"), QStringLiteral("Izz")};
  out.values = r.correlation;
  return out;
}

}  // namespace heft
