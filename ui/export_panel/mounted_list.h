#pragma once
// "What else is mounted?": parts between flange and tool that the sensor does not feel.
#include <QWidget>

#include "core/workspace/session.h"

class QVBoxLayout;

namespace heft {

class MountedList : public QWidget {
  Q_OBJECT
 public:
  explicit MountedList(QWidget* parent = nullptr);
  /// `tool` is the estimated mass [kg], `together` what the file states; below 0 if there is no file.
  void showParts(const std::vector<MountedPart>& parts, bool nothingElse, double together);

 signals:
  /// The user ticked, added or took away a part.
  void changed(const std::vector<heft::MountedPart>& parts, const QString& what);

 private:
  void addPart();

  std::vector<MountedPart> parts_;
  QVBoxLayout* rows_;
};

}  // namespace heft
