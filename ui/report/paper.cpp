#include "ui/report/paper.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QLocale>
#include <QPageLayout>
#include <QPageSize>
#include <QPdfWriter>
#include <QTextDocument>
#include <QTextFrame>
#include <QTextTable>
#include <cmath>

#include "ui/theme/theme.h"

namespace heft::paper {
namespace {

const QString kBodyMargin = QStringLiteral("margin:24px auto");

/// A table that a page's end would cut begins on the next page, if one page holds it.
void keepTogether(QTextDocument& document) {
  const double high = document.pageSize().height();
  for (QTextFrame* frame : document.rootFrame()->childFrames()) {
    auto* table = qobject_cast<QTextTable*>(frame);
    if (!table) continue;
    const QRectF place = document.documentLayout()->frameBoundingRect(table);
    const bool cut = std::floor(place.top() / high) != std::floor((place.bottom() - 1.0) / high);
    if (!cut || place.height() > 0.9 * high) continue;
    QTextTableFormat format = table->format();
    format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
    table->setFormat(format);
  }
}

/// An A4 sheet's part that is written on [px].
QSizeF sheetFor(const QPdfWriter& writer) {
  // Laid out as wide as its pictures and printed to fit: with no page size of its own Qt adds margins and cuts them
  // off.
  const QRectF paper = writer.pageLayout().paintRectPixels(writer.resolution());
  const double wide = kWidth + 8.0;
  return {wide, std::floor(wide * paper.height() / paper.width())};
}

void setUp(QPdfWriter& writer) {
  writer.setPageSize(QPageSize(QPageSize::A4));
  writer.setPageMargins(QMarginsF(14, 14, 14, 14), QPageLayout::Millimeter);
  writer.setResolution(150);
}

void layOut(QTextDocument& document, const QString& html, const QPdfWriter& writer) {
  document.setDefaultFont(uiFont(type::kSection));
  document.setDocumentMargin(0.0);
  // The page's margins are the paper's.
  document.setHtml(QString(html).replace(kBodyMargin, QStringLiteral("margin:0")));
  document.setPageSize(sheetFor(writer));
  keepTogether(document);
}

}  // namespace

QString escaped(const QString& text) { return text.toHtmlEscaped().replace('\n', QStringLiteral("<br>")); }

QString heading(const QString& text) { return QStringLiteral("<h2>%1</h2>\n").arg(escaped(text)); }
QString paragraph(const QString& text) { return QStringLiteral("<p>%1</p>\n").arg(escaped(text)); }

QString row(const QStringList& cells, bool head) {
  QString out = QStringLiteral("<tr>");
  for (const QString& cell : cells)
    out += head ? QStringLiteral("<th align=\"left\">%1</th>").arg(escaped(cell))
                : QStringLiteral("<td>%1</td>").arg(escaped(cell));
  return out + QStringLiteral("</tr>\n");
}
QString table(const QString& rows) {
  return QStringLiteral("<table cellspacing=\"0\" cellpadding=\"3\">\n%1</table>\n").arg(rows);
}

QString beginning(const QString& title) {
  return QStringLiteral(
             "<!DOCTYPE html>\n<html lang=\"%1\"><head><meta charset=\"utf-8\"><title>%2</title>\n<style>"
             "body{font-family:Inter,'Noto "
             "Sans',sans-serif;font-size:14px;color:#1C2630;background:#fff;max-width:720px;%3}"
             "h1{font-size:24px}h2{font-size:18px;margin-top:24px}h3{font-size:14px}"
             "td,th{padding:3px 16px 3px 0;vertical-align:top}th{color:#4C5966}</style></head><body>\n<h1>%2</h1>\n")
      .arg(QLocale().name().left(2), escaped(title), kBodyMargin);
}

QString ending() { return QStringLiteral("</body></html>\n"); }

QByteArray pdf(const QString& html, const QString& title) {
  QBuffer bytes;
  bytes.open(QIODevice::WriteOnly);
  QPdfWriter writer(&bytes);
  setUp(writer);
  writer.setTitle(title);
  writer.setCreator(QStringLiteral("Heft Studio"));
  QTextDocument document;
  layOut(document, html, writer);
  document.print(&writer);
  return bytes.data();
}

int sheets(const QString& html) {
  QBuffer bytes;
  bytes.open(QIODevice::WriteOnly);
  QPdfWriter writer(&bytes);
  setUp(writer);
  QTextDocument document;
  layOut(document, html, writer);
  return document.pageCount();
}

}  // namespace heft::paper
