#pragma once
// What a turned knob does, under the arm: the residual of force and torque, the estimate with its lights, and
// whether the fault could be detected.
#include <QWidget>
#include <array>

#include "core/diagnosis/what_if.h"
#include "core/estimation/identifiability.h"

class QGridLayout;
class QLabel;
class QScrollArea;

namespace heft {

class ChartWidget;
class LightIcon;

class WhatIfPane : public QWidget {
  Q_OBJECT
 public:
  explicit WhatIfPane(QWidget* parent = nullptr);

  /// `calm`: without faults. `known`: what the motion determines at all. Cheap: only words, lights and curves change.
  void show(const WhatIf& whatIf, const WhatIfState& calm, const WhatIfState& state, const Identifiability& known);
  void showNothing(const QString& why);

 signals:
  void closeWanted();

 private:
  static constexpr int kNumbers = 7;  ///< Mass, centre x, y, z, Ixx, Iyy, Izz
  struct NumberRow {
    LightIcon* light;
    QLabel *value, *before;
  };
  void addNumbers(QGridLayout* grid);
  void showNumbers(const WhatIfState& calm, const WhatIfState& state, const Identifiability& known);
  void showCurves(const WhatIfState& calm, const WhatIfState& state);
  void showVerdict(const WhatIf& whatIf, const WhatIfState& calm, const WhatIfState& state);

  std::array<ChartWidget*, 2> charts_{};
  std::array<NumberRow, kNumbers> numbers_{};
  QLabel *verdict_, *alike_;
  QScrollArea* scroll_;
  QGridLayout* grid_;
};

/// "12 ms", "0.40 N/m"
QString knobText(const Knob& knob, double position);

}  // namespace heft
