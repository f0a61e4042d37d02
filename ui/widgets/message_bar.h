#pragma once
// Sentences at the top of the window instead of a dialog in its middle. A warning or an error stays until it is closed,
// also when another one comes; plain information floats over the window, so that nothing moves under the pointer, gives
// way to the next message and disappears on its own.
#include <QFrame>
#include <QTimer>
#include <functional>
#include <vector>

#include "core/base/findings.h"

class QVBoxLayout;

namespace heft {

class MessageBar : public QFrame {
  Q_OBJECT
 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showMessage(Severity severity, const QString& text);
  /// With a button that does something about it and closes the message.
  void showMessage(Severity severity, const QString& text, const QString& action, const std::function<void()>& clicked);
  /// Closes the one with this text, if it is still shown: what it says is no longer so.
  void withdraw(const QString& text);
  /// Of all messages shown, one per line.
  QString text() const;
  /// Closes all of them.
  void clear();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Message {
    Severity severity;
    QString text;
    QWidget* row;
    bool stays;
    bool floats;
  };
  void close(QWidget* row);
  /// Where what floats stands in the window.
  void placeFloating();
  QWidget* addRow(const Message& message, const QString& action, const std::function<void()>& clicked);

  QVBoxLayout* rows_;
  std::vector<Message> messages_;
  QTimer fades_;
};

}  // namespace heft
