#include "ui/controller/workspace.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "core/recording/csv_reader.h"
#include "core/workspace/marks.h"
#include "ui/controller/diagnosis.h"
#include "ui/controller/edit_command.h"
#include "ui/controller/free_file.h"
#include "ui/controller/joined_estimate.h"
#include "ui/controller/open_recording.h"

namespace heft {
namespace {

constexpr int kEstimateDelay = 350;  ///< [ms] after the last edit
enum EditKind {
  kMarks = 1,
  kShape,
  kSettings,
  kExport,
  kCorrections,
  kController
};  // Those of recording_list.cpp follow.

bool isSession(const QString& path) {
  return path.endsWith(QLatin1String(kSessionExtension.data()), Qt::CaseInsensitive);
}

}  // namespace

std::shared_ptr<const Recording> Snapshot::recording() const {
  if (marks.empty()) return {opened, &opened->recording};
  auto copy = std::make_shared<Recording>(opened->recording);
  // The last mark that covers an instant wins: the painted ones come last.
  copy->meta.marks.insert(copy->meta.marks.end(), marks.begin(), marks.end());
  return copy;
}

Result<EstimateReport> Snapshot::estimated(const Progress& progress) const {
  if (corrections.causes.empty()) return heft::estimate(*recording(), robot(), options, progress);
  const nlohmann::json found = nlohmann::json::parse(corrections.found, nullptr, false);
  return estimateWith(*recording(), robot(), options, found, corrections.causes, progress);
}

Workspace::Workspace(QObject* parent) : QObject(parent) {
  due_.setSingleShot(true);
  due_.setInterval(kEstimateDelay);
  connect(&due_, &QTimer::timeout, this, &Workspace::estimate);
  connect(&jobs_, &JobRunner::started, this, &Workspace::busyChanged);
  connect(&jobs_, &JobRunner::finished, this, &Workspace::busyChanged);
}

void Workspace::fail(const Error& error) {
  if (error.cancelled) return;
  lastFailure_ = QString::fromStdString(error.message);
  emit failed(lastFailure_);
}

const Workspace::Entry* Workspace::active() const {
  const int index = session_.active;
  return index >= 0 && index < static_cast<int>(entries_.size()) ? &entries_[static_cast<std::size_t>(index)] : nullptr;
}

std::shared_ptr<const OpenRecording> Workspace::opened() const { return active() ? active()->opened : nullptr; }

std::shared_ptr<const EstimateReport> Workspace::report() const { return active() ? active()->report : nullptr; }

std::shared_ptr<const OpenRecording> Workspace::openedAt(int index) const {
  return index >= 0 && index < static_cast<int>(entries_.size()) ? entries_[static_cast<std::size_t>(index)].opened
                                                                 : nullptr;
}

std::shared_ptr<const EstimateReport> Workspace::reportAt(int index) const {
  return index >= 0 && index < static_cast<int>(entries_.size()) ? entries_[static_cast<std::size_t>(index)].report
                                                                 : nullptr;
}

void Workspace::open(const QStringList& paths) {
  for (const QString& path : paths) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    if (isSession(absolute)) {
      auto session = readSession(absolute.toStdString());
      if (!session) {
        fail(session.error());
        continue;
      }
      takeSession(std::move(session).value());
    } else if (!queue_.contains(absolute)) {
      queue_ << absolute;
    }
  }
  if (!queue_.isEmpty() && !loading_) loadNext();
}

void Workspace::addRecording(const Recording& recording, const QString& folder, const QString& name) {
  QDir().mkpath(folder);
  const QString path = freeFile(folder, name, QStringLiteral("csv"));
  const auto written = writeRecording(recording, path.toStdString());
  if (!written) return fail(written.error());
  open(path);
}

void Workspace::startAfresh() { takeSession({}); }

void Workspace::takeSession(Session session) {
  jobs_.cancel();
  ++sessions_;
  loading_ = false;
  due_.stop();
  undo_.clear();
  modified_ = false;
  lastFailure_.clear();
  showAfter_ = session.active;
  session_ = std::move(session);
  session_.active = -1;
  entries_.assign(session_.recordings.size(), {});
  queue_.clear();
  for (const SessionRecording& recording : session_.recordings)
    queue_ << QString::fromStdString(recording.file.string());
  emit shapeChanged();
  emit settingsChanged();
  emit exportChanged();
  emit controllerChanged();
  emit roomChanged();
  emit proofChanged();
  emit openedChanged();
  emit reportChanged();
  emit sessionChanged();
  if (!queue_.isEmpty()) loadNext();
}

void Workspace::loadNext() {
  loading_ = true;
  const QString path = queue_.takeFirst();
  const auto cure = std::make_shared<ReadCure>(ReadCure::none);
  jobs_.start(
      tr("Opening %1").arg(QFileInfo(path).fileName()),
      [path, cure](const Progress& progress) { return loadRecording(path, progress, *cure); },
      [this, path, cure, sessions = sessions_](Result<std::shared_ptr<const OpenRecording>> result) {
        if (sessions != sessions_) return;  // It belongs to a session that has been closed since.
        if (result) {
          loaded(path, *result);
        } else {
          fail(result.error());
          if (result.error().cancelled)
            queue_.clear();
          else
            emit unreadable(path, QString::fromStdString(result.error().message), *cure);
        }
        if (!queue_.isEmpty()) return loadNext();
        loading_ = false;
        if (showAfter_ >= 0 && openedAt(showAfter_)) show(showAfter_);
        showAfter_ = -1;
        // What could not be estimated before is not tried again because another file was refused.
        if (opened() && (!report() || outdated()) && !active()->failed) estimate();
      });
}

void Workspace::loaded(const QString& path, std::shared_ptr<const OpenRecording> opened) {
  const std::filesystem::path file = path.toStdString();
  std::size_t index = 0;
  while (index < session_.recordings.size() && session_.recordings[index].file != file) ++index;
  if (index == session_.recordings.size()) {
    session_.recordings.push_back({file, {}, {}, {}, {}, {}});
    entries_.emplace_back();
    modified_ = true;
  }
  entries_[index] = {std::move(opened), nullptr};
  if (joins())
    for (Entry& entry : entries_) entry.outdated = true;
  // Of a session, the one that was shown is shown again; the first one meanwhile.
  if (showAfter_ < 0 || session_.active < 0) show(static_cast<int>(index));
  emit recordingsChanged();
  emit sessionChanged();
}

void Workspace::show(int index) {
  session_.active = index;
  lastFailure_.clear();
  emit openedChanged();
  emit reportChanged();
  emit sessionChanged();
}

void Workspace::activate(int index) {
  if (index == session_.active || !openedAt(index)) return;
  show(index);
  if ((!report() || outdated()) && queue_.isEmpty() && !active()->failed) estimate();
}

void Workspace::estimateSoon(int index) {
  if (joins()) index = kAllRecordings;
  for (int k = 0; k < static_cast<int>(entries_.size()); ++k)
    if (index == kAllRecordings || k == index) {
      entries_[static_cast<std::size_t>(k)].outdated = true;
      entries_[static_cast<std::size_t>(k)].failed = false;
    }
  if (!opened()) return;
  due_.start();
  emit busyChanged();
}

Snapshot Workspace::snapshotOf(int index) const {
  Snapshot out;
  out.opened = openedAt(index);
  if (!out.opened) return out;
  const SessionRecording& recording = session_.recordings[static_cast<std::size_t>(index)];
  out.marks = recording.marks;
  out.options = estimateOptions(session_);
  out.corrections = recording.corrections;
  // Painting over a suggestion must not turn the rest of the recording into "not marked": what counts is whether the
  // file itself came with marks.
  out.options.segments = defaultSegmentMode(out.opened->recording);
  return out;
}

std::vector<Segment> Workspace::segments() const {
  const auto now = opened();
  if (!now) return {};
  std::vector<Segment> base;
  if (report()) {
    base = report()->segments;
  } else {
    for (const Mark& mark : now->recording.meta.marks) {
      Segment segment;
      segment.from = mark.from;
      segment.to = mark.to;
      segment.label = mark.label;
      segment.reason = tr("Marked in the file.").toStdString();
      base.push_back(segment);
    }
  }
  return withMarks(base, session_.recordings[static_cast<std::size_t>(session_.active)].marks,
                   tr("Marked by you.").toStdString());
}

bool Workspace::suggested(const Segment& segment) const {
  const auto now = opened();
  if (!now || segment.label == MarkLabel::free) return false;
  if (defaultSegmentMode(now->recording) != SegmentMode::automatic) return false;
  const double middle = 0.5 * (segment.from + segment.to);
  const auto& marks = session_.recordings[static_cast<std::size_t>(session_.active)].marks;
  return std::none_of(marks.begin(), marks.end(),
                      [&](const Mark& mark) { return middle >= mark.from && middle <= mark.to; });
}

void Workspace::estimate() {
  due_.stop();
  if (!opened() || loading_) return;  // After loading it is estimated anyway.
  lastFailure_.clear();
  std::vector<Snapshot> of;
  for (int k = 0; k < static_cast<int>(entries_.size()); ++k)
    if (k == session_.active || (joins() && openedAt(k))) of.push_back(snapshotOf(k));
  jobs_.start(
      tr("Estimating"), [of](const Progress& progress) { return estimateTogether(of, progress); },
      [this, of](const Result<SharedReports>& result) {
        takeReports(of, result);
        if (!result) fail(result.error());
        emit reportChanged();
        emit sessionChanged();
      });
}

void Workspace::takeReports(const std::vector<Snapshot>& of, const Result<SharedReports>& result) {
  for (std::size_t i = 0; i < of.size(); ++i)
    for (std::size_t k = 0; k < entries_.size(); ++k) {
      if (entries_[k].opened != of[i].opened) continue;
      entries_[k].failed = !result && !result.error().cancelled;
      if (result) {
        entries_[k].report = (*result)[i];
        entries_[k].outdated = false;
        session_.recordings[k].result = toJson(*entries_[k].report).dump();
      } else if (!result.error().cancelled) {
        // The earlier numbers were of other marks or another shape.
        entries_[k].report.reset();
      }
    }
}

void Workspace::cancel() {
  due_.stop();
  queue_.clear();
  jobs_.cancel();
  emit busyChanged();
}

bool Workspace::save(const QString& file) {
  const auto written = writeSession(session_, file.toStdString());
  if (!written) {
    emit failed(QString::fromStdString(written.error().message));
    return false;
  }
  session_.home = QFileInfo(file).absoluteFilePath().toStdString();
  modified_ = false;
  undo_.setClean();
  emit saved(file);
  emit sessionChanged();
  return true;
}

template <class T>
void Workspace::edit(T Session::*part, T after, const QString& text, int mergeKey, void (Workspace::*changed)(),
                     bool estimates) {
  const int kind = std::is_same_v<T, ShapeChoice>        ? kShape
                   : std::is_same_v<T, EstimateSettings> ? kSettings
                   : std::is_same_v<T, ControllerChoice> ? kController
                                                         : kExport;
  undo_.push(new EditCommand<T>(text, kind, mergeKey, session_.*part, std::move(after),
                                [this, part, changed, estimates](const T& value) {
                                  session_.*part = value;
                                  emit(this->*changed)();
                                  emit sessionChanged();
                                  if (estimates) estimateSoon(kAllRecordings);
                                }));
}

void Workspace::setShape(const ShapeChoice& shape, const QString& text, int mergeKey) {
  edit(&Session::shape, shape, text, mergeKey, &Workspace::shapeChanged, true);
}

void Workspace::setSettings(const EstimateSettings& settings, const QString& text, int mergeKey) {
  edit(&Session::settings, settings, text, mergeKey, &Workspace::settingsChanged, true);
}

void Workspace::setExport(const ExportChoice& choice, const QString& text, int mergeKey) {
  edit(&Session::exporting, choice, text, mergeKey, &Workspace::exportChanged, false);
}

void Workspace::setController(const ControllerChoice& choice, const QString& text) {
  edit(&Session::controller, choice, text, 0, &Workspace::controllerChanged, false);
}

void Workspace::setRoom(const std::filesystem::path& file, const QString& text) {
  edit(&Session::room, file, text, 0, &Workspace::roomChanged, false);
}

void Workspace::setProof(const std::string& json) {
  session_.proof = json;
  modified_ = true;
  emit proofChanged();
  emit sessionChanged();
}

void Workspace::setMarks(const std::vector<Mark>& marks, const QString& text, int mergeKey) {
  if (!opened()) return;
  const auto index = static_cast<std::size_t>(session_.active);
  undo_.push(new EditCommand<std::vector<Mark>>(text, kMarks, mergeKey, session_.recordings[index].marks, marks,
                                                [this, index](const std::vector<Mark>& value) {
                                                  session_.recordings[index].marks = value;
                                                  // Undoing shows what it changes.
                                                  if (session_.active != static_cast<int>(index))
                                                    show(static_cast<int>(index));
                                                  emit marksChanged();
                                                  emit sessionChanged();
                                                  estimateSoon(static_cast<int>(index));
                                                }));
}

const Corrections& Workspace::corrections() const {
  static const Corrections none;
  return active() ? session_.recordings[static_cast<std::size_t>(session_.active)].corrections : none;
}

void Workspace::setCorrections(const Corrections& corrections, const QString& text) {
  if (!opened()) return;
  const auto index = static_cast<std::size_t>(session_.active);
  undo_.push(new EditCommand<Corrections>(text, kCorrections, 0, session_.recordings[index].corrections, corrections,
                                          [this, index](const Corrections& value) {
                                            session_.recordings[index].corrections = value;
                                            if (session_.active != static_cast<int>(index))
                                              show(static_cast<int>(index));
                                            emit correctionsChanged();
                                            emit sessionChanged();
                                            estimateSoon(static_cast<int>(index));
                                          }));
}

void Workspace::paint(double from, double to, std::optional<MarkLabel> label, int mergeKey) {
  if (!opened()) return;
  const QString text = !label                         ? tr("remove a mark")
                       : *label == MarkLabel::free    ? tr("mark as free")
                       : *label == MarkLabel::contact ? tr("mark as contact")
                                                      : tr("mark as ignored");
  setMarks(painted(session_.recordings[static_cast<std::size_t>(session_.active)].marks, from, to, label), text,
           mergeKey);
}

void Workspace::setStep(const QString& id) {
  if (showAfter_ >= 0 || session_.step == id.toStdString()) return;  // A session being opened brings its own.
  session_.step = id.toStdString();
  emit sessionChanged();
}

}  // namespace heft
