// Every cause of the catalogue: complete, silent at its start, and found again when it is in the data.
#include <gtest/gtest.h>

#include <set>

#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/model/linearisation.h"
#include "core/diagnosis/search/alternatives.h"
#include "core/diagnosis/search/scan.h"
#include "core/diagnosis/verdict/description.h"
#include "core/diagnosis/wording/words.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

using namespace diagnosis;

struct Prepared {
  Recording recording = aRecording(MotionKind::free, 3);
  Motion motion;
  Signals signals;
  Model model;
  Prepared() {
    MotionOptions options;
    options.cutoffHz = 25.0;
    motion = motionOf(recording, &RobotModel::panda(), options).value();
    signals = signalsOf(recording, motion, &RobotModel::panda());
    model.x.tail<10>() = toParameters(aTool());
  }
};

const Prepared& prepared() {
  static const Prepared kPrepared;
  return kPrepared;
}

TEST(Catalogue, HasWordsAndUniqueNames) {
  std::set<std::string> names;
  for (const auto& cause : catalogue()) {
    EXPECT_TRUE(names.insert(std::string(cause->id())).second) << cause->id();
    if (cause->id() != kRandomWalk) {  // never a verdict
      EXPECT_NE(causeTitle(cause->id()), cause->id());
      EXPECT_FALSE(causeCheck(cause->id()).empty() || causeDecides(cause->id()).empty() ||
                   causeLooks(cause->id()).empty())
          << cause->id();
    }
    for (const auto& other : cause->lookAlikes())
      EXPECT_TRUE(findCause(other) != nullptr || other == "contact") << cause->id() << " looks like " << other;
    EXPECT_FALSE(cause->forms(prepared().signals).empty()) << cause->id();
  }
  EXPECT_EQ(findCause("no_such_cause"), nullptr);
}

/// A weight that a driver takes off the readings acts as a pull straight up does, wherever up is.
TEST(Words, APullStraightUpMayBeAWeightTakenOffAlready) {
  DiagnosisReport report;
  DiagnosedCause pull;
  pull.id = "constant_pull";
  const auto asks = [&](double x, double y, double z) {
    pull.parameters = {{"force_x", "N", x, 0.01}, {"force_y", "N", y, 0.01}, {"force_z", "N", z, 0.01}};
    return causeCheck(pull, report) != causeCheck("constant_pull");
  };
  EXPECT_TRUE(asks(0.02, 0.0, 2.0));
  EXPECT_FALSE(asks(0.2, 0.0, 2.0));
  EXPECT_FALSE(asks(0.0, 0.0, -2.0));
  report.meta.gravity = {9.81, 0.0, 0.0};
  EXPECT_TRUE(asks(-2.0, 0.0, 0.02));
  EXPECT_FALSE(asks(0.0, 0.0, 2.0));
  pull.parameters.push_back({"time", "s", 4.0, 0.1});
  EXPECT_EQ(causeCheck(pull, report), causeCheck("constant_pull"));
}

/// What took two terms is said twice, each with its own numbers; what would be said in the same words, once.
TEST(Words, EachTermIsSaidOnce) {
  DiagnosedCause gains;
  gains.id = "gain_error";
  gains.parameters = {{"gain_fx", "%", 5.0, 0.1}, {"gain_ty_2", "%", -3.0, 0.1}};
  EXPECT_EQ(
      causeSentence(gains, {}),
      "The channel force x reads 5.0 \u00b1 0.2 % too much. The channel torque y reads 3.0 \u00b1 0.2 % too little.");
  gains.parameters[1] = {"gain_fx_2", "%", 5.0, 0.1};
  EXPECT_EQ(causeSentence(gains, {}), "The channel force x reads 5.0 \u00b1 0.2 % too much.");
  DiagnosedCause jump;
  jump.id = "sensor_bias";
  jump.parameters = {{"time", "s", 4.0, 0.01}, {"tx", "N m", 0.5, 0.01}};
  EXPECT_EQ(causeSentence(jump, {}), "At 4.0 s the sensor's zero jumped by 0.50 \u00b1 0.02 N m.");
}

/// What little a width takes at the corner of Heft's own smoothing is no cause; what takes a tremor is.
TEST(Catalogue, OwnSmoothingIsNoCause) {
  const Cause& cause = *findCause("derivative_noise");
  Signals signals = prepared().signals;
  for (const Form& form : cause.forms(signals)) {
    if (form.choice.empty()) continue;
    const auto over = [&](double width) {
      return cause.overOwnErrors(form, VectorXd::Constant(1, std::pow(width, form.name == "smoothed" ? 2.0 : 4.0)),
                                 signals);
    };
    signals.keptHz = 0.0;
    EXPECT_LT(over(0.004), 1.0) << form.name;
    EXPECT_GT(over(0.008), 1.0) << form.name;
    signals.keptHz = 10.0;
    EXPECT_LT(over(0.004), 1.0) << form.name;
    EXPECT_GT(over(0.012), 1.0) << form.name;
  }
}

/// Times that resampling may put a row off by, and loops of less than a thousandth, are no causes.
TEST(Catalogue, WhatResamplingMayLeaveIsNoCause) {
  const Signals& signals = prepared().signals;
  const auto over = [&](std::string_view cause, std::size_t form, std::vector<double> v) {
    const auto forms = findCause(cause)->forms(signals);
    return findCause(cause)->overOwnErrors(forms.at(form), Eigen::Map<const VectorXd>(v.data(), std::ssize(v)),
                                           signals);
  };
  for (const char* cause : {"time_offset", "low_pass_lag", "motion_lag"}) {
    EXPECT_LT(over(cause, 0, {1e-5}), 1.0) << cause;
    EXPECT_GT(over(cause, 0, {1e-4}), 3.5) << cause;
  }
  EXPECT_GT(over("time_offset", 1, {0.0, 1e-4}), 3.5) << "clocks that run apart";
  const auto loops = findCause("hysteresis")->forms(signals);
  const auto loop = std::ranges::find_if(loops, [](const Form& form) { return form.name == "loop"; });
  ASSERT_NE(loop, loops.end());
  EXPECT_LT(over("hysteresis", static_cast<std::size_t>(loop - loops.begin()), {0.0007, 0.002}), 1.0);
  EXPECT_GT(over("hysteresis", static_cast<std::size_t>(loop - loops.begin()), {0.005, 0.02}), 3.5);
}

TEST(Catalogue, EveryFormIsSilentAtItsStart) {
  const Wrenches plain = predicted(prepared().signals, prepared().model);
  for (const auto& cause : catalogue())
    for (const auto& form : cause->forms(prepared().signals)) {
      Model with = prepared().model;
      with.terms.push_back({std::make_shared<const Form>(form), form.start, {}});
      const double difference = (predicted(prepared().signals, with) - plain).cwiseAbs().maxCoeff();
      ASSERT_LT(difference, 1e-9) << cause->id() << " " << form.name;
      if (form.local) break;
    }
}

/// What saves work by doing several at once does what one at a time does.
TEST(Catalogue, SeveralSetsOfParametersAreEachAsAlone) {
  const Signals& signals = prepared().signals;
  const Wrenches load = payloadWrench(signals.kinematics, prepared().model.x.tail<10>());
  for (const auto& cause : catalogue())
    for (const Form& form : cause->forms(signals)) {
      // About a size away from where it does nothing, and from there a little along each parameter.
      std::vector<VectorXd> each(1, form.start);
      const auto move = [&](VectorXd& v, std::size_t p, double sizes) {
        const Parameter& parameter = form.parameters[p];
        double& value = v(static_cast<Eigen::Index>(p));
        value = std::clamp(value + sizes * parameter.size, parameter.lower, parameter.upper);
      };
      for (const int p : form.scan) move(each[0], static_cast<std::size_t>(p), 1.0);
      for (std::size_t p = 0; p < form.parameters.size(); ++p) {
        each.push_back(each[0]);
        move(each.back(), p, 0.1);
      }
      std::vector<Wrenches> added(each.size(), Wrenches::Zero(6, signals.size())), sensed(each.size(), load);
      cause->forces(form, each, signals, signals.kinematics, added);
      cause->sensors(form, each, signals, sensed);
      for (std::size_t i = 0; i < each.size(); ++i) {
        Wrenches force = Wrenches::Zero(6, signals.size()), reading = load;
        cause->force(form, each[i], signals, signals.kinematics, force);
        cause->sensor(form, each[i], signals, reading);
        EXPECT_LT((added[i] - force).cwiseAbs().maxCoeff(), 1e-9 * (1.0 + force.cwiseAbs().maxCoeff()))
            << cause->id() << " " << form.name << " " << i;
        EXPECT_LT((sensed[i] - reading).cwiseAbs().maxCoeff(), 1e-9 * (1.0 + reading.cwiseAbs().maxCoeff()))
            << cause->id() << " " << form.name << " " << i;
      }
    }
}

/// Signatures around a term that turns the motion are kept until it moves so that a first look would see it.
TEST(SignatureBank, IsWorkedOutAnewWhereTheModelHasMoved) {
  const Signals& signals = prepared().signals;
  SignatureBank bank(signals, {});
  // What swings from the start is told from the tool alone.
  const auto follows = [](const Form& form) {
    return form.cause->id() == "loose_mass" && !form.name.starts_with("swinging from the start");
  };
  Model model = prepared().model;
  const Form lag = findCause("motion_lag")->forms(signals).front();
  model.terms.push_back({std::make_shared<const Form>(lag), lag.start, {}});
  const auto at = [&](double sizes) {
    model.terms[0].v(0) = lag.start(0) + sizes * lag.parameters[0].size;
    return bank.around(signals, model, follows);
  };
  const auto first = at(1.0), near = at(1.05), far = at(3.0), back = at(1.0);
  ASSERT_FALSE(first.empty());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].columns, near[i].columns) << first[i].form.name;
    EXPECT_EQ(first[i].columns, back[i].columns) << first[i].form.name;
    const MatrixXd columns = first[i].columns->dense();
    EXPECT_GT((columns - far[i].columns->dense()).norm(), 1e-3 * columns.norm()) << first[i].form.name;
  }
}

TEST(SignatureBank, WorksOutAnewWhatItForgot) {
  const Signals& signals = prepared().signals;
  SignatureBank bank(signals, {});
  const auto cable = [](const Form& form) { return form.cause->id() == "cable_pull"; };
  const auto first = bank.around(signals, Model{}, cable);
  bank.forget();
  const auto second = bank.around(signals, Model{}, cable);
  ASSERT_FALSE(first.empty());
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_NE(first[i].columns, second[i].columns);
    EXPECT_EQ(first[i].columns->dense(), second[i].columns->dense());
  }
  EXPECT_TRUE(bank.knows("cable_pull"));
}

/// What is kept without its zeros, and of what passes only where it passes, are the columns of the whole recording.
TEST(SignatureBank, KeepsTheColumnsOfTheWholeRecording) {
  const Signals& signals = prepared().signals;
  const Model nothing;
  const LinearisationPoint bare(signals, nothing);
  SignatureBank bank(signals, {});
  std::set<std::string> passing;
  for (const Signature& signature : bank.around(signals, nothing)) {
    const MatrixXd whole = bare.signatures(signature.form).dense(), kept = signature.columns->dense();
    const Eigen::Index from = 6 * signature.reach.from, rows = kept.rows();
    ASSERT_LE(from + rows, whole.rows()) << signature.form.name;
    if (signature.form.local && !signature.form.atOnce) passing.insert(std::string(signature.form.cause->id()));
    const double most = whole.cwiseAbs().maxCoeff();
    EXPECT_LE((whole.middleRows(from, rows) - kept).cwiseAbs().maxCoeff(), 1e-9 * most) << signature.form.name;
    EXPECT_TRUE(whole.topRows(from).isZero(0.0) && whole.bottomRows(whole.rows() - from - rows).isZero(0.0))
        << signature.form.name;
    const VectorXd ones = VectorXd::Ones(kept.cols());
    EXPECT_LE((signature.columns->times(ones) - kept * ones).cwiseAbs().maxCoeff(), 1e-9 * most * ones.sum());
  }
  EXPECT_TRUE(passing.contains("contact"));
}

/// A form with sizes put into it by hand is estimated within its deviations: fit and model agree with each other.
TEST(Catalogue, WhatTheModelPutsInTheFitFindsAgain) {
  const auto& p = prepared();
  Signals signals = p.signals;
  for (Eigen::Index n = 0; n < signals.blocks(); ++n)
    signals.usable[static_cast<std::size_t>(n)] = n > 20 && n + 20 < signals.blocks();
  const auto stretches = stretchesOf(signals.usable);
  const Wrenches noise = p.signals.measured - valueOf(signals, p.model);
  for (const char* id : {"time_offset", "low_pass_lag", "gravity_tilt", "sensor_rotation", "cable_pull", "viscous_drag",
                         "lever_arm", "joint_offset", "constant_pull", "gain_error"}) {
    const auto forms = findCause(id)->forms(signals);
    const Form& form = forms.back();
    Model truth = p.model;
    VectorXd v = form.start;
    for (const int i : form.scan) v(i) += 4.0 * form.parameters[static_cast<std::size_t>(i)].size;
    truth.terms.push_back({std::make_shared<const Form>(form), v, {}});
    signals.measured = valueOf(signals, truth) + noise;
    Model start = p.model;
    start.terms.push_back({std::make_shared<const Form>(form), form.start, {}});
    for (const int i : form.scan) start.terms[0].v(i) += 0.5 * form.parameters[static_cast<std::size_t>(i)].size;
    const Fit fit = fitModel(signals, stretches, start, 20);
    const VectorXd std = fit.std();
    for (const int i : form.scan)
      EXPECT_NEAR(fit.model.terms[0].v(i), v(i), 4.5 * std(kLinear + i) + 1e-9)
          << id << " " << form.parameters[static_cast<std::size_t>(i)].name;
  }
}

TEST(Fit, PriceRisesWithCountAndGainAndIsNeverAboveBic) {
  constexpr double kLnN = 8.7;
  for (const double count : {1.0, 4.0, 8.0})
    for (const double gain : {0.0, 10.0, 100.0, 1e4, 1e8}) {
      const double price = complexityPenalty(gain, count, kLnN);
      EXPECT_LE(price, count * kLnN);
      EXPECT_LE(price, complexityPenalty(10.0 * gain, count, kLnN));
      EXPECT_LT(price, complexityPenalty(gain, count + 1.0, kLnN));
      EXPECT_GT(price, count) << "an idle parameter gains one on average";
    }
  EXPECT_DOUBLE_EQ(complexityPenalty(1e8, 4.0, kLnN), 4.0 * kLnN) << "plain to see: as BIC has it";
  EXPECT_EQ(complexityPenalty(100.0, 0.0, kLnN), 0.0);
}

/// A mass on a spring is heavy after a stop as before it, and carries its weight: over a slow motion nothing shows but
/// the sag, which moves the weight by g / w^2.
TEST(Catalogue, ASlowlyTurnedLooseMassOnlySags) {
  constexpr double kMass = 0.1, kHz = 8.0, kRate = 200.0;
  Signals signals;
  signals.rateHz = kRate;
  const Eigen::Index n = 4000;
  signals.kinematics.specificForce = Eigen::Matrix3Xd::Zero(3, n);
  signals.kinematics.omega = Eigen::Matrix3Xd::Zero(3, n);
  signals.kinematics.alpha = Eigen::Matrix3Xd::Zero(3, n);
  // Half a turn about y in 20 s, taken up slowly.
  for (Eigen::Index k = 0; k < n; ++k) {
    const double u = static_cast<double>(k) / static_cast<double>(n), T = static_cast<double>(n) / kRate;
    const double angle = EIGEN_PI * (u - std::sin(2.0 * EIGEN_PI * u) / (2.0 * EIGEN_PI));
    signals.kinematics.specificForce.col(k) = 9.81 * Vector3d(-std::sin(angle), 0.0, std::cos(angle));
    signals.kinematics.omega(1, k) = EIGEN_PI * (1.0 - std::cos(2.0 * EIGEN_PI * u)) / T;
    signals.kinematics.alpha(1, k) = EIGEN_PI * 2.0 * EIGEN_PI * std::sin(2.0 * EIGEN_PI * u) / (T * T);
  }
  const Cause* cause = findCause("loose_mass");
  for (const auto& form : cause->forms(signals)) {
    if (form.choice[0] != 2 && form.choice[0] != 3) continue;
    VectorXd v = form.start;
    v(0) = kMass;
    v(4) = kHz;
    Wrenches w = Wrenches::Zero(6, n);
    cause->force(form, v, signals, signals.kinematics, w);
    EXPECT_LT(w.topRows<3>().cwiseAbs().maxCoeff(), 0.02 * kMass * 9.81) << form.name;
    // All ways: along the weight, so without a moment. Along z only: the weight across times the sag along.
    const double sag = 9.81 / std::pow(2.0 * EIGEN_PI * kHz, 2);
    const double largest = form.choice[0] == 3 ? 0.0 : 0.5 * kMass * 9.81 * sag;
    EXPECT_NEAR(w.bottomRows<3>().cwiseAbs().maxCoeff(), largest, 0.05 * kMass * 9.81 * sag) << form.name;
  }
}

TEST(Scan, JacobianIsTheDerivative) {
  const auto& p = prepared();
  struct Case {
    std::vector<const char*> causes;
    bool payload;  ///< Whether bias and payload move, too: a sensor with a memory is linearised without it for these
  };
  for (const Case& c : {Case{{"cable_pull", "time_offset", "gravity_tilt"}, true},
                        Case{{"cable_pull", "bias_drift", "wandering"}, true},
                        Case{{"hysteresis", "cable_pull", "bias_drift", "wandering", "lever_arm"}, false}}) {
    Model model = p.model;
    for (const char* id : c.causes) {
      const Form form = findCause(id)->forms(p.signals).front();
      VectorXd v = form.start;
      for (Eigen::Index i = 0; i < v.size(); ++i) v(i) += form.parameters[static_cast<std::size_t>(i)].size;
      model.terms.push_back({std::make_shared<const Form>(form), v, {}});
    }
    const CachedJacobian columns(p.signals, model);
    VectorXd step = VectorXd::Zero(model.size());
    for (Eigen::Index i = c.payload ? 0 : kLinear; i < step.size(); ++i)
      step(i) = i < 6 ? 1e-3 : 1e-5 * (1.0 + static_cast<double>(i % 3));
    Model moved = model;
    moved.unpack(model.packed() + step);
    const Wrenches change = valueOf(p.signals, moved) - valueOf(p.signals, model);
    const VectorXd expected = columns.columns().times(step);
    EXPECT_LT((Eigen::Map<const VectorXd>(change.data(), change.size()) - expected).norm(), 2e-3 * expected.norm())
        << c.causes.front();
  }
}

/// Steps of a fit keep columns that hardly change; what is told of the fit in the end is of all of them.
TEST(CachedJacobian, FollowTheModel) {
  const auto& p = prepared();
  Model model = p.model;
  const auto add = [&](const char* id, double sizes) {
    const Form form = findCause(id)->forms(p.signals).front();
    VectorXd v = form.start;
    for (const int i : form.scan) v(i) += sizes * form.parameters[static_cast<std::size_t>(i)].size;
    model.terms.push_back({std::make_shared<const Form>(form), v, {}});
  };
  const auto farthest = [](const CachedJacobian& columns, const CachedJacobian& anew) {
    const MatrixXd all = anew.columns().dense(), off = columns.columns().dense() - all;
    double out = 0.0;
    for (Eigen::Index i = 0; i < off.cols(); ++i)
      if (all.col(i).norm() > 1e-9) out = std::max(out, off.col(i).norm() / all.col(i).norm());
    return out;
  };
  add("gravity_tilt", 1.0);
  add("cable_pull", 1.0);
  const CachedJacobian known(p.signals, model);
  // A term more: one that adds a force, one that bends the motion.
  add("loose_mass", 1.0);
  EXPECT_LT(farthest(CachedJacobian(known, model), CachedJacobian(p.signals, model)), 0.01);
  add("lever_arm", 1.0);
  CachedJacobian columns(known, model);
  EXPECT_LT(farthest(columns, CachedJacobian(p.signals, model)), 0.05);
  // All of them move, some far.
  model.terms[0].v *= 1.2;
  model.terms[1].v *= 3.0;
  model.terms[2].v(4) *= 1.3;
  model.x(6) *= 1.04;
  columns.follow(model);
  EXPECT_LT(farthest(columns, CachedJacobian(p.signals, model)), 0.3);
  columns.refresh(model);
  EXPECT_LT(farthest(columns, CachedJacobian(p.signals, model)), 0.02);
  // Of another model nothing is kept.
  model.terms.erase(model.terms.begin());
  EXPECT_LT(farthest(CachedJacobian(columns, model), CachedJacobian(p.signals, model)), 1e-12);
}

/// At first all ways of being late are one.
TEST(Catalogue, ALittleOfAnyFilterIsADelay) {
  const auto& p = prepared();
  const LinearisationPoint surroundings(p.signals, p.model);
  const auto column = [&](const Form& form) { return surroundings.signatures(form).dense(); };
  const MatrixXd late = column(findCause("time_offset")->forms(p.signals).front());
  for (const auto& form : findCause("low_pass_lag")->forms(p.signals)) {
    const MatrixXd filtered = column(form);
    EXPECT_GT(std::abs(late.col(0).dot(filtered.col(0))) / (late.norm() * filtered.norm()), 0.999) << form.name;
  }
}

/// Where a load of no mass becomes one, nothing jumps: the fit must be able to cross it.
TEST(Catalogue, ALoadMayChangeItsSign) {
  const auto& p = prepared();
  const Form form = findCause("payload_change")->forms(p.signals).front();
  const auto forceOf = [&](double mass) {
    VectorXd v = form.start;
    v.segment<4>(1) << mass, 2e-4, -3e-4, 4e-4;
    Wrenches w = Wrenches::Zero(6, p.signals.size());
    form.cause->force(form, v, p.signals, p.signals.kinematics, w);
    return w;
  };
  const double step = 1e-5, largest = forceOf(0.0).cwiseAbs().maxCoeff();
  for (double mass = -2e-3; mass < 2e-3; mass += step)
    ASSERT_LT((forceOf(mass + step) - forceOf(mass)).cwiseAbs().maxCoeff(), 0.05 * largest) << mass;
}

/// What explains as much elsewhere widens what is said of a parameter.
TEST(Described, ADeviationKnowsOfOtherAnswers) {
  const auto& p = prepared();
  Fit fit;
  fit.model = p.model;
  const Form form = findCause("time_offset")->forms(p.signals).front();
  fit.model.terms.push_back({std::make_shared<const Form>(form), VectorXd::Constant(1, 0.01), {}});
  fit.covariance = MatrixXd::Identity(kLinear + 1, kLinear + 1) * 1e-6;
  const auto std = [&](const VectorXd& spread) {
    DiagnosedCause cause;
    cause.id = "time_offset";
    describe(cause, fit, spread, p.signals, {});
    return cause.parameters.front().std;
  };
  EXPECT_NEAR(std({}), 1.0, 1e-9) << "ms";
  EXPECT_NEAR(std(VectorXd::Constant(1, 0.003)), std::sqrt(10.0), 1e-9);
}

/// A base that is tilted, or gives under the arm, pulls across gravity where the tool's weight does: no motion tells it
/// from a pull that is there by chance.
TEST(Alternatives, APullAcrossGravityAtTheCentreOfMassMayBeATilt) {
  const Recording recording = aRecording(MotionKind::free, 215);
  const Signals signals =
      signalsOf(recording, motionOf(recording, &RobotModel::panda(), {}).value(), &RobotModel::panda());
  const Vector3d com = aTool().com;
  const auto mayBe = [&](const char* cause, const Vector3d& force, const Vector3d& place) {
    const auto forms = findCause(cause)->forms(signals);
    const auto form = std::ranges::find(forms, "away from the sensor", &Form::name);
    Fit fit;
    fit.model.x(6) = aTool().mass;
    fit.model.x.segment<3>(7) = aTool().mass * com;
    VectorXd v = VectorXd::Ones(form->start.size());
    v.tail<6>() << force, place;
    fit.model.terms.push_back({std::make_shared<const Form>(*form), v, {}});
    Found found;
    found.cause = cause;
    return alternativesOf(found, fit, false, signals.gravity);
  };
  const std::vector<std::string> tilt{"gravity_tilt"};
  for (const char* cause : {"constant_pull", "cable_pull"}) {
    EXPECT_EQ(mayBe(cause, {0.3, -0.2, 0.01}, com), tilt) << cause;
    EXPECT_TRUE(mayBe(cause, {0.3, -0.2, 0.01}, com + Vector3d(0.0, 0.0, 0.02)).empty()) << cause;
  }
  EXPECT_EQ(mayBe("constant_pull", {0.0, 0.0, -0.3}, com), std::vector<std::string>{"derivative_noise"});
  // Across gravity and along it: the base may be tilted and gravity another than stated.
  EXPECT_EQ(mayBe("constant_pull", {0.3, -0.2, 0.1}, com),
            (std::vector<std::string>{"derivative_noise", "gravity_tilt"}));
  EXPECT_TRUE(mayBe("cable_pull", {0.3, -0.2, 0.1}, com).empty());
}

}  // namespace
}  // namespace heft::test
