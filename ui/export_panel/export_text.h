#pragma once
// What the step "Export" says, computed without widgets.
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "core/base/findings.h"
#include "core/estimation/estimate.h"
#include "core/exporters/exporter.h"
#include "core/workspace/session.h"

namespace heft {

struct FormatName {
  QString name;    ///< "Franka Desk"
  QString detail;  ///< "end effector"
  QString file;    ///< "JSON"
  /// "Franka Desk: end effector, JSON"
  QString whole() const;
};
FormatName formatName(const ExportFormat& format);

/// What the format is for, where that depends on whether the robot's own tool or an extra load was measured; empty if
/// it fits. "setLoad is for what the robot picks up ..."
QString roleAdvice(std::string_view formatId, ExportChoice::Role role);

/// A line before saving: a light and a sentence.
struct Check {
  Severity severity = Severity::info;
  bool good = false;   ///< Shown with a check mark.
  bool doubt = false;  ///< Speaks against the numbers: saving wants a word of the user's.
  QString text = {};
};

/// Warnings first, then what is in order.
std::vector<Check> checksBeforeSaving(const EstimateReport& report, const Payload& onFlange, const Findings& findings,
                                      const ExportChoice& choice, const ExportFormat& format);

/// Indices of the lines that contain numbers that the motion did not determine; `what` is shown beside the first.
std::vector<int> doubtfulLines(const QStringList& lines, const EstimateReport& report);

/// A part of this mass [kg] whose centre lies at `p_FPcm_F` [m], taken as a compact ball of aluminium: for mounted
/// parts of which only weight and place are known.
Payload compactPart(double mass, const Vector3d& p_FPcm_F);

/// Mass of a sensor's body from its model name, if a data sheet states it [kg].
std::optional<double> sensorBodyMass(const std::string& model);

}  // namespace heft
