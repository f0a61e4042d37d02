#pragma once
// Everything a user of the studio has said and got: recordings, painted marks, the tool's shape, settings, what to
// export, results. One versioned JSON file (.heft); what is only a matter of looking (camera, zoom) is not in it.
//
// Paths are written relative to the session's own folder, with the absolute path beside them for the case that only the
// session was moved. Keys that this version does not know are kept and written again.
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/estimation/options.h"
#include "core/payload/inertial_parameters.h"
#include "core/payload/shape.h"
#include "core/recording/recording.h"

namespace heft {

/// The newest session format that this version reads and the one that it writes: "heft.session/1".
inline constexpr int kSessionVersion = 1;
inline constexpr std::string_view kSessionExtension = ".heft";

/// What the user accepted of a diagnosis. An estimate takes it out of the recording first.
struct Corrections {
  std::vector<std::string> causes;  ///< IDs, in the order in which they were applied.
  std::string found;                ///< The heft.diagnose/1 that they are of, as JSON text; empty without causes.

  bool operator==(const Corrections&) const = default;
};

struct SessionRecording {
  std::filesystem::path file;  ///< Absolute.
  std::vector<Mark> marks;     ///< Painted by the user; they win over the file's own, later ones over earlier ones.
  std::string result;          ///< The last heft.estimate/1 as JSON text; empty if there is none.
  std::string kept;            ///< JSON object text with keys that a newer version wrote.
  Corrections corrections = {};
  std::string name = {};  ///< What the user calls it; empty: as the file.
};

/// The answer to "What does your tool look like?".
struct ShapeChoice {
  enum class Answer { notGiven, unknown, given };
  Answer answer = Answer::notGiven;
  std::string picture;  ///< Which picture was picked: "gripper"; empty where the bodies say it.
  Shape shape;          ///< With Answer::given; kept while the answer is "unknown", so that it can be taken up again.
};

struct EstimateSettings {
  Method method = Method::map;
  ParameterSet parameters = ParameterSet::full;
  bool bias = true;
  double trim = 0.10;
  PartialPayload known;  ///< CAD or scale values in S, to compare with; the recording's own where a part is absent.
};

/// Something between flange and tool that the estimate does not see.
struct MountedPart {
  std::string name;
  Payload payload;  ///< F axes, centre of mass from F's origin.
  bool present = false;
};

struct ExportChoice {
  std::string format = "franka-desk";
  enum class Role { unasked, ownTool, extraLoad };
  Role role = Role::unasked;
  std::vector<MountedPart> mounted;
  bool mountedAnswered = false;     ///< "Nothing else" is an answer, too.
  Vector3d tcp = Vector3d::Zero();  ///< Tool centre point from the flange, F axes [m]; only some formats carry it.
};

/// What the robot's controller works with today, and what it reacts to. The usual limits are those that libfranka's
/// examples set (setDefaultBehavior() in examples_common.cpp: nominal force thresholds, Cartesian impedance).
struct ControllerChoice {
  PartialPayload told;            ///< F axes, centre of mass from F's origin; empty: what the recording tells
  std::string source;             ///< File that `told` was read from; empty where it was typed in
  double collisionForce = 10.0;   ///< Outside force that stops it [N]
  double collisionTorque = 10.0;  ///< Likewise about F's origin [N m]
  double stiffness = 3000.0;      ///< Of its Cartesian impedance [N/m]
};

struct Session {
  std::vector<SessionRecording> recordings;
  int active = -1;      ///< Index of the recording shown; -1 without any.
  bool joined = false;  ///< All recordings are of one tool and give one result.
  ShapeChoice shape;
  EstimateSettings settings;
  ExportChoice exporting;
  ControllerChoice controller;
  std::filesystem::path room;  ///< What stands around the arm (heft.room/1), absolute; empty: not known
  std::string proof;           ///< The last heft.prove/1 of exported numbers as JSON text; empty if there is none.
  std::string step;            ///< Id of the step shown; view state, kept for coming back.
  std::filesystem::path home;  ///< Where the user saved the session; empty if nowhere yet.
  std::string kept;            ///< As in SessionRecording, for the whole file.
};

/// The session as the text of a file in `folder`. With `asRecovery` it also names `home`, so that a recovered session
/// knows where it belongs.
std::string sessionText(const Session& session, const std::filesystem::path& folder, bool asRecovery = false);

/// The reverse; `name` stands in messages. A newer format is refused with a sentence that says so, before anything is
/// read.
Result<Session> parseSession(std::string_view text, const std::string& name, const std::filesystem::path& folder);

Result<bool> writeSession(const Session& session, const std::filesystem::path& file);
/// Sets Session::home to `file`.
Result<Session> readSession(const std::filesystem::path& file);

/// What `estimate` is to be asked for. The shape is a prior only if one was given.
EstimateOptions estimateOptions(const Session& session);

}  // namespace heft
