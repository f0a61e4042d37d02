#pragma once
// One estimate from several recordings of the same tool, and which of them it takes.
#include <span>

#include "core/estimation/estimate.h"

namespace heft {

struct JointInput {
  const Recording* recording = nullptr;
  const RobotModel* robot = nullptr;  ///< May be null where the recording carries poses.
};

/// How many times wider the intervals would be without a recording; 1: it adds nothing.
struct InformationGain {
  Vector10d components = Vector10d::Ones();     ///< mass, com, Ixx, Ixy, Ixz, Iyy, Iyz, Izz
  double mass = 1.0, com = 1.0, inertia = 1.0;  ///< of the norms
};

struct JointPiece {
  EstimateReport report;    ///< The joint payload with this recording's own bias, residual and segments.
  Payload alone, aloneStd;  ///< What the recording tells by itself.
  bool used = true;         ///< Takes part in the joint estimate.
  InformationGain adds;
  std::string words;  ///< What it adds, one sentence.
};

struct JointReport {
  std::vector<JointPiece> pieces;     ///< As given.
  std::size_t first = 0;              ///< The first that is used: its report is the result.
  std::vector<std::size_t> proposal;  ///< Enough of the used ones: the others narrow no interval by a tenth.
  std::string proposalText;           ///< "Use 2 and 3; 1 adds nothing."

  const EstimateReport& report() const { return pieces[first].report; }
};

/// Joins recordings of one tool: each has its own bias and its own noise, the payload is shared. A recording whose own
/// mass and centre of mass contradict the others' (chi-squared over 4 numbers, sensor's calibration allowed for) is of
/// another tool: it is left out, and said. Needs the method map and all parameters; fails where a recording cannot be
/// prepared, naming it.
Result<JointReport> estimateJointly(std::span<const JointInput> inputs, const EstimateOptions& options,
                                    const Progress& progress = {});

/// heft.estimate/1 of the first used recording with "recordings" and "selection".
nlohmann::json toJson(const JointReport& joint);
std::string toText(const JointReport& joint);

}  // namespace heft
