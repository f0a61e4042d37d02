#pragma once
// What the robot's controller is set to now, and what it reacts to.
#include <QDialog>
#include <array>

#include "core/workspace/session.h"

class QLabel;
class QLineEdit;

namespace heft {

class PayloadForm;

/// As entered in the controller: flange axes. An empty weight means: as the recording states.
class EntryDialog : public QDialog {
  Q_OBJECT
 public:
  /// `shown` fills the fields of the payload: as in `choice`, else as the recording states.
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
