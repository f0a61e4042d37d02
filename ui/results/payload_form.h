#pragma once
// Fields for a known payload: mass, centre of mass, inertia; each is optional.
#include <QString>
#include <QWidget>
#include <array>
#include <optional>

#include "core/payload/inertial_parameters.h"

class QFormLayout;
class QLineEdit;

namespace heft {

/// The user's decimal sign, or a point; nothing if it is no finite number.
std::optional<double> typedNumber(const QLineEdit* field);
/// With the user's decimal sign.
QString editableNumber(double value);

class PayloadForm : public QObject {
  Q_OBJECT
 public:
  /// Adds its rows to `form`. `frame`: where the centre is counted from, and along which axes.
  PayloadForm(const PartialPayload& known, const QString& frame, QFormLayout* form, QWidget* parent);

  /// What was typed. Nothing if that makes no sense: problem() says why.
  std::optional<PartialPayload> read();
  QString problem() const { return problem_; }
  /// A mass of zero is allowed: nothing was entered at all.
  void allowZero() { zero_ = true; }

 private:
  std::optional<PartialPayload> fail(const QString& sentence);

  QLineEdit* mass_;
  std::array<QLineEdit*, 3> com_;
  std::array<QLineEdit*, 6> inertia_;  ///< xx, yy, zz, xy, xz, yz
  QString problem_;
  bool zero_ = false;
};

}  // namespace heft
