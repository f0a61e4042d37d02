#include "ui/controller/joined_estimate.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>
#include <tuple>

#include "core/base/doubts.h"
#include "core/estimation/joint.h"
#include "core/estimation/judgement.h"

namespace heft {
namespace {

struct JoinWords {
  Q_DECLARE_TR_FUNCTIONS(Joining)
};

Result<std::shared_ptr<EstimateReport>> estimatedAlone(const Snapshot& of, const Progress& progress) {
  auto result = of.estimated(progress);
  if (!result) return result.error();
  return std::make_shared<EstimateReport>(std::move(result).value());
}

QString fileOf(const Snapshot& of) { return QFileInfo(of.opened->path).fileName(); }

/// What the joint report says about all recordings, not only about the first.
bool isOfAll(const Finding& finding) {
  return finding.code == "different_tool" || finding.code == "recording_not_understood" ||
         finding.code == "low_trust_of_one";
}

/// Its own findings doubt the numbers, not those of another recording.
bool isDoubted(const JointPiece& piece) {
  return std::ranges::any_of(piece.report.findings, [](const Finding& finding) {
    return !isOfAll(finding) && doubtsNumbers(finding.severity, finding.code);
  });
}

EstimateOptions jointOptions(const std::vector<Snapshot>& of, const std::vector<std::size_t>& members) {
  EstimateOptions options = of[members.front()].options;
  // Marks count in either mode; what no file marks is judged.
  for (const std::size_t i : members)
    if (of[i].options.segments == SegmentMode::automatic) options.segments = SegmentMode::automatic;
  return options;
}

/// The joint reports, put at the places of `members`.
Result<bool> join(const std::vector<Snapshot>& of, const std::vector<std::size_t>& members, const Progress& progress,
                  std::vector<std::shared_ptr<EstimateReport>>& out) {
  std::vector<std::shared_ptr<const Recording>> recordings;
  for (const std::size_t i : members) recordings.push_back(of[i].recording());
  std::vector<JointInput> inputs;
  for (std::size_t m = 0; m < members.size(); ++m) inputs.push_back({recordings[m].get(), of[members[m]].robot()});
  auto joint = estimateJointly(inputs, jointOptions(of, members), progress);
  if (!joint) return joint.error();
  Findings ofAll;
  std::ranges::copy_if(joint->report().findings, std::back_inserter(ofAll),
                       [](const Finding& finding) { return isOfAll(finding) && finding.code != "low_trust_of_one"; });
  const EstimateReport& whole = joint->report();
  const auto [trust, why, whatToDo] = std::tuple(whole.trust, whole.whyNoTrust, whole.whatToDo);
  QStringList used, doubted;
  for (std::size_t m = 0; m < members.size(); ++m) {
    if (!joint->pieces[m].used) continue;
    used << fileOf(of[members[m]]);
    if (isDoubted(joint->pieces[m])) doubted << fileOf(of[members[m]]);
  }
  for (std::size_t m = 0; m < members.size(); ++m) {
    JointPiece& piece = joint->pieces[m];
    if (piece.used) {
      Findings& findings = piece.report.findings;
      std::erase_if(findings, isOfAll);
      findings.insert(findings.end(), ofAll.begin(), ofAll.end());
      if (trust > piece.report.trust)
        std::tie(piece.report.trust, piece.report.whyNoTrust, piece.report.whatToDo) = std::tuple(trust, why, whatToDo);
      // By its name: an index into the list would mean nothing to the reader.
      for (const QString& file : doubted)
        if (file != fileOf(of[members[m]]))
          findings.push_back({Severity::warning,
                              "low_trust_of_one",
                              JoinWords::tr("%1 is not reliable, so neither are the numbers from all of them.")
                                  .arg(file)
                                  .toStdString(),
                              JoinWords::tr("Look at its result alone, or leave it out.").toStdString(),
                              {}});
      doubtLabels(piece.report);
      piece.report.findings.push_back(
          {Severity::info,
           "joined",
           JoinWords::tr("Joint result from %n recordings: %1.", "", static_cast<int>(used.size()))
               .arg(used.join(QStringLiteral(", ")))
               .toStdString(),
           piece.words,
           {}});
    } else {
      piece.report.findings.push_back(
          {Severity::warning,
           "not_joined",
           JoinWords::tr("This recording contradicts the others, or Heft cannot explain it. It keeps its own numbers.")
               .toStdString(),
           piece.words,
           {}});
    }
    out[members[m]] = std::make_shared<EstimateReport>(std::move(piece.report));
  }
  return true;
}

}  // namespace

Result<SharedReports> estimateTogether(const std::vector<Snapshot>& of, const Progress& progress) {
  std::vector<std::shared_ptr<EstimateReport>> made(of.size());
  std::vector<std::size_t> members;
  for (std::size_t i = 0; i < of.size(); ++i)
    if (of[i].corrections.causes.empty()) members.push_back(i);
  if (members.size() < 2) members.clear();
  if (!members.empty())
    if (auto joined = join(of, members, progress, made); !joined) return joined.error();
  for (std::size_t i = 0; i < of.size(); ++i) {
    if (made[i]) continue;
    auto alone = estimatedAlone(of[i], progress);
    if (!alone) return alone.error();
    made[i] = *alone;
    if (of.size() > 1)
      made[i]->findings.push_back(
          {Severity::info,
           "not_joined",
           JoinWords::tr("Only recordings without applied corrections are joined; these numbers come from %1 alone.")
               .arg(fileOf(of[i]))
               .toStdString(),
           {},
           {}});
  }
  for (std::size_t i = 0; i < of.size(); ++i) {
    // Findings of reading concern the result as much as those of estimating.
    made[i]->timing.read = of[i].opened->readSeconds;
    made[i]->findings.insert(made[i]->findings.begin(), of[i].opened->findings.begin(), of[i].opened->findings.end());
  }
  return SharedReports(made.begin(), made.end());
}

}  // namespace heft
