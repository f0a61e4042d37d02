#pragma once
// Naming causes one after the other, each by the evidence it adds. What could stand in their place is asked in the end:
// rival_comparison.h.
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "core/base/progress.h"
#include "core/diagnosis/search/candidate_fits.h"
#include "core/diagnosis/search/evidence.h"

namespace heft::diagnosis {

/// What a search has found when it is asked whether it ends there.
struct SearchStatus {
  const Fit& fit;
  bool isFirst = false;    ///< Whether the cause that was accepted last is the first one
  std::string_view last;   ///< Cause that was accepted last
  double gain = 0.0;       ///< Evidence of that
  double explained = 0.0;  ///< Evidence of everything that was accepted
};

struct SearchOptions {
  double threshold = kThreshold;
  int maxTerms = 6;
  Model start;  ///< Terms to begin with, as a search on nearly the same blocks found them
  /// Asked with each cause accepted: whether the search is given up there. Empty: never.
  std::function<bool(const SearchStatus& standing)> stopsEarly;
};

/// A cause that explains a step (almost) as well.
struct Rival {
  std::string cause;
  double behind = 0.0;                    ///< Evidence that it lacks against the accepted one
  double worse = 0.0;                     ///< The same without the price of parameters: by how much it fits worse
  int extra = 0;                          ///< Parameters that it has more
  bool anyCourse = false;                 ///< See takesAnyCourse()
  Vector10d payload = Vector10d::Zero();  ///< That goes with it
};

struct Found {
  std::string cause;
  double gain = 0.0;          ///< Evidence lost if it is taken out of the final model again
  std::vector<Rival> rivals;  ///< Tried in its place, best first
  VectorXd spread;  ///< Of its only term's parameters: how far away others are that explain as much; empty: unknown
};

/// Whether the recording leaves it open which of the two it is. Where only its price sets a rival back, simplicity
/// decides; not, though, between look-alikes, nor where there is little evidence at all, nor where the rival fits
/// better by more than idle parameters would.
bool tied(const Found& found, const Rival& rival);

struct Search {
  Fit null;                        ///< Bias and payload alone
  Fit final;                       ///< With everything accepted
  std::vector<std::string> order;  ///< Causes in `final`, in the order of acceptance
  CandidateFits accepted;          ///< The trials that the last of them was chosen from
  std::vector<Found> found;        ///< By cause, in that order, once compareRivals() has compared them
  bool givenUp = false;            ///< `final` is as far as it came, and nothing was compared
};

/// `bank`: of these signals. Nothing is compared yet.
Search search(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank,
              const SearchOptions& options, const Progress& progress);

/// The best that one more term of one of the `causes` makes of `base`; none where nothing believable comes of it. Of
/// the forms that promise anything, `most` are tried at most, and no more where none of those that promise most can be
/// believed.
std::optional<Fit> withOneOf(const Signals& signals, const std::vector<Stretch>& stretches, SignatureBank& bank,
                             const Fit& base, std::span<const std::string_view> causes,
                             std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace heft::diagnosis
