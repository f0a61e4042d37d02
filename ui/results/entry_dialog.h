#pragma once
// What the robot's controller is set to today, and what it reacts to.
#include <QDialog>
#include <array>

#include "core/workspace/session.h"

class QLabel;
class QLineEdit;

namespace heft {

class PayloadForm;

/// As it stands at the controller: flange axes. An empty weight: what the recording tells.
class EntryDialog : public QDialog {
  Q_OBJECT
 public:
  /// `shown` fills the fields of the payload: what `choice` says, else what the recording tells.
  EntryDialog(const ControllerChoice& choice, const PartialPayload& shown, QWidget* parent = nullptr);
  ControllerChoice choice() const { return choice_; }

 private:
  bool read();

  PayloadForm* fields_;
  std::array<QLineEdit*, 3> limits_{};
  QLabel* problem_;
  ControllerChoice choice_;
};

}  // namespace heft
