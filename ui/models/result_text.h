#pragma once
// What the result panel says, as plain data: words, numbers and lights of an estimate, computed without widgets.
#include <QString>
#include <QStringList>
#include <vector>

#include "core/estimation/estimate.h"

namespace heft {

/// One number with its 95 % interval as half a width, in the unit shown.
struct NumberText {
  QString name;       ///< "Ixx", "x"
  QString value;      ///< "16.0"
  QString plusMinus;  ///< "± 1.3"
  Source source = Source::none;
  QString tip;  ///< The interval in full and what the number means.
};

/// A position on the mass card's scale, 0 to 1.
struct MassScale {
  double value = 0.5, from = 0.5, to = 0.5;  ///< Shares of the scale's width.
  QString lowest, highest;                   ///< Numbers at its ends.
  double stated = -1.0;                      ///< What the user knows, or below 0.
};

struct FindingText {
  Severity severity = Severity::info;
  QString text, remedy;
  bool doubt = false;    ///< Says that the numbers themselves may be wrong.
  bool noTrust = false;  ///< Says why they are not shown.
  enum class Leads { cause, realityCheck, shape, object } leads = Leads::cause;  ///< Where more is to be had
};

struct DetailText {
  QString name, value, tip;
};

/// Correlations of the reported numbers.
struct MatrixText {
  QStringList names;
  Matrix10d values = Matrix10d::Identity();
};

/// How much of a number the motion determined, compared with what the user stated.
struct ShareText {
  QString name;
  double data = 1.0;
  QString words;        ///< "98 % data"
  QString tip;          ///< What the data say, what was stated, and how far these disagree.
  bool pulled = false;  ///< What was stated moved the number out of the interval that the data gave.
};

struct ResultText {
  QString question;       ///< "Your tool weighs 0.81 kg."
  QString answer;         ///< "Mass and centre are measured; inertia is not known from this motion."
  bool doubtful = false;  ///< A finding doubts the numbers: check before use.
  bool withheld = false;  ///< Nothing in the result can be trusted: no number is shown.
  bool doubted = false;   ///< So, or a cause that is not applied doubts some of them.
  NumberText mass;
  MassScale massScale;
  QString massNote;             ///< "you stated 0.815 kg, 0.4 % away"; may be empty
  std::vector<NumberText> com;  ///< Three, in mm
  QString comNote;
  std::vector<NumberText> inertia;  ///< In inertiaUnit; unknown products of inertia share one row.
  QString inertiaUnit;              ///< "kg cm²"
  QString inertiaNote;
  QString advice;                     ///< What would make it better; may be empty.
  std::vector<FindingText> findings;  ///< Gravest first.
  std::vector<ShareText> shares;      ///< Empty if nothing was stated.
  std::vector<DetailText> known;      ///< Comparison with CAD or scale values; empty without any.
  std::vector<DetailText> details;
  std::vector<std::vector<DetailText>> frames;  ///< Those of the sensor's axes, and of the flange's
  MatrixText correlation;
};

/// What is known of the payload from elsewhere, and who says so.
struct KnownPayload {
  PartialPayload payload;
  bool byUser = true;  ///< Else it stands in the recording's setup file.
};

/// What the reality check found and the user has not applied.
struct OpenQuestion {
  QStringList causes;                   ///< A sentence each
  Vector10d moved = Vector10d::Zero();  ///< payloadShift(): mass, centre, inertia in their own deviations
  QString change;                       ///< "Izz 29.3 → 12.3 kg cm²"
};

ResultText describeResult(const EstimateReport& report, const KnownPayload& known, const OpenQuestion& open = {});

/// "measured", "doubtful", "from your shape", "not known from this motion".
QString sourceWord(Source source);

/// The most modest source of several: one unknown makes the whole unknown or partly known.
Source jointSource(const std::vector<NumberText>& numbers);

}  // namespace heft
