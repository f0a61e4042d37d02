// What menus and scripts ask of the reality check.
#include <QAction>
#include <QFileInfo>
#include <QMenu>
#include <QRandomGenerator>
#include <algorithm>
#include <utility>

#include "core/simulation/practice.h"
#include "ui/controller/diagnosis.h"
#include "ui/controller/workspace.h"
#include "ui/reality_cards/reality_page.h"
#include "ui/reality_panel/difference_pane.h"
#include "ui/reality_panel/lesson_guide.h"
#include "ui/reality_panel/practice.h"
#include "ui/reality_panel/reality_panel.h"
#include "ui/reality_panel/what_if_knobs.h"

namespace heft {

Result<bool> RealityPanel::refusal(const QString& sentence) { return Error{sentence.toStdString()}; }

void RealityPanel::addActions(const StudioMenus& menus) {
  QAction* again = menus.tools->addAction(tr("Run reality chec&k"), this, [this] {
    if (!workspace().opened()) return;
    parts().goTo(Step::realityCheck);
    diagnose();
  });
  again->setShortcut(QKeySequence("Ctrl+L"));
  menus.file->addAction(tr("Save repor&t …"), this, [this] { files_.saveReport(); })
      ->setShortcut(QKeySequence("Ctrl+P"));
  QAction* riddle = menus.practice->addAction(tr("&New exercise"), this,
                                              [this] { practise(QRandomGenerator::global()->bounded(1u, 1000000u)); });
  riddle->setShortcut(QKeySequence("Ctrl+Shift+P"));
  menus.practice->addAction(tr("&What if …?"), this, [this] {
    if (!workspace().opened()) return parts().say(Severity::info, tr("Open a recording first."));
    parts().goTo(Step::realityCheck);
    whatIf_->setOn(true);
  });
  lesson_->addActions(menus.practice, this);
  menus.practice->addSeparator();
  for (unsigned seed = 1; seed <= 9; ++seed)
    menus.practice->addAction(tr("Exercise &%1").arg(seed), this, [this, seed] { practise(seed); });
}

ScriptForms RealityPanel::scriptForms() {
  ScriptForms forms{{"diagnose", "look for causes (reality check)"},
                    {"apply CAUSE | takeback CAUSE", "a correction, by the cause's name in files"},
                    {"check FILE", "the causes found, on another open recording"},
                    {"look plots|time|frequency|motion [WITNESS]", "the difference views"},
                    {"meta FILE [replace]", "the corrected setup file that the causes ask for"},
                    {"report FILE [replace]", "of the whole session, .html or .pdf"},
                    {"practice NUMBER | guess CAUSE", "a recording with a hidden fault"}};
  for (const ScriptForms& more : {WhatIfKnobs::scriptForms(), LessonGuide::scriptForms()})
    forms.insert(forms.end(), more.begin(), more.end());
  return forms;
}

std::optional<Result<bool>> RealityPanel::obey(const QStringList& words) {
  const QString& verb = words[0];
  const auto arguments = words.size() - 1;
  if (auto obeyed = whatIf_->obey(words)) return obeyed;
  if (auto obeyed = lesson_->obey(words)) return obeyed;
  if (verb == "diagnose" && arguments == 0) {
    if (!workspace().opened()) return refusal(tr("diagnose needs an open recording."));
    diagnose();
    return Result<bool>(true);
  }
  if ((verb == "apply" || verb == "takeback") && arguments == 1) {
    const std::string id = words[1].toStdString();
    if (verb == "takeback") {
      if (!applied(id)) return refusal(tr("%1 is not applied.").arg(words[1]));
      takeBack(id);
      return Result<bool>(true);
    }
    if (!found()) return refusal(tr("apply needs a reality check first: diagnose."));
    const auto& causes = found()->report->causes;
    const auto cause = std::find_if(causes.begin(), causes.end(), [&](const auto& c) { return c.id == id; });
    if (cause == causes.end() || !canApply(*found()->report, *cause)) {
      QStringList names;
      for (const auto& c : causes) names << QString::fromStdString(c.id);
      return refusal(tr("%1 cannot be applied here; found were: %2.")
                         .arg(words[1], names.isEmpty() ? tr("none") : names.join(", ")));
    }
    apply(id);
    return Result<bool>(true);
  }
  if (verb == "look" && arguments >= 1) {
    using View = DifferencePane::View;
    const std::pair<const char*, View> views[] = {
        {"time", View::time}, {"frequency", View::frequency}, {"motion", View::motion}};
    if (words[1] == "plots") return look(false), Result<bool>(true);
    for (const auto& [name, view] : views)
      if (words[1] == name) {
        pane_->setView(view);
        if (arguments >= 2 && !pane_->setWitness(words[2]))
          return refusal(tr("There is no quantity called %1.").arg(words[2]));
        look(true);
        return Result<bool>(true);
      }
    return std::nullopt;
  }
  if (verb == "check" && arguments == 1) {
    if (!found()) return refusal(tr("check needs a reality check first: diagnose."));
    const auto all = others();
    for (std::size_t k = 0; k < all.size(); ++k)
      if (QFileInfo(workspace().openedAt(all[k])->path) == QFileInfo(words[1]))
        return checkOnOther(static_cast<int>(k)), Result<bool>(true);
    return refusal(tr("%1 is not open beside the shown recording.").arg(words[1]));
  }
  if (verb == "meta" && (arguments == 1 || (arguments == 2 && words[2] == "replace")))
    return files_.writeMeta(words[1], arguments == 2);
  if (verb == "report" && (arguments == 1 || (arguments == 2 && words[2] == "replace")))
    return files_.writeReport(words[1], arguments == 2);
  if (verb == "practice" && arguments == 1) {
    bool ok = false;
    const auto seed = words[1].toULongLong(&ok);
    if (!ok) return std::nullopt;
    practise(seed);
    return Result<bool>(true);
  }
  if (verb == "guess" && arguments == 1) {
    const auto& kinds = practiceKinds();
    if (!workspace().opened() || !practiceSeed(workspace().opened()->path))
      return refusal(tr("guess needs a recording to practise on."));
    if (std::find(kinds.begin(), kinds.end(), words[1].toStdString()) == kinds.end())
      return refusal(tr("%1 is not one of the faults to guess.").arg(words[1]));
    guess(words[1].toStdString());
    return Result<bool>(true);
  }
  return std::nullopt;
}

}  // namespace heft
