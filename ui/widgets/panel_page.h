#pragma once
// A page of the panel at the right: one question, what answers it (scrolling), and at the foot the one thing to do
// next.
#include <QStringList>
#include <QWidget>
#include <functional>

class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace heft {

class PanelPage : public QWidget {
  Q_OBJECT
 public:
  explicit PanelPage(QWidget* parent = nullptr);

  /// Empties the page and begins again with its question; the layout takes what follows, children of content().
  QVBoxLayout* restart(const QString& question, const QString& answer = {});
  /// Keeps room under the question for the longest of these answers, so that what follows stays where it is from one
  /// page to the next. After restart().
  void reserveAnswers(const QStringList& answers);
  /// Only the words above; the rest stays.
  void setQuestion(const QString& question, const QString& answer);
  QWidget* content() const;

  using Clicked = std::function<void()>;
  /// The filled button: what to do next. Hidden with an empty text. `icon` is a name of resources/icons.
  void setMainButton(const QString& text, Clicked clicked = {}, const QString& icon = {});
  void setMainEnabled(bool enabled, const QString& why = {});
  /// The plain one beside it ("Back", "Copy"). Hidden with an empty text.
  void setSecondButton(const QString& text, Clicked clicked = {}, const QString& icon = {});
  QPushButton* mainButton() { return main_; }
  QPushButton* secondButton() { return second_; }

  int scrollPosition() const;
  void setScrollPosition(int position);
  /// Scrolls to the part with this property "role", once the page is laid out.
  void reveal(const char* role);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  /// The keyboard stays where it is while the page is built anew: on the control of the same name, else what to do
  /// next.
  void keepFocus();
  void showFoot();
  void refreshIcons();

  QScrollArea* scroll_;
  QWidget* foot_;
  QPushButton* main_;
  QPushButton* second_;
  QString mainIcon_, secondIcon_;
  Clicked mainClicked_, secondClicked_;
};

}  // namespace heft
