#pragma once
// What the panel shows while data comes in: the coach's card, what is known so far, or the standing poses, and how the
// sources are. Brought up to date in place, many times a second.
#include <QWidget>
#include <vector>

#include "ui/live/live_run.h"

class QLabel;
class QFrame;
class QProgressBar;
class QPushButton;
class QHBoxLayout;
class QVBoxLayout;

namespace heft {

class KnownRow;
class LightIcon;

class LiveBoard : public QWidget {
  Q_OBJECT
 public:
  /// `run` must outlive the board.
  explicit LiveBoard(LiveRun* run, QWidget* parent = nullptr);
  void refresh();

 signals:
  void posesWanted(bool poses);
  void anotherToolWanted();

 private:
  void buildCard(QVBoxLayout* column);
  void buildKnown(QVBoxLayout* column);
  void buildPoses(QVBoxLayout* column);
  void buildVirtual(QVBoxLayout* column);
  void refreshCard();
  void refreshKnown();
  void refreshPoses();

  LiveRun* run_;
  QFrame* card_ = nullptr;
  QLabel *kicker_ = nullptr, *sentence_ = nullptr, *gain_ = nullptr, *more_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton *show_ = nullptr, *wander_ = nullptr, *another_ = nullptr;
  std::vector<KnownRow*> known_;
  QWidget* touched_ = nullptr;
  QLabel* touchedText_ = nullptr;
  QLabel *poseResult_ = nullptr, *spread_ = nullptr, *lastPose_ = nullptr;
  QWidget* lights_ = nullptr;
  std::vector<LightIcon*> poseLights_;
  QPushButton* removeLast_ = nullptr;
  QLabel* sources_ = nullptr;
};

}  // namespace heft
