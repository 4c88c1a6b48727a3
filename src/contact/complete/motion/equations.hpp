// The equations of a mode, over any number type.
#pragma once

#include <algorithm>

#include "contact/complete/motion/motion.hpp"

namespace slipproof {

/// The equations of a mode over any number type, in the order of ModeUnknowns: for each contact in turn u_N = 0, where
/// it sticks u_T = 0, where it slips in the plane r_T = -+ mu r_N, and in space u_T + s r_T = 0 and
/// |r_T|^2 = (mu r_N)^2.
template <class T>
class EquationMaker {
 public:
  using Equation = ModeEquation<T>;

  template <class Contacts>
  EquationMaker(const Contacts& contacts, const ExactContacts& exact, const ContactPattern& mode,
                const ModeUnknowns& unknowns)
      : W_(contacts.W), q_(contacts.q), mu_(contacts.mu), exact_(exact), mode_(mode), unknowns_(unknowns) {
    for (std::size_t k = 0; k < mode.size(); ++k) add_contact(mode[k], k);
  }

  std::vector<Equation> equations;

 private:
  /// u_i.
  Equation row(std::size_t i) const {
    Equation result{q_[i], {}, {}};
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      for (std::size_t t = 0; t < unknowns_.forces(k); ++t) {
        result.linear.emplace_back(unknowns_.first[k] + t, W_[i][exact_.normal(k) + t]);
      }
    }
    return result;
  }

  void add_contact(const ContactState& state, std::size_t k) {
    const std::size_t forces = unknowns_.forces(k), normal = exact_.normal(k), first = unknowns_.first[k];
    if (forces == 0) return;
    equations.push_back(row(normal));
    if (forces == 1) return;
    if (state.kind != ContactState::Kind::slip) {
      for (std::size_t t = 1; t < forces; ++t) equations.push_back(row(normal + t));
    } else if (forces == 2) {
      equations.push_back({T(), {{first + 1, T(1)}, {first, state.from.x.sign() > 0 ? mu_[k] : T(-mu_[k])}}, {}});
    } else {
      for (const std::size_t t : {1U, 2U}) {
        equations.push_back(row(normal + t));
        equations.back().products.push_back({first + 3, first + t, T(1)});
      }
      equations.push_back(
          {T(),
           {},
           {{first + 1, first + 1, T(1)}, {first + 2, first + 2, T(1)}, {first, first, T(-(mu_[k] * mu_[k]))}}});
    }
  }

  const std::vector<std::vector<T>>& W_;
  const std::vector<T>&q_, &mu_;
  const ExactContacts& exact_;
  const ContactPattern& mode_;
  const ModeUnknowns& unknowns_;
};

/// As many as there are unknowns. `contacts` are the same problem in numbers of type T.
template <class T, class Contacts>
std::vector<ModeEquation<T>> mode_equations(const Contacts& contacts, const ExactContacts& exact,
                                            const ContactPattern& mode, const ModeUnknowns& unknowns) {
  return EquationMaker<T>(contacts, exact, mode, unknowns).equations;
}

template <class T>
T value_at(const ModeEquation<T>& equation, const std::vector<T>& z) {
  T sum = equation.constant;
  for (const auto& [j, a] : equation.linear) sum += a * z[j];
  for (const auto& p : equation.products) sum += p.coefficient * z[p.i] * z[p.j];
  return sum;
}

template <class T>
std::vector<T> slope_at(const ModeEquation<T>& equation, const std::vector<T>& z) {
  std::vector<T> slope(z.size());
  for (const auto& [j, a] : equation.linear) slope[j] += a;
  for (const auto& p : equation.products) {
    slope[p.i] += p.coefficient * z[p.j];
    slope[p.j] += p.coefficient * z[p.i];
  }
  return slope;
}

/// How much the products change the equation within p of a point. Each is a square, or the only one.
template <class T>
T bend_within(const ModeEquation<T>& equation, const std::vector<T>& p) {
  T up{}, down{};
  for (const auto& term : equation.products) {
    (term.coefficient > 0 ? up : down) += abs(term.coefficient) * p[term.i] * p[term.j];
  }
  return std::max(up, down);
}

}  // namespace slipproof
