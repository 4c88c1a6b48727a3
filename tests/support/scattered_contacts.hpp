// Contacts that do not know of each other, W = identity, with an answer: open, sticking, sliding, and without friction.
#pragma once

#include <vector>

#include "base/number/dice.hpp"
#include "contact/formats/problem_file.hpp"

namespace slipproof::test {

struct ScatteredContacts {
  ProblemFile problem;
  std::vector<double> r;  ///< solves it up to rounding
  std::vector<bool> slides;
};

/// Forces are small integers over a power of two, the directions of sliding (3, 4) / 5 and its mirror images.
inline ScatteredContacts scattered_contacts(std::size_t contacts, std::size_t dimension) {
  ScatteredContacts made;
  Dice dice(11, contacts);
  ProblemFile& p = made.problem;
  p.dimension = dimension;
  const std::size_t n = contacts * dimension;
  std::vector<MatrixEntry> entries, twice;
  for (std::uint32_t i = 0; i < n; ++i) entries.push_back({i, i, 1});
  p.W = sparse_matrix(n, n, entries, twice);
  for (std::size_t k = 0; k < contacts; ++k) {
    const double mu = dice.chance(12) ? 0 : 0.25 * dice.number(1, 4), N = dice.chance(5) ? 0 : 20 * dice.number(1, 50);
    const bool slides = N > 0 && mu > 0 && dice.chance(2);
    const double bound = mu * N, along = slides ? bound : bound * dice.number(0, 7) / 8, sign = dice.chance(2) ? 1 : -1;
    std::vector<double> r{N, along}, u{N > 0 ? 0.0 : dice.number(1, 9), 0};
    if (dimension == 3) r = {N, sign * along * 0.6, along * 0.8}, u.push_back(0);
    r[1] *= dimension == 3 ? 1 : sign;
    if (slides) {
      for (std::size_t i = 1; i < dimension; ++i) u[i] = -r[i] / 8;
    }
    for (std::size_t i = 0; i < dimension; ++i) {
      made.r.push_back(r[i]);
      p.q.push_back(u[i] - r[i]);
    }
    p.mu.push_back(mu);
    made.slides.push_back(slides);
  }
  return made;
}

}  // namespace slipproof::test
