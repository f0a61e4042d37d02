#include "ui/reality_panel/reality_files.h"

#include <QFileDialog>
#include <QFileInfo>
#include <nlohmann/json.hpp>

#include "core/base/json_file.h"
#include "core/recording/csv_reader.h"
#include "core/recording/meta_file.h"
#include "ui/controller/diagnosis.h"
#include "ui/controller/reality_findings.h"
#include "ui/controller/workspace.h"
#include "ui/reality_panel/practice.h"
#include "ui/report/session_report.h"
#include "ui/robot_view/robot_view.h"

namespace heft {
namespace {

Result<bool> refusal(const QString& sentence) { return Error{sentence.toStdString()}; }

}  // namespace

Result<bool> RealityFiles::writeMeta(const QString& file, bool replace) const {
  const auto opened = parts_.workspace->opened();
  const auto* found = findings_->current(*parts_.workspace);
  if (!opened || !found) return refusal(tr("There is no reality check yet to correct a setup file from."));
  const nlohmann::json changes = found->report->metaChanges();
  if (changes.empty()) return refusal(tr("The reality check proposes no change of the setup file."));
  if (!replace && QFileInfo::exists(file)) return refusal(tr("%1 already exists and was not overwritten.").arg(file));
  const auto meta = mergedMeta(metaFileOf(opened->path.toStdString()), changes);
  if (!meta) return meta.error();
  return writeTextFile(file.toStdString(), meta->dump(2) + "\n");
}

void RealityFiles::saveMeta() const {
  const auto opened = parts_.workspace->opened();
  if (!opened) return;
  const QFileInfo info(opened->path);
  const QString file = QFileDialog::getSaveFileName(
      owner_, tr("Save the corrected setup file"),
      info.absolutePath() + "/" + info.completeBaseName() + "-corrected.meta.json", tr("Setup files (*.meta.json)"));
  if (file.isEmpty()) return;
  const auto written = writeMeta(file, true);
  parts_.say(written ? Severity::info : Severity::error,
             written ? tr("Saved %1.").arg(file) : QString::fromStdString(written.error().message));
}

Result<bool> RealityFiles::writeReport(const QString& file, bool replace) const {
  const auto opened = parts_.workspace->opened();
  if (!opened) return refusal(tr("A report needs an open recording."));
  ReportParts content;
  content.workspace = parts_.workspace;
  // A riddle that is still to be guessed is not given away on paper.
  const auto* found = findings_->current(*parts_.workspace);
  const bool riddle = found && practiceSeed(opened->path) && found->guess.empty();
  if (found && !riddle) content.diagnosis = found->report;
  if (parts_.view) content.view = parts_.view->picture();
  return writeSessionReport(content, file, replace);
}

void RealityFiles::saveReport() const {
  const auto opened = parts_.workspace->opened();
  if (!opened) return parts_.say(Severity::info, tr("Open a recording first."));
  const QFileInfo info(opened->path);
  QString chosen;
  QString file = QFileDialog::getSaveFileName(owner_, tr("Save report"),
                                              info.absolutePath() + "/" + info.completeBaseName() + "-report.pdf",
                                              tr("PDF (*.pdf);;Web page (*.html)"), &chosen);
  if (file.isEmpty()) return;
  // The dialog asked about a name with an ending only.
  const bool asked = !QFileInfo(file).suffix().isEmpty();
  if (!asked) file += chosen.contains("html") ? ".html" : ".pdf";
  const auto written = writeReport(file, asked);
  parts_.say(written ? Severity::info : Severity::error,
             written ? tr("Saved %1.").arg(file) : QString::fromStdString(written.error().message));
}

}  // namespace heft
