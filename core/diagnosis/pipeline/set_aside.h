#pragma once
// Touches that a search finds: which are plain to see on the way, and which of those left in the end are touches at
// all.
#include <vector>

#include "core/diagnosis/search/search.h"

namespace heft::diagnosis {

struct Way;
struct Work;

/// The `holes` with the touches that a search has found so far, if it found the last of them just now and that stands
/// out among all that it explains, or all go on from the holes; empty otherwise, or where they would take too much of
/// the time.
std::vector<Stretch> holesWithTouches(const Signals& signals, const Standing& standing,
                                      const std::vector<Stretch>& holes);

/// Contacts that show what no push makes, or that all obey a law of how the tool moves, are something else. Those that
/// smoothing leaves are left out as well, but they are nothing: a motion that is smoothed can do no better there.
/// `whole`: with the contacts.
void setOddAside(Work& work, const Signals& whole);

/// Light touches that the search found become contact like any other: set aside, not modelled. Too many of them are
/// none, nor are those that are something else.
void setTouchesAside(Work& work);

/// Nobody touches a tool again and again for no longer than it takes to knock at it.
void setKnocksAside(Work& work);

/// Looks for it in the contacts of `work`: Work::carried, which then are none. Not where a load that changes is among
/// the causes already, or hidden.
void setCarriedAside(Work& work, const std::vector<std::string>& hidden);

/// Contacts in which the zero was another one, where it jumps elsewhere, too, or the load, where that changes
/// elsewhere, are no touches but that again: Work::again.
void setAgainAside(Work& work);

/// Looks for it in what `work` has set aside, on the least smoothed `way`: Work::ringing, which then are no contacts.
void setRingingAside(Work& work, const Way& way);

}  // namespace heft::diagnosis
