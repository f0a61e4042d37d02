#pragma once
// The whole session on paper: what was recorded, what the tool weighs, what was left out, what the reality check found.
// One HTML page that needs no other file, or the same as PDF.
#include <QImage>
#include <QString>
#include <memory>

#include "ui/controller/diagnosis.h"
#include "ui/controller/workspace.h"

namespace heft {

struct ReportParts {
  Workspace* workspace = nullptr;
  std::shared_ptr<const DiagnosisReport> diagnosis;  ///< Null: the reality check was not run.
  QImage view;                                       ///< Of the arm; may be null.
};

/// Pictures are in it as data, in the colours for paper, whatever the window's theme.
QString sessionReportHtml(const ReportParts& parts);

/// By the name's ending .pdf or .html. Fails with one sentence; never replaces without `replace`.
Result<bool> writeSessionReport(const ReportParts& parts, const QString& file, bool replace);

}  // namespace heft
