#include "records/judging/forces_near.hpp"

#include <algorithm>

#include "contact/space/space_problem.hpp"

namespace slipproof {

namespace {

/// Corrects given forces of the contacts that are closed, so that these stay where they are.
class ForceCorrection {
 public:
  ForceCorrection(const SolvedSpace& solved, const SpaceMotion& motion, const std::vector<Rational>& given)
      : m_(solved.scene.mechanism),
        motion_(motion),
        given_(given),
        problem_(space_problem(solved.scene)),
        free_(reduced(problem_, m_)),
        r_(free_.contacts.size()) {}

  std::optional<std::vector<std::optional<Rational>>> run() {
    for (std::size_t k = 0; k < problem_.contacts.size(); ++k) {
      const std::string& mode = motion_.modes[problem_.contacts[k].contact];
      if (mode == "slip") return std::nullopt;
      if (mode != "lift") close(k, mode == "stick" ? 3 : 1);
    }
    if (!correct() || !obeys_law()) return std::nullopt;
    return forces();
  }

 private:
  std::size_t force(std::size_t unknown) const { return unknown - m_.accelerations; }

  void close(std::size_t k, std::size_t components) {
    const MechanismContact& c = m_.contacts[problem_.contacts[k].contact];
    for (std::size_t t = 0; t < components; ++t) {
      const std::size_t unknown = t == 0 ? c.normal : t == 1 ? *c.tangent : c.second->force;
      r_[3 * k + t] = given_[force(unknown)];
      closed_.push_back(3 * k + t);
    }
  }

  Rational velocity(std::size_t i) const {
    Rational u = free_.contacts.q[i];
    for (std::size_t j = 0; j < r_.size(); ++j) {
      if (!r_[j].is_zero()) u += free_.contacts.W[i][j] * r_[j];
    }
    return u;
  }

  /// W (r + change) + q = 0 in the closed components; false if that has no solution.
  bool correct() {
    RationalMatrix equations;
    for (const std::size_t i : closed_) {
      std::vector<Rational>& row = equations.emplace_back();
      for (const std::size_t j : closed_) row.push_back(free_.contacts.W[i][j]);
      row.push_back(-velocity(i));
    }
    if (closed_.empty()) return true;
    const Echelon echelon = eliminate(equations);
    if (echelon.rank() > echelon.rank(closed_.size())) return false;
    for (std::size_t i = 0; i < echelon.rank(); ++i) {
      r_[closed_[echelon.pivot_columns[i]]] += Rational(echelon.rows[i].back(), echelon.pivot);
    }
    return true;
  }

  bool obeys_law() const {
    for (std::size_t k = 0; k < problem_.contacts.size(); ++k) {
      const Rational &n = r_[3 * k], &first = r_[3 * k + 1], &second = r_[3 * k + 2], &mu = problem_.contacts[k].mu;
      if (n.sign() < 0 || first * first + second * second > mu * mu * n * n) return false;
      if (motion_.modes[problem_.contacts[k].contact] == "lift" && velocity(3 * k).sign() < 0) return false;
    }
    for (std::size_t j = 0; j < free_.V.size(); ++j) {
      const Rational a = sum(free_.V[j], free_.v0[j]);
      const Range& range = motion_.accelerations[j];
      if (a < *range.lower || a > *range.upper) return false;
    }
    return true;
  }

  Rational sum(const std::vector<Rational>& weights, Rational total) const {
    for (std::size_t j = 0; j < r_.size(); ++j) {
      if (!r_[j].is_zero()) total += weights[j] * r_[j];
    }
    return total;
  }

  std::vector<std::optional<Rational>> forces() const {
    std::vector<std::optional<Rational>> result(given_.size(), Rational(0));
    for (std::size_t k = 0; k < problem_.contacts.size(); ++k) {
      const MechanismContact& c = m_.contacts[problem_.contacts[k].contact];
      result[force(c.normal)] = r_[3 * k];
      if (!c.second) continue;
      result[force(*c.tangent)] = r_[3 * k + 1];
      result[force(c.second->force)] = r_[3 * k + 2];
    }
    for (std::size_t j = 0; j < problem_.held.size(); ++j) {
      std::optional<Rational>& held = result[force(problem_.held[j])];
      held.reset();
      if (free_.determined[j]) held = sum(free_.L[j], free_.l0[j]);
    }
    return result;
  }

  const Mechanism& m_;
  const SpaceMotion& motion_;
  const std::vector<Rational>& given_;
  const SpaceProblem problem_;
  const ReducedSpace free_;
  std::vector<Rational> r_;
  std::vector<std::size_t> closed_;  ///< components of r
};

}  // namespace

std::optional<std::vector<std::optional<Rational>>> forces_near(const SolvedSpace& solved, const SpaceMotion& motion,
                                                                const std::vector<Rational>& given) {
  return ForceCorrection(solved, motion, given).run();
}

}  // namespace slipproof
