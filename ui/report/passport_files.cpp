#include "ui/report/passport_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/json_file.h"
#include "core/compensation/passport.h"
#include "core/compensation/passport_page.h"
#include "ui/models/proof_text.h"
#include "ui/reality_cards/cause_words.h"
#include "ui/report/paper.h"

namespace heft {
namespace {

using nlohmann::json;

struct PassportWords {
  Q_DECLARE_TR_FUNCTIONS(Passport)
};

constexpr qint64 kLargestPassport = 1 << 20;  // [bytes] A usual one takes 20 kB.
constexpr int kMostUnseen = 6;                // Of what could not have been seen: one line of the sheet

QString textAt(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? QString::fromStdString(found->get<std::string>()) : QString();
}

PassportContent contentOf(const PassportParts& parts) {
  PassportContent out;
  out.tool = parts.tool.trimmed().toStdString();
  out.date = parts.date.toString(Qt::ISODate).toStdString();
  out.program = "Heft Studio " + QCoreApplication::applicationVersion().toStdString();
  const json proof = json::parse(parts.workspace->session().proof, nullptr, false);
  const Payload now = parts.workspace->report()->payload;
  // A proof of other numbers says nothing about these.
  if (const auto text = describeProof(parts.workspace->session().proof, &now); text && !text->outdated)
    out.proof = proof;
  if (!parts.diagnosis) return out;
  out.lookedForCauses = true;
  const auto& applied = parts.workspace->corrections().causes;
  for (const DiagnosedCause& cause : parts.diagnosis->causes)
    out.causes.push_back({cause.id, sentenceOf(cause, *parts.diagnosis).toStdString(),
                          std::find(applied.begin(), applied.end(), cause.id) != applied.end()});
  for (const QString& phrase : couldNotBeSeen(*parts.diagnosis, kMostUnseen))
    out.notSeen.push_back(phrase.toStdString());
  return out;
}

}  // namespace

QString newestPassport(const QString& folder, const QString& tool, const QString& except) {
  QString newest, date;
  for (const QFileInfo& info : QDir(folder).entryInfoList({"*.json"}, QDir::Files, QDir::Time | QDir::Reversed)) {
    if (info.size() > kLargestPassport || info.absoluteFilePath() == QFileInfo(except).absoluteFilePath()) continue;
    const auto read = readJsonFile(info.absoluteFilePath().toStdString());
    if (!read || !read->is_object() || textAt(*read, "schema") != QLatin1String("heft.passport/1") ||
        textAt(*read, "tool") != tool.trimmed() || textAt(*read, "date") < date)
      continue;
    newest = info.absoluteFilePath();
    date = textAt(*read, "date");
  }
  return newest;
}

Result<bool> writePassport(const PassportParts& parts, const QString& file, const QString& before, bool replace) {
  const auto report = parts.workspace->report();
  if (!report) return Error{PassportWords::tr("A passport needs a result.").toStdString()};
  QString base = file;
  for (const char* ending : {".pdf", ".json"})
    if (base.endsWith(QLatin1String(ending), Qt::CaseInsensitive)) base.chop(static_cast<int>(qstrlen(ending)));
  const QString pdf = base + ".pdf", jsonFile = base + ".json";
  if (!replace)
    for (const QString& each : {pdf, jsonFile})
      if (QFileInfo::exists(each))
        return Error{PassportWords::tr("%1 already exists and was not overwritten.").arg(each).toStdString()};
  auto passport = passportOf(contentOf(parts), toJson(*report), report->file);
  if (!passport) return passport.error();
  if (!before.isEmpty()) {
    const auto read = readJsonFile(before.toStdString());
    if (!read) return read.error();
    const auto change = changeSince(*read, QFileInfo(before).fileName().toStdString(), *passport);
    if (!change) return change.error();
    (*passport)["since"] = toJson(*change);
  }
  const QString html =
      QString::fromStdString(passportPage(*passport, pageUnits(), QLocale().name().left(2).toStdString()));
  const QString title = QString::fromStdString(passportTitle(*passport));
  if (auto written = writeTextFile(jsonFile.toStdString(), passport->dump(2) + "\n"); !written) return written;
  return writeTextFile(pdf.toStdString(), paper::pdf(html, title).toStdString());
}

}  // namespace heft
