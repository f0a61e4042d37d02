#pragma once
// A cable's stiffness as its parameters tell it.
#include <string>

#include "core/diagnosis/diagnose.h"

namespace heft {

/// Symmetric, B axes [N/m]: alike to all sides, or along each axis and, where it has them, across two. `find`: the parameter of a
/// name, as of CauseParameter::name, or null.
template <class Find>
Matrix3d stiffnessFrom(const Find& find) {
  const auto valueOf = [&](const std::string& name) {
    const CauseParameter* parameter = find(name);
    return parameter ? parameter->value : 0.0;
  };
  Matrix3d out = valueOf("stiffness") * Matrix3d::Identity();
  for (int i = 0; i < 3; ++i) {
    out(i, i) += valueOf(std::string("stiffness_") + "xyz"[i]);
    for (int j = 0; j < i; ++j) out(i, j) = out(j, i) = valueOf(std::string("stiffness_") + "xyz"[j] + "xyz"[i]);
  }
  return out;
}

}  // namespace heft
