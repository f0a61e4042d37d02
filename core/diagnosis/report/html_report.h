#pragma once
// The diagnosis as a page on its own, with plots: inline SVG, no scripts, nothing fetched.
#include <span>
#include <string>

#include "core/diagnosis/wording/views.h"

namespace heft {

/// `witnesses`: of the same recording; empty where the motion could not be worked out.
std::string toHtml(const DiagnosisReport& report, std::span<const diagnosis::Witness> witnesses);

}  // namespace heft
