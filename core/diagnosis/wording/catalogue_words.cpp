// What is said of each cause of the catalogue, whatever was found of it.
#include <fmt/format.h>

#include <map>

#include "core/base/say.h"
#include "core/diagnosis/wording/words.h"

namespace heft {
namespace {

struct Words {
  const char *title, *check, *decides, *looks;
};

const std::map<std::string_view, Words>& words() {
  static const std::map<std::string_view, Words> kWords{
      {"sensor_bias",
       {heft::toSay("Sensor's zero jumped"),
        heft::toSay("Was there a knock, a loose plug, or a program that zeroed the sensor while recording?"),
        heft::toSay("Turn the tool to another pose after the jump and hold: a jump stays, a load turns with gravity."),
        heft::toSay("The difference is flat, steps once, and is flat again, however the tool is held.")}},
      {"bias_drift",
       {heft::toSay("Sensor drifts"),
        heft::toSay("Let the sensor warm up for half an hour, keep draughts off it, and zero it often."),
        heft::toSay("Come back to the same pose three times: a drift reads differently each time."),
        heft::toSay("The difference climbs or sinks slowly over the whole recording and ignores the motion.")}},
      {"time_offset",
       {heft::toSay("Readings late"),
        heft::toSay("Do force and joint angles get their time from one clock, at the source?"),
        heft::toSay("Shake the tool quickly for ten seconds, two to four times a second."),
        heft::toSay(
            "The difference is large where the force changes fast and zero where it rests, with the full height "
            "kept.")}},
      {"low_pass_lag",
       {heft::toSay("Readings smoothed"),
        heft::toSay("Is a filter or averaging switched on in the sensor's amplifier or driver?"),
        heft::toSay("Shake the tool quickly for ten seconds: smoothing makes fast forces smaller, a delay does not."),
        heft::toSay("Late like a delay, but peaks are also cut down, and the noise looks soft.")}},
      {"motion_lag",
       {heft::toSay("Accelerations late"),
        heft::toSay("Record the plain joint angles at the full rate, without smoothing."),
        heft::toSay(
            "Turn the tool slowly through large angles: late readings show then too, late accelerations do not."),
        heft::toSay("Slow turning fits well; only starts and stops leave a difference.")}},
      {"sensor_rotation",
       {heft::toSay("Sensor mounted turned"),
        heft::toSay("Compare the arrows printed on the sensor with the mount in the meta file."),
        heft::toSay("Turn the last joint by half a turn and hold, then tilt the tool."),
        heft::toSay("The weight shows up on the wrong axis of the sensor, always the same one.")}},
      {"gravity_tilt",
       {heft::toSay("Robot base tilted"),
        heft::toSay("Put a spirit level on the robot's base, or state the true gravity in the meta file."),
        heft::toSay("Record once more with a heavier tool: a tilt grows with the weight, a pull does not."),
        heft::toSay("A difference that keeps its direction in the room and grows with the tool's weight.")}},
      {"gain_error",
       {heft::toSay("One channel reads wrong"),
        heft::toSay("Hang a known weight from each side of the sensor; check its calibration file."),
        heft::toSay(
            "Tilt the tool so that its weight lies on each axis in turn. Equal gains on all axes need a scale."),
        heft::toSay("The difference on one channel is a small copy of that channel itself.")}},
      {"crosstalk",
       {heft::toSay("One channel shows on another"),
        heft::toSay("Is the sensor's own calibration matrix loaded (serial number)?"),
        heft::toSay("Tilt the tool so that its weight lies on each axis of the sensor in turn."),
        heft::toSay("The difference on one channel is a small copy of another channel.")}},
      {"cable_pull",
       {heft::toSay("Cable or hose pulls"),
        heft::toSay("Does the cable or hose hang free of the wrist, with slack in every pose?"),
        heft::toSay("Move the tool through a larger space, to where the cable is taut and where it is slack."),
        heft::toSay("The difference goes with the place of the tool: the same spot, the same pull, at any speed.")}},
      {"constant_pull",
       {heft::toSay("Steady pull from outside"),
        heft::toSay("Is there a balancer, a hose or a weight that pulls in one direction?"),
        heft::toSay("Record once more with a heavier tool: a tilt grows with the weight, a pull does not."),
        heft::toSay("A difference that keeps its direction in the room, whatever the tool weighs.")}},
      {"viscous_drag",
       {heft::toSay("Resistance grows with speed"),
        heft::toSay("Does the tool drag hoses full of liquid, dampers, bellows or covers along?"),
        heft::toSay("Repeat one movement slowly, faster and fast."),
        heft::toSay("The difference follows the speed: none at rest, twice as much at twice the speed.")}},
      {"coulomb_friction",
       {heft::toSay("Something rubs"), heft::toSay("Does a cable rub in a clamp, a cover scrape, a sheath stiffen?"),
        heft::toSay("Repeat one movement at several speeds, and turn back after short and long ways."),
        heft::toSay("The difference jumps to the other side whenever the motion reverses, at any speed.")}},
      {"loose_mass",
       {heft::toSay("Something loose in the tool"),
        heft::toSay("Shake the tool by hand and listen: a loose part, a liquid, a hanging hose?"),
        heft::toSay("Move and stop abruptly a few times in different directions: what is loose rings on."),
        heft::toSay("After each stop the difference swings on for a while, a few times a second.")}},
      {"flexible_mount",
       {heft::toSay("Mount gives"),
        heft::toSay("Tighten the screws between arm, sensor and tool; look for rubber or thin adapters."),
        heft::toSay("Tap the tool with a finger while the arm holds still."),
        heft::toSay("A fine, fast ringing after every jerk, always at the same pitch.")}},
      {"payload_change",
       {heft::toSay("Load changed on the way"),
        heft::toSay("Was a part picked up or put down? Mark only the stretch that you mean."),
        heft::toSay("Turn the tool to another pose after the change: a load turns with gravity, a jump does not."),
        heft::toSay("From one moment on there is a difference that turns with the tool, as a weight does.")}},
      {"contact",
       {heft::toSay("The tool touched something"), heft::toSay("Was the tool set down, bumped, or held by its front?"),
        heft::toSay("Repeat the motion without touching anything."),
        heft::toSay("Short, large differences at a few moments; between them everything fits.")}},
      {"saturation",
       {heft::toSay("Sensor at its limit"), heft::toSay("Use a range that fits the load, and check the sensor's zero."),
        heft::toSay("Repeat the motion more slowly, or with a lighter tool."),
        heft::toSay("The measured curve is cut off flat at the top.")}},
      {"joint_offset",
       {heft::toSay("Joint angle off"),
        heft::toSay("Check that joint's calibration and the robot description of this recording."),
        heft::toSay("Visit poses in which the other joints stand very differently, elbow high and low."),
        heft::toSay("A difference that depends on the pose: a tilt that is not the same everywhere.")}},
      {"spikes",
       {heft::toSay("Spikes"), heft::toSay("Check the sensor's cable and plug, and what switches on nearby."),
        heft::toSay("Hold still for a few seconds: spikes come without motion."),
        heft::toSay("Single readings far off, with normal ones on both sides.")}},
      {"lever_arm",
       {heft::toSay("Sensor's place is wrong"),
        heft::toSay("Measure from the flange to the sensor's origin and compare with the meta file."),
        heft::toSay("Turn the tool fast to and fro about all three axes."),
        heft::toSay("Slow motion fits; fast turning leaves a difference that grows with the square of its speed.")}},
      {"derivative_noise",
       {heft::toSay("Accelerations off"),
        heft::toSay("Record joint angles at the full rate; check the size of gravity in the meta file."),
        heft::toSay("Record once more with stronger smoothing and compare."),
        heft::toSay("The fast parts of the motion are too large or too small in the simulation, the slow ones fit.")}},
      {"hysteresis",
       {heft::toSay("Sensor remembers its load"),
        heft::toSay("Was the sensor overloaded, glued or pinched? Check its screws."),
        heft::toSay("Load the sensor slowly up and down in one direction, in small and large steps."),
        heft::toSay("The difference lags behind the load itself: one value on the way up, another on the way down.")}},
      {"frame_error",
       {heft::toSay("Frames or signs mixed up"),
        heft::toSay("Compare the sensor's manual with the meta file: axes, signs, gravity."),
        heft::toSay("None is needed: the mistake is too large to be overlooked."),
        heft::toSay("Nothing fits: the simulated curves run against the measured ones.")}},
      {"dropouts",
       {heft::toSay("Readings lost or repeated"),
        heft::toSay("Check the connection, and record at the sensor's own rate."),
        heft::toSay("None is needed: the readings show it."),
        heft::toSay("The measured curve has flat steps or holes where it should run on.")}},
      {"jitter",
       {heft::toSay("Uneven time stamps"),
        heft::toSay("Let the sensor or the robot stamp the readings, not a busy computer."),
        heft::toSay("None is needed: the time stamps show it."),
        heft::toSay("In fast motion the measured curve trembles forth and back in time.")}},
      {"quantisation",
       {heft::toSay("Coarse readings"),
        heft::toSay("Choose a finer measuring range, or a file format with more digits."),
        heft::toSay("None is needed: the readings show it."),
        heft::toSay("The measured curve climbs in stairs where the simulated one is smooth.")}},
  };
  return kWords;
}

std::string said(std::string_view id, const char* Words::*member) {
  const auto it = words().find(id);
  return it == words().end() ? std::string() : heft::say(fmt::runtime(it->second.*member));
}

}  // namespace

std::string causeTitle(std::string_view id) {
  const std::string title = said(id, &Words::title);
  return title.empty() ? std::string(id) : title;
}
std::string causeCheck(std::string_view id) { return said(id, &Words::check); }
std::string causeDecides(std::string_view id) { return said(id, &Words::decides); }
std::string causeLooks(std::string_view id) { return said(id, &Words::looks); }

}  // namespace heft
