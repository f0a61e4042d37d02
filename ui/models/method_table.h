#pragma once
// All methods side by side as a table of texts, computed without widgets.
#include <QString>
#include <QStringList>
#include <vector>

#include "core/estimation/comparison.h"

namespace heft {

struct MethodRow {
  QStringList cells;  ///< As many as headers; the first is the method's name.
  QString tip;        ///< Why it stopped, or why there is no result.
  bool usable = false;
  bool chosen = false;  ///< The method of the result on screen.
};

struct MethodTable {
  QStringList headers;
  QStringList headerTips;
  std::vector<MethodRow> rows;
};

MethodTable methodTable(const std::vector<ComparedMethod>& methods, Method chosen);

/// "MAP (Heft’s own)", "least squares" ...
QString methodName(Method method);

}  // namespace heft
