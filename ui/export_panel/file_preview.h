#pragma once
// The payload file as it would be written: line numbers, doubtful lines tinted, a button that copies it.
#include <QStringList>
#include <QWidget>
#include <vector>

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace heft {

class FilePreview : public QWidget {
  Q_OBJECT
 public:
  explicit FilePreview(QWidget* parent = nullptr);

  void showFile(const QString& name, const QString& text, const std::vector<int>& doubtful);
  void showNothing(const QString& why);
  /// "not saved", "saved".
  void setSaved(bool saved);
  QString text() const;

 signals:
  void copyWanted();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void tint();

  QLabel* name_;
  QLabel* tag_;
  QPushButton* copy_;
  QPlainTextEdit* edit_;
  std::vector<int> doubtful_;
};

}  // namespace heft
