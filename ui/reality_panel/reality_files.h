#pragma once
// Files that the reality check writes: the corrected setup file and the report of the session.
#include <QCoreApplication>
#include <QString>

#include "core/base/result.h"
#include "ui/steps/studio_parts.h"

class QWidget;

namespace heft {

class RealityFindings;

class RealityFiles {
  Q_DECLARE_TR_FUNCTIONS(RealityFiles)
 public:
  /// `owner` is the dialogs' parent; all must outlive it.
  RealityFiles(const StudioParts& parts, const RealityFindings* findings, QWidget* owner)
      : parts_(parts), findings_(findings), owner_(owner) {}

  /// An existing file is overwritten only with `replace`.
  Result<bool> writeMeta(const QString& file, bool replace) const;
  Result<bool> writeReport(const QString& file, bool replace) const;
  /// Ask for the file.
  void saveMeta() const;
  void saveReport() const;

 private:
  StudioParts parts_;
  const RealityFindings* findings_;
  QWidget* owner_;
};

}  // namespace heft
