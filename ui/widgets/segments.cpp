#include "ui/widgets/segments.h"

#include <QHBoxLayout>
#include <QPushButton>

namespace heft {

Segments::Segments(const QStringList& texts, const QStringList& names, QWidget* parent) : QFrame(parent) {
  setObjectName("choices");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(1, 1, 1, 1);
  row->setSpacing(0);
  for (int i = 0; i < texts.size(); ++i) {
    auto* button = new QPushButton(texts[i], this);
    button->setObjectName(names.value(i));
    button->setCheckable(true);
    connect(button, &QPushButton::clicked, this, [this, i] {
      setChosen(i);
      emit picked(i);
    });
    buttons_.push_back(button);
    row->addWidget(button, 1);
  }
}

void Segments::setChosen(int index) {
  chosen_ = index;
  for (int i = 0; i < static_cast<int>(buttons_.size()); ++i)
    buttons_[static_cast<std::size_t>(i)]->setChecked(i == index);
}

}  // namespace heft
