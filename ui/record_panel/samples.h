#pragma once
// Sample recordings for users without one: simulated when first needed.
#include <QString>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace heft {

struct Sample {
  QString file;    ///< Name without folder
  QString title;   ///< "A clean demonstration"
  QString effect;  ///< What is wrong with it, by ID; empty: nothing
  double size = 0.0;
};
std::vector<Sample> samples();

/// Its path; it is written unless it is there.
Result<QString> sampleFile(const Sample& sample, const Progress& progress);

}  // namespace heft
