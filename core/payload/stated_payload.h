#pragma once
// What is believed of a payload before any data, as soft information: a scale's mass, the numbers of a CAD program.
//
// Mass, centre and shape are believed apart, each with its own standard deviation. The shape is what is left of the
// inertia without mass and place: the covariance of the mass about its centre, so that numbers of a CAD program with
// the wrong material still tell how the inertia grows with the mass.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "core/payload/inertial_parameters.h"
#include "core/payload/shape.h"

namespace heft {

struct StatedPayload {
  std::optional<double> mass;      ///< [kg]
  std::optional<Vector3d> com;     ///< [m], S axes
  std::optional<Matrix3d> spread;  ///< (tr(I_C)/2 - I_C) / m [m2], positive definite
  double massStd = 0.005;          ///< Relative.
  double centreStd = 0.0;          ///< In the body's own standard deviations (kUsualRadius without `spread`).
  double shapeStd = 0.0;           ///< Relative, of a length: half of that of a moment of inertia.
  std::string source;              ///< Who says so, for messages: "the scale", a file name.
};

/// A tool's usual radius of gyration along an axis [m], where nobody says otherwise.
constexpr double kUsualRadius = 0.05;

/// What a scale shows: "0.812", "0.812+-0.004" or "0.812±0.004" [kg], "0.812+-1%". Without a standard deviation 0.5 %.
Result<StatedPayload> parseScaleMass(const std::string& text);

/// A payload object as partialPayloadFromJson reads it, and beside it (both optional) "certainty": "rough" (default),
/// "good" or "exact", and "weights": {"mass", "centre", "shape"}: how often each part counts (1 if absent, 0: not at
/// all). Standard deviations of mass, centre and length: rough 20 %, 0.3, 20 %; good 3 %, 0.1, 5 %; exact 0.5 %, 0.02,
/// 1 %. Fails if no part is left, if no body can have the inertia, and for an inertia without mass.
Result<StatedPayload> statedPayloadFromJson(const nlohmann::json& object, const std::string& where);

}  // namespace heft
