#include "ui/studio/window_remedies.h"

#include <QCoreApplication>

namespace heft {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Remedies)
};

QString words(Remedy way, const QString& subject) {
  switch (way) {
    case Remedy::showContents:
      return Words::tr("Tools, “Columns and units”, shows what there is.");
    case Remedy::chooseSource:
      return Words::tr("If so, choose it under Tools, “Columns and units”.");
    case Remedy::takeSource:
      return Words::tr("You can still choose it.");
    case Remedy::addFile:
      return Words::tr("Choose its columns, or add the file that has it.");
    case Remedy::chooseTime:
      return Words::tr("Choose the time column under Tools, “Columns and units”.");
    case Remedy::stateOffset:
      return Words::tr("If you know the offset, enter it under Tools, “Columns and units”.");
    case Remedy::stateRate:
      return Words::tr("If the file has no clock, state its rate, rate_hz, in the map file beside it.");
    case Remedy::nameRobot:
      return Words::tr("Choose it under Tools, “Robot and sensor”.");
    case Remedy::mountSensor:
      return Words::tr("Choose the link that carries the sensor under Tools, “Robot and sensor”: one of %1.")
          .arg(subject);
    case Remedy::stateConvention:
      return Words::tr("If so, enter it under Tools, “Robot and sensor”, “Conventions of the numbers”.");
    case Remedy::turnWrench:
      return Words::tr("Set the opposite sign of the force under Tools, “Robot and sensor”.");
    case Remedy::turnGravity:
      return Words::tr("Enter how the robot is mounted under Tools, “Robot and sensor”.");
    case Remedy::correctMount:
      return Words::tr("Correct how the sensor is turned under Tools, “Robot and sensor”.");
    case Remedy::sayStandingPoses:
      return Words::tr(
          "If the rows are standing poses, set this under Tools, “Robot and sensor”; for another unit, see “Columns "
          "and units”.");
    case Remedy::keepEndsOut:
      return Words::tr("To keep them out, paint them as ignored in Mark.");
    case Remedy::giveCentre:
      return Words::tr("Describe the tool’s shape in the step Shape.");
    case Remedy::readSo:
      return Words::tr(
                 "The step Reality check applies it with one click; or enter it under Tools, “Robot and sensor”: %1.")
          .arg(subject);
    case Remedy::keepReading:
      return Words::tr("Enter it under Tools, “Robot and sensor”, “Conventions of the numbers”: %1.").arg(subject);
    case Remedy::giveInertia:
      return Words::tr("Describe the tool’s shape in the step Shape.");
  }
  return {};
}

}  // namespace

std::string windowRemedy(Remedy way, const std::string& subject) {
  return words(way, QString::fromStdString(subject)).toStdString();
}

}  // namespace heft
