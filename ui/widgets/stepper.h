#pragma once
// A number with its unit between minus and plus. Typing is taken at Enter or on leaving; what is no such number stays
// there, marked, and refused() says why in one sentence.
#include <QFrame>
#include <optional>

class QLabel;
class QLineEdit;
class QToolButton;

namespace heft {

class Stepper : public QFrame {
  Q_OBJECT
 public:
  struct Range {
    double least, most;
    double step = 1.0;
    int decimals = 1;  ///< At most; zeros at the end are left out.
  };
  /// `unit` "mm" also understands cm, m and in; "°" understands deg. `name` is read out and stands in messages.
  Stepper(const QString& name, const QString& unit, const Range& range, QWidget* parent = nullptr);

  void setValue(double value);
  double value() const { return value_; }
  /// Marks the value as one that does not fit; `sentence` empty takes that back. Emits refused().
  void setProblem(const QString& sentence);
  /// Drawn as being dragged or pointed at elsewhere.
  void setStrong(bool strong);
  /// The unit gives way where there is room for the number only.
  QSize minimumSizeHint() const override;

 signals:
  /// The user begins to change it: by holding a button or a key, or by typing. Changes until the next one are one edit.
  void begun();
  void changed(double value);
  /// Empty when it is well again.
  void refused(const QString& sentence);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void step(double steps);
  void take();
  void showValue();
  void fitUnit();
  void mark(const char* property, bool on);

  QString name_, unit_;
  Range range_;
  double value_ = 0.0;
  QLineEdit* field_;
  QLabel* unitLabel_;
  QToolButton *less_, *more_;
};

/// A length or angle as typed: "12", "1,5 cm", "-3 deg"; nothing if it is none. In `unit` ("mm" or "°").
std::optional<double> parseMeasure(const QString& text, const QString& unit);

}  // namespace heft
