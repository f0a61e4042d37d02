#pragma once
// The step "Export": which controller, the two questions that decide what the numbers mean there, the file before it is
// written, and saving it.
#include <QString>
#include <memory>
#include <optional>
#include <string>

#include "core/estimation/estimate.h"
#include "core/workspace/session.h"
#include "ui/steps/step_panel.h"

class QVBoxLayout;

namespace heft {

class FilePreview;
class ProofCard;
struct Check;
struct PayloadFile;

class ExportPanel : public StepPanel {
  Q_OBJECT
 public:
  explicit ExportPanel(const StudioParts& parts);

  Step step() const override { return Step::exportFile; }
  StepState state() const override;
  void entered() override { refresh(); }
  QString hint() const override { return tr("An existing file is never overwritten without asking"); }
  Below below() const override { return Below::own; }
  QWidget* ownPane() override;
  double viewShare() const override { return 0.52; }
  static ScriptForms scriptForms();
  std::optional<Result<bool>> obey(const QStringList& words) override;

  /// Writes the file; an existing one is replaced only with `replace`.
  Result<bool> saveTo(const QString& path, bool replace);

 private:
  void refresh();
  void addFormats(QVBoxLayout* column, const ExportChoice& choice);
  void addRole(QVBoxLayout* column, const ExportChoice& choice);
  void addMounted(QVBoxLayout* column, const ExportChoice& choice, double together);
  void addToolCentre(QVBoxLayout* column, const ExportChoice& choice);
  void addChecks(QVBoxLayout* column, const Result<PayloadFile>& file, const ExportChoice& choice);
  void addCheck(QVBoxLayout* column, const Check& check);
  void addDoubts(QVBoxLayout* column, const PayloadFile& file, const ExportChoice& choice);
  /// Where the doubts come from, and the box that takes them on.
  void addAllTheSame(QVBoxLayout* column);
  bool mayBeSaved() const { return doubts_.isEmpty() || accepted_ == doubts_; }
  void chooseFormat(const std::string& id);
  void chooseRole(ExportChoice::Role role);
  void save();
  void copy();
  /// What nothing in the result allows is written only after this was answered with yes, and for this result only.
  void confirmUntrusted();
  bool confirmed() const;
  /// The choice of the session, with the parts that this recording suggests where the user has not said anything.
  ExportChoice choiceNow() const;
  QString suggestedName() const;
  Result<PayloadFile> fileNow(const ExportChoice& choice) const;

  FilePreview* preview_;
  ProofCard* proof_;
  std::string text_;                               ///< Of the file shown; empty if it cannot be made.
  std::string refusal_;                            ///< Why there is none.
  std::weak_ptr<const EstimateReport> confirmed_;  ///< To be written although nothing in it can be trusted
  QString savedAs_;                                ///< Where this very text was written last.
  QString savedText_;
  int tcpKey_ = 0;        ///< Steps of one change are one edit.
  QStringList doubts_;    ///< What speaks against the numbers of the file shown
  QStringList accepted_;  ///< The doubts that the user took on; others ask anew.
};

}  // namespace heft
