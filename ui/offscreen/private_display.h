#pragma once
// A private X server for pictures without a screen. Must be started before QApplication exists.
#include <memory>
#include <string>

#include "core/base/result.h"

namespace heft {

/// Runs as long as the object lives; dies with this process even if it is killed.
class PrivateDisplay {
 public:
  /// Starts Xvfb with one screen of this size and points DISPLAY and Qt at it. The error names the missing package.
  static Result<std::unique_ptr<PrivateDisplay>> start(int width, int height);
  ~PrivateDisplay();
  PrivateDisplay(const PrivateDisplay&) = delete;
  PrivateDisplay& operator=(const PrivateDisplay&) = delete;

  const std::string& name() const { return name_; }  ///< ":99"

 private:
  PrivateDisplay(int pid, std::string name) : pid_(pid), name_(std::move(name)) {}
  int pid_;
  std::string name_;
};

/// Whether a window can be opened: an X server answers at DISPLAY. Otherwise one sentence that says why not.
Result<bool> displayAnswers();

}  // namespace heft
