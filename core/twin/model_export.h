#pragma once
// The rig as a diagnosis found it, in the files of other simulators: payload, sensor, gravity and the named causes.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace heft {

enum class ModelTarget {
  mujoco,  ///< MJCF, read by MuJoCo 2.2 and later
  gazebo,  ///< SDF 1.9, read by libsdformat 12 and later
  data,    ///< heft.model/1: everything that is known, for programs
};

struct ModelExportOptions {
  std::string name = "tool";         ///< Of the body that is carried
  std::string program = "Heft";      ///< Writes: "heft 0.2.0"
  std::vector<std::string> without;  ///< IDs of causes that are switched off.
};

/// What became of a cause of the diagnosis.
struct ExportedCause {
  std::string id, title;
  /// The target simulates it. Otherwise its sizes stand in the file as numbers and the simulation runs without it.
  bool simulated = false;
};

struct ExportedModel {
  std::string text;  ///< The file
  std::vector<ExportedCause> causes;
};

/// `found`, read from the file `where`, is a heft.diagnose/1. The payload is the one estimated with the causes taken
/// out, in the axes of the sensor as stated; a sensor that was found turned or beside its place, and a tilted gravity,
/// are part of the model's geometry. Delays, filters, gains, drifts and forces from outside are nothing that the
/// file formats of MuJoCo and Gazebo know: their sizes are written as numbers under names of their own (MJCF: custom
/// and user data; SDF: elements of the namespace heft). Fails where `found` is no such result, does not name a cause of
/// `without`, does not say where the sensor sits, or where its payload cannot exist.
Result<ExportedModel> exportModel(const nlohmann::json& found, const std::string& where, ModelTarget target,
                                  const ModelExportOptions& options);

}  // namespace heft
