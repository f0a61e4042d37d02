#include "ui/export_panel/proof_card.h"

#include <QDate>
#include <QDesktopServices>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QPushButton>
#include <QUrl>
#include <QVBoxLayout>
#include <QVariant>
#include <nlohmann/json.hpp>

#include "core/compensation/proof.h"
#include "ui/controller/only_child.h"
#include "ui/controller/open_recording.h"
#include "ui/controller/reality_findings.h"
#include "ui/controller/workspace.h"
#include "ui/live/live_run.h"
#include "ui/models/proof_text.h"
#include "ui/report/passport_files.h"
#include "ui/widgets/basics.h"

namespace heft {
namespace {

Error sentence(const QString& text) { return Error{text.toStdString()}; }

/// The recording, held against what was entered.
Result<Proof> proofOn(const QString& path, const EnteredPayload& entered, const Progress& progress) {
  ReadCure cure = ReadCure::none;
  const auto opened = loadRecording(path, progress, cure);
  if (!opened) return opened.error();
  EstimateOptions options;
  options.segments = defaultSegmentMode((*opened)->recording);
  return prove(entered, (*opened)->recording, (*opened)->robot.get(), options, (*opened)->findings, progress);
}

}  // namespace

ProofCard::ProofCard(const StudioParts& parts, QWidget* owner)
    : QObject(owner), parts_(parts), owner_(owner), run_(onlyChild<LiveRun>(*parts.workspace)) {
  parts_.followJobs(&jobs_);
  connect(parts_.workspace, &Workspace::proofChanged, this, &ProofCard::changed);
  connect(&jobs_, &JobRunner::started, this, &ProofCard::changed);
  connect(&jobs_, &JobRunner::finished, this, &ProofCard::changed);
  connect(run_, &LiveRun::started, this, &ProofCard::changed);
  connect(run_, &LiveRun::ended, this, &ProofCard::changed);
}

void ProofCard::addTo(QVBoxLayout* column, QWidget* content) {
  const auto report = parts_.workspace->report();
  if (!report || report->trust == Trust::none) return;
  column->addSpacing(4);
  column->addWidget(styledLabel(tr("Is it right on the robot?"), "sectionTitle", content));
  const Card card = makeCard("card", content);
  card.frame->setProperty("role", "proof");
  addProof(card.layout, content);
  addButtons(card.layout, content);
  column->addWidget(card.frame);
}

void ProofCard::addProof(QVBoxLayout* card, QWidget* content) {
  const Payload now = parts_.workspace->report()->payload;
  const auto text = describeProof(parts_.workspace->session().proof, &now);
  if (jobs_.running()) {
    card->addWidget(wrappedLabel(tr("Checking the numbers with that recording …"), "body", content));
    return;
  }
  if (!text) {
    card->addWidget(wrappedLabel(tr("Load the file into the controller, guide the tool in all directions for ten "
                                    "seconds without touching anything, and let Heft check the numbers."),
                                 "body", content));
    return;
  }
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  const bool good = text->passed && !text->outdated;
  row->addWidget(new LightIcon(good ? Light::measured : Light::look, 22, content), 0, Qt::AlignTop);
  row->addWidget(wrappedLabel(QString::fromStdString(text->headline), "findingText", content), 1);
  card->addLayout(row);
  if (text->outdated)
    card->addWidget(wrappedLabel(tr("The numbers have changed since; prove them again."), "body", content));
  for (const auto& reason : text->reasons) {
    card->addWidget(wrappedLabel(QString::fromStdString(reason.text), "body", content));
    if (!reason.remedy.empty())
      card->addWidget(wrappedLabel(QString::fromStdString(reason.remedy), "caption", content));
  }
  QStringList facts;
  for (const std::string& fact : text->facts) facts << QString::fromStdString(fact);
  card->addWidget(wrappedLabel(facts.join(' '), "caption", content));
}

void ProofCard::addButtons(QVBoxLayout* card, QWidget* content) {
  const auto add = [&](const QString& text, const char* name, auto clicked) {
    auto* button = new QPushButton(text, content);
    button->setObjectName("linkButton");
    button->setProperty("role", name);
    button->setEnabled(!jobs_.running());
    connect(button, &QPushButton::clicked, this, clicked);
    card->addWidget(button, 0, Qt::AlignLeft);
  };
  if (run_->running() && !run_->poses()) add(tr("Prove on live data"), "proveLive", [this] { tell(proveLive()); });
  add(tr("Prove on a recording …"), "prove", [this] { chooseRecording(); });
  add(tr("Tool passport …"), "passport", [this] { askPassport(); });
}

void ProofCard::tell(const Result<bool>& outcome) {
  if (!outcome) parts_.say(Severity::error, QString::fromStdString(outcome.error().message));
}

Result<bool> ProofCard::prove(const QString& recording) {
  Workspace& workspace = *parts_.workspace;
  const auto report = workspace.report();
  if (!report) return sentence(tr("Prove needs a result."));
  const auto& files = workspace.session().recordings;
  for (int k = 0; k < static_cast<int>(files.size()); ++k)
    if ((k == workspace.session().active || workspace.joins()) &&
        QFileInfo(QString::fromStdString(files[static_cast<std::size_t>(k)].file.string())) == QFileInfo(recording))
      return sentence(
          tr("The numbers come from %1 itself: prove them on another recording.").arg(QFileInfo(recording).fileName()));
  const QString name = workspace.nameOf(workspace.session().active);
  const auto entered = enteredPayloadFromJson(toJson(*report), name.toStdString());
  if (!entered) return entered.error();
  jobs_.start(
      tr("Proving the numbers"),
      [path = QFileInfo(recording).absoluteFilePath(), entered = *entered](const Progress& progress) {
        return proofOn(path, entered, progress);
      },
      [this](const Result<Proof>& proof) {
        if (proof)
          parts_.workspace->setProof(toJson(*proof).dump());
        else if (!proof.error().cancelled)
          parts_.say(Severity::error, QString::fromStdString(proof.error().message));
      });
  return true;
}

Result<bool> ProofCard::proveLive() {
  if (!run_->running() || run_->file().isEmpty())
    return sentence(tr("No live data: start listening to the robot under Record, then guide the tool."));
  return prove(run_->file());
}

void ProofCard::chooseRecording() {
  const auto opened = parts_.workspace->opened();
  const QString folder = opened ? QFileInfo(opened->path).absolutePath() : QString();
  const QString file = QFileDialog::getOpenFileName(owner_, tr("Prove on a recording"), folder, tr("All files (*)"));
  if (!file.isEmpty()) tell(prove(file));
}

QString ProofCard::toolName() const {
  const auto& session = parts_.workspace->session();
  return QFileInfo(parts_.workspace->nameOf(session.active)).completeBaseName();
}

void ProofCard::askPassport() {
  const auto opened = parts_.workspace->opened();
  if (!opened) return;
  bool ok = false;
  const QString tool = QInputDialog::getText(owner_, tr("Tool passport"), tr("What is the tool called?"),
                                             QLineEdit::Normal, toolName(), &ok)
                           .trimmed();
  if (!ok || tool.isEmpty()) return;
  const QString day = QDate::currentDate().toString(Qt::ISODate);
  const QString file = QFileDialog::getSaveFileName(
      owner_, tr("Save the passport"),
      QFileInfo(opened->path).absolutePath() + "/" + tool + "-passport-" + day + ".pdf", tr("PDF (*.pdf)"));
  if (file.isEmpty()) return;
  // The dialog asked about this file alone.
  const bool replace = QFileInfo::exists(file);
  const QString before =
      newestPassport(QFileInfo(file).absolutePath(), tool,
                     QFileInfo(file).absolutePath() + "/" + QFileInfo(file).completeBaseName() + ".json");
  const auto saved = savePassport(file, tool, before, replace);
  if (!saved) return tell(saved);
  const QString compared = before.isEmpty() ? tr("Saved %1.").arg(file)
                                            : tr("Saved %1, compared with %2.").arg(file, QFileInfo(before).fileName());
  parts_.offer(Severity::info, compared, tr("Show in folder"),
               [file] { QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(file).absolutePath())); });
}

Result<bool> ProofCard::savePassport(const QString& file, const QString& tool, const QString& before, bool replace) {
  PassportParts content;
  content.workspace = parts_.workspace;
  content.tool = tool;
  content.date = QDate::currentDate();
  const auto* found = onlyChild<RealityFindings>(*parts_.workspace)->current(*parts_.workspace);
  // A riddle that is still to be guessed is not given away on paper.
  if (found && !found->secret) content.diagnosis = found->report;
  return writePassport(content, file, before, replace);
}

ScriptForms ProofCard::scriptForms() {
  return {{"prove FILE | prove live", "check the numbers on another recording, or on what comes in"},
          {"passport FILE [tool NAME] [since FILE] [replace]",
           "the tool's passport, .pdf and .json; what changed since an earlier one"}};
}

std::optional<Result<bool>> ProofCard::obey(const QStringList& words) {
  if (words[0] == "prove") {
    if (words.size() != 2) return std::nullopt;
    return words[1] == "live" ? proveLive() : prove(words[1]);
  }
  if (words[0] != "passport") return std::nullopt;
  QString tool = toolName(), before;
  bool replace = false, understood = words.size() >= 2;
  for (int i = 2; i < words.size(); ++i) {
    if (words[i] == "replace")
      replace = true;
    else if (words[i] == "tool" && i + 1 < words.size())
      tool = words[++i];
    else if (words[i] == "since" && i + 1 < words.size())
      before = words[++i];
    else
      understood = false;
  }
  if (!understood) return std::nullopt;
  return savePassport(words[1], tool, before, replace);
}

}  // namespace heft
