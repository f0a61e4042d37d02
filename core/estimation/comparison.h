#pragma once
// Every method on one recording, side by side.
#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/estimation/estimate.h"

namespace heft {

/// All methods, in the order in which help, tables and charts show them.
inline constexpr std::array kAllMethods{Method::map,   Method::ls,      Method::wls,
                                        Method::tls,   Method::tlsFast, Method::tlsExact,
                                        Method::ceres, Method::eigenLm, Method::bruteForce};

struct ComparedMethod {
  Method method = Method::map;
  std::optional<EstimateReport> report;  ///< Absent where the method failed;
  std::string failure;                   ///< this says why then.
};

/// Estimates with every method, everything else as in `options`, one after the other so that their times can be
/// compared. One method's failure is a row; fails only if none gives a result, or if stopped.
Result<std::vector<ComparedMethod>> compareMethods(const Recording& recording, const RobotModel* robot,
                                                   const EstimateOptions& options, const Progress& progress = {});

/// One table, a method a line: mass and its interval, centre of mass, trace of the inertia about it, held-out residual,
/// errors where values are known, times, and why a result is not usable.
std::string toText(const std::vector<ComparedMethod>& methods);

/// A list with a summary of each heft.estimate/1: what differs between methods, without segments and findings.
nlohmann::json toJson(const std::vector<ComparedMethod>& methods);

}  // namespace heft
