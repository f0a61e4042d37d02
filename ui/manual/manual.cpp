#include "ui/manual/manual.h"

#include <QFile>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLocale>
#include <QScrollBar>
#include <QTextBrowser>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/models/glossary.h"
#include "ui/theme/theme.h"
#include "ui/widgets/basics.h"

static void initialiseManual() { Q_INIT_RESOURCE(manual); }

namespace heft {
namespace {

QString language() { return QLocale().language() == QLocale::German ? QStringLiteral("de") : QStringLiteral("en"); }

/// "live:NAME" is a picture of the window as it is, "picture:NAME" one of what it need not show now.
class Browser : public QTextBrowser {
 public:
  Browser(std::function<QImage(const QString&)> pictureOf, QWidget* parent)
      : QTextBrowser(parent), pictureOf_(std::move(pictureOf)) {}

  QVariant loadResource(int type, const QUrl& name) override {
    const int room = viewport()->width() - 28;
    if (name.scheme() == QLatin1String("picture")) {
      const QImage image(QStringLiteral(":/manual/%1.%2.png").arg(name.path(), language()));
      return image.width() > room ? image.scaledToWidth(std::max(200, room), Qt::SmoothTransformation) : image;
    }
    if (name.scheme() != QLatin1String("live")) return QTextBrowser::loadResource(type, name);
    const QImage image = pictureOf_(name.path());
    if (image.isNull()) return QImage(1, 1, QImage::Format_ARGB32);
    // Text comes first: a picture of a panel is there to be recognised, only the bar of steps is read from it.
    const int width = std::max(200, name.path() == QLatin1String("steps") ? room : room / 2);
    const double ratio = std::max(1.0, devicePixelRatioF());
    QImage scaled = image.scaledToWidth(static_cast<int>(width * ratio), Qt::SmoothTransformation);
    scaled.setDevicePixelRatio(ratio);
    return scaled;
  }

 private:
  std::function<QImage(const QString&)> pictureOf_;
};

}  // namespace

Manual::Manual(std::function<QImage(const QString&)> pictureOf, QWidget* parent) : QWidget(parent) {
  initialiseManual();
  setObjectName("panel");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(1, 0, 0, 0);
  column->setSpacing(0);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(20, 10, 12, 6);
  head->addWidget(styledLabel(tr("Manual"), "cardTitle", this));
  head->addStretch(1);
  auto* close = new IconButton("close", tr("Back to the step (F1 or Esc)"), this);
  close->setObjectName("closeManual");
  connect(close, &QToolButton::clicked, this, &Manual::closeWanted);
  head->addWidget(close);
  column->addLayout(head);
  browser_ = new Browser(std::move(pictureOf), this);
  browser_->setObjectName("manualText");
  browser_->setAccessibleName(tr("Manual"));
  browser_->setFrameShape(QFrame::NoFrame);
  browser_->setOpenExternalLinks(false);
  browser_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  browser_->document()->setDocumentMargin(14);
  column->addWidget(browser_, 1);
}

void Manual::open(const QString& chapter) {
  QFile file(QStringLiteral(":/manual/%1.html").arg(language()));
  if (!file.open(QIODevice::ReadOnly)) return;
  const Theme& t = theme();
  browser_->document()->setDefaultStyleSheet(
      QStringLiteral("body,p,h1,h2{color:%1}h1{font-size:23px}h2{font-size:17px}a{color:%2;text-decoration:none}")
          .arg(t.text.name(), t.accent.name()));
  browser_->clear();
  browser_->document()->setDefaultFont(uiFont(type::kBody));
  browser_->setHtml(QString::fromUtf8(file.readAll()).replace(QStringLiteral("<!-- glossary -->"), glossaryTable()));
  browser_->setFocus();
  // Only after the text is laid out it has a place to go to.
  QTimer::singleShot(0, this, [this, chapter] {
    if (chapter.isEmpty()) {
      browser_->verticalScrollBar()->setValue(0);
    } else {
      browser_->scrollToAnchor(chapter);
    }
  });
}

void Manual::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return emit closeWanted();
  QWidget::keyPressEvent(event);
}

}  // namespace heft
