// Problems in space whose exact solution by a law is known, because they are made from it.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "contact/enclosure/known_problem.hpp"

namespace slipproof::test {

/// The matrix and mu of known_problem(); forces and velocities of each contact by the law, in Pythagorean directions.
/// Only the last bits of c may be rounded: `exact` says whether none was.
struct LawfulProblem {
  MixedProblem problem;
  std::vector<double> x;
  bool exact = true;
};

class Lawful {
 public:
  Lawful(Dice& dice, ContactLaw law) : dice_(dice), law_(std::move(law)) {}

  LawfulProblem make(std::size_t contacts) {
    LawfulProblem result{known_problem(dice_, contacts).problem, {}, true};
    MixedProblem& p = result.problem;
    if (law_.kind == FrictionLaw::regularised) law_.slip_speed = speed;
    for (std::size_t k = 0; k < contacts; ++k) add_contact(p.mu[k]);
    p.law = law_;
    result.x = r_;
    for (std::size_t i = 0; i < p.size(); ++i) {
      p.c[i] = 0;
      const Rational c = to_rational(u_[i]) - exact_row(p, i, result.x);
      p.c[i] = nearest_binary64(c);
      result.exact = result.exact && to_rational(p.c[i]) == c;
    }
    return result;
  }

 private:
  static constexpr double speed = 4.0 * 5 * 13 * 17 * 29;  // of which 3/4 is a slip with sqrt(v_s^2 + u^2) = 5/4 v_s

  void put(std::array<double, 3> r, std::array<double, 3> u) {
    r_.insert(r_.end(), r.begin(), r.end());
    u_.insert(u_.end(), u.begin(), u.end());
  }

  void add_contact(double mu) {
    constexpr std::array<std::array<int, 3>, 4> triples{{{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {20, 21, 29}}};
    const auto& [first, second, c] = triples[static_cast<std::size_t>(dice_.number(0, 3))];
    const double a = dice_.chance(2) ? first : -first, b = dice_.chance(2) ? second : -second;
    const double size = dice_.number(1, 40), s = dice_.number(1, 40), N = 20 * c * size / mu;
    const int state = dice_.number(0, 2);  // open, sticks, slides
    switch (law_.kind) {
      case FrictionLaw::associated:
        if (state == 0) return put({0, 0, 0}, {mu * c * s + dice_.number(1, 40), a * s, b * s});
        if (state == 1) return put({N, a * size, b * size}, {0, 0, 0});
        return put({N, 20 * a * size, 20 * b * size}, {mu * c * s, -a * s, -b * s});
      case FrictionLaw::fixed:
        return add_fixed(state);
      case FrictionLaw::box:
        if (state == 1) return put({N, 2 * a * size, -b * size}, {0, 0, 0});
        if (state == 2) return put({N, -20 * c * size, b * size}, {0, s, 0});
        break;
      case FrictionLaw::diamond:
        if (state == 1) return put({N, a * size, -b * size}, {0, 0, 0});
        if (state == 2) return put({N, -20 * c * size, 0}, {0, s, s / 2});
        break;
      case FrictionLaw::regularised:
        if (state == 1) return add_creep(N, size, c, a, b);
        if (state == 2 && law_.function == Regularisation::linear) {
          const double fast = std::ceil(speed / c) + s;
          return put({N, -20 * a * size, -20 * b * size}, {0, a * fast, b * fast});
        }
        if (state == 2) return add_creep(N, size, c, -a, b);
        break;
      case FrictionLaw::cone:
        if (state == 1) return put({N, a * size, b * size}, {0, 0, 0});
        if (state == 2) return put({N, 20 * a * size, 20 * b * size}, {0, -a * s, -b * s});
        break;
    }
    put({0, 0, 0}, {s, a, b});
  }

  void add_fixed(int state) {
    std::array<double, 3> r{state == 0 ? 0.0 : dice_.number(1, 99), 0, 0},
        u{state == 0 ? dice_.number(1, 99) : 0.0, 0, 0};
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}}) {
      const double bound = dice_.number(0, 50);
      law_.bounds.push_back(bound);
      const bool slides = bound == 0 || dice_.chance(2);
      const int sign = dice_.chance(2) ? 1 : -1;
      r[i] = slides ? -sign * bound : dice_.number(-99, 99) / 100.0 * bound;
      r[i] = slides ? r[i] : std::trunc(r[i]);
      u[i] = slides ? sign * dice_.number(1, 60) : 0;
    }
    put(r, u);
  }

  /// The slip of 3/4 v_s: linear friction is 3/4 of its limit, soft friction 3/5. The limit is 20 c size.
  void add_creep(double N, double size, double c, double a, double b) {
    const double part = law_.function == Regularisation::linear ? 15 : 12, slip = 0.75 * speed / c;
    put({N, -part * size * a, -part * size * b}, {0, slip * a, slip * b});
  }

  Dice& dice_;
  ContactLaw law_;
  std::vector<double> r_, u_;
};

/// The same with one more contact, which touches without load and moves along: its normal row is half of that of the
/// first contact that is pressed. Nothing if none is.
inline std::optional<LawfulProblem> with_touching(const LawfulProblem& known, Dice& dice) {
  const MixedProblem& p = known.problem;
  const std::size_t n = p.size(), all = n + 3;
  std::size_t pressed = 0;
  while (pressed < n && known.x[pressed] == 0) pressed += 3;
  if (pressed >= n) return std::nullopt;
  LawfulProblem result = known;
  std::vector<double> W(all * all, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t e = p.A.starts[i]; e < p.A.starts[i + 1]; ++e) W[i * all + p.A.column[e]] = p.A.value[e];
  }
  for (std::size_t j = 0; j < n; ++j) W[n * all + j] = W[pressed * all + j] / 2;
  for (std::size_t i = n; i < all; ++i) W[i * all + i] = dice.number(1, 9);
  result.problem.A = from_dense(all, all, W);
  result.problem.c.insert(result.problem.c.end(),
                          {p.c[pressed] / 2, 1.0 * dice.number(-9, 9), 1.0 * dice.number(-9, 9)});
  result.problem.mu.push_back(0.5);
  result.x.insert(result.x.end(), 3, 0.0);
  return result;
}

/// Contacts of one point mass, all at the same place: u_k = r_1 + r_2 + ... + q. The last row of blocks is larger by
/// 2^-50, as if rounding had done it.
inline MixedProblem one_place(std::size_t contacts, std::vector<double> q) {
  MixedProblem p;
  const std::size_t n = 3 * contacts;
  std::vector<double> W(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i % 3; j < n; j += 3) W[i * n + j] = 1;
  }
  for (std::size_t i = n - 3; i < n; ++i) W[i * n + i] += 0x1p-50;
  p.A = from_dense(n, n, W);
  p.c = std::move(q);
  p.mu.assign(contacts, 0.5);
  return p;
}

}  // namespace slipproof::test
