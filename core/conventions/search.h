#pragma once
// The hypotheses about what a file's numbers mean, fitted and judged; check.cpp decides among them.
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/conventions/check.h"
#include "core/conventions/fit.h"
#include "core/payload/inertial_parameters.h"

namespace heft::conventions {

/// Of people with a wrong convention one in a hundred has a second one: 2 ln 100 for each.
inline const double kPriceOfChange = 2.0 * std::log(100.0);
/// In standing poses gravity the other way is the other sign of all readings, exactly. Drivers with the weight's sign
/// are many, robots that hang and whose setup file does not say so are few.
inline const double kPriceOfHanging = 2.0 * std::log(10.0);
/// A smaller turn of mount or gravity is a cause with an interval, no convention [rad].
constexpr double kLeastTurn = 15.0 * std::numbers::pi / 180.0;
/// No tool's centre of mass is farther from the sensor [m]; most are between the other two.
constexpr double kReach = 1.0, kUsualReach = 0.15, kUsualLeast = 0.01;
/// A centre so far behind the sensor lies in the arm [m].
constexpr double kBehind = 0.01;

/// A way to understand the file, and what it is fitted to.
struct Candidate {
  Way way;
  std::size_t form = 0;  ///< Of the poses
  Free free = Free::nothing;
  Fit fit;
  Reading reading;
  std::vector<Change> differs;
  Payload payload;
  Misfit misfit;
  double reach = 0.0;  ///< outOfReach() of it
  double prior = 0.0;  ///< Price of a centre where centres seldom are; standing poses only
  double score = 0.0;  ///< 2 ln L less prices, and less what speaks against the payload
};

/// What changes cost, as evidence.
double priceOf(const std::vector<Change>& changes);

/// Poses understood in one way.
struct PoseForm {
  Reading reading;  ///< Pose direction and quaternion order are meant; the rest as stated
  Blocks blocks;
};

bool operator==(const Way& a, const Way& b);

/// Works on one question.
class Check {
 public:
  explicit Check(const Question& q) : q_(q), standing_(q.kind == RecordingKind::poses) {
    file_ = asInFile(*q.motion, q.stated.conventions);
    forms_.push_back({q.stated, blocksOf(*q.motion, file_, q.use, standing_)});
    forms_.front().blocks.silent = q.silent;
    place_.gravity = q.stated.gravity;
  }

  Report run();

 private:
  Way statedWay() const {
    Way way;
    way.axes = kStated;
    way.forceSi = q_.stated.conventions.force.si;
    way.torqueSi = q_.stated.conventions.torque.si;
    return way;
  }
  /// The same from the file's numbers; nothing where torques are about a point of their own.
  std::optional<Way> statedFromFile() const;
  Reading readingOf(const Candidate& candidate) const;
  /// Fits `way` robustly and judges it.
  Candidate candidate(const Way& way, std::size_t form, Free free, const Place& start) const;
  std::size_t changesOf(const Way& way, std::size_t form) const;
  /// Units of force and torque, SI in one of them.
  std::vector<std::pair<double, double>> units() const;
  std::vector<Way> ways(std::size_t form) const;
  void addForms();
  /// The `most` ways that fit best by least squares join `into`, unless they are in it: with gravity as stated, or
  /// along any axis of the base.
  void scanAll(const VectorXd& weights, bool anyGravity, std::size_t most, std::vector<Candidate>& into) const;
  void addTurned(const VectorXd& weights, std::vector<Candidate>& into) const;
  /// What may be wrong with the stated conventions and is none: small turns, a sensor beside its place.
  void addCauses(std::vector<Candidate>& into) const;
  /// `like` with every unit and sign of the torque: standing poses tell the centre's scale by nothing else.
  void addOtherScales(const Candidate& like, std::vector<Candidate>& into) const;
  bool same(const Candidate& a, const Candidate& b) const;
  void decide(const Candidate& stated, std::vector<Candidate>& all, Report& report) const;

  const Question& q_;
  bool standing_;
  MatrixXd file_;
  Place place_;  ///< As stated
  std::vector<PoseForm> forms_;
};

/// Best first.
inline bool byScore(const Candidate& a, const Candidate& b) { return a.score > b.score; }

/// Cautions, sentence and what to look at, from everything else in `report`.
void putIntoWords(const Question& question, Report& report);

}  // namespace heft::conventions
