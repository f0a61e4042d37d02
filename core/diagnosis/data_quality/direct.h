#pragma once
// What single samples show of a cause, without any model.
#include <string>
#include <utility>
#include <vector>

namespace heft::diagnosis {

/// A cause that was seen directly rather than fitted.
struct Direct {
  std::string cause;
  struct Value {
    std::string name, unit;
    double value = 0.0, std = 0.0;  ///< In `unit`
  };
  std::vector<Value> parameters;
  std::vector<std::pair<double, double>> when;  ///< [s]; empty: throughout
  double pValue = 0.0;
  std::vector<std::string> alternatives;
  std::vector<bool> rows;     ///< Of the recording: not to be trusted; empty: all are fine.
  bool ofVelocities = false;  ///< Those that were reported are wrong; the positions are fine.
};

}  // namespace heft::diagnosis
