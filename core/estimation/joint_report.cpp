#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/estimation/joint.h"

namespace heft {

nlohmann::json toJson(const JointReport& joint) {
  nlohmann::json out = toJson(joint.report());
  auto recordings = nlohmann::json::array();
  for (const auto& piece : joint.pieces) {
    const nlohmann::json own = toJson(piece.report);
    nlohmann::json entry = own["recording"];
    entry["used"] = piece.used;
    entry["text"] = piece.words;
    entry["alone"] = {{"payload", toJson(piece.alone)}, {"std", toJson(piece.aloneStd)}};
    const auto& c = piece.adds.components;
    entry["adds"] = {{"mass", piece.adds.mass},
                     {"com", piece.adds.com},
                     {"inertia", piece.adds.inertia},
                     {"com_each", {c(1), c(2), c(3)}},
                     {"inertia_each", {{c(4), c(5), c(6)}, {c(5), c(7), c(8)}, {c(6), c(8), c(9)}}}};
    for (const char* key : {"trust", "conventions", "bias", "residual", "segments", "findings"}) entry[key] = own[key];
    recordings.push_back(std::move(entry));
  }
  out["recordings"] = std::move(recordings);
  auto use = nlohmann::json::array();
  for (const std::size_t i : joint.proposal) use.push_back(i + 1);
  out["selection"] = {{"use", use}, {"text", joint.proposalText}};
  return out;
}

std::string toText(const JointReport& joint) {
  std::string text = toText(joint.report());
  text += fmt::format("\n  {} recordings. {}\n", joint.pieces.size(),
                      joint.report().trust == Trust::none ? std::string() : joint.proposalText);
  for (std::size_t i = 0; i < joint.pieces.size(); ++i) {
    const auto& piece = joint.pieces[i];
    if (joint.report().trust == Trust::none || piece.report.trust == Trust::none) {
      text += fmt::format("  {:3}  {}  {}\n", i + 1, piece.report.file,
                          piece.report.trust == Trust::none ? piece.report.whyNoTrust : std::string());
      continue;
    }
    text += fmt::format("  {:3}  {}  {:.1f} s used, by itself {:.3f} +- {:.2g} kg. {}\n", i + 1, piece.report.file,
                        piece.used ? piece.report.usedDuration : 0.0, piece.alone.mass, 1.96 * piece.aloneStd.mass,
                        piece.words);
  }
  return text;
}

}  // namespace heft
