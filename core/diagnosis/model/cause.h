#pragma once
// A cause of misfit: its model, parameters with units and bounds, and what a person reads about it.
//
// Adding a cause is adding one file under causes/ with a class and a factory, and naming the factory in catalogue.cpp:
// causes/README.md.
//
// The measured wrench is modelled in its physical order (domain: what happens to the signal on its way):
//   motion -> geometry() -> rigid payload + force() -> sensor() -> readings() + bias.
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnosis/model/cause_info.h"
#include "core/diagnosis/signals/signals.h"

namespace heft::diagnosis {

struct Parameter {
  std::string name;                      ///< As reported, for instance "delay"
  std::string unit;                      ///< As reported, for instance "ms"; empty for pure numbers
  double scale = 1.0;                    ///< Reported value = scale * internal SI value
  double size = 1.0;                     ///< A realistic size (SI): sets steps of differentiation and of the search
  double lower = 0.0, upper = 0.0;       ///< What is physically believable (SI); at a bound the cause is not accepted.
  bool lowerIsFine = false;              ///< Unless it may well lie at its lower bound, such as how long a step takes.
  bool saysHowMuch = true;               ///< Of the cause there is
  double (*reported)(double) = nullptr;  ///< What is reported instead of scale * value, where that is no multiple of it
};

class Cause;
struct FoundValues;

/// One parametrisation of a cause: which parameters are free, where the search starts.
struct Form {
  const Cause* cause = nullptr;
  std::string name;  ///< Empty for the only form; otherwise what is special about it, for instance "second axis"
  std::vector<Parameter> parameters;
  VectorXd start;         ///< Parameters at which the wrench is unchanged (amplitudes zero).
  std::vector<int> scan;  ///< Those that the first look varies, linearly, from `start`.
  std::vector<int>
      choice;           ///< Fixed integers that tell forms apart, for instance an axis; meaning private to the cause
  bool subset = false;  ///< Only those of the scanned parameters that the data ask for are freed.
  bool local = false;   ///< Has a place in time, parameter 0 [s].
  bool atOnce = false;  ///< And changes there within a block or so.
  bool alone = false;   ///< Nothing else of its cause beside it: with two of them, almost anything could be made up
  bool rare = false;   ///< Takes no place of its cause's other forms when some are chosen for a fit: the most promising
                       ///< one is added.
  bool later = false;  ///< Never looked for first: begins where the fit of another form ended, see Cause::grown()
  bool guide = false;  ///< Linear in all, and only shows where the forms begin that it grows into: never named itself
  bool walk = false;   ///< Waves k = 1, 2, .. of six channels in turn, whose amplitudes fall with 1/k as a walk's do
};

class Cause {
 public:
  virtual ~Cause() = default;
  virtual const CauseInfo& info() const = 0;
  std::string_view id() const { return info().id; }
  /// The finding in one sentence, said now: one occurrence of it. Empty where the parameters do not tell.
  virtual std::string sentence(const FoundValues&) const { return {}; }
  /// What to look at on the rig, said now. `gravity`: g_B.
  virtual std::string check(const FoundValues&, const Vector3d& gravity) const;
  /// IDs of causes that leave much the same behind.
  virtual std::vector<std::string> lookAlikes() const { return {}; }
  /// Every form worth looking at with these signals; none if the recording cannot show the cause, or where it is only
  /// ever seen directly, in single samples.
  virtual std::vector<Form> forms(const Signals&) const { return {}; }

  /// Forms, also of other causes, that begin where the fit of one ended, with their first guess: such as lie too far
  /// from any of forms() to be found.
  virtual std::vector<std::pair<Form, VectorXd>> grown(const Form&, const VectorXd&, const Signals&) const {
    return {};
  }

  /// Place in the signal's way; lower comes first within a stage.
  virtual int order() const { return 0; }
  virtual void geometry(const Form&, const VectorXd&, const Signals&, Kinematics&) const {}
  /// Adds forces that act on the tool.
  virtual void force(const Form&, const VectorXd&, const Signals&, const Kinematics&, Wrenches&) const {}
  /// Whether force() depends on how the motion feels (s, omega, alpha), not on how S stands alone.
  virtual bool feelsMotion() const { return true; }
  /// force() of several sets of parameters, each added to its own wrench, for causes that save work so.
  virtual void forces(const Form& form, std::span<const VectorXd> each, const Signals& signals, const Kinematics& kin,
                      std::span<Wrenches> wrenches) const {
    for (std::size_t i = 0; i < each.size(); ++i) force(form, each[i], signals, kin, wrenches[i]);
  }
  /// Changes the wrench on its way through the sensor: a linear map unless linear() is false for the form.
  virtual void sensor(const Form&, const VectorXd&, const Signals&, Wrenches&) const {}
  /// sensor() of several sets of parameters, each on its own wrench, all of which are the same before: for causes that
  /// save work so.
  virtual void sensors(const Form& form, std::span<const VectorXd> each, const Signals& signals,
                       std::span<Wrenches> wrenches) const {
    for (std::size_t i = 0; i < each.size(); ++i) sensor(form, each[i], signals, wrenches[i]);
  }
  virtual bool linear(const Form&) const { return true; }
  /// Whether sensor() is one 6 x 6 matrix for all instants.
  virtual bool isMatrix(const Form&) const { return false; }
  /// Adds to the sensor's readings.
  virtual void readings(const Form&, const VectorXd&, const Signals&, Wrenches&) const {}
  virtual bool addsToReadings() const { return false; }
  virtual bool bendsGeometry() const { return false; }
  virtual bool changesSensor(const Form&) const { return false; }
  /// Evidence that it needs beyond what any cause needs, with these parameters on these signals.
  virtual double doubt(const Form&, const VectorXd&, const Signals&) const { return 0.0; }
  /// How much of it there is over what Heft's own smoothing and resampling of these signals may leave; where each term
  /// of a cause comes to less than 1, they are part of the model but nothing that somebody could mend.
  virtual double overOwnErrors(const Form&, const VectorXd&, const Signals&) const {
    return std::numeric_limits<double>::infinity();
  }
  /// How much of that is enough where much speaks for the cause.
  virtual double enoughIfPlain(const Form&) const { return 1.0; }
  /// Whether all of it may come of Heft's own bringing together of two clocks, see Signals::clockAlignmentStd.
  virtual bool mayBeAlignment(const Form&, const VectorXd&, const Signals&) const { return false; }
  /// False for parameters that no thing of its kind has, with their standard deviations.
  virtual bool possible(const Form&, const VectorXd&, const VectorXd&) const { return true; }
  /// False for parameters, with their standard deviations, that nobody would believe of a cause that is named in the
  /// end: something unknown passes for it.
  virtual bool plausible(const Form&, const VectorXd&, const VectorXd&) const { return true; }
  /// Standard deviations of its parameters that come of what the model leaves out, beside those of the fit; empty:
  /// none.
  virtual VectorXd modelStd(const Form&, const VectorXd&) const { return {}; }
  /// Stretches of time [s] in which it acts; empty: always.
  virtual std::vector<std::pair<double, double>> when(const Form&, const VectorXd&, const Signals&) const { return {}; }
};

}  // namespace heft::diagnosis
