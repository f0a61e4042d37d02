#pragma once
// Which causes a model has, and what a fit tells of their amplitudes.
#include <algorithm>
#include <cstddef>
#include <functional>
#include <string_view>

#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/fit.h"

namespace heft::diagnosis {

inline std::string_view causeOf(const Term& term) { return term.form->cause->id(); }

/// A drift of any course, such as a walk's waves grow into.
inline bool takesAnyCourse(const Form& form) { return form.later && form.cause->id() == ids::biasDrift; }

/// Whether any term is one.
inline bool takesAnyCourse(const Model& model) {
  return std::ranges::any_of(model.terms, [](const Term& t) { return takesAnyCourse(*t.form); });
}

/// Whether any term is of that cause.
bool contains(const Model& model, std::string_view cause);
/// Terms of `cause` are one cause: this takes them all out.
Model without(const Model& model, std::string_view cause);

/// Causes in the model, but for a zero that walks.
std::ptrdiff_t causesIn(const Model& model);

/// Terms in the model that are a mass that swings.
std::ptrdiff_t massesIn(const Model& model);

/// How far amplitudes that a fit moves are from where their causes do nothing, and how well that is known beside
/// everything else.
struct Amplitudes {
  VectorXd sizes;
  MatrixXd covariance;

  double squaredDeviations() const;
};

/// Those of the terms that `which` is true of.
Amplitudes amplitudesOf(const Fit& fit, const std::function<bool(const Term&)>& which);

/// Squared deviations by which term `at` of the fit stands out, as far as its amplitudes are known beside everything
/// else.
double standsOut(const Fit& fit, std::size_t at);

}  // namespace heft::diagnosis
