#pragma once
// The lengths of one body in a row, and the tool's pose: steppers in mm and degrees.
#include <QWidget>
#include <array>
#include <vector>

#include "core/payload/tool_sketch.h"

class QLabel;

namespace heft {

class Stepper;

constexpr double kLeastLength = 0.5, kMostLength = 5000.0;  ///< [mm] of a tool

/// The sentence under a row of fields; hidden while there is nothing to say.
QLabel* makeFieldError(QWidget* parent);
void showFieldError(QLabel* label, const QString& sentence);

class BodyForm : public QWidget {
  Q_OBJECT
 public:
  /// `index` of the body, for object names: size_0_2 is the third length of the first body.
  BodyForm(const QString& title, const ShapeBody& body, int index, QWidget* parent = nullptr);

  void showBody(const ShapeBody& body);
  void setProblem(int measure, const QString& sentence);
  /// -1: none.
  void setStrong(int measure);

 signals:
  void begun();
  void changed(int measure, double metres);

 private:
  std::vector<Stepper*> steppers_;
  QLabel* error_;
};

class PlaceForm : public QWidget {
  Q_OBJECT
 public:
  explicit PlaceForm(QWidget* parent = nullptr);

  /// Near end [m] and fixed-axis roll, pitch, yaw [rad], S axes.
  void showPlace(const Vector3d& nearEnd, const Vector3d& rpy);

 signals:
  void begun();
  void moved(const heft::Vector3d& nearEnd);
  void tilted(const heft::Vector3d& rpy);

 private:
  std::array<Stepper*, 3> place_{}, tilt_{};
  QLabel* error_;
};

}  // namespace heft
