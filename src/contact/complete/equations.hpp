// The equations of a mode, over any number type.
#pragma once

#include "contact/complete/motion.hpp"

namespace slipproof {

/// Whether a contact slips in a direction that is unknown.
inline bool slips_in_space(const ExactContacts& contacts, const ContactPattern& mode, std::size_t k) {
  return contacts.dimension == 3 && mode[k].kind == ContactState::Kind::slip && contacts.has_friction(k);
}

/// The equations of a mode over any number type.
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
  Equation row(std::size_t i) const {
    Equation result{q_[i], {}, {}};
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      if (mode_[k].kind != ContactState::Kind::open) add_forces(result, i, k);
    }
    return result;
  }

  /// What the forces of contact k do in row i.
  void add_forces(Equation& row, std::size_t i, std::size_t k) const {
    const std::size_t normal = exact_.normal(k), first = unknowns_.first[k];
    const T mu = mu_[k];
    if (!exact_.has_friction(k)) {
      row.linear.emplace_back(first, W_[i][normal]);
    } else if (mode_[k].kind != ContactState::Kind::slip) {
      for (std::size_t t = 0; t < exact_.dimension; ++t) row.linear.emplace_back(first + t, W_[i][normal + t]);
    } else if (exact_.dimension == 2) {
      const T friction = mu * W_[i][normal + 1];
      row.linear.emplace_back(first,
                              mode_[k].from.x.sign() > 0 ? T(W_[i][normal] - friction) : T(W_[i][normal] + friction));
    } else {
      row.linear.emplace_back(first, W_[i][normal]);
      for (const std::size_t t : {1, 2}) row.products.push_back({first, first + t, T(-(mu * W_[i][normal + t]))});
    }
  }

  void add_contact(const ContactState& state, std::size_t k) {
    if (state.kind == ContactState::Kind::open) return;
    const std::size_t normal = exact_.normal(k), first = unknowns_.first[k];
    equations.push_back(row(normal));
    if (!exact_.has_friction(k)) return;
    for (std::size_t t = 1; state.kind != ContactState::Kind::slip && t < exact_.dimension; ++t)
      equations.push_back(row(normal + t));
    if (state.kind != ContactState::Kind::slip || exact_.dimension == 2) return;
    for (const std::size_t t : {1, 2}) {
      Equation tangential = row(normal + t);
      tangential.products.push_back({first + 3, first + t, T(-1)});
      equations.push_back(std::move(tangential));
    }
    equations.push_back({T(-1), {}, {{first + 1, first + 1, T(1)}, {first + 2, first + 2, T(1)}}});
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

}  // namespace slipproof
