// Lines of a script that make a recording: live ..., sample ..., room ...
#include <QFileInfo>
#include <chrono>
#include <thread>

#include "core/recording/csv_reader.h"
#include "ui/controller/workspace.h"
#include "ui/live/live_run.h"
#include "ui/record_panel/flange_guide.h"
#include "ui/record_panel/record_panel.h"
#include "ui/record_panel/samples.h"
#include "ui/record_panel/touched_walls.h"

namespace heft {
namespace {

constexpr double kLongest = 7200.0;  ///< [s] a virtual arm moves by one line

Result<bool> refusal(const QString& sentence) { return Error{sentence.toStdString()}; }

}  // namespace

ScriptForms RecordPanel::scriptForms() {
  return {{"sample clean|hose|delay", "a recording to try with, made by the simulation"},
          {"live virtual|poses SECONDS [TOOL]", "the virtual arm, moving by itself; TOOL chooses what it carries"},
          {"live replay FILE", "a recording as if it came in now"},
          {"live pass SECONDS | live guide DX DY DZ [RX RY RZ]", "time goes on; the hand moves the tool [m, rad]"},
          {"live show | live change | live form", "what the coach suggests; another tool; the form for a robot"},
          {"live stop | live discard", "keep what came and open it, or not"},
          {"room FILE | room touched | room off", "what is in the way: a file, or walls that the tool touched"}};
}

std::optional<Result<bool>> RecordPanel::obey(const QStringList& words) {
  if (words[0] == "live") return obeyLive(words);
  if (words.size() != 2) return std::nullopt;
  if (words[0] == "sample") {
    for (const Sample& sample : samples())
      if (sample.file == QStringLiteral("sample-%1.csv").arg(words[1])) return openSample(sample), Result<bool>(true);
    return std::nullopt;
  }
  if (words[0] != "room") return std::nullopt;
  if (words[1] == "touched") return touchedWalls_->find();
  if (words[1] != "off") return setRoom(words[1]);
  workspace().setRoom({}, tr("Remove the room"));
  return Result<bool>(true);
}

std::optional<Result<bool>> RecordPanel::obeyLive(const QStringList& words) {
  const QString what = words.value(1);
  bool numbers = true;
  const auto number = [&](int index, double otherwise) {
    if (words.size() <= index) return otherwise;
    bool ok = false;
    const double value = words[index].toDouble(&ok);
    numbers = numbers && ok;
    return value;
  };
  if (what == "virtual" || what == "poses") {
    const double seconds = number(2, 0.0), seed = number(3, 1.0);
    if (!numbers || seconds < 0 || seed < 0) return std::nullopt;
    if (seconds > kLongest) return refusal(tr("In a script, the virtual arm can move for at most %1 s.").arg(kLongest));
    startVirtual(static_cast<std::uint64_t>(seed), what == "poses", false);
    if (!run_->running()) return refusal(tr("The virtual arm did not start."));
    if (what == "virtual") run_->virtualArm()->guide([](GuidedArm& arm) { arm.wander(); });
    run_->pass(seconds);
    return Result<bool>(true);
  }
  if (what == "form") {
    way_ = Way::live;
    refresh();
    return Result<bool>(true);
  }
  if (what == "replay" && words.size() >= 3) return replay(words[2]);
  if (!run_->running()) return refusal(tr("Nothing is being recorded: begin with live virtual or live replay."));
  if (what == "pass") {
    const double seconds = number(2, 0.0);
    if (!numbers || seconds < 0) return std::nullopt;
    if (!run_->virtualArm()) return refusal(tr("live pass works only with the virtual arm."));
    run_->pass(seconds);
    return Result<bool>(true);
  }
  if (what == "guide" && run_->virtualArm()) {
    const Vector3d shift(number(2, 0), number(3, 0), number(4, 0)), turn(number(5, 0), number(6, 0), number(7, 0));
    if (!numbers) return std::nullopt;
    run_->virtualArm()->guide([&](GuidedArm& arm) { FlangeGuide::nudge(arm, shift, turn); });
    return Result<bool>(true);
  }
  if (what == "show") return run_->makeAdvised() ? Result<bool>(true) : refusal(tr("There is nothing to show now."));
  if (what == "change") return changeTool(), Result<bool>(true);
  if (what == "stop") return stopAndKeep(), Result<bool>(true);
  if (what == "discard") {
    run_->discard();
    showNoLive();
    return Result<bool>(true);
  }
  return std::nullopt;
}

Result<bool> RecordPanel::replay(const QString& file) {
  way_ = Way::live;
  form_ = nullptr;
  LiveOrigin origin{0, {"replay:" + file.toStdString() + "?speed=20"}, {}, {}, false};
  Findings findings;
  if (QFileInfo::exists(QString::fromStdString(metaFileOf(file.toStdString()).string()))) {
    auto meta = readMeta(metaFileOf(file.toStdString()), findings);
    if (!meta) return Result<bool>(meta.error());
    origin.meta = std::move(*meta);
    origin.meta.numbersArePlain();
  }
  listenTo(std::move(origin), false);
  if (!run_->running()) return refusal(tr("%1 could not be replayed.").arg(file));
  waiting_.start(
      QString(),
      [session = run_->session()](const Progress& progress) -> Result<bool> {
        const auto under = [&](LinkState state) { return state == LinkState::connecting || state == LinkState::live; };
        while (!progress.cancelled() && under(session->status().sources.front().state))
          std::this_thread::sleep_for(std::chrono::milliseconds(20));
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        return true;
      },
      [](const Result<bool>&) {});
  return Result<bool>(true);
}

}  // namespace heft
