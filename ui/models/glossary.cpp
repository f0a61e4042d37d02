#include "ui/models/glossary.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <nlohmann/json.hpp>
#include <string>

static void initialiseGlossary() { Q_INIT_RESOURCE(glossary); }

namespace heft {
namespace {

struct GlossaryWords {
  Q_DECLARE_TR_FUNCTIONS(Glossary)
};

const nlohmann::json& glossaryTerms() {
  static const nlohmann::json kTerms = [] {
    initialiseGlossary();
    QFile file(QStringLiteral(":/glossary/glossary.json"));
    file.open(QIODevice::ReadOnly);
    return nlohmann::json::parse(file.readAll().toStdString()).at("terms");
  }();
  return kTerms;
}

QString inThisLanguage(const nlohmann::json& words) {
  const char* language = QLocale().language() == QLocale::German ? "de" : "en";
  return QString::fromStdString(words.at(language).get<std::string>());
}

}  // namespace

QString glossaryTip(const QString& id) {
  for (const auto& term : glossaryTerms())
    if (term.at("id") == id.toStdString())
      return QStringLiteral("%1: %2").arg(inThisLanguage(term.at("term")), inThisLanguage(term.at("meaning")));
  return {};
}

QString glossaryTable() {
  const QString row = QStringLiteral("<tr><td>%1</td><td>%2</td><td>%3</td></tr>\n");
  const auto bold = [](const QString& text) { return QStringLiteral("<b>%1</b>").arg(text); };
  QString out = QStringLiteral("<table cellpadding=\"3\">\n") + row.arg(bold(GlossaryWords::tr("Plain words")),
                                                                        bold(GlossaryWords::tr("In the field")),
                                                                        bold(GlossaryWords::tr("What it is")));
  for (const auto& term : glossaryTerms())
    out += row.arg(inThisLanguage(term.at("plain")).toHtmlEscaped(), inThisLanguage(term.at("term")).toHtmlEscaped(),
                   inThisLanguage(term.at("meaning")).toHtmlEscaped());
  return out + QStringLiteral("</table>");
}

}  // namespace heft
