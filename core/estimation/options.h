#pragma once
// What an estimate can be asked for.
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/motion/motion.h"
#include "core/payload/inertial_parameters.h"
#include "core/payload/shape.h"
#include "core/payload/stated_payload.h"
#include "core/segmentation/segmentation.h"

namespace heft {

enum class Method { map, ls, wls, tls, tlsFast, tlsExact, ceres, eigenLm, bruteForce };
enum class ParameterSet { mass, massCom, full };
/// What the recording's numbers are taken to mean: what its setup file says, or what physics says where that is plain.
enum class ConventionChoice { asStated, suggested };

std::string_view toString(Method method);  ///< "tls-fast"
std::optional<Method> methodFromString(std::string_view text);
std::string_view toString(ParameterSet set);  ///< "mass-com"
std::optional<ParameterSet> parameterSetFromString(std::string_view text);
std::string_view toString(ConventionChoice choice);  ///< "as-stated", "suggested"

struct EstimateOptions {
  Method method = Method::map;
  ParameterSet parameters = ParameterSet::full;
  ConventionChoice conventions = ConventionChoice::asStated;
  bool bias = true;                           ///< Six constant sensor biases are estimated too.
  double trim = 0.10;                         ///< Fraction of the duration dropped at each end.
  bool keepTrim = false;                      ///< Even where contact leaves little else.
  std::optional<SegmentMode> segments;        ///< Absent: marks if the recording has any, else automatic.
  std::optional<PayloadGuess> firstEstimate;  ///< Helps to find what is free; the estimate itself does not lean on it.
  PartialPayload known;               ///< Values for parameters that are not estimated; overrides the recording's own.
  std::optional<Shape> shape;         ///< Prior.
  std::vector<StatedPayload> stated;  ///< Soft information about what is estimated: a scale's mass, CAD numbers.
  bool insideShape = false;           ///< map, full: all mass is held inside the shape.
  std::array<bool, 6> silent{};       ///< Channels that are not used; those that hardly ever change never are.
  bool uncompressed = false;          ///< Solve on all rows instead of the triangle, for comparison with the paper.
  MotionOptions motion;
};

}  // namespace heft
