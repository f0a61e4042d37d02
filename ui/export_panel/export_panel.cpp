#include "ui/export_panel/export_panel.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QDesktopServices>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QUrl>
#include <QVBoxLayout>
#include <QVariant>

#include "core/base/json_file.h"
#include "ui/controller/only_child.h"
#include "ui/controller/payload_file.h"
#include "ui/controller/reality_findings.h"
#include "ui/controller/workspace.h"
#include "ui/export_panel/export_text.h"
#include "ui/export_panel/file_preview.h"
#include "ui/export_panel/mounted_list.h"
#include "ui/export_panel/proof_card.h"
#include "ui/reality_cards/open_question.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/choice_card.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/stepper.h"

namespace heft {
namespace {

/// In front; the others under "More".
constexpr std::string_view kFront[] = {"franka-desk", "libfranka", "franka-ros2", "ur", "kuka"};

QString fromView(std::string_view text) { return QString::fromUtf8(text.data(), static_cast<int>(text.size())); }

/// A section's title with a caption at the right, which breaks where the panel is narrow.
void addHead(QVBoxLayout* column, const QString& title, const QString& caption, QWidget* content) {
  auto* head = new QHBoxLayout;
  head->setSpacing(12);
  head->addWidget(styledLabel(title, "sectionTitle", content), 0, Qt::AlignTop);
  QLabel* right = wrappedLabel(caption, "caption", content);
  right->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  head->addWidget(right, 1);
  column->addLayout(head);
}

}  // namespace

ExportPanel::ExportPanel(const StudioParts& parts)
    : StepPanel(parts), preview_(new FilePreview), proof_(new ProofCard(parts, this)) {
  connect(proof_, &ProofCard::changed, this, &ExportPanel::refresh);
  connect(preview_, &FilePreview::copyWanted, this, &ExportPanel::copy);
  connect(&workspace(), &Workspace::openedChanged, this, &ExportPanel::refresh);
  connect(&workspace(), &Workspace::reportChanged, this, &ExportPanel::refresh);
  connect(&workspace(), &Workspace::exportChanged, this, &ExportPanel::refresh);
  connect(&workspace(), &Workspace::correctionsChanged, this, &ExportPanel::refresh);
  connect(onlyChild<RealityFindings>(workspace()), &RealityFindings::changed, this, &ExportPanel::refresh);
  refresh();
}

QWidget* ExportPanel::ownPane() { return preview_; }

StepState ExportPanel::state() const {
  using P = StepState::Progress;
  if (!savedAs_.isEmpty() && savedText_ == QString::fromStdString(text_))
    return {P::done, Light::measured, tr("saved as %1").arg(QFileInfo(savedAs_).fileName())};
  if (!workspace().report()) return {P::later, Light::measured, tr("nothing saved yet")};
  const bool asked = workspace().session().exporting.role != ExportChoice::Role::unasked;
  if (!text_.empty() && !mayBeSaved()) return {P::ready, Light::look, tr("see the warnings")};
  return {P::ready, Light::measured,
          text_.empty() ? tr("cannot be written yet")
          : asked       ? tr("ready to save")
                        : tr("one question left")};
}

ExportChoice ExportPanel::choiceNow() const {
  ExportChoice choice = workspace().session().exporting;
  const auto opened = workspace().opened();
  if (!choice.mounted.empty() || !opened) return choice;
  const RecordingMeta& meta = opened->recording.meta;
  const std::string model = meta.sensorModel.empty()
                                ? tr("Sensor body").toStdString()
                                : tr("Sensor body, %1").arg(QString::fromStdString(meta.sensorModel)).toStdString();
  if (const auto mass = sensorBodyMass(meta.sensorModel))
    choice.mounted.push_back({model, compactPart(*mass, 0.5 * meta.mount.xyz), false});
  return choice;
}

QString ExportPanel::suggestedName() const {
  const auto opened = workspace().opened();
  const ExportFormat* format = findExportFormat(workspace().session().exporting.format);
  const QString base = opened ? QFileInfo(opened->path).completeBaseName() : QStringLiteral("tool");
  return base + QStringLiteral("-payload") + (format ? fromView(format->extension) : QString());
}

void ExportPanel::refresh() {
  const int position = page()->scrollPosition();
  const auto opened = workspace().opened();
  const auto report = workspace().report();
  text_.clear();
  refusal_.clear();
  if (!opened || !report) {
    page()->restart(tr("Which controller is this for?"), tr("Estimate a result first."))->addStretch(1);
    page()->setMainButton(opened ? tr("Go to the result") : tr("Go to Record"),
                          [this, opened] { parts().goTo(opened ? Step::result : Step::record); });
    page()->setSecondButton({});
    preview_->showNothing(tr("nothing to write yet"));
    emit stateChanged();
    return;
  }
  const ExportChoice choice = choiceNow();
  QVBoxLayout* column =
      page()->restart(tr("Which controller is this for?"), tr("You see the whole file before anything is written."));
  const auto file = fileNow(choice);
  doubts_.clear();
  if (file)
    for (const Finding& finding : file->findings)
      if (finding.code == "doubtful") doubts_ << QString::fromStdString(finding.text);
  if (!doubts_.isEmpty()) addDoubts(column, *file, choice);
  addFormats(column, choice);
  addRole(column, choice);
  addMounted(column, choice, file ? file->onFlange.mass : -1.0);
  addToolCentre(column, choice);
  if (file) {
    text_ = file->text;
    const QString text = QString::fromStdString(text_);
    preview_->showFile(suggestedName(), text, doubtfulLines(text.split('\n'), *report));
    preview_->setSaved(!savedAs_.isEmpty() && savedText_ == text);
  } else {
    refusal_ = file.error().message;
    preview_->showNothing(tr("cannot be written"));
  }
  addChecks(column, file, choice);
  proof_->addTo(column, page()->content());
  column->addStretch(1);
  page()->setSecondButton(
      tr("Copy"), [this] { copy(); }, "copy");
  page()->secondButton()->setEnabled(!text_.empty());
  page()->setMainButton(
      tr("Save the payload file …"), [this] { save(); }, "save");
  const bool asked = choice.role != ExportChoice::Role::unasked;
  page()->setMainEnabled(!text_.empty() && asked && mayBeSaved(), !asked ? tr("Answer the question above first.")
                                                                  : text_.empty()
                                                                      ? tr("This file cannot be written; see above.")
                                                                      : tr("Read the warnings above first."));
  page()->setScrollPosition(position);
  emit stateChanged();
}

void ExportPanel::addFormats(QVBoxLayout* column, const ExportChoice& choice) {
  QWidget* content = page()->content();
  auto* grid = new QGridLayout;
  grid->setSpacing(8);
  int place = 0;
  const auto add = [&](QWidget* card) {
    grid->addWidget(card, place / 3, place % 3);
    ++place;
  };
  bool front = false;
  for (const std::string_view id : kFront) {
    const ExportFormat* format = findExportFormat(id);
    if (!format) continue;
    const FormatName name = formatName(*format);
    auto* card = new ChoiceCard(name.name, name.detail, content);
    card->setObjectName(QStringLiteral("format_") + fromView(id));
    card->setToolTip(name.whole());
    card->setChecked(choice.format == id);
    front = front || choice.format == id;
    connect(card, &QAbstractButton::clicked, this, [this, key = std::string(id)] { chooseFormat(key); });
    add(card);
  }
  const ExportFormat* chosen = findExportFormat(choice.format);
  const int others = static_cast<int>(exportFormats().size()) - place;
  auto* more = new ChoiceCard(!front && chosen ? formatName(*chosen).name : tr("More …"),
                              !front && chosen ? formatName(*chosen).detail : tr("%n format(s)", "", others), content);
  more->setObjectName("format_more");
  more->setChecked(!front && chosen);
  connect(more, &QAbstractButton::clicked, this, [this, more, front] {
    more->setChecked(!front);
    auto* menu = new QMenu(more);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const ExportFormat& format : exportFormats()) {
      if (std::find(std::begin(kFront), std::end(kFront), format.id) != std::end(kFront)) continue;
      menu->addAction(formatName(format).whole(), this, [this, id = std::string(format.id)] { chooseFormat(id); });
    }
    menu->popup(more->mapToGlobal(QPoint(0, more->height())));
  });
  add(more);
  column->addLayout(grid);
}

void ExportPanel::addRole(QVBoxLayout* column, const ExportChoice& choice) {
  QWidget* content = page()->content();
  column->addSpacing(4);
  column->addWidget(
      wrappedLabel(tr("Is this the robot’s own tool, or something it picked up?"), "sectionTitle", content));
  using Role = ExportChoice::Role;
  auto* roles = new Segments({tr("Its own tool"), tr("An extra load")}, {"roleOwnTool", "roleExtraLoad"}, content);
  roles->setChosen(choice.role == Role::ownTool ? 0 : choice.role == Role::extraLoad ? 1 : -1);
  connect(roles, &Segments::picked, this, [this](int i) { chooseRole(i == 0 ? Role::ownTool : Role::extraLoad); });
  column->addWidget(roles);
  column->addWidget(wrappedLabel(tr("Don’t enter it as both, or its weight is counted twice."), "caption", content));
}

void ExportPanel::addMounted(QVBoxLayout* column, const ExportChoice& choice, double together) {
  QWidget* content = page()->content();
  column->addSpacing(4);
  addHead(column, tr("What else is mounted?"), tr("between flange and tool"), content);
  auto* list = new MountedList(content);
  const bool any =
      std::any_of(choice.mounted.begin(), choice.mounted.end(), [](const MountedPart& part) { return part.present; });
  list->showParts(choice.mounted, choice.mountedAnswered && !any, together);
  connect(list, &MountedList::changed, this, [this](const std::vector<MountedPart>& parts, const QString& what) {
    ExportChoice next = choiceNow();
    next.mounted = parts;
    next.mountedAnswered = true;
    workspace().setExport(next, what);
  });
  column->addWidget(list);
}

Result<PayloadFile> ExportPanel::fileNow(const ExportChoice& choice) const {
  std::vector<std::string> cautions;
  const OpenQuestion open = openQuestion(workspace());
  for (const QString& cause : open.causes)
    cautions.push_back(tr("The reality check found a cause that is not applied: %1").arg(cause).toStdString());
  if (!open.change.isEmpty())
    cautions.back() += " " + tr("With it the result changes: %1.").arg(open.change).toStdString();
  return payloadFile(*workspace().opened(), *workspace().report(), choice, cautions, confirmed());
}

void ExportPanel::addToolCentre(QVBoxLayout* column, const ExportChoice& choice) {
  const ExportFormat* format = findExportFormat(choice.format);
  if (!format || !carriesTool(*format)) return;
  QWidget* content = page()->content();
  column->addSpacing(4);
  addHead(column, tr("Tool centre point"), tr("from the flange, its axes, in mm"), content);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  for (int i = 0; i < 3; ++i) {
    const QString axis(QChar('x' + i));
    auto* field = new Stepper(axis, QStringLiteral("mm"), {-2000.0, 2000.0, 1.0, 1}, content);
    field->setObjectName(QStringLiteral("tcp_") + axis);
    field->setValue(1e3 * choice.tcp(i));
    connect(field, &Stepper::begun, this, [this] { tcpKey_ = workspace().newMergeKey(); });
    connect(field, &Stepper::changed, this, [this, i](double millimetres) {
      ExportChoice next = workspace().session().exporting;
      next.tcp(i) = 1e-3 * millimetres;
      workspace().setExport(next, tr("tool centre point"), tcpKey_);
    });
    auto* cell = new QVBoxLayout;
    cell->setSpacing(2);
    cell->addWidget(styledLabel(axis, "caption", content));
    cell->addWidget(field);
    row->addLayout(cell, 1);
  }
  column->addLayout(row);
}

void ExportPanel::addAllTheSame(QVBoxLayout* column) {
  QWidget* content = page()->content();
  auto* box = new QCheckBox(tr("Save anyway"), content);
  box->setObjectName("saveAllTheSame");
  box->setChecked(mayBeSaved());
  connect(box, &QCheckBox::toggled, this, [this](bool on) {
    accepted_ = on ? doubts_ : QStringList();
    refresh();
  });
  column->addWidget(box);
  // To where more is said about it.
  const bool cause = !openQuestion(workspace()).causes.isEmpty();
  auto* back = new QPushButton(cause ? tr("Back to the reality check") : tr("Back to the result"), content);
  back->setObjectName("smallButton");
  back->setProperty("role", "doubts");
  connect(back, &QPushButton::clicked, this,
          [this, cause] { parts().goTo(cause ? Step::realityCheck : Step::result); });
  column->addWidget(back, 0, Qt::AlignLeft);
  column->addSpacing(6);
}

void ExportPanel::addChecks(QVBoxLayout* column, const Result<PayloadFile>& file, const ExportChoice& choice) {
  QWidget* content = page()->content();
  const auto report = workspace().report();
  column->addSpacing(4);
  column->addWidget(styledLabel(tr("Before you save"), "sectionTitle", content));
  if (!file && report->trust == Trust::none && !confirmed()) {
    const Card card = makeCard("cardBad", content);
    card.layout->addWidget(
        wrappedLabel(tr("This result is not reliable, so no file is written."), "cardTitle", content));
    card.layout->addWidget(wrappedLabel(QString::fromStdString(report->whyNoTrust), "body", content));
    card.layout->addWidget(wrappedLabel(QString::fromStdString(report->whatToDo), "caption", content));
    auto* row = new QHBoxLayout;
    auto* look = new QPushButton(tr("Run reality check"), content);
    look->setObjectName("acceptButton");
    connect(look, &QPushButton::clicked, this, [this] { parts().goTo(Step::realityCheck); });
    row->addWidget(look);
    row->addStretch(1);
    auto* anyway = new QPushButton(tr("Write it anyway …"), content);
    anyway->setObjectName("writeUntrusted");
    connect(anyway, &QPushButton::clicked, this, &ExportPanel::confirmUntrusted);
    row->addWidget(anyway);
    card.layout->addLayout(row);
    column->addWidget(card.frame);
    return;
  }
  if (!file) {
    const Card card = makeCard("cardBad", content);
    card.layout->addWidget(wrappedLabel(QString::fromStdString(file.error().message), "body", content));
    column->addWidget(card.frame);
    return;
  }
  const ExportFormat* format = findExportFormat(choice.format);
  auto checks = checksBeforeSaving(*report, file->onFlange, file->findings, choice, *format);
  if (!choice.mountedAnswered) {
    const QString asks = choice.mounted.empty()
                             ? tr("Don’t forget the sensor’s own weight: add it under “Something else …” unless the "
                                  "controller already includes it, or tick “Nothing else”.")
                             : tr("Don’t forget the sensor’s own weight: tick it above unless the "
                                  "controller already includes it, or tick “Nothing else”.");
    checks.insert(checks.begin(), {Severity::warning, false, false, asks});
  }
  if (choice.role == ExportChoice::Role::unasked)
    checks.insert(checks.begin(), {Severity::warning, false, false, tr("Answer the question above before saving.")});
  for (const Check& check : checks)
    if (!check.doubt) addCheck(column, check);
}

/// What speaks against the numbers stands before everything else: the button below waits for it.
void ExportPanel::addDoubts(QVBoxLayout* column, const PayloadFile& file, const ExportChoice& choice) {
  const auto checks =
      checksBeforeSaving(*workspace().report(), file.onFlange, file.findings, choice, *findExportFormat(choice.format));
  for (const Check& check : checks)
    if (check.doubt) addCheck(column, check);
  addAllTheSame(column);
}

void ExportPanel::addCheck(QVBoxLayout* column, const Check& check) {
  QWidget* content = page()->content();
  const bool warns = !check.good;
  const Light light = check.good                            ? Light::measured
                      : check.severity == Severity::error   ? Light::notPossible
                      : check.severity == Severity::warning ? Light::look
                                                            : Light::info;
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  row->addWidget(new LightIcon(light, 18, content), 0, Qt::AlignTop);
  row->addWidget(wrappedLabel(check.text, warns ? "body" : "answer", content), 1);
  if (warns) {
    const Card card = makeCard("cardLook", content);
    card.layout->addLayout(row);
    column->addWidget(card.frame);
  } else {
    column->addLayout(row);
  }
}

void ExportPanel::chooseFormat(const std::string& id) {
  ExportChoice next = workspace().session().exporting;
  if (next.format == id) return refresh();
  next.format = id;
  workspace().setExport(next, tr("choose the format"));
}

void ExportPanel::chooseRole(ExportChoice::Role role) {
  ExportChoice next = workspace().session().exporting;
  if (next.role == role) return refresh();
  next.role = role;
  workspace().setExport(
      next, role == ExportChoice::Role::ownTool ? tr("it is the robot’s own tool") : tr("it is an extra load"));
}

void ExportPanel::save() {
  const auto opened = workspace().opened();
  if (!opened || text_.empty()) return;
  const QString suggested = QFileInfo(opened->path).absolutePath() + "/" + suggestedName();
  // The dialog itself asks before an existing file is replaced.
  const QString path = QFileDialog::getSaveFileName(this, tr("Save the payload file"), suggested, tr("All files (*)"));
  if (path.isEmpty()) return;
  const auto saved = saveTo(path, true);
  if (!saved) {
    parts().say(Severity::error, QString::fromStdString(saved.error().message));
  } else {
    parts().offer(Severity::info, tr("Saved %1.").arg(path), tr("Show in folder"),
                  [path] { QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(path).absolutePath())); });
  }
}

Result<bool> ExportPanel::saveTo(const QString& path, bool replace) {
  if (text_.empty())
    return Error{refusal_.empty() ? tr("There is no payload file to save yet.").toStdString() : refusal_};
  if (!replace && QFileInfo::exists(path))
    return Error{tr("%1 already exists and was not overwritten.").arg(path).toStdString()};
  auto written = writeTextFile(path.toStdString(), text_);
  if (!written) return written.error();
  savedAs_ = path;
  savedText_ = QString::fromStdString(text_);
  preview_->setSaved(true);
  emit stateChanged();
  return true;
}

bool ExportPanel::confirmed() const {
  const auto report = workspace().report();
  return report && confirmed_.lock() == report;
}

void ExportPanel::confirmUntrusted() {
  const auto report = workspace().report();
  if (!report) return;
  auto* box = new QMessageBox(QMessageBox::NoIcon, tr("Heft Studio"),
                              tr("Write a payload that the recording does not support?"), QMessageBox::NoButton, this);
  box->setObjectName("confirmUntrusted");
  box->setIconPixmap(lightPixmap(Light::look, 36, devicePixelRatioF()));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setInformativeText(
      tr("%1\n\nA robot with a wrong load setting drifts when it is guided, stops without a reason, or does not stop "
         "when it should.")
          .arg(QString::fromStdString(report->whyNoTrust)));
  auto* yes = box->addButton(tr("Write it; I know that these numbers are wrong"), QMessageBox::DestructiveRole);
  box->setDefaultButton(box->addButton(tr("Do not write"), QMessageBox::RejectRole));
  connect(yes, &QAbstractButton::clicked, this, [this, report] {
    if (workspace().report() != report) return;
    confirmed_ = report;
    QMetaObject::invokeMethod(this, &ExportPanel::refresh, Qt::QueuedConnection);
  });
  box->open();
}

void ExportPanel::copy() {
  QApplication::clipboard()->setText(QString::fromStdString(text_));
  parts().say(Severity::info, tr("The file was copied to the clipboard."));
}

ScriptForms ExportPanel::scriptForms() {
  ScriptForms forms{{"export FORMAT FILE [replace]", "write the payload file"}};
  for (const ScriptForms& more : {ProofCard::scriptForms()}) forms.insert(forms.end(), more.begin(), more.end());
  return forms;
}

std::optional<Result<bool>> ExportPanel::obey(const QStringList& words) {
  if (auto obeyed = proof_->obey(words)) return obeyed;
  if (words[0] != "export") return std::nullopt;
  const bool replace = words.size() == 4 && words[3] == "replace";
  if (words.size() != 3 && !replace) return std::nullopt;
  if (!findExportFormat(words[1].toStdString()))
    return Result<bool>(Error{tr("There is no format %1; heft export --help lists them.").arg(words[1]).toStdString()});
  if (!workspace().report()) return Result<bool>(Error{tr("export needs a result.").toStdString()});
  chooseFormat(words[1].toStdString());
  return saveTo(words[2], replace);
}

}  // namespace heft
