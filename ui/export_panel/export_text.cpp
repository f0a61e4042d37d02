#include "ui/export_panel/export_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "ui/models/numbers.h"

namespace heft {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ExportText)
};

bool anyFromPrior(const EstimateReport& report) {
  bool any = false;
  for (int i = 0; i < 3; ++i) any = any || report.identifiability.inertia[i][i] == Source::prior;
  return any;
}

bool anyUnknown(const EstimateReport& report) {
  bool any = false;
  for (int i = 0; i < 3; ++i) any = any || report.identifiability.inertia[i][i] == Source::none;
  return any;
}

bool centreMeasured(const EstimateReport& report) {
  const auto& com = report.identifiability.com;
  return report.identifiability.mass == Source::data &&
         std::all_of(com.begin(), com.end(), [](Source source) { return source == Source::data; });
}

}  // namespace

QString FormatName::whole() const {
  const QString more = file.isEmpty() ? detail : detail + QStringLiteral(", ") + file;
  return more.isEmpty() ? name : name + QStringLiteral(": ") + more;
}

FormatName formatName(const ExportFormat& format) {
  const struct {
    std::string_view id;
    FormatName name;
  } names[] = {{"franka-desk", {"Franka Desk", Words::tr("end effector"), "JSON"}},
               {"franka-profile", {Words::tr("Franka profile"), Words::tr("end effector"), "JSON"}},
               {"libfranka", {"libfranka", "setLoad", "C++"}},
               {"franka-ros", {"ROS 1", "franka_ros", "YAML"}},
               {"franka-ros2", {"ROS 2", "franka_ros2", "YAML"}},
               {"urdf", {"URDF", Words::tr("link with inertia"), "XML"}},
               {"sdf", {"SDFormat", Words::tr("Gazebo model"), "XML"}},
               {"mjcf", {"MuJoCo", Words::tr("body"), "XML"}},
               {"ur", {"UR", "URScript", {}}},
               {"kuka", {"KUKA", "LOAD_DATA", "KRL"}},
               {"abb", {"ABB", "loaddata", "RAPID"}},
               {"fanuc", {"FANUC", Words::tr("payload schedule"), {}}},
               {"xarm", {"xArm", "set_tcp_load", "Python"}},
               {"ros2-control", {"ros2_control", Words::tr("gravity compensation"), "YAML"}},
               {"force-torque-tools", {"force_torque_tools", Words::tr("calibration"), "YAML"}},
               {"mc-rtc", {"mc_rtc", Words::tr("calibration"), {}}},
               {"json", {"Heft JSON", Words::tr("for programs"), "JSON"}}};
  for (const auto& [id, name] : names)
    if (id == format.id) return name;
  return {QString::fromUtf8(format.title.data(), static_cast<int>(format.title.size())), {}, {}};
}

QString roleAdvice(std::string_view formatId, ExportChoice::Role role) {
  const bool setLoad = formatId == "libfranka" || formatId == "franka-ros" || formatId == "franka-ros2";
  const bool endEffector = formatId == "franka-desk" || formatId == "franka-profile";
  if (setLoad && role == ExportChoice::Role::ownTool)
    return Words::tr(
        "This file sets the load on top of the end effector. Enter the robot’s own tool in Franka Desk instead; "
        "otherwise its weight counts twice.");
  if (endEffector && role == ExportChoice::Role::extraLoad)
    return Words::tr(
        "This file describes the robot’s own end effector. Something that it picked up belongs into setLoad "
        "(libfranka or ROS), added to the tool that is already there.");
  if (formatId == "ur" && role == ExportChoice::Role::extraLoad)
    return Words::tr("UR expects tool and load combined: tick the tool under “What else is mounted?”.");
  return {};
}

std::vector<Check> checksBeforeSaving(const EstimateReport& report, const Payload& onFlange, const Findings& findings,
                                      const ExportChoice& choice, const ExportFormat& format) {
  std::vector<Check> checks;
  const auto warn = [&](const QString& text) { checks.push_back({Severity::warning, false, false, text}); };
  if (const QString advice = roleAdvice(format.id, choice.role); !advice.isEmpty()) warn(advice);
  if (report.trust == Trust::none) {
    warn(Words::tr("You chose to write numbers that the recording does not support. %1")
             .arg(QString::fromStdString(report.whyNoTrust)));
    return checks;
  }
  if (report.identifiability.mass == Source::none) warn(Words::tr("The mass is not known from this motion."));
  if (anyUnknown(report)) {
    warn(
        Words::tr("The inertia is not known from this motion; the file contains only a plausible value. Fine for slow "
                  "work; record faster rotations for fast work."));
  } else if (anyFromPrior(report)) {
    warn(
        Words::tr("The inertia comes from your shape, not from your motion. Fine for slow work; record faster "
                  "rotations for fast work."));
  }
  for (const Finding& finding : findings) {
    if (finding.code == "tool_centre_unset") {
      warn(
          Words::tr("The tool centre point is written at the flange, and loading the file sets the controller’s TCP "
                    "there. Enter it above if it is elsewhere."));
      continue;
    }
    if (finding.severity == Severity::info) continue;
    // Said above in the worker's words, as long as it concerns the inertia alone.
    if (centreMeasured(report) && (finding.code == "not_known" || finding.code == "rests_on_prior")) continue;
    checks.push_back({finding.severity, false, finding.code == "doubtful",
                      QString::fromStdString(errorAt({}, finding.text, finding.remedy).message)});
  }
  // What speaks against the numbers comes first.
  std::stable_partition(checks.begin(), checks.end(), [](const Check& check) { return check.doubt; });
  if (checkPhysical(onFlange).physical)
    checks.push_back({Severity::info, true, false, Words::tr("Physically consistent.")});
  if (format.heaviest > 0 && onFlange.mass < 0.9 * format.heaviest)
    checks.push_back({Severity::info, true, false,
                      Words::tr("Well below the arm’s payload limit of %1 kg.").arg(numberText(format.heaviest, 0))});
  return checks;
}

std::vector<int> doubtfulLines(const QStringList& lines, const EstimateReport& report) {
  std::vector<int> found;
  if (!anyFromPrior(report) && !anyUnknown(report)) return found;
  static const QRegularExpression begins(QStringLiteral("inertia|\\bi[xyz]{2}\\b|\\bJ\\b"),
                                         QRegularExpression::CaseInsensitiveOption);
  static const QRegularExpression continues(QStringLiteral("^[\\s\\d.,\\-+eE\\[\\]{}]+$"));
  static const QRegularExpression comment(QStringLiteral("^\\s*(//|#|;|<!--|!|&|\\*)"));
  bool inside = false;
  for (int i = 0; i < lines.size(); ++i) {
    const bool remark = comment.match(lines[i]).hasMatch();
    const bool holdsNumber = lines[i].contains(QRegularExpression(QStringLiteral("\\d")));
    if (!remark && begins.match(lines[i]).hasMatch()) {
      inside = true;
      found.push_back(i);
    } else if (inside && holdsNumber && continues.match(lines[i]).hasMatch()) {
      found.push_back(i);
    } else {
      inside = false;
    }
  }
  return found;
}

Payload compactPart(double mass, const Vector3d& p_FPcm_F) {
  constexpr double kDensity = 2700.0;  // aluminium [kg/m3]
  constexpr double kPi = 3.14159265358979323846;
  Payload part;
  part.mass = mass;
  part.com = p_FPcm_F;
  const double radius = std::cbrt(3.0 * mass / (4.0 * kPi * kDensity));
  part.inertiaCom = 0.4 * mass * radius * radius * Matrix3d::Identity();
  return part;
}

std::optional<double> sensorBodyMass(const std::string& model) {
  // Data sheets of ATI / Schunk, transducer alone.
  const struct {
    const char* name;
    double mass;
  } known[] = {{"gamma", 0.255}, {"mini40", 0.050}, {"mini45", 0.092}, {"nano25", 0.063}, {"delta", 0.913}};
  const QString lower = QString::fromStdString(model).toLower();
  for (const auto& [name, mass] : known)
    if (lower.contains(QLatin1String(name))) return mass;
  return std::nullopt;
}

}  // namespace heft
