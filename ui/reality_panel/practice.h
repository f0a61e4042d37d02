#pragma once
// Practice: a recording that hides one fault; guess, then see.
#include <QString>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "ui/controller/reality_findings.h"

class QVBoxLayout;
class QWidget;

namespace heft {

/// Where practice recordings are written.
QString practiceFolder();
QString practiceFile(std::uint64_t seed);
/// The number of a practice recording by its file; nothing for other recordings.
std::optional<std::uint64_t> practiceSeed(const QString& path);

/// "What is wrong with this recording?": the faults to choose from, and a hint on request. A first wrong guess
/// (`found.tried`) is mentioned, and the user can give up.
struct RiddleActions {
  std::function<void(std::string)> guessed;
  std::function<void()> hintWanted, gaveUp, another;
  std::function<void()> twinWanted;  ///< Show what the recording would be without the fault, or hide it.
};
void addGuesses(QVBoxLayout* column, QWidget* parent, const std::string& truth, const RealityFindings::Found& found,
                const RiddleActions& does);

/// What was right about the guess, how to see it next time, and how many were found so far.
void addFeedback(QVBoxLayout* column, QWidget* parent, const std::string& truth, const RealityFindings::Found& found,
                 const RealityFindings::Score& score, const RiddleActions& does);

}  // namespace heft
