#pragma once
// The manual in place of the step's panel. Its pictures are taken of the window itself whenever a page is shown, so
// that they are always of this version, this language and this theme.
#include <QImage>
#include <QWidget>
#include <functional>

class QTextBrowser;

namespace heft {

class Manual : public QWidget {
  Q_OBJECT
 public:
  /// `pictureOf("record")` draws that part of the window; null pictures are left out.
  explicit Manual(std::function<QImage(const QString&)> pictureOf, QWidget* parent = nullptr);

  /// Loads the text with fresh pictures and goes to a chapter, by the id of a step; empty: the beginning.
  void open(const QString& chapter);
  QTextBrowser* browser() { return browser_; }

 signals:
  void closeWanted();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QTextBrowser* browser_;
};

}  // namespace heft
