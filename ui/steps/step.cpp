#include "ui/steps/step.h"

#include <QCoreApplication>

namespace heft {
namespace {

struct Steps {
  Q_DECLARE_TR_FUNCTIONS(Steps)
};

}  // namespace

QString stepName(Step step) {
  switch (step) {
    case Step::record:
      return Steps::tr("Record");
    case Step::mark:
      return Steps::tr("Mark");
    case Step::shape:
      return Steps::tr("Shape");
    case Step::result:
      return Steps::tr("Result");
    case Step::realityCheck:
      return Steps::tr("Reality check");
    case Step::exportFile:
      return Steps::tr("Export");
  }
  return {};
}

std::string_view stepId(Step step) {
  switch (step) {
    case Step::record:
      return "record";
    case Step::mark:
      return "mark";
    case Step::shape:
      return "shape";
    case Step::result:
      return "result";
    case Step::realityCheck:
      return "reality-check";
    case Step::exportFile:
      return "export";
  }
  return {};
}

std::optional<Step> stepFromId(std::string_view id) {
  for (const Step step : kAllSteps) {
    if (stepId(step) == id) return step;
  }
  return std::nullopt;
}

}  // namespace heft
