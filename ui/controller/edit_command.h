#pragma once
// One undo step: a value before and after, and who puts it in place.
#include <QUndoCommand>
#include <functional>
#include <utility>

namespace heft {

template <class T>
class EditCommand : public QUndoCommand {
 public:
  using Apply = std::function<void(const T&)>;
  /// `kind` identifies the part that is edited; edits of one kind with the same mergeKey above 0 become one.
  EditCommand(const QString& text, int kind, int mergeKey, T before, T after, Apply apply)
      : QUndoCommand(text),
        kind_(kind),
        mergeKey_(mergeKey),
        before_(std::move(before)),
        after_(std::move(after)),
        apply_(std::move(apply)) {}

  void undo() override { apply_(before_); }
  void redo() override { apply_(after_); }
  int id() const override { return mergeKey_ > 0 ? kind_ : -1; }
  bool mergeWith(const QUndoCommand* later) override {
    const auto* next = dynamic_cast<const EditCommand*>(later);
    if (!next || next->mergeKey_ != mergeKey_) return false;
    after_ = next->after_;
    return true;
  }

 private:
  int kind_, mergeKey_;
  T before_, after_;
  Apply apply_;
};

}  // namespace heft
