// Bounds on the distance of every solution, for convex laws (FORMAT.md, `every-solution`).
#pragma once

#include "proofs/check_contact/claims.hpp"

namespace slipproof::check_contact {

/// A + A^T - 2 D - L L^T is semidefinite, by its rows: the diagonal is at least the sum of the others.
inline void check_moduli(const Problem& problem, const Vector& moduli, const Matrix& L) {
  Matrix rest = remainder(problem.A, L);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    require(moduli[i].sign() >= 0, "row", i, "its modulus is negative");
    rest[i][i] += -2 * moduli[i];
  }
  check_semidefinite(rest);
}

inline bool is_symmetric(const Problem& problem) {
  for (std::size_t i = 0; i < problem.size(); ++i) {
    for (const auto& [j, a] : problem.A[i]) {
      if (!(problem.entry(j, i) == a)) return false;
    }
  }
  return true;
}

class EverySolution {
 public:
  EverySolution(const Problem& problem, Reader& reader) : problem_(problem) {
    rho_ = reader.number();
    eta_ = reader.number();
    moduli_ = reader.numbers("moduli", problem.size());
    factor_ = reader.entries("factor", problem.size(), problem.size());
    point_ = reader.numbers("point", problem.size());
    motion_ = reader.numbers("motion", problem.size());
    shares_ = reader.numbers("shares", problem.size());
    gaps_ = reader.numbers("gaps", problem.contacts());
    reader.expect("energy");
    energy_ = reader.number();
    radii_ = reader.numbers("radii", problem.size());
  }

  std::string check() const {
    require(rho_.sign() >= 0 && eta_.sign() >= 0 && energy_.sign() >= 0, "RHO, ETA or the energy is negative");
    check_moduli(problem_, moduli_, factor_);
    check_energy();
    const std::size_t open = check_distances();
    check_velocities();
    const std::string near = " within " + decimal(rho_) + " of the answer and velocities within " + decimal(eta_);
    if (open == 0) return "exactly one solution," + near;
    return "every solution has all but " + std::to_string(open) + " components" + near;
  }

 private:
  /// energy^2 >= gaps + energy sqrt(sum of shares^2).
  void check_energy() const {
    Number squares, gaps;
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      const Number rest = abs(problem_.motion(i, point_) - motion_[i]);
      require(i >= problem_.free || motion_[i].sign() == 0, "row", i, "the motion is not 0");
      require(shares_[i].sign() >= 0 && square(rest) <= moduli_[i] * square(shares_[i]), "row", i,
              "its share is less than what is left of it");
      squares += square(shares_[i]);
    }
    for (std::size_t k = 0; k < problem_.contacts(); ++k) {
      require(Contact(problem_, k, point_, motion_).gap() <= gaps_[k], "contact", k, "its gap is larger");
      require(gaps_[k].sign() >= 0, "contact", k, "its gap is negative");
      gaps += gaps_[k];
    }
    const Number rest = square(energy_) - gaps;
    require(rest.sign() >= 0 && square(rest) >= square(energy_) * squares, "the energy is too small");
  }

  /// radius >= energy / sqrt(d), where d is not 0. Returns how many components are open.
  std::size_t check_distances() const {
    const Vector& answer = problem_.the_answer();
    std::size_t open = 0;
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      if (moduli_[i].sign() == 0) {
        ++open;
        continue;
      }
      require(radii_[i].sign() >= 0 && square(radii_[i]) * moduli_[i] >= square(energy_), "component", i,
              "its radius is too small");
      require(abs(point_[i] - answer[i]) + radii_[i] <= rho_, "component", i,
              "it may be farther than RHO from the answer");
    }
    return open;
  }

  void check_velocities() const {
    const bool symmetric = is_symmetric(problem_);
    const Vector& answer = problem_.the_answer();
    for (std::size_t i = problem_.free; i < problem_.size(); ++i) {
      const Number left = eta_ - abs(problem_.motion(i, point_) - problem_.motion(i, answer));
      // |(A e)_i|^2 <= a_ii e . A e for a symmetric semidefinite A
      const bool by_energy = symmetric && problem_.entry(i, i) * square(energy_) <= square(left);
      require(left.sign() >= 0 && (by_energy || by_radii(i) <= left), "row", i,
              "its velocity may be farther than ETA from the answer's");
    }
  }

  Number by_radii(std::size_t i) const {
    Number sum;
    for (const auto& [j, a] : problem_.A[i]) {
      require(moduli_[j].sign() > 0 || a.sign() == 0, "row", i, "its velocity depends on what is open");
      sum += abs(a) * radii_[j];
    }
    return sum;
  }

  const Problem& problem_;
  Number rho_, eta_, energy_;
  Vector moduli_, point_, motion_, shares_, gaps_, radii_;
  Matrix factor_;
};

}  // namespace slipproof::check_contact
