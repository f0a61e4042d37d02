#pragma once
// What the tool is made of: its weight if a scale was there, solid or hollow, its material. Everything may stay open.
#include <QWidget>
#include <optional>

#include "core/payload/tool_sketch.h"

class QComboBox;
class QLabel;
class QLineEdit;

namespace heft {

class Segments;
class Stepper;

/// A weight in kg or g, or none.
class WeightField : public QWidget {
  Q_OBJECT
 public:
  /// `id` begins the object names: id and idUnit.
  WeightField(const QString& name, const QString& id, const QString& placeholder, QWidget* parent = nullptr);
  void showWeight(std::optional<double> kilograms);
  void setWrong(bool wrong);

 signals:
  void changed(std::optional<double> kilograms);
  void refused(const QString& sentence);

 private:
  void take();
  QLineEdit* field_;
  QComboBox* unit_;
  std::optional<double> shown_;
};

class SubstanceForm : public QWidget {
  Q_OBJECT
 public:
  /// `part`: of one of several bodies, else of the whole tool.
  SubstanceForm(const ShapeBody& body, bool part, QWidget* parent = nullptr);

  void showSubstance(const ShapeBody& body, std::optional<double> weight);
  void setWeightProblem(const QString& sentence);
  void setWallProblem(const QString& sentence);

 signals:
  void begun();
  void weightChanged(std::optional<double> kilograms);
  void hollowChanged(bool hollow);
  void wallChanged(double metres);
  /// In kg/m3.
  void materialChanged(std::optional<double> density);

 private:
  WeightField* weight_;
  Segments* inside_ = nullptr;
  QWidget* wallRow_ = nullptr;
  Stepper* wall_ = nullptr;
  QComboBox* material_;
  QLabel *error_, *note_;
};

}  // namespace heft
