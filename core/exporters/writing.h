#pragma once
// How numbers, names and remarks stand in exported files, whatever the locale.
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/exporters/exporter.h"

namespace heft {

/// The shortest decimal without exponent that reads back as the same double; never "-0".
std::string number(double value);
/// `value` as the double nearest to its decimal with so many places.
double roundedTo(double value, int decimals);
/// Places after the point that leave six digits of `largest`.
int decimalsFor(double largest);

/// "a, b, c"
std::string list(std::span<const double> values, std::string_view separator = ", ");
std::string list(std::initializer_list<double> values, std::string_view separator = ", ");
std::string list(const Vector3d& v, std::string_view separator = ", ");
/// The nine entries; column by column, which for a symmetric tensor is also row by row.
std::string columnMajor(const Matrix3d& m);

/// Letters, digits and underscores, starting with a letter, at most 24: fit for a name in any robot language.
std::string identifier(std::string_view name);

/// One remark a line, each fit to follow `prefix`: printable, no line break, no end-of-comment.
std::string comment(const std::vector<std::string>& remarks, std::string_view prefix);
/// The same as one XML comment.
std::string xmlComment(const std::vector<std::string>& remarks);
/// For attribute values and text.
std::string xmlEscaped(std::string_view text);
/// Letters, digits, '_', '-' and '/'; others become '_': fit for a frame's name in ROS and in YAML.
std::string frameName(const std::string& frame);
/// A JSON string with its quotes.
std::string jsonString(std::string_view text);

/// Provenance and uncertainty if there are any, then `more`.
std::vector<std::string> remarksOf(const ExportInput& input, const std::vector<std::string>& more = {});

/// I = R diag(moments) R^T with the axes chosen nearest to F's own, so that a diagonal tensor gives R = identity.
struct PrincipalAxes {
  Matrix3d R_FA = Matrix3d::Identity();
  Vector3d moments = Vector3d::Zero();  ///< Rounded, and still those of a possible body [kg m2]
};
PrincipalAxes principalAxes(const Matrix3d& inertia);

/// The element <inertial> of a URDF, each line after `indent`, ending in `newline`.
std::string urdfInertial(const Payload& payload, const std::string& indent, const std::string& newline);

// The formats.
std::string writeFrankaDesk(const ExportInput& input);
std::string writeFrankaProfile(const ExportInput& input);
std::string writeLibfranka(const ExportInput& input);
std::string writeFrankaRos(const ExportInput& input);
std::string writeFrankaRos2(const ExportInput& input);
std::string writeUrdf(const ExportInput& input);
std::string writeSdf(const ExportInput& input);
std::string writeMjcf(const ExportInput& input);
std::string writeJson(const ExportInput& input);
std::string writeUr(const ExportInput& input);
std::string writeKuka(const ExportInput& input);
std::string writeAbb(const ExportInput& input);
std::string writeFanuc(const ExportInput& input);
std::string writeRos2Control(const ExportInput& input);
std::string writeForceTorqueTools(const ExportInput& input);
std::string writeMcRtc(const ExportInput& input);
std::string writeXarm(const ExportInput& input);

}  // namespace heft
