#include "mechanics/two_contacts/random_body.hpp"

namespace slipproof::test::two_contacts {

namespace {

enum class Numbers { small, fractions, sizes };

Rational power_of_ten(int exponent) {
  Rational result = 1;
  for (int i = 0; i < exponent || i < -exponent; ++i) result *= 10;
  return exponent < 0 ? 1 / result : result;
}

Rational positive(Dice& dice, Numbers numbers) {
  if (numbers == Numbers::small) return Rational(dice.number(1, 4), dice.number(1, 3));
  const Rational fraction(dice.number(1, 999), dice.number(1, 999));
  return numbers == Numbers::sizes ? fraction * power_of_ten(dice.number(-6, 6)) : fraction;
}

Rational any(Dice& dice, Numbers numbers) {
  if (numbers == Numbers::small) return dice.number(-4, 4);
  return dice.chance(2) ? positive(dice, numbers) : -positive(dice, numbers);
}

/// A number times 1 + e, for a small e of either sign.
Rational beside(Dice& dice, const Rational& number) {
  return number * (1 + Rational(dice.number(-9, 9)) * power_of_ten(-dice.number(1, 7)));
}

Body random_body(Dice& dice, Numbers numbers) {
  Body body;
  body.inertia = positive(dice, numbers);
  for (Body::Contact& c : body.contacts) c = {any(dice, numbers), any(dice, numbers), positive(dice, numbers), {}};
  body.set_normals(any(dice, numbers));
  for (Rational& force : body.load) force = any(dice, numbers);
  return body;
}

Body near(Dice& dice, Body body) {
  const bool all = dice.chance(2);
  const auto change = [&](Rational& number) {
    if (all || dice.chance(3)) number = beside(dice, number);
  };
  change(body.inertia);
  for (Body::Contact& c : body.contacts) {
    for (Rational* number : {&c.x, &c.y, &c.mu}) change(*number);
  }
  for (Rational& force : body.load) change(force);
  return body;
}

/// One that balances forces of both contacts, most of them small, or turns the body about a contact.
std::array<Rational, 3> load_near_a_border(Dice& dice, const Body& body) {
  std::array<Rational, 3> load;
  const auto part = [&] { return Rational(dice.number(0, 9)) * power_of_ten(-dice.number(0, 5)); };
  const auto add = [&](const Rational& factor, const Rational& x, const Rational& y, const Rational& turn) {
    load[0] += factor * x;
    load[1] += factor * y;
    load[2] += factor * turn;
  };
  for (const Body::Contact& c : body.contacts) {
    for (const int side : {1, -1}) {  // the edges of its cone of friction
      const Rational x = c.normal.cosine - side * c.mu * c.normal.sine,
                     y = c.normal.sine + side * c.mu * c.normal.cosine;
      add(-part(), x, y, c.x * y - c.y * x);
      if (dice.chance(3)) add(side * part(), c.y, -c.x, body.inertia);
    }
  }
  return load;
}

}  // namespace

Body RandomBodies::body(std::uint64_t number) const {
  Dice dice(57, number);
  Body body;
  const int kind = dice.number(0, 9);
  if (kind < 4 && !listed_.empty()) {
    body = near(dice, listed_[static_cast<std::size_t>(dice.number(0, static_cast<int>(listed_.size()) - 1))].body);
  } else {
    body = random_body(dice, static_cast<Numbers>(dice.number(0, 2)));
    if (dice.chance(3)) body.below = dice.chance(4) ? Below::belts : Below::belt;
  }
  if (kind == 3 || kind > 7) {  // near a mode without a determinant
    const std::vector<Rational> at = thresholds(body);
    if (!at.empty()) {
      body.contacts[0].mu = beside(dice, at[static_cast<std::size_t>(dice.number(0, static_cast<int>(at.size()) - 1))]);
    }
  }
  if (kind == 2 || kind == 5 || kind == 6 || kind == 9) body.load = load_near_a_border(dice, body);
  return body;
}

}  // namespace slipproof::test::two_contacts
