#pragma once
// Touches that a search finds: which are plain to see on the way, and which of those left in the end are touches at
// all.
#include <string>
#include <vector>

#include "core/diagnosis/search/search.h"

namespace heft::diagnosis {

struct SmoothingCandidate;
struct Hypothesis;

/// Share of the time that touches may take: a tool that is touched for longer is held.
constexpr double kTouched = 0.25;

/// The `holes` with the touches that a search has found so far, if it found the last of them just now and that stands
/// out among all that it explains, or all go on from the holes; empty otherwise, or where they would take too much of
/// the time.
std::vector<Stretch> holesWithTouches(const Signals& signals, const SearchStatus& standing,
                                      const std::vector<Stretch>& holes);

/// The chain of all that follow but the ringing, in the order of kSettingAside: each sees what those before it left.
/// `sought`: contact was looked for and found on `whole`, beside what the search found.
void setAside(Hypothesis& hypothesis, const Signals& whole, bool sought, const std::vector<std::string>& hidden);

/// Contacts that show what no push makes, or that all obey a law of how the tool moves, are something else. Those that
/// smoothing leaves are left out as well, but they are nothing: a motion that is smoothed can do no better there.
/// `whole`: with the contacts.
void setUnexplainedAside(Hypothesis& hypothesis, const Signals& whole);

/// Light touches that the search found become contact like any other: set aside, not modelled. Too many of them are
/// none, nor are those that are something else.
void setTouchesAside(Hypothesis& hypothesis);

/// Nobody touches a tool again and again for no longer than it takes to knock at it.
void setKnocksAside(Hypothesis& hypothesis);

/// Looks for it in the contacts of `hypothesis`: Hypothesis::carriedLoad, which then are none. Not where a load that
/// changes is among the causes already, or hidden.
void setCarriedLoadAside(Hypothesis& hypothesis, const std::vector<std::string>& hidden);

/// Contacts in which the zero was another one, where it jumps elsewhere, too, or the load, where that changes
/// elsewhere, are no touches but that again: Hypothesis::recurrences.
void setRecurrencesAside(Hypothesis& hypothesis);

/// Looks for it in what `hypothesis` has set aside, on the least smoothed `candidate`: Hypothesis::ringing, which then
/// are no contacts.
void setRingingAside(Hypothesis& hypothesis, const SmoothingCandidate& candidate);

}  // namespace heft::diagnosis
