#pragma once
// What a diagnosis found: types only, for whoever reads or shows it.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/diagnosis/frames.h"
#include "core/diagnosis/model/forward_model.h"
#include "core/diagnosis/model/found_values.h"
#include "core/diagnosis/residual_analysis/structure.h"
#include "core/diagnosis/search/cross_validation.h"
#include "core/estimation/estimate.h"

namespace heft {

enum class Verdict { clean, explained, ambiguous, unexplained };
std::string_view toString(Verdict verdict);

struct DiagnosedCause {
  std::string id;
  std::string title;     ///< "Force readings out of step"
  std::string sentence;  ///< With the numbers
  std::string check;     ///< What to look at on the rig
  std::vector<CauseParameter> parameters;
  std::vector<std::pair<double, double>> when;  ///< [s]; empty: throughout
  bool direct = false;                          ///< Seen in the samples themselves; evidence and gain are then empty.
  bool ofMistake = false;                       ///< Found as a mistake of frames or signs: the report's
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
  bool ofPoses = false;  ///< The sensor's pose was recorded: where the setup file mounts it is not used.
  Verdict verdict = Verdict::clean;
  std::string sentence;                  ///< The verdict in plain words
  diagnosis::WrenchRms baseline, noise;  ///< Misfit of bias and payload; noise floor
  std::vector<DiagnosedCause> causes;
  diagnosis::Structure remaining;  ///< What nothing accounts for; gain <= 0: nothing
  double threshold = 10.0;
  int surrogates = 0;
  EstimateReport before, after;  ///< Payload as estimated from the recording, and with the causes taken out
  std::vector<Smallest> smallest;
  nlohmann::json metaChanges() const;  ///< What the setup file should say instead; empty object: nothing
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

}  // namespace heft
