#include <QDir>
#include <QFileInfo>
#include <QRandomGenerator>
#include <memory>
#include <utility>

#include "core/recording/csv_reader.h"
#include "core/simulation/practice.h"
#include "ui/controller/workspace.h"
#include "ui/reality_panel/difference_pane.h"
#include "ui/reality_panel/practice.h"
#include "ui/reality_panel/reality_panel.h"

namespace heft {

void RealityPanel::practise(std::uint64_t seed) {
  const QString path = practiceFile(seed);
  found_.remove(path);
  jobs_.start(
      tr("Making a recording to practise on"),
      [seed, path](const Progress& progress) -> Result<bool> {
        auto made = practiceRecording(seed, progress);
        if (!made) return made.error();
        QDir().mkpath(practiceFolder());
        return writeRecording(made->recording, path.toStdString());
      },
      [this, path](Result<bool> result) {
        if (!result) {
          if (!result.error().cancelled) parts().say(Severity::error, QString::fromStdString(result.error().message));
          return;
        }
        wanted_ = true;
        looking_ = true;  // The difference is what the exercise is about.
        workspace().open(path);
        parts().goTo(Step::realityCheck);
      });
}

void RealityPanel::guess(const std::string& cause) {
  const auto opened = workspace().opened();
  if (!opened || !practiceSeed(opened->path)) return;
  Found& entry = found_[opened->path];
  const bool right = cause == practiceEffect(*practiceSeed(opened->path)).id;
  if (!right && entry.tried.empty()) {
    entry.tried = cause;
    return refresh();
  }
  RealityFindings::Score& score = findings_->score;
  ++score.asked;
  if (right) ++(entry.tried.empty() && !entry.hinted ? score.first : score.second);
  entry.guess = cause;
  entry.secret = false;
  findings_->tellChanged();
  if (!found() && !jobs_.running()) diagnose();
  refresh();
}

RiddleActions RealityPanel::riddleActions(const QString& path) {
  RiddleActions does;
  does.guessed = [this](const std::string& id) { guess(id); };
  does.hintWanted = [this, path] {
    found_[path].hinted = true;
    refresh();
  };
  does.gaveUp = [this, path] { guess(found_[path].tried); };
  does.another = [this] { practise(QRandomGenerator::global()->bounded(1u, 1000000u)); };
  does.twinWanted = [this, path] { showTwin(path); };
  return does;
}

void RealityPanel::showTwin(const QString& path) {
  if (std::exchange(found_[path].twin, nullptr)) return refresh();
  const auto seed = practiceSeed(path);
  if (!seed) return;
  jobs_.start(
      tr("Making the recording without the fault"),
      [seed = *seed](const Progress& progress) { return practiceTwin(seed, progress); },
      [this, path](Result<Simulated> made) {
        if (!made) {
          if (!made.error().cancelled) parts().say(Severity::error, QString::fromStdString(made.error().message));
          return;
        }
        if (!found_.contains(path)) return;
        found_[path].twin = std::make_shared<const Recording>(std::move(made->recording));
        pane_->setView(DifferencePane::View::time);
        look(true);
        QMetaObject::invokeMethod(this, &RealityPanel::refresh, Qt::QueuedConnection);
      });
}

}  // namespace heft
