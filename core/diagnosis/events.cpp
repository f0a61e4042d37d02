#include "core/diagnosis/events.h"

#include <algorithm>
#include <cmath>

namespace heft::diagnosis {

double evidenceForLeavingOut(const Signals& signals, const Fit& fit, Eigen::Index from, Eigen::Index to) {
  // A little of what lies around it starts the memory, as far as it is to be trusted.
  constexpr Eigen::Index kMemory = 8;
  std::vector<Stretch> whole{{from, to}};
  while (whole[0].from > std::max<Eigen::Index>(0, from - kMemory) && signals.usable[static_cast<std::size_t>(whole[0].from - 1)]) --whole[0].from;
  while (whole[0].to < std::min(signals.blocks(), to + kMemory) && signals.usable[static_cast<std::size_t>(whole[0].to)]) ++whole[0].to;
  // Innovations of the stretch cost their square.
  const Eigen::Map<const VectorXd> flat(fit.residual.data(), fit.residual.size());
  const MatrixXd u = whitened(flat, fit.noise, whole);
  double cost = 0.0;
  for (Eigen::Index n = from; n < to; ++n)
    for (Eigen::Index c = 0; c < 6; ++c) cost += u(6 * n + c, 0) * u(6 * n + c, 0) - 1.0;
  const double seconds = static_cast<double>(to - from) / signals.blockRate();
  return cost - 6.0 * std::ceil(10.0 * seconds) * std::log(std::max(2.0, fit.noise.samples));
}

std::vector<Contact> contactsIn(const Signals& signals, const Fit& fit, const std::vector<Stretch>& candidates) {
  std::vector<Contact> out;
  for (const auto& stretch : candidates) {
    Contact contact{signals.blockTime(stretch.from), signals.blockTime(stretch.to - 1), 0.0,
                    evidenceForLeavingOut(signals, fit, stretch.from, stretch.to), stretch};
    if (contact.evidence < kThreshold) continue;
    for (Eigen::Index n = stretch.from; n < stretch.to; ++n)
      contact.peakForce = std::max(contact.peakForce, fit.residual.col(n).head<3>().norm());
    out.push_back(contact);
  }
  return out;
}

}  // namespace heft::diagnosis
