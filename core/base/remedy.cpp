#include "core/base/remedy.h"

#include <memory>
#include <mutex>

#include "core/base/say.h"

namespace heft {
namespace {

std::mutex wordsMutex;
std::shared_ptr<const RemedyWords> chosenWords;

std::string onCommandLine(Remedy way, const std::string& subject) {
  switch (way) {
    case Remedy::showContents:
      return heft::say("'heft convert IN --list' shows what there is.");
    case Remedy::chooseSource:
      return heft::say("Choose with --use {}=NAME.", subject);
    case Remedy::takeSource:
      return heft::say("--use wrench={} takes it nevertheless.", subject);
    case Remedy::addFile:
      return heft::say("Add its file with --join FILE, or name its columns with --use.");
    case Remedy::chooseTime:
      return heft::say("Name it time (in seconds), or choose it with --use time=NAME.");
    case Remedy::stateOffset:
      return heft::say("State it in a map file, for instance {{\"offset_s\": {{{}}}}} (seconds added to its times).",
                       subject);
    case Remedy::stateRate:
      return heft::say("If the file has no clock, state its rate with --rate HZ.");
    case Remedy::nameRobot:
      return heft::say("Name it with --robot, or in the setup file: \"robot\": \"panda\" or the path of a URDF.");
    case Remedy::mountSensor:
      return heft::say("Set sensor.mount.parent in the setup file to one of: {}.", subject);
    case Remedy::stateConvention:
      return heft::say("If so, write {} into the setup file.", subject);
    case Remedy::turnWrench:
      return heft::say(
          "Set sensor.wrench_sign in the setup file to the other convention (sensor_on_payload or payload_on_sensor).");
    case Remedy::turnGravity:
      return heft::say("Reverse gravity_m_s2 in the setup file.");
    case Remedy::correctMount:
      return heft::say("Correct sensor.mount.rpy_rad in the setup file.");
    case Remedy::sayStandingPoses:
      return heft::say("For standing poses write \"kind\": \"poses\" into the setup file.");
    case Remedy::keepEndsOut:
      return heft::say("Use --trim to exclude them.");
    case Remedy::giveCentre:
      return heft::say("Give it with --known to hold it fixed.");
    case Remedy::readSo:
      return heft::say("Estimate with --conventions suggested, or write {} into the setup file.", subject);
    case Remedy::keepReading:
      return subject.empty() ? std::string() : heft::say("To keep that, write {} into the setup file.", subject);
    case Remedy::giveInertia:
      return heft::say("Give it with --known, or a shape with --shape.");
  }
  return {};
}

}  // namespace

std::string remedy(Remedy way, const std::string& subject) {
  std::shared_ptr<const RemedyWords> words;
  {
    const std::lock_guard lock(wordsMutex);
    words = chosenWords;
  }
  return words ? (*words)(way, subject) : onCommandLine(way, subject);
}

void setRemedyWords(RemedyWords words) {
  const std::lock_guard lock(wordsMutex);
  chosenWords = words ? std::make_shared<const RemedyWords>(std::move(words)) : nullptr;
}

}  // namespace heft
