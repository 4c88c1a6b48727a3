#include "mechanics/checks/rigid_contacts.hpp"

#include <algorithm>

namespace slipproof::mechanism_checks {

Rational dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1];
}
Vector turned(const Vector& a) {
  return {Rational(-a[1]), a[0]};
}
bool vanishes(const Vector& a) {
  return a[0].is_zero() && a[1].is_zero();
}

namespace {

using Why = RigidMisfit::Why;
using Contacts = std::vector<PlacedContact>;

/// a + factor * b
Vector sum(const Vector& a, const Rational& factor, const Vector& b) {
  return {Rational(a[0] + factor * b[0]), Rational(a[1] + factor * b[1])};
}
Rational square(const Vector& a) {
  return dot(a, a);
}

/// Two translations are perpendicular and of one length; one is not 0.
bool translations_fit(const PlacedContact& one) {
  const Vector &x = one.translations.front(), &y = one.translations.back();
  return !vanishes(x) && (one.translations.size() == 1 || (square(x) == square(y) && dot(x, y).is_zero()));
}

/// Whether the origin of the picture is the point that the translations are of.
bool is_central(const PlacedContact& one, const Vector& rotation) {
  return dot(rotation, one.at).is_zero() && square(rotation) == square(one.translations.front()) * square(one.at);
}
bool is_right(const PlacedContact& one) {
  return is_central(one, one.rotation);
}

/// What does not fit at a contact with what the reference has; `side` is that to which the rotation turns, once known.
std::optional<RigidMisfit> misfit_against(const Contacts& all, std::size_t reference, std::size_t index, int& side) {
  const PlacedContact &there = all[reference], &one = all[index];
  const Rational length = square(there.translations.front());
  const Rational ratio = dot(one.translations.front(), there.translations.front()) / length;
  for (std::size_t i = 0; i < one.translations.size(); ++i) {
    const Vector off = sum(one.translations[i], Rational(-ratio), there.translations[i]);
    if (ratio > 0 && vanishes(off)) continue;
    return RigidMisfit{index, Why::translations, !dot(off, one.normal).is_zero(), reference};
  }
  const Vector difference = sum({}, Rational(1) / ratio, sum(one.rotation, Rational(-ratio), there.rotation));
  const Vector arm = turned(sum(one.at, -1, there.at));
  for (const bool gap : {true, false}) {
    const Vector& axis = gap ? one.normal : one.along;
    const Rational found = dot(difference, axis), expected = dot(arm, axis);
    const int turn = sign(found) * sign(expected);
    const bool fits = found * found == length * expected * expected && (turn == 0 || side == 0 || turn == side);
    if (!fits) return RigidMisfit{index, Why::rotation, gap, reference};
    if (turn != 0) side = turn;
  }
  return std::nullopt;
}

/// Whether all are right where the rotation has the other sign across the contacts, or along them.
bool mirrored(const Contacts& all, bool gap) {
  int side = 0;
  return std::ranges::all_of(all, [&](const PlacedContact& one) {
    const Vector& axis = gap ? one.normal : one.along;
    const Vector other = sum(one.rotation, Rational(-2) * dot(one.rotation, axis) / square(axis), axis);
    const int turn = sign(dot(other, turned(one.at)));
    if (!is_central(one, other) || turn == 0 || (side != 0 && turn != side)) return false;
    side = turn;
    return true;
  });
}

}  // namespace

std::optional<RigidMisfit> rigid_misfit(const Contacts& contacts) {
  const auto odd = std::ranges::find_if_not(contacts, translations_fit);
  if (odd != contacts.end()) {
    const auto index = static_cast<std::size_t>(odd - contacts.begin());
    return RigidMisfit{index, Why::lengths, false, index};
  }
  const auto right = std::ranges::find_if(contacts, is_right);
  const std::size_t reference = right == contacts.end() ? 0 : static_cast<std::size_t>(right - contacts.begin());
  int side = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (auto found = misfit_against(contacts, reference, i, side)) return found;
  }
  if (std::ranges::all_of(contacts, is_right)) return std::nullopt;
  for (const bool gap : {false, true}) {
    if (mirrored(contacts, gap)) return RigidMisfit{0, Why::mirrored, gap, 0};
  }
  return std::nullopt;
}

}  // namespace slipproof::mechanism_checks
