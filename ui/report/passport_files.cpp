#include "ui/report/passport_page.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/json_file.h"
#include "core/compensation/passport.h"
#include "ui/models/numbers.h"
#include "ui/models/proof_text.h"
#include "ui/models/result_text.h"
#include "ui/models/units.h"
#include "ui/reality_panel/cause_words.h"
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

QString numbersPart(const EstimateReport& report) {
  const ResultText text = describeResult(report, {});
  QString rows = paper::row({PassportWords::tr("Number"), PassportWords::tr("Value"), PassportWords::tr("95 %"),
                             PassportWords::tr("Known from")},
                            true);
  const auto add = [&](const QString& name, const NumberText& n, const QString& unit) {
    // Some intervals name their unit themselves.
    const bool named = n.plusMinus.contains(unit);
    rows += paper::row({name, n.value, named ? n.plusMinus : n.plusMinus + ' ' + unit, sourceWord(n.source)});
  };
  add(PassportWords::tr("Mass"), text.mass, massUnit().name);
  for (const NumberText& n : text.com) add(PassportWords::tr("Centre %1").arg(n.name), n, lengthUnit().name);
  for (const NumberText& n : text.inertia) add(n.name, n, text.inertiaUnit);
  return paper::heading(PassportWords::tr("Numbers, in the sensor’s axes")) + paper::table(rows);
}

QString provedPart(const json& passport) {
  QString out = paper::heading(PassportWords::tr("Proof"));
  const auto text = describeProof(passport["proof"].dump(), nullptr);
  if (!text) return out + paper::paragraph(PassportWords::tr("These numbers were not proved on another recording."));
  out += QStringLiteral("<p><b>%1</b></p>\n").arg(paper::escaped(text->headline));
  for (const auto& reason : text->reasons) out += paper::paragraph(reason.text);
  return out + paper::paragraph(text->facts.join(' '));
}

QString causesPart(const json& passport) {
  QString out = paper::heading(PassportWords::tr("Causes of misfit"));
  if (!passport["looked_for_causes"].get<bool>()) return out + paper::paragraph(PassportWords::tr("The reality check was not run."));
  if (passport["causes"].empty()) out += paper::paragraph(PassportWords::tr("None was found."));
  for (const json& cause : passport["causes"])
    out += paper::paragraph(textAt(cause, "sentence") + ' ' +
                            (cause["applied"].get<bool>() ? PassportWords::tr("It is taken out of the numbers.")
                                                          : PassportWords::tr("It is not taken out of the numbers.")));
  QStringList unseen;
  for (const json& phrase : passport["not_seen"]) unseen << QString::fromStdString(phrase.get<std::string>());
  if (!unseen.isEmpty())
    out += paper::paragraph(PassportWords::tr("Could not have been seen: %1.").arg(unseen.join(", ")));
  return out;
}

/// "mass_kg" and its like as people say it, in the unit shown.
struct Quantity {
  QString name, unit;
  double scale;
  int decimals;
};
Quantity quantityOf(const QString& id) {
  if (id == QLatin1String("mass_kg"))
    return {PassportWords::tr("Mass"), massUnit().name, massUnit().scale, 3 + massUnit().decimals};
  if (id.startsWith(QLatin1String("com_")))
    return {PassportWords::tr("Centre %1").arg(id.mid(4, 1)), lengthUnit().name, lengthUnit().scale,
            1 + lengthUnit().decimals};
  return {QStringLiteral("I") + id.mid(8, 2), QString::fromUtf8("kg cm²"), 1e4, 2};
}

QString changePart(const json& passport) {
  const json& since = passport["since"];
  if (!since.is_object()) return {};
  QString out = paper::heading(PassportWords::tr("Since the passport of %1").arg(textAt(since, "date")));
  const bool changed = since["mass_and_centre_changed"].get<bool>() || since["inertia_changed"].get<bool>();
  out += paper::paragraph(changed ? PassportWords::tr("The tool has changed, by more than chance.")
                                  : PassportWords::tr("Nothing has changed beyond chance."));
  if (since["other_mount"].get<bool>())
    out +=
        paper::paragraph(PassportWords::tr("The sensor’s mount is stated otherwise, so the mass alone is compared."));
  QString rows = paper::row({PassportWords::tr("Number"), PassportWords::tr("Before"), PassportWords::tr("Now"),
                             PassportWords::tr("Difference"), QString()},
                            true);
  for (const json& each : since["numbers"]) {
    const Quantity q = quantityOf(textAt(each, "quantity"));
    const auto shown = [&](const char* key, double times = 1.0) {
      return numberText(times * q.scale * each[key].get<double>(), q.decimals);
    };
    rows += paper::row({q.name, shown("before"), shown("now"),
                        QStringLiteral("%1 ± %2 %3").arg(shown("difference"), shown("std", 1.96), q.unit),
                        each["more_than_chance"].get<bool>() ? PassportWords::tr("changed") : QString()});
  }
  return out + paper::table(rows);
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

QString passportHtml(const std::string& text, const EstimateReport& report) {
  const json passport = json::parse(text);
  QString out = paper::beginning(PassportWords::tr("Payload passport: %1").arg(textAt(passport, "tool")));
  out += paper::paragraph(PassportWords::tr("%1, %2. Recording %3.")
                              .arg(textAt(passport, "date"), textAt(passport, "program"),
                                   QFileInfo(QString::fromStdString(report.file)).fileName()));
  if (report.trust == Trust::low)
    out +=
        QStringLiteral("<p><b>%1</b></p>\n")
            .arg(paper::escaped(PassportWords::tr("These numbers deserve little trust; see the result’s warnings.")));
  out += numbersPart(report) + provedPart(passport) + causesPart(passport) + changePart(passport);
  return out + paper::ending();
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
        return Error{PassportWords::tr("%1 exists already and was not replaced.").arg(each).toStdString()};
  auto passport = passportOf(contentOf(parts), *report);
  if (!passport) return passport.error();
  if (!before.isEmpty()) {
    const auto read = readJsonFile(before.toStdString());
    if (!read) return read.error();
    const auto change = changeSince(*read, QFileInfo(before).fileName().toStdString(), *passport);
    if (!change) return change.error();
    (*passport)["since"] = toJson(*change);
  }
  const QString html = passportHtml(passport->dump(), *report);
  const QString title = PassportWords::tr("Payload passport: %1").arg(parts.tool.trimmed());
  if (auto written = writeTextFile(jsonFile.toStdString(), passport->dump(2) + "\n"); !written) return written;
  return writeTextFile(pdf.toStdString(), paper::pdf(html, title).toStdString());
}

}  // namespace heft
