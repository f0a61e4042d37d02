#include "ui/results/detail_section.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QHelpEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolTip>
#include <QVBoxLayout>
#include <QVariant>
#include <cmath>
#include <utility>

#include "ui/models/numbers.h"
#include "ui/results/detail_rows.h"
#include "ui/theme/theme.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/segments.h"

namespace heft {
namespace {

struct SectionWords {
  Q_DECLARE_TR_FUNCTIONS(ResultPanel)
};

QStringList frameNames() { return {SectionWords::tr("Sensor"), SectionWords::tr("Flange")}; }

/// A square a pair, the stronger the correlation the darker, with its number.
class CorrelationView : public QWidget {
 public:
  CorrelationView(MatrixText matrix, QWidget* parent) : QWidget(parent), matrix_(std::move(matrix)) {
    setObjectName("correlationView");
    setAccessibleName(SectionWords::tr("Correlation of the numbers"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFixedHeight((count() + 1) * kRow);
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    constexpr double kStrong = 0.9;  ///< From here on the two can hardly be told apart.
    const Theme& t = theme();
    QPainter painter(this);
    painter.setFont(uiFont(kDigits));
    for (int k = 0; k < count(); ++k) {
      painter.setPen(t.text2);
      painter.drawText(cell(-1, k), Qt::AlignCenter, matrix_.names[k]);
      painter.drawText(cell(k, -1), Qt::AlignLeft | Qt::AlignVCenter, matrix_.names[k]);
    }
    for (int row = 0; row < count(); ++row)
      for (int column = 0; column <= row; ++column) {
        const double r = matrix_.values(row, column), size = std::abs(r);
        QColor ground = r < 0 ? t.markContact : t.markFree;
        ground.setAlphaF(row == column ? 0.0 : 0.6 * size);
        painter.fillRect(cell(row, column).adjusted(0.5, 0.5, -0.5, -0.5), ground);
        painter.setFont(uiFont(kDigits, row != column && size >= kStrong ? QFont::Bold : QFont::Normal));
        painter.setPen(row == column ? t.text3 : t.text);
        painter.drawText(cell(row, column), Qt::AlignCenter, row == column ? QStringLiteral("1") : numberText(r, 2));
      }
  }
  bool event(QEvent* event) override {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    for (int row = 0; row < count(); ++row)
      for (int column = 0; column < row; ++column)
        if (cell(row, column).contains(help->pos()))
          QToolTip::showText(
              help->globalPos(),
              SectionWords::tr("%1 with %2: %3")
                  .arg(matrix_.names[row], matrix_.names[column], numberText(matrix_.values(row, column), 3)),
              this);
    return true;
  }

 private:
  static constexpr int kRow = 19, kName = 26, kDigits = 10;  ///< [px]
  int count() const { return static_cast<int>(matrix_.names.size()); }
  /// -1: the names.
  QRectF cell(int row, int column) const {
    const double wide = (width() - kName) / static_cast<double>(count());
    return column < 0 ? QRectF(0, (row + 1) * kRow, kName, kRow)
                      : QRectF(kName + column * wide, (row + 1) * kRow, wide, kRow);
  }
  MatrixText matrix_;
};

void addFrames(QVBoxLayout* column, QWidget* content, const ResultText& result, int frame,
               std::function<void(int)> chosen) {
  column->addSpacing(4);
  column->addWidget(styledLabel(SectionWords::tr("In the frame of"), "sectionTitle", content));
  auto* choice = new Segments(frameNames(), {"frameSensor", "frameFlange"}, content);
  choice->setChosen(frame);
  column->addWidget(choice);
  std::vector<QWidget*> pages;
  for (std::size_t k = 0; k < result.frames.size(); ++k) {
    auto* page = new QWidget(content);
    auto* rows = new QVBoxLayout(page);
    rows->setContentsMargins(0, 0, 0, 0);
    addDetailRows(rows, result.frames[k], page);
    page->setVisible(static_cast<int>(k) == frame);
    column->addWidget(page);
    pages.push_back(page);
  }
  QObject::connect(choice, &Segments::picked, content, [choice, pages, chosen = std::move(chosen)](int picked) {
    choice->setChosen(picked);
    for (std::size_t k = 0; k < pages.size(); ++k) pages[k]->setVisible(static_cast<int>(k) == picked);
    chosen(picked);
  });
}

}  // namespace

QString detailTable(const ResultText& result) {
  QStringList lines;
  const auto add = [&](const std::vector<DetailText>& rows) {
    for (const DetailText& detail : rows)
      lines << detail.name + QChar('\t') + QString(detail.value).replace('\n', QStringLiteral("\n\t"));
  };
  add(result.details);
  for (std::size_t k = 0; k < result.frames.size(); ++k) {
    lines << frameNames().value(static_cast<int>(k));
    add(result.frames[k]);
  }
  lines << SectionWords::tr("Correlation of the numbers") + QChar('\t') + result.correlation.names.join('\t');
  for (int row = 0; row < result.correlation.names.size(); ++row) {
    QStringList values{result.correlation.names[row]};
    for (int column = 0; column < result.correlation.names.size(); ++column)
      values << numberText(result.correlation.values(row, column), 3);
    lines << values.join('\t');
  }
  return lines.join('\n');
}

void addDetailSection(QVBoxLayout* column, QWidget* content, const ResultText& result, int frame,
                      std::function<void(int)> frameChosen) {
  column->addSpacing(4);
  QLabel* title = styledLabel(SectionWords::tr("Details"), "sectionTitle", content);
  title->setProperty("role", "details");
  column->addWidget(title);
  addDetailRows(column, result.details, content);
  if (!result.frames.empty()) addFrames(column, content, result, frame, std::move(frameChosen));
  if (!result.correlation.names.isEmpty()) {
    column->addSpacing(4);
    QLabel* name = styledLabel(SectionWords::tr("Correlation of the numbers"), "sectionTitle", content);
    name->setToolTip(
        SectionWords::tr("Near 1 or −1, an error of one number comes with an error of the other: this motion does not "
                         "separate them well. Inertia is about the centre of mass, in the sensor’s axes."));
    column->addWidget(name);
    column->addWidget(new CorrelationView(result.correlation, content));
  }
  auto* copy = new QPushButton(SectionWords::tr("Copy the details"), content);
  copy->setObjectName("copyDetails");
  copy->setToolTip(SectionWords::tr("As a table, for a spreadsheet or a message"));
  QObject::connect(copy, &QPushButton::clicked, content,
                   [result] { QGuiApplication::clipboard()->setText(detailTable(result)); });
  column->addWidget(copy, 0, Qt::AlignLeft);
}

}  // namespace heft
