#pragma once
// HTML for paper, in the words of a report: headings, tables, and the same as PDF. Private to ui/report.
#include <QByteArray>
#include <QString>
#include <QStringList>

namespace heft::paper {

inline constexpr int kWidth = 680;  ///< [px] of pictures

QString escaped(const QString& text);
QString heading(const QString& text);
QString paragraph(const QString& text);
QString row(const QStringList& cells, bool head = false);
QString table(const QString& rows);
/// The document up to its title, which is shown, too; and its end.
QString beginning(const QString& title);
QString ending();

/// A document of beginning() and ending() on A4 sheets.
QByteArray pdf(const QString& html, const QString& title);
/// How many sheets that takes.
int sheets(const QString& html);

}  // namespace heft::paper
