#include "contact/simulation/loaded_contacts.hpp"

#include <stdexcept>

#include "contact/problem/every_load.hpp"

namespace slipproof {

namespace {

/// The problem whose load is a part of its constants.
FrictionProblem with_load_at(FrictionProblem problem, const Rational& load) {
  const auto put = [&](AffineForm& form) {
    if (form.coefficients.empty()) return;  // what an element does not have
    form.constant += form.coefficients.back() * load;
    form.coefficients.back() = 0;
  };
  for (auto* forms : {&problem.equations, &problem.accelerations, &problem.forces}) {
    for (AffineForm& form : *forms) put(form);
  }
  for (ProblemElement& e : problem.elements) {
    for (AffineForm* form : {&e.gap, &e.normal, &e.slip, &e.tangent, &e.static_limit, &e.kinetic_limit}) put(*form);
  }
  return problem;
}

ContactProblem contacts_of(const FrictionProblem& problem) {
  auto contacts = contact_problem(problem);
  if (!contacts || !contacts->frictional()) {
    throw std::invalid_argument(
        "found elements that are not simulated, expected contacts from rest that can open, with one coefficient of "
        "friction each, whose forces determine the motion");
  }
  for (std::size_t i = 0; i < contacts->size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (contacts->W[i][j] == contacts->W[j][i]) continue;
      throw std::invalid_argument(
          "found a Delassus matrix that is not symmetric, expected forces that work along the motions of their "
          "contacts");
    }
  }
  return std::move(*contacts);
}

}  // namespace

std::vector<double> rounded(const std::vector<Rational>& numbers) {
  std::vector<double> result;
  for (const Rational& x : numbers) result.push_back(x.to_double());
  return result;
}

LoadedContacts loaded_contacts(const MechanismScene& scene) {
  const FrictionProblem problem = friction_problem(scene.mechanism, scene.values);
  if (!problem.has_load) {
    if (scene.load) throw std::invalid_argument("found a load, expected none: the mechanism has no load");
    ContactProblem contacts = contacts_of(problem);
    std::vector<Rational> nothing(contacts.size());
    return {std::move(contacts), std::move(nothing)};
  }
  const std::optional<Rational>& at = scene.load;
  if (!at) {
    throw std::invalid_argument("found no value of the load " + scene.mechanism.load->symbol +
                                ", expected one in the scene or as --load");
  }
  if (!problem.load_domain.contains(*at)) {
    throw std::invalid_argument("found " + scene.mechanism.load->symbol + " = " + at->str() +
                                ", expected a load of the mechanism's domain");
  }
  return {contacts_of(with_load_at(problem, *at)), contacts_of(with_load_at(problem, 0)).q};
}

}  // namespace slipproof
