#pragma once
// A tool's passport: its numbers on one day with all that speaks for and against them, and what changed since the
// passport before it.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/estimation/estimate.h"

namespace heft {

struct PassportCause {
  std::string id;        ///< As in files: "cable_pull"
  std::string sentence;  ///< With its size
  bool applied = false;  ///< It is taken out of the numbers.
};

/// What one passport states.
struct PassportContent {
  std::string tool;     ///< Its name; a passport is compared with others of the same name only.
  std::string date;     ///< ISO 8601, "2026-11-28"
  std::string program;  ///< "Heft Studio 0.2.0"
  bool lookedForCauses = false;
  std::vector<PassportCause> causes;
  std::vector<std::string> notSeen;  ///< What this motion could not have shown, a phrase each
  nlohmann::json proof;              ///< heft.prove/1 of these numbers, or null
};

/// heft.passport/1 of `estimate`, a heft.estimate/1 that is called `where` in messages: numbers in sensor axes. Fails
/// for other or incomplete files, for an estimate without trust and for a tool without a name.
Result<nlohmann::json> passportOf(const PassportContent& content, const nlohmann::json& estimate,
                                  const std::string& where);

/// One of a passport's ten numbers.
struct PassportNumber {
  std::string quantity;                    ///< "mass_kg", "com_x_m", "inertia_xx_kgm2" ...
  double value = 0, lower = 0, upper = 0;  ///< With the 95 % interval, SI; NaN where it has no end
  Source source = Source::none;
};
/// Of a passport of passportOf(): mass, centre, moments, products.
std::vector<PassportNumber> passportNumbers(const nlohmann::json& passport);

struct PassportChange {
  std::string date, file;  ///< Of the passport before
  struct Row {
    std::string quantity;  ///< "mass_kg", "com_x_m", "inertia_xx_kgm2" ...
    double before = 0, now = 0, difference = 0, std = 0;
    bool moreThanChance = false;
  };
  std::vector<Row> rows;                     ///< Ten; the mass alone where the mount is stated otherwise
  bool massCentre = false, inertia = false;  ///< Differ by more than the same tool shows once in 200 comparisons.
  bool otherMount = false;
  bool moreThanChance() const { return massCentre || inertia; }
};

/// Both are heft.passport/1; `where` names the first in messages. Fails for other files, and for other tools.
Result<PassportChange> changeSince(const nlohmann::json& before, const std::string& where, const nlohmann::json& now);
/// The member "since" of a passport.
nlohmann::json toJson(const PassportChange& change);

}  // namespace heft
