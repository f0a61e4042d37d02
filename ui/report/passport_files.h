#pragma once
// A tool's payload passport on one sheet of paper, and the same as JSON.
#include <QDate>
#include <QString>
#include <memory>

#include "core/base/result.h"
#include "ui/controller/diagnosis.h"
#include "ui/controller/workspace.h"

namespace heft {

struct PassportParts {
  Workspace* workspace = nullptr;
  QString tool;                                      ///< Its name
  QDate date;                                        ///< Of the passport
  std::shared_ptr<const DiagnosisReport> diagnosis;  ///< Null: the reality check was not run.
};

/// The newest passport of this tool among the JSON files of a folder, `except` aside; empty if there is none.
QString newestPassport(const QString& folder, const QString& tool, const QString& except);

/// Writes NAME.pdf and NAME.json, where `file` is either of the two, compared with the passport `before`; empty: with
/// none. Fails with one sentence and writes nothing where a file exists and is not to be replaced, where there is no
/// result, or where `before` is no passport of this tool.
Result<bool> writePassport(const PassportParts& parts, const QString& file, const QString& before, bool replace);

}  // namespace heft
