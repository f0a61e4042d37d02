#pragma once
// The engineer's part of a result: rows, the frame they are stated in, and how the numbers depend on each other.
#include <functional>

#include "ui/models/result_text.h"

class QVBoxLayout;
class QWidget;

namespace heft {

/// At the end of `column`, under a title with the role "details". `frame` is a place in `result.frames`; another one
/// that the user chooses is shown at once and told.
void addDetailSection(QVBoxLayout* column, QWidget* content, const ResultText& result, int frame,
                      std::function<void(int)> frameChosen);

/// All of it as a table, for a spreadsheet or a message.
QString detailTable(const ResultText& result);

}  // namespace heft
