#pragma once
// Names and values in two columns, for the engineer's rows.
#include <vector>

#include "ui/models/result_text.h"

class QVBoxLayout;
class QWidget;

namespace heft {

/// At the end of `column`; values can be selected, tips stand on both.
void addDetailRows(QVBoxLayout* column, const std::vector<DetailText>& rows, QWidget* content);

}  // namespace heft
