#include "core/import/publishers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/say.h"

namespace heft {

namespace {

bool isPart(const ColumnSource& column, const char* prefix) {
  return column.column.starts_with(prefix) && column.column.size() > std::string_view(prefix).size();
}

}  // namespace

void Publishers::choose() {
  for (const auto s : joining_.used) {
    const auto core = joining_.coreOf(s);
    if (core.empty()) continue;
    std::map<int, Sender> senders;
    const auto& stream = joining_.streams[s];
    for (std::size_t k = 0; k < stream.received.size(); ++k) {
      bool complete = true, zero = true;
      for (const auto* values : core) {
        complete = complete && k < values->size() && std::isfinite((*values)[k]);
        zero = zero && complete && (*values)[k] == 0.0;
      }
      if (!complete) continue;
      const int sender = k < stream.sender.size() ? stream.sender[k] : 0;
      senders[zero ? -1 : sender].rows.push_back(k);
    }
    if (senders.size() < 2) continue;
    for (auto& [id, sender] : senders) {
      for (const auto* values : core) {
        std::vector<double> here;
        for (const auto k : sender.rows) here.push_back((*values)[k]);
        const double mean = std::accumulate(here.begin(), here.end(), 0.0) / static_cast<double>(here.size());
        double squares = 0.0;
        for (const double value : here) squares += (value - mean) * (value - mean);
        sender.spread += std::sqrt(squares / static_cast<double>(here.size()));
      }
    }
    const auto main = std::max_element(senders.begin(), senders.end(),
                                       [](const auto& a, const auto& b) { return a.second.spread < b.second.spread; });
    for (const auto& [id, sender] : senders) {
      if (id == main->first || continues(s, core, main->second, sender)) continue;
      for (const auto k : sender.rows) dropped_[s].insert(k);
      const std::string who = id >= 0 && static_cast<std::size_t>(id) < stream.senders.size()
                                  ? stream.senders[static_cast<std::size_t>(id)]
                                  : std::string();
      joining_.note(
          Severity::warning, "other_publisher",
          id < 0 ? heft::say("{} of {} samples of {} are all zeros between others: another publisher sends there, "
                             "too. They were left out.",
                             sender.rows.size(), stream.received.size(), joining_.nameOf(s))
                 : heft::say("{} of {} samples of {} do not fit the others: another publisher sends there, too ({}). "
                             "The one that moves was taken.",
                             sender.rows.size(), stream.received.size(), joining_.nameOf(s), who));
    }
  }
}

bool Publishers::continues(std::size_t s, const std::vector<const std::vector<double>*>& core, const Sender& main,
                           const Sender& other) const {
  const auto& times = joining_.streams[s].received;
  double off = 0.0;
  std::size_t inside = 0;
  std::size_t next = 0;
  for (const auto k : other.rows) {
    while (next < main.rows.size() && main.rows[next] < k) ++next;
    if (next == 0 || next == main.rows.size()) continue;
    const auto a = main.rows[next - 1], b = main.rows[next];
    const double whole = static_cast<double>(times[b] - times[a]);
    const double share = whole > 0.0 ? static_cast<double>(times[k] - times[a]) / whole : 0.0;
    for (const auto* values : core) off += std::abs((*values)[k] - (1.0 - share) * (*values)[a] - share * (*values)[b]);
    ++inside;
  }
  return inside == 0 || off < 0.2 * main.spread * static_cast<double>(inside);
}

bool Publishers::reported(std::size_t stream, std::size_t k) const {
  if (const auto found = dropped_.find(stream); found != dropped_.end() && found->second.contains(k)) return false;
  const bool joints = std::any_of(joining_.columns.begin(), joining_.columns.end(), [&](const auto& c) {
    return c.stream == stream && isPart(c, "q") && !c.column.ends_with('x') && !c.column.ends_with('y') &&
           !c.column.ends_with('z') && !c.column.ends_with('w');
  });
  if (!joints) return true;
  for (const auto& column : joining_.columns) {
    if (column.stream != stream || !isPart(column, "q")) continue;
    const auto& values = joining_.streams[stream].values[column.field];
    if (k < values.size() && std::isfinite(values[k])) return true;
  }
  return false;
}

std::string Publishers::others(std::size_t s) const {
  const auto& stream = joining_.streams[s];
  std::set<int> mine, all;
  for (std::size_t k = 0; k < stream.sender.size(); ++k) {
    all.insert(stream.sender[k]);
    if (reported(s, k)) mine.insert(stream.sender[k]);
  }
  std::vector<std::string> names;
  for (const int sender : all)
    if (!mine.contains(sender) && names.size() < 3) names.push_back(stream.senders[static_cast<std::size_t>(sender)]);
  return names.empty() ? std::string() : fmt::format(" ({})", fmt::join(names, "; "));
}

}  // namespace heft
