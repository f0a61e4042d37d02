#include "ui/reality_panel/cause_marks.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ui/models/numbers.h"
#include "ui/reality_cards/cause_card.h"

namespace heft {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(CauseMarks)
};

constexpr double kDegree = 3.14159265358979323846 / 180.0;

Vector3d vectorOf(const DiagnosedCause& cause, const std::array<const char*, 3>& names) {
  Vector3d out = Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    if (const CauseParameter* p = findParameter(cause.parameters, names[static_cast<std::size_t>(i)]))
      out(i) = p->value;
  return out;
}

double valueOf(const DiagnosedCause& cause, const char* name) {
  const CauseParameter* p = findParameter(cause.parameters, name);
  return p ? p->value : 0.0;
}

/// The integer factor that makes `size` visible; 1 if it is large enough.
double enlargement(double size, double visible) {
  return size > 0.0 ? std::clamp(std::round(visible / size), 1.0, 10.0) : 1.0;
}

QString withScale(const QString& size, double enlarged) {
  return enlarged > 1.0 ? Words::tr("%1, drawn %2× larger").arg(size, numberText(enlarged, 0)) : size;
}

/// The push of a touch where it was greatest: its direction, and the point of its line nearest to the sensor.
std::optional<CauseMark> pushOf(const DiagnosisReport& report, const DiagnosedCause& cause) {
  const auto& s = report.series;
  Eigen::Index at = -1;
  double most = 0.0;
  for (Eigen::Index n = 0; n < s.time.size(); ++n) {
    const bool during = std::any_of(cause.when.begin(), cause.when.end(), [&](const auto& stretch) {
      return s.time(n) >= stretch.first && s.time(n) <= stretch.second;
    });
    const double size = (s.measured.col(n) - s.before.col(n)).head<3>().norm();
    if (!during || !std::isfinite(size) || size <= most) continue;
    most = size;
    at = n;
  }
  if (at < 0) return std::nullopt;
  const Vector6d left = s.measured.col(at) - s.before.col(at);
  const Vector3d force = left.head<3>(), torque = left.tail<3>();
  CauseMark mark;
  mark.kind = CauseMark::Kind::push;
  mark.vector = force;
  mark.at = force.cross(torque) / force.squaredNorm();
  constexpr double kTool = 0.5;  // [m] Farther away no tool reaches: then noise placed it.
  if (!(mark.at.norm() < kTool)) mark.at.setZero();
  mark.title = Words::tr("Something touched the tool");
  mark.note = Words::tr("%1 N at %2 s").arg(numberText(force.norm(), 1), numberText(s.time(at), 1));
  return mark;
}

std::optional<CauseMark> markOf(const DiagnosisReport& report, const DiagnosedCause& cause) {
  using Kind = CauseMark::Kind;
  CauseMark mark;
  if (cause.id == "sensor_rotation" && !cause.direct) {
    mark.kind = Kind::turnedFrame;
    mark.vector = kDegree * vectorOf(cause, {"rx", "ry", "rz"});
    mark.enlarged = enlargement(mark.vector.norm(), 20.0 * kDegree);
    mark.title = Words::tr("The sensor’s true axes");
    mark.note = withScale(Words::tr("rotated by %1°").arg(numberText(mark.vector.norm() / kDegree, 1)), mark.enlarged);
    return mark;
  }
  if (cause.id == "lever_arm") {
    mark.kind = Kind::misplaced;
    mark.vector = 1e-3 * vectorOf(cause, {"dx", "dy", "dz"});
    mark.enlarged = enlargement(mark.vector.norm(), 0.06);
    mark.title = Words::tr("The sensor’s true origin");
    mark.note = withScale(Words::tr("%1 mm away").arg(numberText(1e3 * mark.vector.norm(), 1)), mark.enlarged);
    return mark;
  }
  if (cause.id == "gravity_tilt") {
    const nlohmann::json changes = report.metaChanges();
    const auto g = changes.find("gravity_m_s2");
    if (g == changes.end()) return std::nullopt;
    mark.kind = Kind::gravity;
    for (int i = 0; i < 3; ++i) mark.vector(i) = (*g)[static_cast<std::size_t>(i)].get<double>();
    const double angle =
        std::acos(std::clamp(mark.vector.normalized().dot(report.meta.gravity.normalized()), -1.0, 1.0));
    mark.enlarged = enlargement(angle, 20.0 * kDegree);
    mark.title = Words::tr("True gravity");
    mark.note = withScale(Words::tr("base tilted by %1°").arg(numberText(angle / kDegree, 1)), mark.enlarged);
    return mark;
  }
  if (cause.id == "contact" && !cause.when.empty()) return pushOf(report, cause);
  if (cause.id == "constant_pull") {
    mark.kind = Kind::push;
    mark.inBase = true;
    mark.vector = vectorOf(cause, {"force_x", "force_y", "force_z"});
    if (mark.vector.norm() <= 0.0) return std::nullopt;
    mark.title = Words::tr("A steady pull");
    mark.note = Words::tr("%1 N").arg(numberText(mark.vector.norm(), 2));
    return mark;
  }
  if (cause.id == "payload_change" && valueOf(cause, "mass") != 0.0) {
    const double grams = valueOf(cause, "mass");
    mark.kind = Kind::load;
    mark.vector = (grams > 0.0 ? 1.0 : -1.0) * report.meta.gravity;
    mark.at = report.before.payload.com;
    mark.title = grams > 0.0 ? Words::tr("The load became heavier") : Words::tr("The load became lighter");
    const double time = cause.when.empty() ? valueOf(cause, "time") : cause.when.front().first;
    mark.note = Words::tr("%1 g from %2 s on").arg(numberText(std::abs(grams), 0), numberText(time, 1));
    return mark;
  }
  if (cause.id == "loose_mass") {
    mark.kind = Kind::swing;
    mark.at = report.before.payload.com;
    mark.title = Words::tr("Something loose swings");
    mark.note = Words::tr("%1 g at %2 Hz")
                    .arg(numberText(valueOf(cause, "mass"), 0), numberText(valueOf(cause, "frequency"), 1));
    return mark;
  }
  return std::nullopt;
}

}  // namespace

std::vector<CauseMark> causeMarks(const DiagnosisReport& report) {
  std::vector<CauseMark> out;
  for (const DiagnosedCause& cause : report.causes)
    if (auto mark = markOf(report, cause)) out.push_back(std::move(*mark));
  return out;
}

}  // namespace heft
