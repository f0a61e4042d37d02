#pragma once
// Recordings that grow on disk are under way as long as their program lives. What a killed program left behind is found
// and offered.
#include <QLockFile>
#include <QString>
#include <QStringList>

namespace heft {

/// While it lives the recording `csv` is under way; with its end the recording is an ordinary one.
class UnderWay {
 public:
  explicit UnderWay(const QString& csv);
  ~UnderWay();

 private:
  QString csv_;
  QLockFile lock_;
};

/// Recordings in `folder` whose program died while they were under way, newest first. Those that hold nothing are
/// removed.
QStringList unfinishedRecordings(const QString& folder);
/// It has been opened, or is not wanted: it is not offered again. The recording stays.
void forgetUnfinished(const QString& csv);

}  // namespace heft
