#include "contact/complete/motion/frictionless.hpp"

#include "contact/complete/motion/forces_at.hpp"

namespace slipproof {

namespace {

using Kind = ContactState::Kind;

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
  std::vector<std::vector<Rational>> normals;
  for (std::size_t k = 0; k < contacts.contacts(); ++k) {
    if (u[contacts.normal(k)].is_zero()) normals.push_back(force_on(contacts, k, {Rational(1)}));
  }
  auto r = ForcesAlong(contacts, u, std::move(normals)).most_even();
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
