#pragma once
// Practice: a recording that hides one fault; guess, then see.
#include <QString>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

class QVBoxLayout;
class QWidget;

namespace heft {

/// Where practice recordings are written.
QString practiceFolder();
QString practiceFile(std::uint64_t seed);
/// The number of a practice recording by its file; nothing for other recordings.
std::optional<std::uint64_t> practiceSeed(const QString& path);

/// "What is wrong with this recording?": the faults to choose from.
void addGuesses(QVBoxLayout* column, QWidget* parent, const std::function<void(std::string)>& guessed);

/// What was right about the guess, and how to see it next time.
void addFeedback(QVBoxLayout* column, QWidget* parent, const std::string& truth, const std::string& guess,
                 const std::function<void()>& another);

}  // namespace heft
