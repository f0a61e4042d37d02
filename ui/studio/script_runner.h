#pragma once
// Drives the real window by the lines of a script: one after the other, each when everything that the one before set
// going has come to rest.
#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/steps/script_help.h"
#include "ui/studio/script.h"

namespace heft {

class Studio;

class ScriptRunner : public QObject {
  Q_OBJECT
 public:
  /// `studio` must outlive the runner; `name` stands in messages ("walk.txt:3: ..."), empty: no place in them.
  ScriptRunner(Studio* studio, std::vector<ScriptLine> lines, const std::string& name);

  /// With `goOn` what failed inside the window (an estimate) still lets the lines after it run, as long as a recording
  /// is open; the outcome is a failure all the same.
  void start(bool goOn = false);

  /// All lines that a script may have: the runner's own and those of the steps' panels.
  static ScriptForms forms();

 signals:
  /// Empty after success, otherwise one sentence.
  void finished(const QString& failure);

 private:
  void turn();
  void finish(const QString& failure);
  Result<bool> obey(const QStringList& words);
  /// Of each of these nothing where the line has none of its forms.
  std::optional<Result<bool>> obeySession(const QStringList& words);
  std::optional<Result<bool>> obeyPlots(const QStringList& words);
  std::optional<Result<bool>> obeyWindow(const QStringList& words);
  std::optional<Result<bool>> obeyLooks(const QStringList& words);
  std::optional<Result<bool>> chooseUnits(const QStringList& words);
  std::optional<Result<bool>> takePicture(const QStringList& words);
  QString placed(const QString& sentence) const;

  Studio* studio_;
  std::vector<ScriptLine> lines_;
  std::string name_;
  std::size_t next_ = 0;
  QTimer poll_;
  QElapsedTimer quiet_;
  int calm_ = 0;  ///< Turns of the event loop since then: what was rebuilt takes some to be laid out.
  int wait_ = 0;  ///< [ms] of rest before the next line.
  bool goOn_ = false;
  QString failure_;
};

}  // namespace heft
