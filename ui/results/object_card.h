#pragma once
// "Something picked up?" under the result: what the tool carries, from this recording or from two.
#include <QObject>
#include <QStringList>
#include <optional>

#include "core/base/result.h"
#include "ui/controller/carried_objects.h"
#include "ui/steps/script_help.h"
#include "ui/steps/studio_parts.h"

class QVBoxLayout;

namespace heft {

class ObjectCard : public QObject {
  Q_OBJECT
 public:
  ObjectCard(const StudioParts& parts, QWidget* owner);

  /// At the end of a page that is being built.
  void addTo(QVBoxLayout* column, QWidget* content);
  void findPickedUp();
  void askMinus();
  /// Lines of a script that this obeys.
  static ScriptForms scriptForms();
  std::optional<Result<bool>> obey(const QStringList& words);

 signals:
  void changed();
  /// Once after the user asked; not when a changed setting updates the answer.
  void answered();

 private:
  void addAnswer(QVBoxLayout* card, QWidget* content);
  void tell(const Result<bool>& outcome);

  StudioParts parts_;
  QWidget* owner_;
  CarriedObjects* objects_;
  bool waiting_ = false;  ///< Somebody asked and has no answer yet.
};

}  // namespace heft
