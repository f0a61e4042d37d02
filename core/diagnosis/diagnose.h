#pragma once
// What does the simulation get wrong? Shows it, names the cause, extends the model and measures the gain.
//
// A rigid payload with a constant bias is fitted to the whole recording (baseline). What it leaves over is searched for
// the causes of the catalogue, one after the other, by the evidence that each adds under autoregressive noise
// (difference of BIC), against a threshold learned on simulated clean recordings with the same motion and noise. What
// fits equally well is said to be equal; what nothing in the catalogue accounts for is said to be unexplained.
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "core/diagnosis/frames.h"
#include "core/diagnosis/heldout.h"
#include "core/diagnosis/sample_tests.h"
#include "core/diagnosis/structure.h"
#include "core/estimation/estimate.h"

namespace heft {

enum class Verdict { clean, explained, ambiguous, unexplained };
std::string_view toString(Verdict verdict);

struct DiagnoseOptions {
  std::optional<SegmentMode> segments;  ///< Marks where there are any, otherwise contact is found like other causes.
  int surrogates = 200;                 ///< Simulated clean recordings that set the threshold; 0: a fixed one.
  unsigned seed = 1;
  std::vector<std::string> hidden;  ///< Causes not to be looked for, by ID: shows what a missing cause looks like.
  EstimateOptions estimate;         ///< How the payload is estimated, before and after.
};

struct CauseParameter {
  std::string name, unit;
  double value = 0.0, std = 0.0;  ///< In `unit`
};

/// The one of that name, or null.
const CauseParameter* findParameter(const std::vector<CauseParameter>& parameters, std::string_view name);

struct DiagnosedCause {
  std::string id;
  std::string title;     ///< "Force readings out of step"
  std::string sentence;  ///< With the numbers
  std::string check;     ///< What to look at on the rig
  std::vector<CauseParameter> parameters;
  std::vector<std::pair<double, double>> when;  ///< [s]; empty: throughout
  bool direct = false;                          ///< Seen in the samples themselves; evidence and gain are then empty.
  bool ofVelocities = false;                    ///< Seen directly in the reported ones: they are wrong and not used.
  double deltaBic = 0.0, pValue = 0.0;
  diagnosis::Gain gain;               ///< On blocks that were held out, the other causes in place
  diagnosis::Wrenches before, after;  ///< 6 x N, left over on such blocks without and with it; empty if seen directly
  std::vector<std::string> alternatives;
  std::string tellApart;
};

/// Whether it means that the sensor sits elsewhere, or turned another way, than stated.
bool mountIsWrong(const DiagnosedCause& cause);

/// What a cause would have to reach to be seen in this recording.
struct Smallest {
  std::string cause, parameter, unit;
  double value = 0.0;
};

/// Wrench as measured, as simulated by the baseline and by the extended model; for plots, on blocks of about 20 ms.
struct DiagnosisSeries {
  VectorXd time;                      ///< [s]
  diagnosis::Wrenches measured;       ///< 6 x N
  diagnosis::Wrenches before, after;  ///< Simulated; each block by parameters fitted without it
  std::vector<bool> judged;           ///< False: trimmed, contact, marked
};

struct DiagnosisReport {
  std::string file;
  bool ofPoses = false;  ///< The sensor's pose was recorded and no joints: where the meta file mounts it is not used
  Verdict verdict = Verdict::clean;
  std::string sentence;                  ///< The verdict in plain words
  diagnosis::WrenchRms baseline, noise;  ///< Misfit of bias and payload; noise floor
  std::vector<DiagnosedCause> causes;
  diagnosis::Structure remaining;  ///< What nothing accounts for; gain <= 0: nothing
  double threshold = 10.0;
  int surrogates = 0;
  EstimateReport before, after;  ///< Payload as estimated from the recording, and with the causes taken out
  std::vector<Smallest> smallest;
  nlohmann::json metaChanges() const;  ///< What the meta file should say instead; empty object: nothing
  RecordingMeta meta;
  diagnosis::Model model;                          ///< Extended model
  std::optional<diagnosis::FrameMistake> mistake;  ///< Undone before everything else
  DiagnosisSeries series;
  Findings findings;
  /// On another recording, where one was given: misfit of the baseline, and with the causes kept as found here.
  struct Check {
    std::string file;
    diagnosis::WrenchRms before, after;
    double gain = 0.0;                     ///< Evidence there for these causes, of which nothing was fitted
    bool setsRight = false;                ///< Without them the payload there cannot be, such as a mass below zero
    std::vector<std::string> checked;      ///< IDs
    std::vector<std::string> ofOneMoment;  ///< IDs of those that say nothing of another recording, such as a drift
    bool holds() const;
  };
  std::optional<Check> check;
  double seconds = 0.0;
};

/// `robot` may be null where the recording carries poses. Fails like estimate().
Result<DiagnosisReport> diagnose(const Recording& recording, const RobotModel* robot, const DiagnoseOptions& options,
                                 const Progress& progress = {});

/// Applies the causes of `report`, and its mistake of frames or signs if any, to another recording and fits bias and
/// payload only.
Result<DiagnosisReport::Check> checkOn(const DiagnosisReport& report, const Recording& other, const RobotModel* robot);
/// What came of it, in plain words.
std::string checkText(const DiagnosisReport::Check& check);

/// What the causes add to the wrench [N, N m] at each row of the recording: measured minus this is what the rigid
/// payload and the bias alone would read. `causes`: IDs to apply; empty: all.
Result<Eigen::Matrix<double, Eigen::Dynamic, 6>> effectOf(const diagnosis::Model& model, const Recording& recording,
                                                          const RobotModel* robot,
                                                          const std::vector<std::string>& causes = {});

/// The contract's heft.diagnose/1.
nlohmann::json toJson(const DiagnosisReport& report);
std::string toText(const DiagnosisReport& report);
/// What is left unknown, in one sentence; empty where nothing is.
std::string unknownText(const DiagnosisReport& report);

/// By how many standard deviations, as before, the mass, the centre of mass (x, y, z) and the inertia about it (xx, xy,
/// xz, yy, yz, zz) change where the causes are taken out; 0 where a deviation is unknown.
Vector10d payloadShift(const DiagnosisReport& report);

/// The extended model as it stands in toJson(report)["model"].
nlohmann::json modelToJson(const diagnosis::Model& model);
/// A cause in a form of another version that this one does not know is an error, or, where `unknown` is given, left out
/// and its ID put there.
Result<diagnosis::Model> modelFromJson(const nlohmann::json& model, const Recording& recording, const RobotModel* robot,
                                       std::vector<std::string>* unknown = nullptr);

}  // namespace heft
