#pragma once
// What to do about something where a command line and a window have different ways to do it. Core says which way is
// meant; the program around it says how one goes it: by default in the words of the command line.
#include <functional>
#include <string>

namespace heft {

enum class Remedy {
  showContents,      ///< See which topics and columns a recording has.
  chooseSource,      ///< Say which topic or column a part is; subject: the part, "wrench".
  takeSource,        ///< Take a topic that was passed over; subject: its name.
  addFile,           ///< Add the file of a part that is missing, or say which columns it has.
  chooseTime,        ///< Say which column or dataset is the time.
  stateOffset,       ///< Say how much one clock is late; subject: the stream and by how much, "/ft": 0.25.
  stateRate,         ///< Say at which rate a file without a clock was recorded.
  nameRobot,         ///< Say which robot was recorded.
  mountSensor,       ///< Say which link carries the sensor; subject: the links there are.
  stateConvention,   ///< Say which unit or form the numbers have; subject: as in a setup file, "angle_unit": "deg".
  turnWrench,        ///< The wrench has the other sign.
  turnGravity,       ///< Gravity points the other way.
  correctMount,      ///< The sensor is mounted turned.
  sayStandingPoses,  ///< The rows are standing poses, not a motion.
  keepEndsOut,       ///< The ends of the recording are not to be used.
  giveCentre,        ///< Tell the centre of mass.
  readSo,            ///< The numbers mean something else than stated; subject: the meta keys as JSON.
  keepReading,       ///< They were understood so now; state it for good; subject: the meta keys as JSON.
  giveInertia,       ///< Tell the inertia, or a shape.
};

/// One sentence. Called from any thread.
std::string remedy(Remedy way, const std::string& subject = {});

using RemedyWords = std::function<std::string(Remedy, const std::string& subject)>;
/// From now on remedy() speaks so; an empty function: as the command line.
void setRemedyWords(RemedyWords words);

}  // namespace heft
