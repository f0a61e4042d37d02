#include "core/import/signals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/say.h"

namespace heft {

void SignalReader::setAsideSparse() {
  const auto sparse = [&](const std::vector<std::string>& names, const std::string& what) {
    std::size_t missing = 0, rows = 0;
    for (const auto& column : joining_.columns) {
      if (std::find(names.begin(), names.end(), column.column) == names.end()) continue;
      const auto& values = joining_.streams[column.stream].values[column.field];
      std::size_t here = 0;
      rows = 0;
      for (std::size_t k = 0; k < values.size(); ++k) {
        if (!publishers_.reported(column.stream, k)) continue;
        ++rows;
        here += std::isfinite(values[k]) ? 0 : 1;
      }
      missing = std::max(missing, here);
    }
    if (rows == 0 || static_cast<double>(missing) <= kMissingShare * static_cast<double>(rows)) return;
    std::erase_if(joining_.columns, [&](const ColumnSource& column) {
      return std::find(names.begin(), names.end(), column.column) != names.end();
    });
    joining_.note(Severity::info, "columns_set_aside",
                  heft::say("{} missing in {} of {} samples and not used.", what, missing, rows));
  };
  sparse(joining_.numbered("dq"), heft::say("The joint velocities are"));
  if (!joining_.numbered("q").empty()) return;
  sparse({"px", "py", "pz"}, heft::say("The position is"));
}

Signal quaternionsOf(Signal signal, const std::vector<std::string>& form, Conventions::QuaternionOrder order) {
  if (signal.empty()) return signal;
  MatrixXd out(signal.values.rows(), 4);
  for (Eigen::Index k = 0; k < out.rows(); ++k) {
    const Eigen::RowVectorXd row = signal.values.row(k);
    Quaterniond q;
    if (form[0] == "r11") {
      Matrix3d R;
      R << row.segment<3>(0), row.segment<3>(3), row.segment<3>(6);
      q = Quaterniond(R);
      // A matrix that is no rotation shows by a quaternion that is none.
      if (std::abs(R.determinant() - 1.0) > 0.2) q.coeffs().setZero();
    } else if (form[0] == "rvx") {
      const Vector3d v = row.head<3>().transpose();
      q = v.norm() > 0.0 ? Quaterniond(Eigen::AngleAxisd(v.norm(), v.normalized())) : Quaterniond::Identity();
    } else {
      const bool abc = form[0] == "kuka_a";
      const double yaw = row(abc ? 0 : 2), pitch = row(1), roll = row(abc ? 2 : 0);
      q = Eigen::AngleAxisd(yaw, Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Vector3d::UnitY()) *
          Eigen::AngleAxisd(roll, Vector3d::UnitX());
    }
    out.row(k) = q.coeffs().transpose();
  }
  // The order of a quaternion that is stated is another's, and is undone later on.
  if (order == Conventions::QuaternionOrder::wxyz) {
    const MatrixXd xyz = out.leftCols<3>();
    out.col(0) = out.col(3).eval();
    out.rightCols<3>() = xyz;
  }
  signal.values = std::move(out);
  return signal;
}

Signal SignalReader::read(const std::vector<std::string>& names) {
  Signal out;
  std::vector<const ColumnSource*> sources;
  for (const auto& name : names) {
    const auto found =
        std::find_if(joining_.columns.begin(), joining_.columns.end(), [&](const auto& c) { return c.column == name; });
    if (found == joining_.columns.end()) return out;
    sources.push_back(&*found);
  }
  if (sources.empty()) return out;
  out.stream = sources[0]->stream;
  const auto& stream = joining_.streams[out.stream];
  const auto rows = stream.received.size();
  std::vector<std::pair<std::int64_t, std::size_t>> order;
  std::size_t missing = 0;
  std::size_t others = 0;
  std::size_t backwards = 0;
  for (std::size_t k = 0; k < rows; ++k) {
    if (!publishers_.reported(out.stream, k)) {
      others += publishers_.dropsFrom(out.stream) ? 0 : 1;
      continue;
    }
    bool complete = true;
    for (const auto* source : sources) {
      const auto& values = stream.values[source->field];
      complete = complete && k < values.size() && std::isfinite(values[k]);
    }
    if (!complete) {
      ++missing;
      continue;
    }
    const auto time = clocks_.time(out.stream, k);
    if (!isSoundStamp(time)) {
      ++missing;
      continue;
    }
    if (!order.empty() && time < order.back().first) ++backwards;
    order.emplace_back(time, k);
  }
  if (missing > 0)
    joining_.noteOnce(Severity::warning, "values_missing",
                      heft::say("{} of {} samples of {} lack a value and were left out.", missing, rows,
                                joining_.nameOf(out.stream)));
  if (others > 0)
    joining_.noteOnce(
        Severity::info, "other_publisher",
        heft::say("{} of {} samples of {} have none of these joints: another publisher sends there, too{}. They "
                  "were left out.",
                  others, rows, joining_.nameOf(out.stream), publishers_.others(out.stream)));
  if (backwards > 0) {
    std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    joining_.noteOnce(
        Severity::warning, "time_sorted",
        heft::say("{} samples of {} were not in time order and were sorted.", backwards, joining_.nameOf(out.stream)));
  }
  const auto before = order.size();
  order.erase(std::unique(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first == b.first; }),
              order.end());
  if (order.size() < before)
    joining_.noteOnce(Severity::warning, "time_repeated",
                      heft::say("{} of {} samples of {} repeat a time and were left out.", before - order.size(),
                                before, joining_.nameOf(out.stream)));
  out.values.resize(static_cast<Eigen::Index>(order.size()), static_cast<Eigen::Index>(sources.size()));
  for (std::size_t r = 0; r < order.size(); ++r) {
    out.nanoseconds.push_back(order[r].first);
    for (std::size_t c = 0; c < sources.size(); ++c)
      out.values(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) =
          sources[c]->scale * stream.values[sources[c]->field][order[r].second];
  }
  return out;
}

VectorXd clamped(const VectorXd& at, const Signal& signal) {
  return at.cwiseMax(signal.time(0)).cwiseMin(signal.time(signal.time.size() - 1));
}

bool nearSamples(const Signal& signal, double t, double step) {
  const auto after = std::lower_bound(signal.time.begin(), signal.time.end(), t) - signal.time.begin();
  if (after >= signal.time.size()) return false;
  if (after == 0 || signal.time(after) == t) return true;
  return signal.time(after) - signal.time(after - 1) <= kLongestGapSteps * std::max(signal.step, step);
}

}  // namespace heft
