// Problems whose solutions are known, or can be listed, in exact arithmetic.
#pragma once

#include <gmpxx.h>

#include <array>
#include <random>
#include <string>
#include <vector>

namespace slipproof::check_contact {

using Numbers = std::vector<mpq_class>;

inline std::mt19937_64 random_bits(7);

inline int below(int end) {
  return static_cast<int>(random_bits() % static_cast<unsigned>(end));
}
inline int from_to(int low, int high) {
  return low + below(high - low + 1);
}

inline std::string listed(const Numbers& numbers) {
  std::string result;
  for (const mpq_class& number : numbers) result += " " + number.get_str();
  return result;
}

inline std::string listed(const std::vector<Numbers>& matrix) {
  std::string result = std::to_string(matrix.size() * matrix.size());
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    for (std::size_t j = 0; j < matrix.size(); ++j) {
      result += " " + std::to_string(i) + " " + std::to_string(j) + " " + matrix[i][j].get_str();
    }
  }
  return result;
}

/// A problem that x solves, with mu = 1.
struct Solved {
  std::size_t dimension, free, contacts;
  Numbers x, w, c, mu;
  std::vector<Numbers> A;

  std::string header(const Numbers& answer) const {
    return "slipproof-contact 1 dimension " + std::to_string(dimension) + " free " + std::to_string(free) +
           " contacts " + std::to_string(contacts) + " mu" + listed(mu) + " matrix " + listed(A) + " constant" +
           listed(c) + " answer" + listed(answer);
  }
};

/// Force and motion of a contact that obeys the law.
inline void add_contact(Solved& problem) {
  constexpr std::array<std::array<int, 3>, 4> triples{{{3, 4, 5}, {-4, 3, 5}, {0, -1, 1}, {5, -12, 13}}};
  const auto [first, second, length] = triples[random_bits() % (problem.dimension == 3 ? 4 : 0 + 1)];
  const bool planar = problem.dimension == 2;
  const int edge = problem.dimension == 1 ? 1 : planar ? 3 : length, scale = from_to(0, 2);
  const std::array<int, 3> pushed{edge, planar ? 3 : first, second}, none{0, 0, 0};
  const int mode = below(3);
  std::array<int, 3> force = mode == 0 ? none : pushed, motion = none;
  if (mode == 0) motion = {from_to(0, 2), from_to(-2, 2), from_to(-2, 2)};
  if (mode == 1) force[0] += from_to(0, 3);
  if (mode == 2 && problem.dimension > 1) motion = {0, -scale * pushed[1], -scale * pushed[2]};
  for (std::size_t i = 0; i < problem.dimension; ++i) {
    problem.x.emplace_back(force[i]);
    problem.w.emplace_back(motion[i]);
  }
}

inline Solved random_solved() {
  Solved problem{1 + random_bits() % 3, random_bits() % 2, 1 + random_bits() % 2, {}, {}, {}, {}, {}};
  if (problem.free > 0) problem.x.emplace_back(from_to(-3, 3)), problem.w.emplace_back(0);
  for (std::size_t k = 0; k < problem.contacts; ++k) add_contact(problem);
  problem.mu.assign(problem.contacts, problem.dimension > 1 ? 1 : 0);
  problem.c = problem.w;
  for (std::size_t i = 0; i < problem.x.size(); ++i) {
    problem.A.emplace_back();
    for (const mpq_class& x : problem.x) {
      problem.A.back().emplace_back(from_to(-2, 2));
      problem.c[i] -= problem.A.back().back() * x;
    }
  }
  return problem;
}

/// All solutions of a 2 x 2 problem, two contacts in dimension 1 or one in dimension 2, with mu = 1.
struct Small {
  bool planar = false;
  std::vector<Numbers> A;
  Numbers c;

  /// r_T = -r_N for `slide+`.
  static int sign_of(const std::string& mode) { return mode == "slide+" ? 1 : -1; }

  /// The equations of the modes, A' x + c' = 0, with x = 0 where a contact is open.
  std::pair<std::vector<Numbers>, Numbers> equations(const std::string& first, const std::string& second) const {
    std::pair<std::vector<Numbers>, Numbers> result{A, c};
    auto& [rows, constants] = result;
    const auto set = [&](std::size_t i, const mpq_class& a, const mpq_class& b) {
      rows[i] = {a, b};
      constants[i] = 0;
    };
    if (first == "open") set(0, 1, 0);
    if (planar ? first == "open" : second == "open") set(1, 0, 1);
    if (first.starts_with("slide")) set(1, sign_of(first), 1);
    return result;
  }

  Numbers motion(const Numbers& x) const {
    Numbers w = c;
    for (std::size_t i = 0; i < 2; ++i) w[i] += A[i][0] * x[0] + A[i][1] * x[1];
    return w;
  }

  bool obeys(const Numbers& x) const {
    const Numbers w = motion(x);
    const auto complementary = [&](std::size_t i) { return x[i] >= 0 && w[i] >= 0 && x[i] * w[i] == 0; };
    if (!planar) return complementary(0) && complementary(1);
    return complementary(0) && abs(x[1]) <= x[0] && abs(w[1]) * x[1] == -x[0] * w[1];
  }

  /// Nothing where a mode has no solution or more than one.
  std::vector<Numbers> solutions(bool& complete) const {
    std::vector<Numbers> result;
    complete = true;
    for (const char* first : {"open", "stick", "slide+", "slide-"}) {
      for (const char* second : {"open", "stick"}) {
        if (!planar && std::string(first).starts_with("slide")) continue;
        const auto [rows, constants] = equations(first, second);
        const mpq_class det = rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0];
        complete = complete && det != 0;
        if (det == 0) continue;
        const Numbers x{(rows[0][1] * constants[1] - rows[1][1] * constants[0]) / det,
                        (rows[1][0] * constants[0] - rows[0][0] * constants[1]) / det};
        if (obeys(x)) result.push_back(x);
      }
    }
    return result;
  }
};

}  // namespace slipproof::check_contact
