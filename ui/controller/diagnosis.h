#pragma once
// core/diagnosis for files that use Qt, whose keyword "signals" is an ordinary word there. Include this instead.
#pragma push_macro("signals")
#undef signals
#include "core/diagnosis/correction/corrected.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/wording/views.h"
#pragma pop_macro("signals")
