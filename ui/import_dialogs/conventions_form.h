#pragma once
// What the numbers of a recording mean where a driver or a controller has its own ways: folded away until it is wanted.
#include <QWidget>
#include <array>
#include <span>

#include "core/recording/conventions.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace heft {

class ConventionsForm : public QWidget {
  Q_OBJECT
 public:
  explicit ConventionsForm(const Conventions& conventions, QWidget* parent = nullptr);

  Conventions conventions() const;

 signals:
  void folded();

 private:
  struct UnitChoice {
    QComboBox* name;
    QDoubleSpinBox* si;  ///< In one of another unit.
  };
  /// `key`: of the setup file, ui/models/setup_words.h.
  QComboBox* addChoice(QFormLayout* form, const char* name, const char* key, int now);
  UnitChoice addUnit(QFormLayout* form, const char* name, const char* key, std::span<const Conventions::Unit> units,
                     const Conventions::Unit& now);
  static Conventions::Unit chosen(const UnitChoice& choice, std::span<const Conventions::Unit> units,
                                  const Conventions::Unit& before);
  void enableNumbers();

  Conventions before_;
  QComboBox *axes_, *point_, *torqueSign_, *order_, *mirror_, *angles_, *lengths_, *pose_, *quaternions_;
  std::array<QDoubleSpinBox*, 3> offset_{};
  UnitChoice force_{}, torque_{};
};

}  // namespace heft
