#pragma once
// heft estimate WITH --minus WITHOUT, and heft estimate RECORDING --picked-up: what the tool carries.
#include <string>

#include "core/estimation/options.h"
#include "core/import/import.h"

namespace heft::cli {

struct ObjectFiles {
  std::string with;     ///< Recording of the tool with the object
  std::string without;  ///< And without it; empty: it is picked up in the first.
  std::string robot;    ///< "panda" or a URDF; may be empty.
  std::string json;     ///< Result file, "-" or empty.
  bool force = false;
};

/// Estimates both, prints the object, and writes the result. Throws WrongUsage and Failed.
void estimateObject(const ObjectFiles& files, const ImportOptions& import, const EstimateOptions& settings);

}  // namespace heft::cli
