// Large blocks with few entries: bounds on singular values, and balls that contain the solution.
#include <doctest/doctest.h>

#include <Eigen/SVD>
#include <cmath>

#include "contact/judge/certificate.hpp"
#include "contact/judge/judge.hpp"
#include "contact/linear/double_double.hpp"
#include "contact/linear/singular_value.hpp"
#include "known_problem.hpp"
#include "proofs/check_contact/record.hpp"
#include "support/how_many.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

double between(Dice& dice, double low, double high) {
  return low + (high - low) * dice.number(0, 1'000'000) * 1e-6;
}

Rational value_of(const DoubleDouble& x) {
  return to_rational(x.high) + to_rational(x.low);
}

/// A sparse matrix with entries near 1, and rows that differ by about `apart` where they are made dependent.
SparseMatrix sparse_random(Dice& dice, std::size_t n, double apart) {
  std::vector<double> A(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    A[i * n + i] = between(dice, 0.5, 1);
    for (int k = 0; k < 3; ++k)
      A[i * n + static_cast<std::size_t>(dice.number(0, static_cast<int>(n) - 1))] = between(dice, -1, 1);
  }
  for (std::size_t j = 0; j < n && n > 1; ++j) A[(n - 1) * n + j] = A[j] + apart * A[(n - 1) * n + j];
  return from_dense(n, n, A);
}

}  // namespace

TEST_CASE("numbers of 106 bits are rounded by less than their bound") {
  Dice dice(8, 0);
  const Rational bound = to_rational(double_double_roundoff);
  const auto number = [&] {
    const double high = std::ldexp(between(dice, 1, 2), dice.number(-40, 40)) * (dice.chance(2) ? 1 : -1);
    return DoubleDouble::fast_sum(high, high * 0x1p-53 * between(dice, -1, 1));
  };
  for (int i = 0; i < 20000; ++i) {
    const DoubleDouble a = number(), b = number();
    const Rational x = value_of(a), y = value_of(b);
    CHECK(abs(value_of(a + b) - (x + y)) <= bound * abs(x + y));
    CHECK(abs(value_of(a - b) - (x - y)) <= bound * abs(x - y));
    CHECK(abs(value_of(a * b) - x * y) <= bound * abs(x * y));
    CHECK(abs(value_of(a / b) - x / y) <= bound * abs(x / y));
    const Rational root = value_of(sqrt(abs(a)));
    CHECK(abs(root * root - abs(x)) <= 2 * bound * abs(x));
  }
}

TEST_CASE("a bound on the least singular value is below it, and near") {
  int found = 0, near = 0;
  for (int i = 0; i < 300; ++i) {
    Dice dice(9, static_cast<std::uint64_t>(i));
    const auto n = static_cast<std::size_t>(dice.number(1, 40));
    const SparseMatrix A = sparse_random(dice, n, std::pow(10.0, -dice.number(0, 9)));
    const auto factor = SparseFactor::of(A);
    if (!factor) continue;
    const auto bound = least_singular_value(A, *factor);
    if (!bound) continue;
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    for (std::size_t r = 0; r < n; ++r) {
      for (std::size_t e = A.starts[r]; e < A.starts[r + 1]; ++e) {
        dense(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(A.column[e])) = A.value[e];
      }
    }
    const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXd>(dense).singularValues();
    const double least = values[values.size() - 1], noise = 1e-14 * values[0];
    CHECK(*bound <= least + noise);
    ++found;
    near += *bound > 0.3 * least ? 1 : 0;
  }
  CHECK(found > 250);
  CHECK(near > found * 9 / 10);
}

TEST_CASE("balls around solutions of long rows contain them, and their certificates are accepted") {
  for (int i = 0; i < how_many("SLIPPROOF_LONG_ROWS", 6); ++i) {
    Dice dice(10, static_cast<std::uint64_t>(i));
    const KnownProblem known = coupled_contacts(dice, static_cast<std::size_t>(dice.number(150, 400)), 1);
    std::vector<double> answer = known.x;
    for (double& x : answer) x *= 1 + dice.number(-1000, 1000) * 1e-13;
    const ContactJudgement found = judge_contacts(known.problem, answer, {}, {});
    CHECK(found.verdict == ContactVerdict::solution_within_rho);
    REQUIRE(found.enclosure);
    CHECK(found.enclosure->system.mode() == known.mode);
    CHECK(found.enclosure->locally_unique);
    bool sparse = false;
    for (const SystemBlock& block : found.enclosure->blocks) sparse = sparse || block.sparse != nullptr;
    CHECK(sparse);
    for (std::size_t j = 0; j < known.x.size(); ++j) {
      const std::size_t unknown = found.enclosure->system.unknown(j);
      const Rational away = abs(to_rational(known.x[j]) - to_rational(found.enclosure->center[unknown]));
      CHECK(away <= to_rational(found.enclosure->radius[unknown]));
      CHECK(found.enclosure->radius[unknown] < 1e-9);
    }
    using Kind = check_contact::ContactVerdict::Kind;
    const std::string certificate = contact_certificate(known.problem, found);
    CHECK(certificate.find("\nball ") != std::string::npos);
    CHECK(certificate.find("\nmirrored ") != std::string::npos);
    CHECK(certificate.size() < 400 * known.problem.size());
    CHECK(check_contact::checked_on_record(certificate).kind == Kind::accepted);
  }
}

TEST_CASE("without inverses small problems get the verdicts that they get with them") {
  for (int i = 0; i < how_many("SLIPPROOF_KNOWN_PROBLEMS", 40); ++i) {
    Dice dice(11, static_cast<std::uint64_t>(i));
    const KnownProblem known = known_problem(dice, static_cast<std::size_t>(dice.number(1, 12)));
    std::vector<double> answer = known.x;
    for (double& x : answer) x *= 1 + dice.number(-1000, 1000) * std::pow(10.0, -dice.number(6, 16));
    ContactJudgeOptions without;
    without.enclosure.sparse_from = 0;
    const ContactJudgement a = judge_contacts(known.problem, answer, {}, {});
    const ContactJudgement b = judge_contacts(known.problem, answer, {}, without);
    CHECK(name(a.verdict) == name(b.verdict));
    if (!b.enclosure) continue;
    for (std::size_t j = 0; j < known.x.size(); ++j) {
      const std::size_t unknown = b.enclosure->system.unknown(j);
      if (unknown == ModeSystem::none) continue;
      const Rational away = abs(to_rational(known.x[j]) - to_rational(b.enclosure->center[unknown]));
      CHECK(away <= to_rational(b.enclosure->radius[unknown]));
    }
  }
}

TEST_CASE("a row of ten thousand contacts is certified, and one that is spoiled is not") {
  Dice dice(12, 0);
  const KnownProblem known = coupled_contacts(dice, 10000, 1);
  CHECK(judge_contacts(known.problem, known.x, {}, {}).verdict == ContactVerdict::solution_within_rho);
  std::vector<double> spoiled = known.x;
  spoiled[15000] += 1;
  CHECK(judge_contacts(known.problem, spoiled, {}, {}).verdict == ContactVerdict::not_converged);
}
