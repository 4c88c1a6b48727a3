#include "contact/complete/motion/frictionless.hpp"

#include "base/algebra/linear_program.hpp"

namespace slipproof {

namespace {

using Kind = ContactState::Kind;

constexpr std::size_t most_pivots = 1000;

/// r_N of the contacts that are closed, as affine forms of some of them, wherever W r + q = u.
class NormalForces {
 public:
  NormalForces(const ExactContacts& contacts, std::span<const Rational> u) : contacts_(contacts) {
    for (std::size_t k = 0; k < contacts.contacts(); ++k) {
      if (u[contacts.normal(k)].is_zero()) closed_.push_back(k);
    }
    RationalMatrix system;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      std::vector<Rational>& row = system.emplace_back();
      for (const std::size_t k : closed_) row.push_back(contacts.W[i][contacts.normal(k)]);
      row.push_back(u[i] - contacts.q[i]);
    }
    const Echelon echelon = eliminate(system);
    const std::size_t count = closed_.size();
    exist_ = echelon.rank(count) == echelon.rank();
    if (!exist_) return;
    std::vector<bool> is_pivot(count, false);
    for (const std::size_t j : echelon.pivot_columns) is_pivot[j] = true;
    forms_.resize(count, {Rational(), std::vector<Rational>(count - echelon.rank())});
    for (std::size_t j = 0, open = 0; j < count; ++j) {
      if (is_pivot[j]) continue;
      forms_[j].coefficients[open] = 1;
      for (std::size_t p = 0; p < echelon.rank(); ++p) {
        forms_[echelon.pivot_columns[p]].coefficients[open] = Rational(-echelon.rows[p][j], echelon.pivot);
      }
      ++open;
    }
    for (std::size_t p = 0; p < echelon.rank(); ++p) {
      forms_[echelon.pivot_columns[p]].constant = Rational(echelon.rows[p][count], echelon.pivot);
    }
  }

  /// With the greatest least one, up to 1; nothing if one is always negative.
  std::optional<std::vector<Rational>> most_even() const {
    if (!exist_) return std::nullopt;
    std::vector<AffineForm> conditions;
    for (AffineForm form : forms_) {
      form.coefficients.emplace_back(-1);
      conditions.push_back(std::move(form));
    }
    const std::size_t open = closed_.empty() ? 0 : forms_[0].coefficients.size();
    AffineForm objective{Rational(), std::vector<Rational>(open + 1)}, below_one{Rational(1), objective.coefficients};
    objective.coefficients[open] = below_one.coefficients[open] = -1;
    conditions.push_back(std::move(below_one));
    const LinearOptimum optimum = minimize(objective, conditions, most_pivots);
    if (optimum.kind != LinearOptimum::Kind::attained || optimum.value.sign() > 0) return std::nullopt;
    std::vector<Rational> point = optimum.x, r(contacts_.size());
    point.pop_back();
    for (std::size_t j = 0; j < closed_.size(); ++j) r[contacts_.normal(closed_[j])] = forms_[j].at(point);
    return r;
  }

 private:
  const ExactContacts& contacts_;
  std::vector<std::size_t> closed_;
  std::vector<AffineForm> forms_;
  bool exist_ = false;
};

bool slides_with_friction(const ExactContacts& contacts, std::span<const Rational> u) {
  for (std::size_t i = 0; i < u.size(); ++i) {
    const std::size_t k = i / contacts.dimension;
    if (i != contacts.normal(k) && contacts.has_friction(k) && !u[i].is_zero()) return true;
  }
  return false;
}

}  // namespace

std::optional<SpatialMotion> motion_without_friction(const ExactContacts& contacts, std::span<const Rational> u) {
  if (slides_with_friction(contacts, u)) return std::nullopt;
  auto r = NormalForces(contacts, u).most_even();
  if (!r) return std::nullopt;
  std::vector<bool> touching;
  for (std::size_t k = 0; k < contacts.contacts(); ++k) touching.push_back(u[contacts.normal(k)].is_zero());
  const std::size_t open = open_directions(contacts, touching);
  ContactPattern mode(contacts.contacts());
  for (std::size_t k = 0; k < mode.size(); ++k) {
    const bool idle = open == 0 && (*r)[contacts.normal(k)].is_zero();  // open in the tree, too
    mode[k].kind = !touching[k] || idle ? Kind::open : contacts.has_friction(k) ? Kind::stick : Kind::closed;
  }
  auto motion = exact_motion(contacts, mode, std::move(*r));
  if (motion) motion->open_directions = open;
  return motion;
}

std::optional<std::vector<WeightedSquare>> squares_of(const RationalMatrix& W) {
  RationalMatrix left = W;
  std::vector<WeightedSquare> squares;
  for (std::size_t i = 0; i < W.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (W[i][j] != W[j][i]) return std::nullopt;
    }
  }
  for (std::size_t i = 0; i < W.size(); ++i) {
    const Rational pivot = left[i][i];
    if (pivot.sign() < 0) return std::nullopt;
    if (pivot.is_zero()) {
      for (const Rational& x : left[i]) {
        if (!x.is_zero()) return std::nullopt;
      }
      continue;
    }
    WeightedSquare square{pivot, left[i]};
    for (Rational& x : square.form) x /= pivot;
    for (std::size_t j = i; j < W.size(); ++j) {
      if (square.form[j].is_zero()) continue;
      const Rational factor = pivot * square.form[j];
      for (std::size_t k = i; k < W.size(); ++k) left[j][k] -= factor * square.form[k];
    }
    squares.push_back(std::move(square));
  }
  return squares;
}

}  // namespace slipproof
