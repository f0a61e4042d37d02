#include "ui/reality_panel/what_if_knobs.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/controller/workspace.h"
#include "ui/reality_cards/cause_words.h"
#include "ui/reality_panel/what_if_pane.h"
#include "ui/widgets/basics.h"

namespace heft {
namespace {

constexpr int kSteps = 100;  // Of a slider

}  // namespace

WhatIfKnobs::WhatIfKnobs(const StudioParts& parts, QObject* owner)
    : QObject(owner), parts_(parts), pane_(new WhatIfPane) {
  parts_.followJobs(&jobs_);
  connect(pane_, &WhatIfPane::closeWanted, this, [this] { setOn(false); });
  connect(parts_.workspace, &Workspace::openedChanged, this, [this] {
    if (on_) prepare();
  });
  connect(parts_.workspace, &Workspace::reportChanged, this, [this] {
    if (on_ && !whatIf_) prepare();
  });
}

void WhatIfKnobs::setOn(bool on) {
  if (on == on_) return;
  on_ = on;
  if (on_) prepare();
  emit changed();
}

void WhatIfKnobs::prepare() {
  const auto opened = parts_.workspace->opened();
  if (whatIf_ && of_ == opened) return showState();
  jobs_.cancel();
  whatIf_.reset();
  state_.reset();
  calm_.reset();
  positions_.clear();
  of_ = opened;
  failure_.clear();
  const auto segments = parts_.workspace->segments();
  if (!opened) failure_ = tr("Open a recording first.");
  pane_->showNothing(opened ? tr("Preparing the sliders …") : failure_);
  // Before the first estimate it is not known which samples are free; this is called again afterwards.
  if (!opened || segments.empty()) return emit changed();
  jobs_.start(
      tr("Preparing the sliders"),
      [opened, segments](const Progress& progress) -> Result<std::shared_ptr<const WhatIf>> {
        auto made = WhatIf::make(opened->recording, opened->robot, segments, progress);
        if (!made) return made.error();
        return std::make_shared<const WhatIf>(std::move(*made));
      },
      [this, opened](const Result<std::shared_ptr<const WhatIf>>& made) {
        if (opened != of_) return;
        if (made) {
          whatIf_ = *made;
          positions_.assign(whatIf_->knobs().size(), 0.0);
          calm_ = whatIf_->at(positions_);
          showState();
          for (int i = 0; i + 1 < wanted_.size(); i += 2)
            if (const auto turned = turnBySize(wanted_[i], wanted_[i + 1]); !turned)
              parts_.say(Severity::error, QString::fromStdString(turned.error().message));
          wanted_.clear();
        } else if (!made.error().cancelled) {
          failure_ = QString::fromStdString(made.error().message);
          pane_->showNothing(failure_);
        }
        emit changed();
      });
  emit changed();
}

void WhatIfKnobs::showState() {
  state_ = whatIf_->at(positions_);
  const auto report = parts_.workspace->report();
  pane_->show(*whatIf_, *calm_, *state_, report ? report->identifiability : Identifiability());
}

void WhatIfKnobs::turn(std::size_t knob, double position) {
  positions_[knob] = std::clamp(position, 0.0, 1.0);
  showState();
}

void WhatIfKnobs::allOff() {
  if (!whatIf_) return;
  positions_.assign(positions_.size(), 0.0);
  showState();
  emit changed();
}

void WhatIfKnobs::addTo(QVBoxLayout* column, QWidget* content) {
  if (!whatIf_) {
    column->addWidget(wrappedLabel(failure_.isEmpty() ? tr("Preparing the sliders …") : failure_, "body", content));
    return;
  }
  for (std::size_t k = 0; k < whatIf_->knobs().size(); ++k) {
    const Knob& knob = whatIf_->knobs()[k];
    if (only_ && !only_->contains(QString::fromStdString(knob.cause))) continue;
    auto* row = new QHBoxLayout;
    row->addWidget(wrappedLabel(titleOf(knob.cause), "rowName", content), 1);
    auto* size = styledLabel({}, "detailValue", content);
    row->addWidget(size);
    column->addLayout(row);
    auto* slider = new QSlider(Qt::Horizontal, content);
    slider->setObjectName(QStringLiteral("knob_") + QString::fromStdString(knob.cause));
    slider->setRange(0, kSteps);
    slider->setValue(static_cast<int>(std::lround(kSteps * positions_[k])));
    const CauseParameter named{knob.parameter, knob.unit, 0.0, 0.0};
    slider->setAccessibleName(titleOf(knob.cause) + ", " + parameterTitle(named));
    slider->setToolTip(parameterTitle(named) + ". " + looksOf(knob.cause));
    const auto tell = [this, k, size](double position) {
      size->setText(position > 0.0 ? knobText(whatIf_->knobs()[k], position) : tr("off"));
    };
    tell(positions_[k]);
    connect(slider, &QSlider::valueChanged, this, [this, k, tell](int value) {
      const double position = static_cast<double>(value) / kSteps;
      turn(k, position);
      tell(position);
    });
    column->addWidget(slider);
    const bool shows = knob.leastSeen <= 1.0;
    auto* seen = wrappedLabel(shows ? tr("This motion shows it from %1 on.").arg(knobText(knob, knob.leastSeen))
                                    : tr("This motion does not show it."),
                              "caption", content);
    column->addWidget(seen);
    column->addSpacing(6);
  }
}

Result<bool> WhatIfKnobs::turnBySize(const QString& cause, const QString& size) {
  bool number = false;
  const double value = size.toDouble(&number);
  return turnTo(cause, number ? value : -1.0);
}

Result<bool> WhatIfKnobs::turnTo(const QString& cause, double value) {
  const auto& knobs = whatIf_->knobs();
  const auto knob = std::find_if(knobs.begin(), knobs.end(),
                                 [&](const Knob& each) { return cause == QString::fromStdString(each.cause); });
  if (knob == knobs.end()) return Error{tr("There is no slider %1 on this recording.").arg(cause).toStdString()};
  if (knob->shownAt || !(value >= 0.0 && value <= knob->scale))
    return Error{tr("%1 goes from 0 to %2.").arg(cause, knobText(*knob, 1.0)).toStdString()};
  turn(static_cast<std::size_t>(knob - knobs.begin()), value / knob->scale);
  emit changed();
  return true;
}

ScriptForms WhatIfKnobs::scriptForms() {
  return {{"whatif CAUSE SIZE ... | whatif on|off", "what a fault of that size would do to the open recording"}};
}

std::optional<Result<bool>> WhatIfKnobs::obey(const QStringList& words) {
  if (words[0] != "whatif") return std::nullopt;
  const bool only = words.size() == 2 && (words[1] == "on" || words[1] == "off");
  if (!only && (words.size() < 3 || words.size() % 2 == 0)) return std::nullopt;
  if (only && words[1] == "off") return setOn(false), Result<bool>(true);
  if (!parts_.workspace->opened()) return Result<bool>(Error{tr("whatif needs an open recording.").toStdString()});
  const QStringList turns = only ? QStringList() : words.mid(1);
  if (whatIf_ && on_) {
    for (int i = 0; i + 1 < turns.size(); i += 2)
      if (auto turned = turnBySize(turns[i], turns[i + 1]); !turned) return turned;
    return Result<bool>(true);
  }
  wanted_ = turns;
  setOn(true);
  return Result<bool>(true);
}

}  // namespace heft
