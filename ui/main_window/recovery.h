#pragma once
// Offers what an earlier session left behind, and shows when the session was saved.
#include <QObject>

namespace heft {

class Autosave;
class Files;
class MessageBar;
class StatusBar;
class Workspace;

class Recovery : public QObject {
  Q_OBJECT
 public:
  struct Parts {
    Workspace* workspace;
    Files* files;
    MessageBar* message;
    StatusBar* status;
  };
  /// `autosave` must outlive it. Offers at once.
  Recovery(Autosave* autosave, const Parts& parts, QObject* parent);

 private:
  void showSaved();
  void showProblem(const QString& why);
  void restore();
  void offerUnfinished();

  Autosave* autosave_;
  Parts parts_;
  QString warning_;  ///< Shown as long as the session cannot be saved
};

}  // namespace heft
