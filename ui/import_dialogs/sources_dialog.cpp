#include "ui/import_dialogs/sources_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/base/json_file.h"
#include "ui/import_dialogs/choice.h"
#include "ui/widgets/basics.h"

#include "core/math/degrees.h"

namespace heft {
namespace {

constexpr double kAsFound = 0.0;  ///< Of a unit: no factor is said.

std::string partOf(const std::string& column) {
  if (column[0] == 'p') return "position";
  if (column[0] == 'd') return "velocities";
  if (column.size() == 2 && column[0] == 'q' && column[1] > '9') return "quaternion";
  return column[0] == 'q' ? "joints" : "wrench";
}

}  // namespace

SourcesDialog::SourcesDialog(const QString& recording, QWidget* parent) : QDialog(parent), path_(recording) {
  setObjectName("sourcesDialog");
  setWindowTitle(tr("Columns and units"));
  setMinimumWidth(640);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(20, 18, 20, 16);
  column->setSpacing(10);
  column->addWidget(styledLabel(tr("Which column is which?"), "question", this));
  column->addWidget(wrappedLabel(tr("Heft assigned the columns of %1 by type and name. Correct anything that is wrong.")
                                     .arg(QFileInfo(recording).fileName()),
                                 "answer", this));
  auto* state = new QHBoxLayout;
  light_ = new LightIcon(Light::info, 20, this);
  state->addWidget(light_, 0, Qt::AlignTop);
  state_ = wrappedLabel({}, "body", this);
  state_->setObjectName("sourcesState");
  state_->setMinimumHeight(40);
  state_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  state->addWidget(state_, 1);
  column->addLayout(state);

  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(8);
  grid->setColumnStretch(1, 1);
  addRow(grid, "wrench", tr("Force and torque"), tr("As measured by the sensor at the wrist"),
         {{tr("N and N m"), 1.0}, {tr("N and N mm"), 0.001}});
  addRow(grid, "joints", tr("Joint angles"), tr("With joint angles, no pose is needed"),
         {{tr("radians"), 1.0}, {tr("degrees"), kRadPerDegree}});
  addRow(grid, "velocities", tr("Joint speeds"), tr("Only with joint angles; optional"),
         {{tr("rad/s"), 1.0}, {tr("degrees/s"), kRadPerDegree}});
  addRow(grid, "quaternion", tr("Orientation"),
         tr("Of the sensor or the flange, as a quaternion; needed without joint angles"), {});
  addRow(grid, "position", tr("Position"), tr("Of the sensor or the flange"), {{tr("m"), 1.0}, {tr("mm"), 0.001}});
  addRow(grid, "time", tr("Time"), tr("The column or dataset that holds the time of each sample"),
         {{tr("unit as found"), kAsFound}, {tr("s"), 1.0}, {tr("ms"), 1e-3}, {tr("µs"), 1e-6}, {tr("ns"), 1e-9}});
  column->addLayout(grid);
  addMore(column);
  addColumns(column);
  column->addWidget(wrappedLabel(tr("Saved to %1 beside the recording; also used by the command line.")
                                     .arg(QString::fromStdString(mapFileOf(path_.toStdString()).filename().string())),
                                 "caption", this));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  read_ = buttons->button(QDialogButtonBox::Ok);
  read_->setObjectName("readSo");
  read_->setText(tr("Apply"));
  guess_ = buttons->addButton(tr("Reset"), QDialogButtonBox::ResetRole);
  guess_->setObjectName("heftsGuess");
  connect(guess_, &QPushButton::clicked, this, [this] {
    wishes_ = {};
    showFiles();
    look();
  });
  connect(buttons, &QDialogButtonBox::accepted, this, &SourcesDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
  look();
}

SourcesDialog::~SourcesDialog() { jobs_.cancel(); }

void SourcesDialog::addRow(QGridLayout* grid, const QString& part, const QString& title, const QString& tip,
                           const std::vector<std::pair<QString, double>>& units) {
  Row row;
  row.part = part;
  const int at = grid->rowCount();
  auto* label = styledLabel(title, "rowName", this);
  grid->addWidget(label, at, 0);
  row.source = makeChoice("source_" + part, title, tip, 12, this);
  label->setBuddy(row.source);
  grid->addWidget(row.source, at, 1);
  connect(row.source, QOverload<int>::of(&QComboBox::activated), this, [this, part, box = row.source](int) {
    setUse(part.toStdString(), box->currentData().toString());
    look();
  });
  if (!units.empty()) {
    row.unit = makeChoice("unit_" + part, tr("Unit of: %1").arg(title), tr("Unit used in the file"), 9, this);
    for (const auto& [text, factor] : units) row.unit->addItem(text, factor);
    grid->addWidget(row.unit, at, 2);
    connect(row.unit, QOverload<int>::of(&QComboBox::activated), this, [this, part, box = row.unit](int) {
      setUnit(part, box->currentData().toDouble());
      look();
    });
  }
  rows_.push_back(row);
}

void SourcesDialog::addMore(QVBoxLayout* column) {
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  row->addWidget(styledLabel(tr("Poses describe"), "rowName", this));
  poseOf_ = makeChoice("poseOf", tr("Poses describe"),
                       tr("The sensor’s poses are derived from the flange’s by its mounting"), 12, this);
  poseOf_->addItem(tr("the sensor"), false);
  poseOf_->addItem(tr("the flange"), true);
  row->addWidget(poseOf_, 1);
  connect(poseOf_, QOverload<int>::of(&QComboBox::activated), this, [this](int) {
    wishes_.poseOfFlange = poseOf_->currentData().toBool();
    look();
  });
  row->addWidget(styledLabel(tr("Wrench time offset"), "rowName", this));
  shift_ = new QDoubleSpinBox(this);
  shift_->setObjectName("wrenchShift");
  shift_->setAccessibleName(tr("Seconds added to the times of force and torque"));
  shift_->setToolTip(tr("For force and torque on another clock, where Heft cannot determine the offset"));
  shift_->setRange(-1e10, 1e10);
  shift_->setDecimals(3);
  shift_->setSuffix(tr(" s"));
  shift_->setKeyboardTracking(false);
  row->addWidget(shift_, 1);
  connect(shift_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double seconds) {
    if (!contents_) return;
    for (const ColumnSource& each : contents_->chosen) {
      if (each.column != "fx") continue;
      const Stream& stream = contents_->streams[each.stream];
      const std::string name = stream.name.empty() ? stream.file : stream.name;
      if (seconds == 0.0)
        wishes_.offset.erase(name);
      else
        wishes_.offset[name] = seconds;
    }
    look();
  });
  column->addLayout(row);
  auto* files = new QHBoxLayout;
  auto* add = new QPushButton(tr("Add another file…"), this);
  add->setObjectName("addFile");
  add->setToolTip(tr("For instance the sensor’s own log beside the robot’s"));
  connect(add, &QPushButton::clicked, this, &SourcesDialog::addFile);
  files->addWidget(add, 0, Qt::AlignTop);
  files_ = new QVBoxLayout;
  files->addLayout(files_, 1);
  column->addLayout(files);
}

void SourcesDialog::addColumns(QVBoxLayout* column) {
  auto* toggle = new QPushButton(tr("Choose columns individually"), this);
  toggle->setObjectName("eachColumn");
  toggle->setCheckable(true);
  column->addWidget(toggle, 0, Qt::AlignLeft);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFixedHeight(190);
  scroll->hide();
  auto* content = new QWidget(scroll);
  auto* grid = new QGridLayout(content);
  grid->setContentsMargins(0, 0, 8, 0);
  grid->setHorizontalSpacing(10);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  const char* const left[] = {"fx", "fy", "fz", "tx", "ty", "tz", "px", "py", "pz"};
  const char* const right[] = {"q1", "q2", "q3", "q4", "q5", "q6", "q7", "qx", "qy", "qz", "qw"};
  const auto add = [&](const char* name, int row, int place) {
    auto* label = styledLabel(QString::fromLatin1(name), "rowName", content);
    auto* box =
        makeChoice(QStringLiteral("column_%1").arg(QLatin1String(name)), tr("Column for %1").arg(QLatin1String(name)),
                   tr("Source of %1").arg(QLatin1String(name)), 12, content);
    box->setModel(&fields_);
    grid->addWidget(label, row, place);
    grid->addWidget(box, row, place + 1);
    connect(box, QOverload<int>::of(&QComboBox::activated), this, [this, name, box](int index) {
      setUse(name, index > 0 ? box->currentText() : QString());
      look();
    });
    columns_[name] = box;
  };
  for (int i = 0; i < 9; ++i) add(left[i], i, 0);
  for (int i = 0; i < 11; ++i) add(right[i], i, 2);
  scroll->setWidget(content);
  column->addWidget(scroll);
  single_ = scroll;
  connect(toggle, &QPushButton::toggled, this, [this, scroll](bool on) {
    scroll->setVisible(on);
    adjustSize();
  });
}

void SourcesDialog::addFile() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Add a file recorded with it"), QFileInfo(path_).absolutePath());
  if (file.isEmpty()) return;
  wishes_.join.emplace_back(file.toStdString());
  showFiles();
  look();
}

void SourcesDialog::showFiles() {
  while (QLayoutItem* item = files_->takeAt(0)) {
    if (item->widget()) item->widget()->deleteLater();
    delete item;
  }
  for (std::size_t k = 0; k < wishes_.join.size(); ++k) {
    const QString name = QString::fromStdString(wishes_.join[k].filename().string());
    auto* line = new QWidget(this);
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(styledLabel(name, "rowName", line), 1);
    auto* remove = new IconButton("close", tr("Remove %1").arg(name), line);
    connect(remove, &QToolButton::clicked, this, [this, k] {
      wishes_.join.erase(wishes_.join.begin() + static_cast<std::ptrdiff_t>(k));
      showFiles();
      look();
    });
    row->addWidget(remove);
    files_->addWidget(line);
  }
}

void SourcesDialog::setUse(const std::string& name, const QString& source) {
  if (source.isEmpty())
    wishes_.use.erase(name);
  else
    wishes_.use[name] = source.toStdString();
}

void SourcesDialog::setUnit(const QString& part, double factor) {
  std::vector<std::string> names = {part.toStdString()};
  // A wrench in N mm has its forces in N.
  if (part == QLatin1String("wrench")) names = {"tx", "ty", "tz"};
  for (const std::string& name : names) {
    if (factor == kAsFound || (factor == 1.0 && part != QLatin1String("time")))
      wishes_.scale.erase(name);
    else
      wishes_.scale[name] = factor;
  }
}

void SourcesDialog::look() {
  ImportOptions options;
  // The first look takes what the map file says.
  if (!first_) options.wishes = wishes_;
  complete_ = false;
  read_->setEnabled(false);
  showState(true, tr("Checking …"));
  light_->setLight(Light::info);
  jobs_.start(
      QString(),
      [path = path_.toStdString(), options](const Progress& progress) {
        return inspectRecording(path, options, progress);
      },
      [this](Result<RecordingContents> found) { show(found); });
}

QString SourcesDialog::streamName(const Stream& stream) const {
  const bool unnamed = stream.name.empty() || stream.name == "/";
  return QString::fromStdString(unnamed ? std::filesystem::path(stream.file).filename().string() : stream.name);
}

void SourcesDialog::show(const Result<RecordingContents>& found) {
  if (!found) {
    if (!found.error().cancelled) showState(false, QString::fromStdString(found.error().message));
    // Even what a broken map file says can be taken back here.
    if (first_) first_ = false;
    return;
  }
  if (first_) wishes_ = found->wishes;
  first_ = false;
  contents_ = std::make_shared<const RecordingContents>(*found);
  complete_ = found->missing.empty();
  read_->setEnabled(complete_);
  showState(complete_, complete_ ? tr("This can be read.") : QString::fromStdString(found->missing));
  for (const Row& row : rows_) showRow(row, *found);
  // A field's own name where it says enough.
  std::map<std::string, int> count;
  for (const Stream& stream : found->streams)
    for (const std::string& field : stream.fields) ++count[field];
  QStringList names = {tr("as above")};
  for (const Stream& stream : found->streams) {
    const std::string topic = stream.name.empty() ? stream.file : stream.name;
    for (const std::string& field : stream.fields)
      names << QString::fromStdString(count[field] == 1 ? field : topic + ":" + field);
  }
  if (names != fields_.stringList()) fields_.setStringList(names);
  for (const auto& [name, box] : columns_) {
    const QSignalBlocker quiet(box);
    const auto said = wishes_.use.find(name);
    const int at = said == wishes_.use.end() ? 0 : box->findText(QString::fromStdString(said->second));
    box->setCurrentIndex(std::max(0, at));
  }
  const QSignalBlocker quietPose(poseOf_), quietShift(shift_);
  poseOf_->setCurrentIndex(wishes_.poseOfFlange ? 1 : 0);
  std::size_t wrench = found->streams.size(), motion = wrench;
  for (const ColumnSource& each : found->chosen) {
    if (each.column == "fx") wrench = each.stream;
    if (each.column == "q1" || each.column == "qx") motion = each.stream;
  }
  const bool apart = wrench < found->streams.size() && motion < found->streams.size() && wrench != motion;
  shift_->setEnabled(apart);
  if (apart) {
    const Stream& stream = found->streams[wrench];
    const auto said = wishes_.offset.find(stream.name.empty() ? stream.file : stream.name);
    shift_->setValue(said == wishes_.offset.end() ? 0.0 : said->second);
  }
  guess_->setEnabled(!(wishes_ == MappingWishes{}));
  showFiles();
}

void SourcesDialog::showRow(const Row& row, const RecordingContents& found) {
  const QSignalBlocker quiet(row.source);
  const std::string part = row.part.toStdString();
  row.source->clear();
  const auto said = wishes_.use.find(part);
  if (part == "time") {
    row.source->addItem(tr("automatic"), QString());
    for (const std::string& name : found.timeCandidates)
      row.source->addItem(QString::fromStdString(name), QString::fromStdString(name));
    row.source->setEnabled(row.source->count() > 1);
  } else {
    QString taken;
    for (const ColumnSource& each : found.chosen)
      if (taken.isEmpty() && partOf(each.column) == part) taken = streamName(found.streams[each.stream]);
    const bool own = said == wishes_.use.end() && !taken.isEmpty();
    row.source->addItem(own                                           ? tr("automatic: %1").arg(taken)
                        : found.candidates.empty() || taken.isEmpty() ? tr("not found")
                                                                      : tr("automatic"),
                        QString());
    for (const ColumnCandidate& candidate : found.candidates) {
      if (candidate.part != part) continue;
      const QString name = streamName(found.streams[candidate.columns[0].stream]);
      if (row.source->findData(name) >= 0) continue;
      row.source->addItem(QStringLiteral("%1 (%2)").arg(name, QString::fromStdString(candidate.why)), name);
    }
    row.source->setEnabled(row.source->count() > 1);
  }
  int at = 0;
  if (said != wishes_.use.end()) {
    const QString name = QString::fromStdString(said->second);
    at = row.source->findData(name);
    if (at < 0) {
      row.source->addItem(name, name);
      at = row.source->count() - 1;
    }
    row.source->setEnabled(true);
  }
  row.source->setCurrentIndex(at);
  if (!row.unit) return;
  const QSignalBlocker quietUnit(row.unit);
  const auto factor = wishes_.scale.find(part == "wrench" ? "tx" : part);
  const double value = factor == wishes_.scale.end() ? (part == "time" ? kAsFound : 1.0) : factor->second;
  int unit = -1;
  for (int k = 0; k < row.unit->count(); ++k)
    if (std::abs(row.unit->itemData(k).toDouble() - value) <= 1e-9 * std::abs(value)) unit = k;
  if (unit < 0) {
    row.unit->addItem(tr("times %1").arg(value), value);
    unit = row.unit->count() - 1;
  }
  row.unit->setCurrentIndex(unit);
}

void SourcesDialog::showState(bool good, const QString& sentence) {
  light_->setLight(good ? Light::measured : Light::look);
  state_->setText(sentence);
}

Result<bool> SourcesDialog::keep() const {
  const std::filesystem::path file = mapFileOf(path_.toStdString());
  if (wishes_ == MappingWishes{}) {
    std::error_code code;
    std::filesystem::remove(file, code);
    if (code)
      return Error{tr("%1 could not be removed: check that the folder may be written to.")
                       .arg(QString::fromStdString(file.string()))
                       .toStdString()};
    return true;
  }
  return writeTextFile(file, mapText(wishes_, std::filesystem::path(path_.toStdString()).parent_path()));
}

void SourcesDialog::accept() {
  if (const auto kept = keep(); !kept) return showState(false, QString::fromStdString(kept.error().message));
  QDialog::accept();
}

}  // namespace heft
