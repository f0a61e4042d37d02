#include "core/diagnosis/search/model_terms.h"

#include <iterator>
#include <set>
#include <vector>

#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

Model without(const Model& model, std::string_view cause) {
  Model out = model;
  std::erase_if(out.terms, [&](const Term& t) { return causeOf(t) == cause; });
  return out;
}

bool contains(const Model& model, std::string_view cause) {
  return std::any_of(model.terms.begin(), model.terms.end(), [&](const Term& t) { return causeOf(t) == cause; });
}

std::ptrdiff_t causesIn(const Model& model) {
  std::set<std::string_view> causes;
  for (const Term& term : model.terms)
    if (!term.form->walk) causes.insert(causeOf(term));
  return std::ssize(causes);
}

std::ptrdiff_t massesIn(const Model& model) {
  return std::ranges::count_if(model.terms, [](const Term& t) { return causeOf(t) == ids::looseMass; });
}

double Amplitudes::squaredDeviations() const {
  return sizes.size() == 0 ? 0.0 : sizes.dot(solveSymmetric(covariance, sizes));
}

Amplitudes amplitudesOf(const Fit& fit, const std::function<bool(const Term&)>& which) {
  std::vector<Eigen::Index> own;
  std::vector<double> sizes;
  for (const auto& [term, at] : indexedTerms(fit.model)) {
    if (!which(*term)) continue;
    for (const int p : term->form->scan) {
      if (!term->moves(p)) continue;
      own.push_back(at + p);
      sizes.push_back(term->v(p) - term->form->start(p));
    }
  }
  return {Eigen::Map<const VectorXd>(sizes.data(), std::ssize(sizes)), fit.covariance(own, own)};
}

double standsOut(const Fit& fit, std::size_t at) {
  const Term& term = fit.model.terms[at];
  return term.form->walk ? 0.0 : amplitudesOf(fit, [&](const Term& t) { return &t == &term; }).squaredDeviations();
}

}  // namespace heft::diagnosis
