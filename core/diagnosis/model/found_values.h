#pragma once
// The parameters of a cause as they were found, for the sentences about it.
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/math/rigid.h"

namespace heft {

struct CauseParameter {
  std::string name, unit;
  double value = 0.0, std = 0.0;  ///< In `unit`
};

/// The one of that name, or null.
const CauseParameter* findParameter(const std::vector<CauseParameter>& parameters, std::string_view name);

/// "_2" of "delay_2", the delay of the second time that a cause was found; empty for the first.
std::string_view occurrenceOf(std::string_view name);
/// "force x" to "torque z"
std::string channelWords(int channel);
/// "2.60 ± 0.10 N/m", with half of the 95 % interval.
std::string parameterWords(const CauseParameter& parameter);

namespace diagnosis {

/// In the language of the program, with that many decimals.
std::string numberWords(double value, int decimals);
/// With half of the 95 % interval, as everywhere where a person reads a number, and as many decimals as that bears.
std::string plusMinus(double value, double deviation);

/// The channel (0 to 5) whose name, such as "fx", `name` begins with.
int channelOf(std::string_view name);

/// Symmetric, in the parameters' axes and unit: `what`, such as "stiffness" [N/m, B axes], alike to all sides, or along
/// each axis and, where it has them, across two. `ending`: what follows the parameters' names where a cause has several
/// terms.
Matrix3d tensorOf(std::string_view what, const std::vector<CauseParameter>& parameters, std::string_view ending = {});

/// Those of one occurrence: the parameters of the second end in _2, and so on.
struct FoundValues {
  const std::vector<CauseParameter>& parameters;
  const std::vector<std::pair<double, double>>& when;  ///< [s]; empty: throughout
  bool direct = false;                                 ///< Seen in the samples themselves
  std::string ending = {};

  /// Null where there is none of that name.
  const CauseParameter* find(std::string_view name) const;
  /// 0 where there is none.
  double value(std::string_view name) const;
  /// Its magnitude with its deviation.
  std::string size(std::string_view name) const;
  /// Length of up to three parameters with the largest of their deviations.
  std::string norm(std::initializer_list<std::string_view> names) const;
  /// The largest of several parameters.
  std::string most(std::initializer_list<std::string_view> names) const;
  /// Of a symmetric tensor, see tensorOf().
  double mostAlongAnyLine(std::string_view what) const;
  /// The one that stands out most from its deviation; null where there is none.
  const CauseParameter* strongest() const;
};

}  // namespace diagnosis
}  // namespace heft
