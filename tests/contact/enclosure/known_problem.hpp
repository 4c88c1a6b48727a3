// Problems in space whose exact solution is known, because they are made from it.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "base/number/binary64.hpp"
#include "base/number/dice.hpp"
#include "contact/enclosure/mode_system.hpp"

namespace slipproof::test {

struct KnownProblem {
  MixedProblem problem;
  std::vector<double> x;  ///< solves it exactly
  ConeMode mode;          ///< strictly
};

/// W is symmetric with integers and dominated by its diagonal, so that the solution is the only one; r and u are
/// integers, sliding ones in Pythagorean directions; q = u - W r. All are exact in binary64.
inline KnownProblem known_problem(Dice& dice, std::size_t contacts) {
  KnownProblem known;
  MixedProblem& p = known.problem;
  const std::size_t n = 3 * contacts;
  std::vector<double> W(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = i / 3;
    for (int neighbour = 0; neighbour < 4 && i > 0; ++neighbour) {
      const auto j = static_cast<std::size_t>(dice.number(0, static_cast<int>(i) - 1));
      if (j / 3 + 20 < k) continue;  // a chain, not one dense block, once there are many
      W[i * n + j] = W[j * n + i] = dice.number(-8, 8);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j) sum += i == j ? 0 : std::abs(W[i * n + j]);
    W[i * n + i] = 4 * sum + dice.number(1, 9);
  }
  p.A = from_dense(n, n, W);
  constexpr std::array<std::array<int, 3>, 4> triples{{{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {20, 21, 29}}};
  std::vector<double> u;
  for (std::size_t k = 0; k < contacts; ++k) {
    const auto& [a, b, c] = triples[static_cast<std::size_t>(dice.number(0, 3))];
    const int s1 = dice.chance(2) ? 1 : -1, s2 = dice.chance(2) ? 1 : -1;
    const int size = dice.number(1, 40);
    p.mu.push_back(1.0 / (1 << dice.number(1, 3)));
    const double N = c * size / p.mu.back();
    switch (dice.number(0, 2)) {
      case 0:
        known.mode.push_back(ConeState::open);
        for (const int value : {0, 0, 0}) known.x.push_back(value);
        for (const int value : {dice.number(1, 99), dice.number(-99, 99), dice.number(-99, 99)}) u.push_back(value);
        break;
      case 1:
        known.mode.push_back(ConeState::stick);
        for (const double value : {N, s1 * a * size / 2.0, s2 * b * size / 2.0}) known.x.push_back(value);
        for (const int value : {0, 0, 0}) u.push_back(value);
        break;
      default: {
        known.mode.push_back(ConeState::slide);
        for (const double value : {N, double(s1 * a * size), double(s2 * b * size)}) known.x.push_back(value);
        const int slip = dice.number(1, 60);
        for (const int value : {0, -s1 * a * slip, -s2 * b * slip}) u.push_back(value);
      }
    }
  }
  p.c.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const Rational q = Rational(static_cast<long>(u[i])) - exact_row(p, i, known.x);
    p.c[i] = q.to_double();
  }
  return known;
}

/// Contacts that push their neighbours as balls do, in rows of `contacts` one above the other, all closed; the answer
/// is known to the last digit. `own` is what the diagonal of W has beyond the sum of its row: 0 for balls, whose
/// condition grows with the square of a row's length.
inline KnownProblem coupled_contacts(Dice& dice, std::size_t contacts, std::size_t rows, double own = 0) {
  KnownProblem known;
  MixedProblem& p = known.problem;
  const std::size_t n = 3 * contacts * rows;
  std::vector<MatrixEntry> entries, twice;
  const auto put = [&](std::size_t i, std::size_t j, double a) {
    entries.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), a});
    if (i != j) entries.push_back({static_cast<std::uint32_t>(j), static_cast<std::uint32_t>(i), a});
  };
  std::vector<double> u(n, 0);
  for (std::size_t k = 0; k < contacts * rows; ++k) {
    for (std::size_t i = 3 * k; i < 3 * k + 3; ++i) {
      put(i, i, own + (rows > 1 ? 4 : 2));
      if (k % contacts > 0) put(i, i - 3, -1);
      if (k >= contacts) put(i, i - 3 * contacts, -1);
    }
    put(3 * k, 3 * k + 1, 0.25);
    const double size = dice.number(1, 20);
    const bool slides = dice.chance(3);
    known.x.insert(known.x.end(), {20 * size, (slides ? 6 : 1) * size, (slides ? 8 : 1) * size});
    known.mode.push_back(slides ? ConeState::slide : ConeState::stick);
    if (slides) u[3 * k + 1] = -3 * size, u[3 * k + 2] = -4 * size;
  }
  p.A = sparse_matrix(n, n, std::move(entries), twice);
  p.mu.assign(contacts * rows, 0.5);
  p.c.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) p.c[i] = (to_rational(u[i]) - exact_row(p, i, known.x)).to_double();
  return known;
}

}  // namespace slipproof::test
