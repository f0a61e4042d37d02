#include "ui/export_panel/file_preview.h"

#include <QEvent>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSyntaxHighlighter>
#include <QTextBlock>
#include <QVBoxLayout>
#include <QVariant>

#include "ui/theme/icons.h"
#include "ui/theme/theme.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/pane_header.h"

namespace heft {
namespace {

constexpr int kGutter = 44;

/// Names blue, numbers orange, remarks grey: enough for every format.
class Colours : public QSyntaxHighlighter {
 public:
  using QSyntaxHighlighter::QSyntaxHighlighter;

 protected:
  void highlightBlock(const QString& text) override {
    const Theme& t = theme();
    static const QRegularExpression number(QStringLiteral("(?<![\\w.])-?\\d+(\\.\\d+)?([eE][-+]?\\d+)?"));
    static const QRegularExpression name(QStringLiteral("\"[^\"]*\"(?=\\s*:)|\\b[A-Za-z_]\\w*(?=\\s*[:=(])"));
    static const QRegularExpression remark(QStringLiteral("^\\s*(//|#|;|!|<!--|&).*$"));
    const auto paint = [&](const QRegularExpression& what, const QColor& colour) {
      for (auto it = what.globalMatch(text); it.hasNext();) {
        const auto match = it.next();
        setFormat(match.capturedStart(), match.capturedLength(), colour);
      }
    };
    paint(number, t.axisSimulated[0]);
    paint(name, t.axisSimulated[2]);
    paint(remark, t.text3);
  }
};

/// Line numbers in the viewport's left margin.
class NumberedText : public QPlainTextEdit {
 public:
  explicit NumberedText(QWidget* parent) : QPlainTextEdit(parent), gutter_(new Gutter(this)) {
    setViewportMargins(kGutter, 0, 0, 0);
    connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect&, int dy) {
      if (dy) {
        gutter_->scroll(0, dy);
      } else {
        gutter_->update();
      }
    });
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QPlainTextEdit::resizeEvent(event);
    gutter_->setGeometry(0, 0, kGutter, height());
  }

 private:
  class Gutter : public QWidget {
   public:
    explicit Gutter(NumberedText* edit) : QWidget(edit), edit_(edit) {}
    void paintEvent(QPaintEvent*) override {
      QPainter painter(this);
      painter.fillRect(rect(), theme().panel);
      painter.setPen(theme().text3);
      painter.setFont(edit_->font());
      for (QTextBlock block = edit_->firstVisibleBlock(); block.isValid(); block = block.next()) {
        const QRectF at = edit_->blockBoundingGeometry(block).translated(edit_->contentOffset());
        if (at.top() > height()) break;
        painter.drawText(QRectF(0, at.top(), kGutter - 14, at.height()), Qt::AlignRight | Qt::AlignVCenter,
                         QString::number(block.blockNumber() + 1));
      }
    }

   private:
    NumberedText* edit_;
  };
  Gutter* gutter_;
};

}  // namespace

FilePreview::FilePreview(QWidget* parent) : QWidget(parent) {
  const PaneHeader top = dressAsPane(this, tr("Preview"), 40);
  QVBoxLayout* column = top.column;
  QWidget* header = top.header;
  QHBoxLayout* row = top.row;
  row->setSpacing(12);
  name_ = styledLabel({}, "caption", header);
  row->addWidget(name_);
  tag_ = styledLabel({}, "tagQuiet", header);
  tag_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  row->addWidget(tag_, 0, Qt::AlignVCenter);
  row->addStretch(1);
  copy_ = new QPushButton(tr("Copy"), header);
  copy_->setObjectName("smallButton");
  copy_->setIcon(themedIcon("copy"));
  copy_->setToolTip(tr("Copy the whole file to the clipboard"));
  connect(copy_, &QPushButton::clicked, this, &FilePreview::copyWanted);
  row->addWidget(copy_);
  edit_ = new NumberedText(this);
  edit_->setObjectName("filePreview");
  edit_->setReadOnly(true);
  edit_->setFrameShape(QFrame::NoFrame);
  edit_->setLineWrapMode(QPlainTextEdit::NoWrap);
  edit_->setAccessibleName(tr("The file, before it is written"));
  QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  font.setPixelSize(13);
  edit_->setFont(font);
  new Colours(edit_->document());
  column->addWidget(edit_, 1);
}

void FilePreview::showFile(const QString& name, const QString& text, const std::vector<int>& doubtful) {
  name_->setText(name);
  doubtful_ = doubtful;
  if (edit_->toPlainText() != text) edit_->setPlainText(text);
  copy_->setEnabled(true);
  tint();
}

void FilePreview::showNothing(const QString& why) {
  name_->setText(why);
  doubtful_.clear();
  edit_->clear();
  copy_->setEnabled(false);
  tag_->hide();
}

void FilePreview::setSaved(bool saved) {
  tag_->setText(saved ? tr("saved") : tr("not saved"));
  tag_->show();
}

QString FilePreview::text() const { return edit_->toPlainText(); }

void FilePreview::tint() {
  QList<QTextEdit::ExtraSelection> selections;
  for (const int line : doubtful_) {
    QTextEdit::ExtraSelection selection;
    selection.format.setBackground(theme().lookTint);
    selection.format.setProperty(QTextFormat::FullWidthSelection, true);
    selection.format.setToolTip(tr("Not determined by the motion"));
    selection.cursor = QTextCursor(edit_->document()->findBlockByNumber(line));
    selections << selection;
  }
  edit_->setExtraSelections(selections);
}

void FilePreview::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  copy_->setIcon(themedIcon("copy"));
  for (auto* colours : edit_->document()->findChildren<QSyntaxHighlighter*>()) colours->rehighlight();
  tint();
}

}  // namespace heft
