// Causes that show in single readings or their stamps: they have no model, tests of samples find them (data_quality/).
// Clipping, lost velocities and coarse motion are forms of causes that have one.
#include <fmt/format.h>

#include "core/base/say.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft::diagnosis {
namespace {

/// Single readings far off.
class Spikes final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::spikes,
        .family = Family::dataQuality,
        .title = heft::toSay("Spikes in the readings"),
        .check = heft::toSay("Check the sensor's cable and plug, and what switches on nearby."),
        .decides = heft::toSay("Hold still for a few seconds: spikes come without motion."),
        .looks = heft::toSay("Single readings far off, with normal ones on both sides."),
        .effect = "spikes"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    return heft::say("{} readings are spikes; Heft replaced them by their neighbours.",
                     numberWords(v.value("count"), 0));
  }
};

/// Packets that were lost, repeated or handed out again.
class Dropouts final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::dropouts,
        .family = Family::dataQuality,
        .title = heft::toSay("Readings lost or repeated (dropouts)"),
        .check = heft::toSay("Check the connection, and record at the sensor's own rate."),
        .decides = heft::toSay("Not needed: the readings show it."),
        .looks = heft::toSay("The measured curve has flat steps or holes where it should run on."),
        .effect = "dropouts"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    if (v.value("zero") > 0.0)
      return heft::say("{} % of the readings are zero throughout: lost packets.", v.size("zero"));
    if (v.find("replayed") && v.value("replayed") > std::max(v.value("repeated"), v.value("missing")))
      return heft::say("{} % of the readings were delivered a second time in place of new ones.", v.size("replayed"));
    if (v.find("motion_repeated") && v.value("motion_repeated") > std::max(v.value("repeated"), v.value("missing")))
      return heft::say("{} % of the recorded positions repeat the previous one although the tool was moving.",
                       v.size("motion_repeated"));
    if (v.value("missing") > v.value("repeated"))
      return heft::say("{} % of the readings are missing.", v.size("missing"));
    return heft::say("{} % of the force readings repeat the previous one.", v.size("repeated"));
  }
};

/// Time stamps that come early and late.
class Jitter final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::jitter,
        .family = Family::dataQuality,
        .title = heft::toSay("Uneven time stamps (jitter)"),
        .check = heft::toSay("Let the sensor or the robot stamp the readings, not a busy computer."),
        .decides = heft::toSay("Not needed: the time stamps show it."),
        .looks = heft::toSay("In fast motion the measured curve jitters back and forth in time."),
        .effect = "jitter"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    return heft::say("The time stamps come up to {} ms early or late; Heft takes the rows as evenly spaced.",
                     numberWords(0.5 * v.value("spread"), 1));
  }
};

/// A converter or a file with too few digits.
class Quantisation final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::quantisation,
        .family = Family::dataQuality,
        .title = heft::toSay("Coarse readings (quantisation)"),
        .check = heft::toSay("Choose a finer measuring range, or a file format with more digits."),
        .decides = heft::toSay("Not needed: the readings show it."),
        .looks = heft::toSay("The measured curve rises in steps where the simulated one is smooth."),
        .effect = "quantisation"};
    return kInfo;
  }
  std::string sentence(const FoundValues& v) const override {
    return v.find("step_force")
               ? heft::say("The force readings come in steps of {}.", parameterWords(*v.find("step_force")))
           : v.find("step_torque")
               ? heft::say("The torque readings come in steps of {}.", parameterWords(*v.find("step_torque")))
               : std::string();
  }
};

/// Frames, signs or units mixed up: what core/conventions finds; its sentence comes from there.
class FrameError final : public Cause {
 public:
  const CauseInfo& info() const override {
    static constexpr CauseInfo kInfo{
        .id = ids::frameError,
        .family = Family::convention,
        .title = heft::toSay("Frames or signs mixed up"),
        .check = heft::toSay("Compare the sensor's manual with the setup file: axes, signs, gravity."),
        .decides = heft::toSay("Not needed: the error is obvious."),
        .looks = heft::toSay("Nothing fits: the simulated curves run opposite to the measured ones."),
        .effect = "frame_error"};
    return kInfo;
  }
};

}  // namespace

std::unique_ptr<Cause> makeSpikes() { return std::make_unique<Spikes>(); }
std::unique_ptr<Cause> makeDropouts() { return std::make_unique<Dropouts>(); }
std::unique_ptr<Cause> makeJitter() { return std::make_unique<Jitter>(); }
std::unique_ptr<Cause> makeQuantisation() { return std::make_unique<Quantisation>(); }
std::unique_ptr<Cause> makeFrameError() { return std::make_unique<FrameError>(); }

}  // namespace heft::diagnosis
