#pragma once
// The engineer's rows of a result.
#include "ui/models/result_text.h"

namespace heft {

/// Method, residuals, bias, what the motion determined.
std::vector<DetailText> detailTexts(const EstimateReport& report);

/// Whose axes and origin the numbers are stated in.
enum class DetailFrame { sensor, flange };
/// Centre, inertia and principal axes.
std::vector<DetailText> frameTexts(const EstimateReport& report, DetailFrame frame);

MatrixText matrixText(const EstimateReport& report);

}  // namespace heft
