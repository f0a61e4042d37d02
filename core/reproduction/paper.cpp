#include "core/reproduction/paper.h"

namespace heft {

std::string_view toString(Quantity quantity) {
  switch (quantity) {
    case Quantity::mass:
      return "mass";
    case Quantity::com:
      return "com";
    case Quantity::inertia:
      return "inertia";
  }
  return "";
}

std::string_view toString(DataKind data) { return data == DataKind::validation ? "validation" : "measured"; }

namespace {

struct ErrorRecord {
  Method method;
  ParameterSet estimated;
  Quantity quantity;
  double validation, measured;
};

constexpr ErrorRecord kErrors[] = {
    {Method::ceres, ParameterSet::mass, Quantity::mass, 0.00065, 0.04469},
    {Method::ceres, ParameterSet::massCom, Quantity::mass, 0.00397, 0.03657},
    {Method::ceres, ParameterSet::full, Quantity::mass, 0.00072, 0.04058},
    {Method::ceres, ParameterSet::massCom, Quantity::com, 2.32594, 4.78282},
    {Method::ceres, ParameterSet::full, Quantity::com, 1.22541, 2.89111},
    {Method::ceres, ParameterSet::full, Quantity::inertia, 15.4697, 1232.35},
    {Method::eigenLm, ParameterSet::mass, Quantity::mass, 0.00139, 0.11658},
    {Method::eigenLm, ParameterSet::massCom, Quantity::mass, 0.00253, 0.11369},
    {Method::eigenLm, ParameterSet::full, Quantity::mass, 0.00283, 0.11303},
    {Method::eigenLm, ParameterSet::massCom, Quantity::com, 0.29014, 1.61306},
    {Method::eigenLm, ParameterSet::full, Quantity::com, 0.34524, 1.89158},
    {Method::eigenLm, ParameterSet::full, Quantity::inertia, 0.65533, 297.511},
};

struct TimeRecord {
  Method method;
  ParameterSet estimated;
  PaperTime time;
};

constexpr double kMinute = 60.0, kHour = 3600.0;
constexpr TimeRecord kTimes[] = {
    {Method::ceres, ParameterSet::mass, {1.0, true}},
    {Method::ceres, ParameterSet::massCom, {1.0, true}},
    {Method::ceres, ParameterSet::full, {1.0, false}},
    {Method::eigenLm, ParameterSet::mass, {1.0, false}},
    {Method::eigenLm, ParameterSet::massCom, {4.0, false}},
    {Method::eigenLm, ParameterSet::full, {45.0, false}},
    {Method::tlsFast, ParameterSet::mass, {2.9 * kHour, false}},
    {Method::tlsFast, ParameterSet::massCom, {41.1 * kHour, false}},
    {Method::tlsFast, ParameterSet::full, {71.0 * kHour, false}},
    {Method::tlsExact, ParameterSet::mass, {20.0 * kHour, false}},
    {Method::bruteForce, ParameterSet::mass, {1.0, true}},
    {Method::bruteForce, ParameterSet::massCom, {1.5 * kMinute, false}},
};

}  // namespace

std::optional<double> paperError(Method method, ParameterSet estimated, Quantity quantity, DataKind data) {
  for (const auto& record : kErrors)
    if (record.method == method && record.estimated == estimated && record.quantity == quantity)
      return data == DataKind::validation ? record.validation : record.measured;
  return std::nullopt;
}

std::optional<PaperTime> paperTime(Method method, ParameterSet estimated) {
  for (const auto& record : kTimes)
    if (record.method == method && record.estimated == estimated) return record.time;
  return std::nullopt;
}

}  // namespace heft
