#pragma once
// Where live data comes from, asked in plain words: which device, at which address, and who tells the arm's joints.
#include <QStringList>
#include <QWidget>

#include "core/base/result.h"
#include "core/recording/recording.h"

class QLineEdit;
class QVBoxLayout;

namespace heft {

class SourceForm : public QWidget {
  Q_OBJECT
 public:
  enum class Kind { netFt, ur, foxglove, rosbridge, jsonUdp, replay };
  explicit SourceForm(QWidget* parent = nullptr);

  void setKind(Kind kind);
  Kind kind() const { return kind_; }
  /// In the form of makeLiveSource(); an error says which field lacks what.
  Result<std::vector<std::string>> addresses() const;
  /// Of the rig file, of the replayed recording, or the usual rig.
  Result<RecordingMeta> meta() const;
  QString rigFile() const;

 private:
  void rebuild();
  QLineEdit* addField(QVBoxLayout* column, const QString& label, const QString& name, const QString& tip);

  Kind kind_ = Kind::netFt;
  Kind joints_ = Kind::foxglove;  ///< With Net F/T, which measures forces only
  QWidget* fields_ = nullptr;
  QLineEdit *address_ = nullptr, *jointsAddress_ = nullptr, *rig_ = nullptr;
  QString lastAddress_[6], lastJoints_, lastRig_;
};

}  // namespace heft
