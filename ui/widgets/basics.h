#pragma once
// Small parts that several panels share: themed icon buttons, lights, cards, tags, labels of the type scale.
#include <QFrame>
#include <QLabel>
#include <QToolButton>

class QLineEdit;
class QVBoxLayout;

namespace heft {

/// A flat button whose icon follows the theme. The tooltip is its accessible name too.
class IconButton : public QToolButton {
 public:
  IconButton(const QString& icon, const QString& tip, QWidget* parent = nullptr);
  void setIconName(const QString& icon, const QString& tip);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  QString icon_;
};

/// How sure something is: always a shape and, beside it or in its accessible name, a word.
enum class Light { measured, partly, unknown, look, twoCauses, notPossible, info };
QString lightWord(Light light);
/// The drawing of a light in the colours of the current theme, for painting code.
QPixmap lightPixmap(Light light, int size, qreal devicePixelRatio);

/// The drawing of a light.
class LightIcon : public QWidget {
 public:
  explicit LightIcon(Light light, int size = 22, QWidget* parent = nullptr);
  void setLight(Light light);
  Light light() const { return light_; }
  QSize sizeHint() const override { return {size_, size_}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Light light_;
  int size_;
};

/// Any icon as a drawing beside text.
class IconLabel : public QWidget {
 public:
  explicit IconLabel(const QString& icon, int size = 20, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {size_, size_}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString icon_;
  int size_;
};

/// A label with a style name of the sheet ("question", "caption" ...).
QLabel* styledLabel(const QString& text, const char* style, QWidget* parent = nullptr);
/// The same over several lines.
QLabel* wrappedLabel(const QString& text, const char* style, QWidget* parent = nullptr);

/// Sets what stands in an empty field in the colour of remarks, so that it does not look like a value.
void dimPlaceholder(QLineEdit* field);

/// A dot in the colour of an axis: 0 x, 1 y, 2 z.
class AxisDot : public QLabel {
 public:
  explicit AxisDot(int axis, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void colour();
  int axis_;
};

/// A frame with the style name "card", "cardSuggested", "cardLook" or "cardBad" and an empty vertical layout.
struct Card {
  QFrame* frame;
  QVBoxLayout* layout;
};
Card makeCard(const char* style, QWidget* parent = nullptr);

/// "measured" in green, "from your shape" in amber, "not known from this motion" in grey.
QLabel* makeTag(const QString& text, Light light, QWidget* parent = nullptr);

/// A thin horizontal line.
QFrame* makeDivider(QWidget* parent = nullptr);

}  // namespace heft
