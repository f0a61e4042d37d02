#pragma once
// Which robot was recorded, where the sensor sits on it, which way its forces point, how the robot stands, and what the
// numbers mean.
#include <QDialog>
#include <array>
#include <functional>

#include "core/recording/recording.h"

class QFormLayout;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace heft {

class ConventionsForm;

class RigDialog : public QDialog {
  Q_OBJECT
 public:
  /// `save` writes what was chosen, and returns why that is not possible, or an empty sentence.
  RigDialog(const QString& recording, const RecordingMeta& meta, std::function<QString(const RecordingMeta&)> save,
            QWidget* parent = nullptr);

  RecordingMeta meta() const;
  void accept() override;

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void addRobot(QFormLayout* form);
  void addMount(QFormLayout* form, const RecordingMeta& meta);
  void addSetup(QFormLayout* form, const RecordingMeta& meta);
  void fit();
  enum Robot { panda, ownArm, noRobot };
  void robotChanged();
  void chooseUrdf();
  void gravityChanged();

  RecordingMeta before_;
  std::function<QString(const RecordingMeta&)> save_;
  QComboBox *robot_, *link_, *sign_, *stand_, *kind_;
  QLineEdit *urdf_, *model_;
  QWidget* urdfRow_;
  QWidget* gravityRow_;
  ConventionsForm* conventions_;
  std::array<QDoubleSpinBox*, 3> xyz_{}, rpy_{}, gravity_{};
  QLabel* problem_;
};

}  // namespace heft
