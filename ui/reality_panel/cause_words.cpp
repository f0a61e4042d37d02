#include "ui/reality_panel/cause_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <map>

#include "ui/models/numbers.h"

namespace heft {
namespace {

struct Words {
  const char *title, *check, *decides, *looks;
};

const std::map<std::string, Words>& words() {
  static const std::map<std::string, Words> kWords{
      {"sensor_bias",
       {QT_TRANSLATE_NOOP("heft::Causes", "Sensor’s zero jumped"),
        QT_TRANSLATE_NOOP("heft::Causes", "was there a knock, a loose plug, or a program that zeroed the sensor while recording?"),
        QT_TRANSLATE_NOOP("heft::Causes", "Turn the tool to another pose after the jump and hold: a jump stays, a load turns with gravity."),
        QT_TRANSLATE_NOOP("heft::Causes", "The difference is flat, steps once, and is flat again, however the tool is held.")}},
      {"bias_drift",
       {QT_TRANSLATE_NOOP("heft::Causes", "Sensor drifts"), QT_TRANSLATE_NOOP("heft::Causes", "let the sensor warm up for half an hour, keep draughts off it, and zero it often."),
        QT_TRANSLATE_NOOP("heft::Causes", "Come back to the same pose three times: a drift reads differently each time."),
        QT_TRANSLATE_NOOP("heft::Causes", "The difference climbs or sinks slowly over the whole recording and ignores the motion.")}},
      {"time_offset",
       {QT_TRANSLATE_NOOP("heft::Causes", "Readings late"), QT_TRANSLATE_NOOP("heft::Causes", "do force and joint angles get their time from one clock, at the source?"),
        QT_TRANSLATE_NOOP("heft::Causes", "Shake the tool quickly for ten seconds, two to four times a second."),
        QT_TRANSLATE_NOOP("heft::Causes", "The difference is large where the force changes fast and zero where it rests, with the full height kept.")}},
      {"low_pass_lag",
       {QT_TRANSLATE_NOOP("heft::Causes", "Readings smoothed"), QT_TRANSLATE_NOOP("heft::Causes", "is a filter or averaging switched on in the sensor’s amplifier or driver?"),
        QT_TRANSLATE_NOOP("heft::Causes", "Shake the tool quickly for ten seconds: smoothing makes fast forces smaller, a delay does not."),
        QT_TRANSLATE_NOOP("heft::Causes", "Late like a delay, but peaks are also cut down, and the noise looks soft.")}},
      {"motion_lag",
       {QT_TRANSLATE_NOOP("heft::Causes", "Accelerations late"), QT_TRANSLATE_NOOP("heft::Causes", "record the plain joint angles at the full rate, without smoothing."),
        QT_TRANSLATE_NOOP("heft::Causes", "Turn the tool slowly through large angles: late readings show then too, late accelerations do not."),
        QT_TRANSLATE_NOOP("heft::Causes", "Slow turning fits well; only starts and stops leave a difference.")}},
      {"sensor_rotation",
       {QT_TRANSLATE_NOOP("heft::Causes", "Sensor mounted turned"), QT_TRANSLATE_NOOP("heft::Causes", "compare the arrows printed on the sensor with the mount in the meta file."),
        QT_TRANSLATE_NOOP("heft::Causes", "Turn the last joint by half a turn and hold, then tilt the tool."),
        QT_TRANSLATE_NOOP("heft::Causes", "The weight shows up on the wrong axis of the sensor, always the same one.")}},
      {"gravity_tilt",
       {QT_TRANSLATE_NOOP("heft::Causes", "Robot base tilted"), QT_TRANSLATE_NOOP("heft::Causes", "put a spirit level on the robot’s base, or state the true gravity in the meta file."),
        QT_TRANSLATE_NOOP("heft::Causes", "Record once more with a heavier tool: a tilt grows with the weight, a pull does not."),
        QT_TRANSLATE_NOOP("heft::Causes", "A difference that keeps its direction in the room and grows with the tool’s weight.")}},
      {"gain_error",
       {QT_TRANSLATE_NOOP("heft::Causes", "One channel reads wrong"), QT_TRANSLATE_NOOP("heft::Causes", "hang a known weight from each side of the sensor; check its calibration file."),
        QT_TRANSLATE_NOOP("heft::Causes", "Tilt the tool so that its weight lies on each axis in turn. Equal gains on all axes need a scale."),
        QT_TRANSLATE_NOOP("heft::Causes", "The difference on one channel is a small copy of that channel itself.")}},
      {"crosstalk",
       {QT_TRANSLATE_NOOP("heft::Causes", "One channel shows on another"), QT_TRANSLATE_NOOP("heft::Causes", "is the sensor’s own calibration matrix loaded (serial number)?"),
        QT_TRANSLATE_NOOP("heft::Causes", "Tilt the tool so that its weight lies on each axis of the sensor in turn."),
        QT_TRANSLATE_NOOP("heft::Causes", "The difference on one channel is a small copy of another channel.")}},
      {"cable_pull",
       {QT_TRANSLATE_NOOP("heft::Causes", "Cable or hose pulls"), QT_TRANSLATE_NOOP("heft::Causes", "does the cable or hose hang free of the wrist, with slack in every pose?"),
        QT_TRANSLATE_NOOP("heft::Causes", "Move the tool through a larger space, to where the cable is taut and where it is slack."),
        QT_TRANSLATE_NOOP("heft::Causes", "The difference goes with the place of the tool: the same spot, the same pull, at any speed.")}},
      {"constant_pull",
       {QT_TRANSLATE_NOOP("heft::Causes", "Steady pull from outside"), QT_TRANSLATE_NOOP("heft::Causes", "is there a balancer, a hose or a weight that pulls in one direction?"),
        QT_TRANSLATE_NOOP("heft::Causes", "Record once more with a heavier tool: a tilt grows with the weight, a pull does not."),
        QT_TRANSLATE_NOOP("heft::Causes", "A difference that keeps its direction in the room, whatever the tool weighs.")}},
      {"viscous_drag",
       {QT_TRANSLATE_NOOP("heft::Causes", "Resistance grows with speed"), QT_TRANSLATE_NOOP("heft::Causes", "does the tool drag hoses full of liquid, dampers, bellows or covers along?"),
        QT_TRANSLATE_NOOP("heft::Causes", "Repeat one movement slowly, faster and fast."),
        QT_TRANSLATE_NOOP("heft::Causes", "The difference follows the speed: none at rest, twice as much at twice the speed.")}},
      {"coulomb_friction",
       {QT_TRANSLATE_NOOP("heft::Causes", "Something rubs"), QT_TRANSLATE_NOOP("heft::Causes", "does a cable rub in a clamp, a cover scrape, a sheath stiffen?"),
        QT_TRANSLATE_NOOP("heft::Causes", "Repeat one movement at several speeds, and turn back after short and long ways."),
        QT_TRANSLATE_NOOP("heft::Causes", "The difference jumps to the other side whenever the motion reverses, at any speed.")}},
      {"loose_mass",
       {QT_TRANSLATE_NOOP("heft::Causes", "Something loose in the tool"), QT_TRANSLATE_NOOP("heft::Causes", "shake the tool by hand and listen: a loose part, a liquid, a hanging hose?"),
        QT_TRANSLATE_NOOP("heft::Causes", "Move and stop abruptly a few times in different directions: what is loose rings on."),
        QT_TRANSLATE_NOOP("heft::Causes", "After each stop the difference swings on for a while, a few times a second.")}},
      {"flexible_mount",
       {QT_TRANSLATE_NOOP("heft::Causes", "Mount gives"), QT_TRANSLATE_NOOP("heft::Causes", "tighten the screws between arm, sensor and tool; look for rubber or thin adapters."),
        QT_TRANSLATE_NOOP("heft::Causes", "Tap the tool with a finger while the arm holds still."),
        QT_TRANSLATE_NOOP("heft::Causes", "A fine, fast ringing after every jerk, always at the same pitch.")}},
      {"payload_change",
       {QT_TRANSLATE_NOOP("heft::Causes", "Load changed on the way"), QT_TRANSLATE_NOOP("heft::Causes", "was a part picked up or put down? Mark only the stretch that you mean."),
        QT_TRANSLATE_NOOP("heft::Causes", "Turn the tool to another pose after the change: a load turns with gravity, a jump does not."),
        QT_TRANSLATE_NOOP("heft::Causes", "From one moment on there is a difference that turns with the tool, as a weight does.")}},
      {"contact",
       {QT_TRANSLATE_NOOP("heft::Causes", "The tool touched something"), QT_TRANSLATE_NOOP("heft::Causes", "was the tool set down, bumped, or held by its front?"),
        QT_TRANSLATE_NOOP("heft::Causes", "Repeat the motion without touching anything."),
        QT_TRANSLATE_NOOP("heft::Causes", "Short, large differences at a few moments; between them everything fits.")}},
      {"saturation",
       {QT_TRANSLATE_NOOP("heft::Causes", "Sensor at its limit"), QT_TRANSLATE_NOOP("heft::Causes", "use a range that fits the load, and check the sensor’s zero."),
        QT_TRANSLATE_NOOP("heft::Causes", "Repeat the motion more slowly, or with a lighter tool."),
        QT_TRANSLATE_NOOP("heft::Causes", "The measured curve is cut off flat at the top.")}},
      {"joint_offset",
       {QT_TRANSLATE_NOOP("heft::Causes", "Joint angle off"), QT_TRANSLATE_NOOP("heft::Causes", "check that joint’s calibration and the robot description of this recording."),
        QT_TRANSLATE_NOOP("heft::Causes", "Visit poses in which the other joints stand very differently, elbow high and low."),
        QT_TRANSLATE_NOOP("heft::Causes", "A difference that depends on the pose: a tilt that is not the same everywhere.")}},
      {"spikes",
       {QT_TRANSLATE_NOOP("heft::Causes", "Spikes"), QT_TRANSLATE_NOOP("heft::Causes", "check the sensor’s cable and plug, and what switches on nearby."),
        QT_TRANSLATE_NOOP("heft::Causes", "Hold still for a few seconds: spikes come without motion."),
        QT_TRANSLATE_NOOP("heft::Causes", "Single readings far off, with normal ones on both sides.")}},
      {"lever_arm",
       {QT_TRANSLATE_NOOP("heft::Causes", "Sensor’s place is wrong"), QT_TRANSLATE_NOOP("heft::Causes", "measure from the flange to the sensor’s origin and compare with the meta file."),
        QT_TRANSLATE_NOOP("heft::Causes", "Turn the tool fast to and fro about all three axes."),
        QT_TRANSLATE_NOOP("heft::Causes", "Slow motion fits; fast turning leaves a difference that grows with the square of its speed.")}},
      {"derivative_noise",
       {QT_TRANSLATE_NOOP("heft::Causes", "Accelerations off"), QT_TRANSLATE_NOOP("heft::Causes", "record joint angles at the full rate; check the size of gravity in the meta file."),
        QT_TRANSLATE_NOOP("heft::Causes", "Record once more with stronger smoothing and compare."),
        QT_TRANSLATE_NOOP("heft::Causes", "The fast parts of the motion are too large or too small in the simulation, the slow ones fit.")}},
      {"hysteresis",
       {QT_TRANSLATE_NOOP("heft::Causes", "Sensor remembers its load"), QT_TRANSLATE_NOOP("heft::Causes", "was the sensor overloaded, glued or pinched? Check its screws."),
        QT_TRANSLATE_NOOP("heft::Causes", "Load the sensor slowly up and down in one direction, in small and large steps."),
        QT_TRANSLATE_NOOP("heft::Causes", "The difference lags behind the load itself: one value on the way up, another on the way down.")}},
      {"frame_error",
       {QT_TRANSLATE_NOOP("heft::Causes", "Frames or signs mixed up"), QT_TRANSLATE_NOOP("heft::Causes", "compare the sensor’s manual with the meta file: axes, signs, gravity."),
        QT_TRANSLATE_NOOP("heft::Causes", "None is needed: the mistake is too large to be overlooked."),
        QT_TRANSLATE_NOOP("heft::Causes", "Nothing fits: the simulated curves run against the measured ones.")}},
      {"dropouts",
       {QT_TRANSLATE_NOOP("heft::Causes", "Readings lost or repeated"), QT_TRANSLATE_NOOP("heft::Causes", "check the connection, and record at the sensor’s own rate."),
        QT_TRANSLATE_NOOP("heft::Causes", "None is needed: the readings show it."),
        QT_TRANSLATE_NOOP("heft::Causes", "The measured curve has flat steps or holes where it should run on.")}},
      {"jitter",
       {QT_TRANSLATE_NOOP("heft::Causes", "Uneven time stamps"), QT_TRANSLATE_NOOP("heft::Causes", "let the sensor or the robot stamp the readings, not a busy computer."),
        QT_TRANSLATE_NOOP("heft::Causes", "None is needed: the time stamps show it."),
        QT_TRANSLATE_NOOP("heft::Causes", "In fast motion the measured curve trembles forth and back in time.")}},
      {"quantisation",
       {QT_TRANSLATE_NOOP("heft::Causes", "Coarse readings"), QT_TRANSLATE_NOOP("heft::Causes", "choose a finer measuring range, or a file format with more digits."),
        QT_TRANSLATE_NOOP("heft::Causes", "None is needed: the readings show it."),
        QT_TRANSLATE_NOOP("heft::Causes", "The measured curve climbs in stairs where the simulated one is smooth.")}},
  };
  return kWords;
}

QString translated(const char* text) { return QCoreApplication::translate("heft::Causes", text); }

QString text(const std::string& id, const char* Words::* member) {
  const auto it = words().find(id);
  return it == words().end() ? QString() : translated(it->second.*member);
}

/// "2.6 ± 0.1"; `factor` for another unit.
QString plusMinusText(double value, double std, double factor = 1.0) {
  const double v = value * factor, s = std * std::abs(factor);
  if (!(s > 0.0)) return numberText(v, std::abs(v) >= 100 ? 0 : std::abs(v) >= 1 ? 1 : 2);
  const int decimals = decimalsFor(s, 4);
  return numberText(v, decimals) + QStringLiteral(" ± ") + numberText(s, decimals);
}

struct Values {
  const DiagnosedCause& cause;
  const CauseParameter* find(std::string_view name) const {
    const auto it = std::find_if(cause.parameters.begin(), cause.parameters.end(),
                                 [&](const CauseParameter& p) { return p.name == name; });
    return it == cause.parameters.end() ? nullptr : &*it;
  }
  double value(std::string_view name) const {
    const auto* p = find(name);
    return p ? p->value : 0.0;
  }
  QString size(std::string_view name) const {
    const auto* p = find(name);
    return p ? plusMinusText(std::abs(p->value), p->std) : QStringLiteral("0");
  }
  /// Length of up to three parameters with the largest of their deviations.
  QString norm(std::initializer_list<std::string_view> names) const {
    double sum = 0.0, std = 0.0;
    for (const auto name : names)
      if (const auto* p = find(name)) {
        sum += p->value * p->value;
        std = std::max(std, p->std);
      }
    return plusMinusText(std::sqrt(sum), std);
  }
  /// The one that stands out most from its deviation.
  const CauseParameter* strongest() const {
    const CauseParameter* best = nullptr;
    double most = -1.0;
    for (const auto& p : cause.parameters) {
      if (p.name.starts_with("time")) continue;
      const double z = p.std > 0.0 ? std::abs(p.value) / p.std : 0.0;
      if (z > most) {
        most = z;
        best = &p;
      }
    }
    return best;
  }
};

int channelOf(std::string_view name) {
  constexpr std::array<std::string_view, 6> kNames{"fx", "fy", "fz", "tx", "ty", "tz"};
  for (std::size_t c = 0; c < kNames.size(); ++c)
    if (name.starts_with(kNames[c])) return static_cast<int>(c);
  return 0;
}

QString zeroSentence(const Values& v) {
  const CauseParameter* p = v.strongest();
  if (!p) return {};
  const QString channel = channelText(channelOf(p->name));
  if (p->unit.ends_with("/s"))
    return QCoreApplication::translate("heft::Causes", "The sensor’s zero drifts: %1 by %2 %3 per second.")
        .arg(channel, plusMinusText(p->value, p->std), QString::fromStdString(p->unit).chopped(2));
  return QCoreApplication::translate("heft::Causes", "The sensor’s zero creeps: %1 by %2 %3 before it settles.")
      .arg(channel, plusMinusText(p->value, p->std), QString::fromStdString(p->unit));
}

QString frameSentence(const DiagnosisReport& report, const DiagnosedCause& cause) {
  using Kind = diagnosis::FrameMistake::Kind;
  switch (report.mistake ? report.mistake->kind : Kind::none) {
    case Kind::wrenchSign:
      return QCoreApplication::translate("heft::Causes", "Forces have the opposite sign: the file holds what the tool does to the sensor.");
    case Kind::gravitySign:
      return QCoreApplication::translate("heft::Causes", "Gravity points up in the meta file; it should point down.");
    case Kind::transposed:
      return QCoreApplication::translate("heft::Causes", "Orientations are stored the other way round: base in sensor instead of sensor in base.");
    case Kind::turned:
      return QCoreApplication::translate("heft::Causes", "The sensor is mounted turned by %1° against the meta file.")
          .arg(numberText(report.mistake->angle * 180.0 / M_PI, 0));
    case Kind::mirrored:
      return QCoreApplication::translate("heft::Causes", "The force’s axes are mirrored: two are swapped, or one has the wrong sign.");
    case Kind::none:
      break;
  }
  return QString::fromStdString(cause.sentence);
}

QString dropoutSentence(const Values& v) {
  if (v.value("zero") > 0.0) return QCoreApplication::translate("heft::Causes", "%1 % of the readings are zero throughout: lost packets.").arg(v.size("zero"));
  if (v.value("missing") > v.value("repeated")) return QCoreApplication::translate("heft::Causes", "%1 % of the readings are missing.").arg(v.size("missing"));
  return QCoreApplication::translate("heft::Causes", "%1 % of the force readings repeat the one before.").arg(v.size("repeated"));
}

}  // namespace

QString causeTitle(const std::string& id) {
  const QString title = text(id, &Words::title);
  return title.isEmpty() ? QString::fromStdString(id) : title;
}
QString causeCheck(const std::string& id) { return text(id, &Words::check); }
QString causeDecides(const std::string& id) { return text(id, &Words::decides); }
QString causeLooks(const std::string& id) { return text(id, &Words::looks); }

std::string causeMotion(const std::string& id) {
  static const std::map<std::string, std::string> kMotions{
      {"sensor_bias", "tilt-sideways"},     {"payload_change", "tilt-sideways"}, {"hysteresis", "tilt-sideways"},
      {"bias_drift", "tilt-round"},         {"gain_error", "tilt-round"},        {"crosstalk", "tilt-round"},
      {"time_offset", "shake-sideways"},    {"low_pass_lag", "shake-sideways"},  {"motion_lag", "turn-slowly"},
      {"sensor_rotation", "tilt-forwards"}, {"viscous_drag", "swing-sideways"},  {"coulomb_friction", "swing-sideways"},
      {"loose_mass", "shake-forwards"},     {"lever_arm", "wobble"}};
  const auto it = kMotions.find(id);
  return it == kMotions.end() ? std::string() : it->second;
}

QString channelText(int channel) {
  const QString axis(QChar('x' + channel % 3));
  return channel < 3 ? QCoreApplication::translate("heft::Causes", "force %1").arg(axis) : QCoreApplication::translate("heft::Causes", "torque %1").arg(axis);
}

QString parameterText(const CauseParameter& p) {
  return QStringLiteral("%1 %2").arg(plusMinusText(p.value, p.std), QString::fromStdString(p.unit)).trimmed();
}

QString causeSentence(const DiagnosedCause& cause, const DiagnosisReport& report) {
  const Values v{cause};
  const std::string& id = cause.id;
  if (id == "sensor_bias")
    return QCoreApplication::translate("heft::Causes", "At %1 s the sensor’s zero jumped by %2 N.").arg(numberText(v.value("time"), 1), v.norm({"fx", "fy", "fz"}));
  if (id == "bias_drift") return zeroSentence(v);
  if (id == "time_offset")
    return v.value("delay") > 0.0 ? QCoreApplication::translate("heft::Causes", "The force readings arrive %1 ms late.").arg(v.size("delay"))
                                  : QCoreApplication::translate("heft::Causes", "The force readings arrive %1 ms before the motion.").arg(v.size("delay"));
  if (id == "low_pass_lag") return QCoreApplication::translate("heft::Causes", "The force readings are smoothed over %1 ms.").arg(v.size("time_constant"));
  if (id == "motion_lag")
    return cause.direct ? QCoreApplication::translate("heft::Causes", "The reported joint velocities come %1 ms late; Heft can use the angles instead.").arg(v.size("lag"))
                        : QCoreApplication::translate("heft::Causes", "Accelerations come %1 ms late; the angles do not.").arg(v.size("lag"));
  if (id == "frame_error" || (id == "sensor_rotation" && cause.direct)) return frameSentence(report, cause);
  if (id == "sensor_rotation") return QCoreApplication::translate("heft::Causes", "The sensor sits turned by %1°.").arg(v.norm({"rx", "ry", "rz"}));
  if (id == "gravity_tilt") return QCoreApplication::translate("heft::Causes", "The robot’s base is tilted by %1° against the stated gravity.").arg(v.norm({"tilt_x", "tilt_y"}));
  if (id == "gain_error" && v.strongest()) {
    const CauseParameter* p = v.strongest();
    const QString channel = channelText(channelOf(std::string_view(p->name).substr(5)));
    return p->value > 0.0 ? QCoreApplication::translate("heft::Causes", "The channel %1 reads %2 % too much.").arg(channel, plusMinusText(p->value, p->std))
                          : QCoreApplication::translate("heft::Causes", "The channel %1 reads %2 % too little.").arg(channel, plusMinusText(-p->value, p->std));
  }
  if (id == "crosstalk" && v.strongest()) {
    const CauseParameter* p = v.strongest();
    const auto to = p->name.find("_to_");
    return QCoreApplication::translate("heft::Causes", "%1 of %2 shows up in %3.")
        .arg(parameterText(*p), channelText(channelOf(p->name)),
             channelText(to == std::string::npos ? 0 : channelOf(std::string_view(p->name).substr(to + 4))));
  }
  if (id == "cable_pull") {
    if (v.find("twist_stiffness")) return QCoreApplication::translate("heft::Causes", "A cable twists back as the tool turns: %1 N m per radian.").arg(v.size("twist_stiffness"));
    if (v.find("stiffness")) return QCoreApplication::translate("heft::Causes", "A cable or hose pulls the tool towards one spot: %1 N per metre.").arg(v.size("stiffness"));
    const CauseParameter* p = v.strongest();
    double most = 0.0;
    for (const char* name : {"stiffness_x", "stiffness_y", "stiffness_z"}) most = std::max(most, std::abs(v.value(name)));
    if (p) return QCoreApplication::translate("heft::Causes", "A cable or hose pulls the tool back, by up to %1 N per metre.").arg(numberText(most, 1));
  }
  if (id == "constant_pull")
    return QCoreApplication::translate("heft::Causes", "Something pulls at the tool with %1 N, always in the same direction.").arg(v.norm({"force_x", "force_y", "force_z"}));
  if (id == "viscous_drag") {
    if (v.find("drag")) return QCoreApplication::translate("heft::Causes", "Something holds the tool back: %1 N per metre per second.").arg(v.size("drag"));
    if (v.find("turning_drag")) return QCoreApplication::translate("heft::Causes", "Something resists turning: %1 N m per radian per second.").arg(v.size("turning_drag"));
    return QCoreApplication::translate("heft::Causes", "Something holds the tool back: %1 N per metre per second.").arg(v.norm({"drag_x", "drag_y", "drag_z"}));
  }
  if (id == "coulomb_friction")
    return v.find("friction") ? QCoreApplication::translate("heft::Causes", "Something rubs and holds the tool back with %1 N.").arg(v.size("friction"))
                              : QCoreApplication::translate("heft::Causes", "Something rubs and resists turning with %1 N m.").arg(v.size("turning_friction"));
  if (id == "loose_mass")
    return QCoreApplication::translate("heft::Causes", "About %1 g in the tool are loose and swing %2 times a second.").arg(v.size("mass"), numberText(v.value("frequency"), 1));
  if (id == "flexible_mount") return QCoreApplication::translate("heft::Causes", "The tool’s mount gives and rings at %1 Hz.").arg(numberText(v.value("frequency"), 0));
  if (id == "payload_change")
    return v.value("mass") > 0.0 ? QCoreApplication::translate("heft::Causes", "At %1 s the load became %2 g heavier.").arg(numberText(v.value("time"), 1), v.size("mass"))
                                 : QCoreApplication::translate("heft::Causes", "At %1 s the load became %2 g lighter.").arg(numberText(v.value("time"), 1), v.size("mass"));
  if (id == "contact")
    return cause.when.size() == 1
               ? QCoreApplication::translate("heft::Causes", "The tool touched something from %1 to %2 s, with up to %3 N.")
                     .arg(numberText(cause.when[0].first, 1), numberText(cause.when[0].second, 1), numberText(v.value("peak_force"), 1))
               : QCoreApplication::translate("heft::Causes", "The tool touched something %1 times, with up to %2 N.").arg(cause.when.size()).arg(numberText(v.value("peak_force"), 1));
  if (id == "saturation") return QCoreApplication::translate("heft::Causes", "The sensor reached the end of its range in %1 % of the readings.").arg(v.size("share"));
  if (id == "joint_offset" && v.strongest()) {
    const CauseParameter* p = v.strongest();
    return QCoreApplication::translate("heft::Causes", "Joint %1 is really %2° away from what was recorded.")
        .arg(QString::fromStdString(p->name).mid(1, 1), plusMinusText(std::abs(p->value), p->std));
  }
  if (id == "spikes") return QCoreApplication::translate("heft::Causes", "%1 readings are isolated spikes; Heft replaced them by their neighbours.").arg(numberText(v.value("count"), 0));
  if (id == "lever_arm") return QCoreApplication::translate("heft::Causes", "The sensor’s origin sits %1 mm away from where the meta file puts it.").arg(v.norm({"dx", "dy", "dz"}));
  if (id == "derivative_noise") {
    if (cause.direct) return QCoreApplication::translate("heft::Causes", "The reported joint velocities are %1 % off; Heft can use the angles instead.").arg(v.size("loss"));
    return QCoreApplication::translate("heft::Causes", "The forces of acceleration are %1 % off what the motion says.").arg(v.size("loss"));
  }
  if (id == "hysteresis" && v.strongest())
    return QCoreApplication::translate("heft::Causes", "The sensor remembers %1 of its load: it reads differently going up and coming down.").arg(parameterText(*v.strongest()));
  if (id == "dropouts") return dropoutSentence(v);
  if (id == "jitter")
    return QCoreApplication::translate("heft::Causes", "The time stamps come up to %1 ms early or late; Heft takes the rows as evenly spaced.")
        .arg(numberText(0.5 * v.value("spread"), 1));
  if (id == "quantisation")
    return v.find("step_force") ? QCoreApplication::translate("heft::Causes", "The force readings come in steps of %1.").arg(parameterText(*v.find("step_force")))
                                : QCoreApplication::translate("heft::Causes", "The torque readings come in steps of %1.").arg(parameterText(*v.find("step_torque")));
  return QString::fromStdString(cause.sentence);
}

QString goesWithText(const std::string& goesWith) {
  const std::pair<const char*, const char*> known[] = {
      {"where the tool is", QT_TRANSLATE_NOOP("heft::Causes", "where the tool is")},
      {"how fast the tool moves", QT_TRANSLATE_NOOP("heft::Causes", "how fast the tool moves")},
      {"the direction in which the tool moves", QT_TRANSLATE_NOOP("heft::Causes", "the direction in which the tool moves")},
      {"the joint angles", QT_TRANSLATE_NOOP("heft::Causes", "the joint angles")},
      {"the joint angles, several times a turn", QT_TRANSLATE_NOOP("heft::Causes", "the joint angles, several times a turn")},
      {"the direction in which joints turn", QT_TRANSLATE_NOOP("heft::Causes", "the direction in which joints turn")},
      {"the load on the sensor", QT_TRANSLATE_NOOP("heft::Causes", "the load on the sensor")},
      {"the load's size", QT_TRANSLATE_NOOP("heft::Causes", "the load’s size")},
      {"how fast the load changes", QT_TRANSLATE_NOOP("heft::Causes", "how fast the load changes")},
      {"how fast the tool turns", QT_TRANSLATE_NOOP("heft::Causes", "how fast the tool turns")},
      {"the direction in which the tool turns", QT_TRANSLATE_NOOP("heft::Causes", "the direction in which the tool turns")},
      {"how fast the turning changes", QT_TRANSLATE_NOOP("heft::Causes", "how fast the turning changes")},
      {"a slow wave in time", QT_TRANSLATE_NOOP("heft::Causes", "a slow wave in time")}};
  for (const auto& [english, shown] : known)
    if (goesWith == english) return translated(shown);
  const QString rhythm = QString::fromStdString(goesWith);
  if (rhythm.startsWith("a rhythm of ")) return QCoreApplication::translate("heft::Causes", "a rhythm of %1").arg(rhythm.mid(12));
  return rhythm;
}

QStringList couldNotBeSeen(const DiagnosisReport& report, int most) {
  QStringList out;
  const auto add = [&](const char* id, const char* shown) {
    for (const Smallest& s : report.smallest) {
      if (s.cause != id || out.size() >= most || !std::isfinite(s.value) || !(s.value > 0.0)) continue;
      const int decimals = std::clamp(static_cast<int>(std::ceil(1.0 - std::log10(s.value) - 1e-9)), 0, 5);
      out << translated(shown).arg(numberText(s.value, decimals) + (s.unit == "deg" ? QStringLiteral("°") : QStringLiteral(" ") + QString::fromStdString(s.unit)));
    }
  };
  add("payload_change", QT_TRANSLATE_NOOP("heft::Causes", "load changes under %1"));
  add("cable_pull", QT_TRANSLATE_NOOP("heft::Causes", "cables softer than %1"));
  add("time_offset", QT_TRANSLATE_NOOP("heft::Causes", "delays under %1"));
  add("gravity_tilt", QT_TRANSLATE_NOOP("heft::Causes", "tilts under %1"));
  add("bias_drift", QT_TRANSLATE_NOOP("heft::Causes", "drifts under %1"));
  add("loose_mass", QT_TRANSLATE_NOOP("heft::Causes", "loose parts under %1"));
  add("sensor_rotation", QT_TRANSLATE_NOOP("heft::Causes", "a sensor turned by less than %1"));
  add("low_pass_lag", QT_TRANSLATE_NOOP("heft::Causes", "smoothing under %1"));
  add("gain_error", QT_TRANSLATE_NOOP("heft::Causes", "wrong gains under %1"));
  add("joint_offset", QT_TRANSLATE_NOOP("heft::Causes", "joint angles off by less than %1"));
  add("constant_pull", QT_TRANSLATE_NOOP("heft::Causes", "steady pulls under %1"));
  add("lever_arm", QT_TRANSLATE_NOOP("heft::Causes", "a sensor misplaced by less than %1"));
  return out;
}

}  // namespace heft
