#pragma once
// Where live data comes from, in plain words: which device, at which address, and where the joint angles come from.
#include <QStringList>
#include <QWidget>

#include "core/base/result.h"
#include "core/recording/recording.h"

class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace heft {

class Segments;
class Stepper;

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
  /// Says what keeps it from listening at the field that it concerns, and puts the keyboard there.
  void complain(const QString& sentence);
  /// Neither a setup file nor the user states how the sensor is mounted on the flange.
  bool mountAssumed() const;

 private:
  void rebuild();
  void addMount(QVBoxLayout* column);
  /// What addresses() or meta() misses, in their order.
  QWidget* culprit() const;
  void clearComplaint();
  QLineEdit* addField(QVBoxLayout* column, const QString& label, const QString& name, const QString& tip);

  Kind kind_ = Kind::netFt;
  Kind joints_ = Kind::foxglove;  ///< With Net F/T, which measures forces only
  QWidget* fields_ = nullptr;
  QLineEdit *address_ = nullptr, *jointsAddress_ = nullptr, *rig_ = nullptr;
  QLabel* complaint_ = nullptr;
  Segments* mounted_ = nullptr;  ///< Not sure, on the flange, at a distance along its axis
  Stepper* distance_ = nullptr;
  int mountAnswer_ = -1;
  double lastDistance_ = 0.0;  ///< [mm]
  QString lastAddress_[6], lastJoints_, lastRig_;
};

}  // namespace heft
