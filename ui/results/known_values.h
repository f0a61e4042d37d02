#pragma once
// What the user knows from a scale or from CAD, to compare the estimate with.
#include <QDialog>

#include "core/payload/inertial_parameters.h"

class QLabel;

namespace heft {

class PayloadForm;

/// Empty fields are not known. Weight in kg, centre in mm from the sensor's origin, inertia in kg cm² about the centre
/// of mass, sensor axes.
class KnownValuesDialog : public QDialog {
  Q_OBJECT
 public:
  explicit KnownValuesDialog(const PartialPayload& known, QWidget* parent = nullptr);
  PartialPayload values() const { return values_; }

 private:
  /// Reads the fields; false, with a sentence shown, where they are half filled or impossible.
  bool read();

  PayloadForm* fields_;
  QLabel* problem_;
  PartialPayload values_;
};

}  // namespace heft
