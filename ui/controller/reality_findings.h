#pragma once
// What the reality check found in each open recording, for every step that reports it.
#include <Eigen/Core>
#include <QMap>
#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/conventions/check.h"
#include "ui/controller/diagnosis.h"
#include "ui/controller/workspace.h"

namespace heft {

/// Two explanations or more fit equally well.
bool isTied(const DiagnosedCause& cause);
/// A contact whose segments the estimate leaves out anyway, because of labels or Heft's own suggestion.
bool leftOutAlready(const DiagnosedCause& cause, const std::vector<Segment>& segments);
/// It made the error smaller on segments that it was not fitted to, or needs no such proof.
bool helpsUnseen(const DiagnosedCause& cause);

/// What a rigid tool leaves unexplained, as the setup file has it and as physics reads it.
struct ReadingCurves {
  conventions::LeftOver stated, read;
};

/// By path. The workspace's only child of its kind.
class RealityFindings : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  struct Found {
    std::weak_ptr<const OpenRecording> of;
    std::shared_ptr<const DiagnosisReport> report;
    std::vector<diagnosis::Witness> witnesses;
    std::optional<ReadingCurves> curves;    ///< Where the numbers do not mean what the setup file says
    std::string json;                       ///< heft.diagnose/1
    std::vector<Mark> marks;                ///< That it was made with.
    std::string guess;                      ///< Of a practice recording, once the solution was shown
    std::string tried;                      ///< The first guess, if it was wrong
    std::shared_ptr<const Recording> twin;  ///< Of a practice recording: the same without the fault, once asked for
    bool hinted = false;                    ///< A hint was asked for.
    bool secret = false;                    ///< Of a practice recording that is still to be guessed
  };
  /// Of the practice recordings since the program was started.
  struct Score {
    int asked = 0, first = 0, second = 0;  ///< Found at the first try without a hint, or at the second or with one
  };
  Score score;
  QMap<QString, Found> found;

  /// For the shown recording; null where nothing was looked for, or in another file of that name.
  const Found* current(const Workspace& workspace) const;
  void tellChanged() { emit changed(); }

 signals:
  void changed();
};

/// Causes that were found in the shown recording and could be applied, but are not.
struct OpenCauses {
  std::shared_ptr<const DiagnosisReport> report;  ///< Keeps the causes alive; null without any.
  std::vector<const DiagnosedCause*> causes;
  /// By how much they would move mass, centre and inertia, in the numbers' own standard deviations (payloadShift()).
  Vector10d moved = Vector10d::Zero();
};
OpenCauses openCauses(Workspace& workspace);

/// A number that moves by more than this many of its own deviations leaves its 95 % interval.
inline constexpr double kLeavesInterval = 1.96;

}  // namespace heft
