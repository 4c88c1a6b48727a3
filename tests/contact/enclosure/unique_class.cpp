#include "contact/exact/unique_class.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/linear/definite.hpp"
#include "contact/linear/dominant.hpp"
#include "contact/problem/every_load.hpp"
#include "contact/problem/solutions.hpp"
#include "lcp_problems.hpp"

using namespace lcp;

namespace {

using Class = UniqueProof::Class;

std::optional<UniqueProof> proof_of(const Matrix& A) {
  Effort effort(10'000'000'000);
  return prove_unique(problem(A, std::vector<double>(A.size())), effort);
}

std::optional<Class> class_of(const Matrix& A) {
  const auto proof = proof_of(A);
  return proof ? std::optional(proof->kind) : std::nullopt;
}

bool is_p_matrix(const Matrix& A) {
  for (unsigned set = 1; set < 1U << A.size(); ++set) {
    if (expansion(part(exact(A), set)) <= 0) return false;
  }
  return true;
}

Matrix hilbert(std::size_t n) {
  Matrix result(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) result[i][j] = 1 / static_cast<double>(i + j + 1);
  }
  return result;
}

/// The same few entries around each place of the diagonal.
MixedProblem band_problem(std::size_t n, const std::vector<double>& stencil) {
  std::vector<MatrixEntry> entries, twice;
  const std::size_t half = stencil.size() / 2;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < stencil.size(); ++k) {
      if (i + k < half || i + k - half >= n) continue;
      entries.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + k - half), stencil[k]});
    }
  }
  MixedProblem result = problem({}, {});
  result.A = sparse_matrix(n, n, entries, twice);
  result.c.resize(n);
  result.mu.resize(n);
  return result;
}

}  // namespace

TEST_CASE("a small matrix has a proof if and only if its principal minors are positive") {
  Draw draw(1);
  int proved = 0, refuted = 0;
  std::set<Class> seen;
  for (int i = 0; i < 4000; ++i) {
    Matrix A = draw.matrix(draw.size(1, 4), 0, 0, 0);
    for (auto& row : A) row = draw.vector(A.size(), -3, 3);
    for (std::size_t k = 0; k < A.size(); ++k) A[k][k] = draw.whole(0, 5);
    const auto proof = proof_of(A);
    REQUIRE(proof.has_value() == is_p_matrix(A));
    (proof ? proved : refuted) += 1;
    if (proof) seen.insert(proof->kind);
    const auto minor = nonpositive_minor(sparse(A));
    REQUIRE(minor.has_value() != proof.has_value());
    if (!minor) continue;
    unsigned set = 0;
    for (const std::size_t row : *minor) set |= 1U << row;
    CHECK(expansion(part(exact(A), set)) <= 0);
  }
  CHECK(proved > 500);
  CHECK(refuted > 500);
  CHECK(seen.size() == 3);
}

TEST_CASE("where a proof was found every constant leaves one solution") {
  Draw draw(2);
  int proved = 0, others = 0;
  for (int i = 0; i < 4000; ++i) {
    const std::size_t n = draw.size(2, 3);
    Matrix A = draw.matrix(n, n, -2, 2);
    for (std::size_t k = 0; k < n; ++k) A[k][k] = draw.whole(1, 4);
    const MixedProblem p = problem(A, draw.vector(n, -4, 4));
    Effort effort(1'000'000'000);
    const bool unique = prove_unique(p, effort).has_value();
    const Enumerated all = enumerate(p, A);
    if (unique) REQUIRE(all.solutions.size() == 1);
    if (unique) REQUIRE(!all.singular);
    proved += unique ? 1 : 0;
    others += all.solutions.size() != 1 ? 1 : 0;
  }
  CHECK(proved > 500);
  CHECK(others > 200);
}

TEST_CASE("planar friction has a proof where every constant leaves one solution, and nowhere else") {
  Draw draw(6);
  std::set<Class> seen;
  int proved = 0, others = 0;
  for (int i = 0; i < 600; ++i) {
    const std::size_t contacts = draw.size(1, 3), n = 2 * contacts;
    Matrix A = draw.definite(n, draw.whole(1, 30));
    for (std::size_t r = 0; i % 2 == 0 && r < n; ++r) {  // symmetric
      for (std::size_t s = 0; s < r; ++s) A[r][s] = A[s][r] = (A[r][s] + A[s][r]) / 2;
    }
    std::vector<double> mu(contacts);
    for (double& x : mu) x = draw.whole(0, 40) / 8.0;
    MixedProblem p = problem(A, std::vector<double>(n), mu);
    Effort effort(1'000'000'000);
    const auto proof = prove_unique(p, effort);
    REQUIRE(proof.has_value() == (for_every_load(contact_problem(p)).verdict == EveryLoad::Verdict::unique));
    (proof ? proved : others) += 1;
    if (!proof) continue;
    seen.insert(proof->kind);
    CHECK(proves(*proof, p));
    for (int k = 0; k < 3; ++k) {
      p.c = draw.vector(n, -9, 9);
      CHECK(ContactSolver(contact_problem(p)).all()->one());
    }
  }
  CHECK(proved > 100);
  CHECK(others > 100);
  CHECK(seen == std::set<Class>{Class::bound, Class::determinants});
}

TEST_CASE("planar friction: known thresholds, and hundreds of contacts") {
  // One contact, W = [1 c; c 1]: the determinant of slip is 1 -+ mu c. The bound asks for 1 - mu^2 > c^2.
  const auto kind = [](double c, double mu) {
    Effort effort(1'000'000'000);
    const auto proof = prove_unique(problem({{1, c}, {c, 1}}, {0, 0}, {mu}), effort);
    return proof ? std::optional(proof->kind) : std::nullopt;
  };
  CHECK(kind(0.5, 0.75) == Class::bound);
  CHECK(kind(0.5, 0.875) == Class::determinants);
  CHECK(kind(0.5, 1.9375) == Class::determinants);
  CHECK(kind(0.5, 2) == std::nullopt);
  CHECK(kind(0.6, 0.8) == Class::determinants);  // the bound holds with equality, but for rounding
  CHECK(kind(1, 0) == std::nullopt);             // singular
  // With a skew part k the bound asks for 1 - mu^2 - 2 mu |k| > c^2: 1/2 for k = 1/4 and mu = 1/2.
  for (const double k : {0.25, -0.25}) {
    for (const auto& [c, expected] : {std::pair(0.703125, Class::bound), std::pair(0.71875, Class::determinants)}) {
      Effort effort(1'000'000'000);
      const auto proof = prove_unique(problem({{1, c + k}, {c - k, 1}}, {0, 0}, {0.5}), effort);
      REQUIRE(proof);
      CHECK(proof->kind == expected);
    }
  }

  MixedProblem chain = band_problem(1'000, {-1, 0, 3, 0, -1});
  chain.dimension = 2;
  chain.mu.assign(500, 0.25);  // 3 - 5 / 16 > 2
  Effort effort(10'000'000'000);
  const auto proof = prove_unique(chain, effort);
  REQUIRE(proof);
  CHECK(proof->kind == Class::bound);
  chain.mu[250] = 1;
  CHECK_FALSE(proves(*proof, chain));
  CHECK_FALSE(proves({Class::determinants, {}, proof->factor}, chain));  // beyond what is looked at
}

TEST_CASE("known matrices have their classes") {
  // [1 a; b 1] is a P-matrix for a b < 1, an H-matrix for |a b| < 1, definite for |a + b| < 2.
  CHECK(class_of({{1, 3}, {0.25, 1}}) == Class::dominant);
  CHECK(class_of({{1, 2}, {-2, 1}}) == Class::definite);
  CHECK(class_of({{1, 4}, {-1, 1}}) == Class::p_matrix);
  CHECK(class_of({{1, 2}, {2, 1}}) == std::nullopt);
  CHECK(nonpositive_minor(sparse({{1, 2}, {2, 1}})) == std::vector<std::size_t>{0, 1});
  CHECK(nonpositive_minor(sparse({{1, 2}, {-2, 0}})) == std::vector<std::size_t>{1});
  CHECK(!nonpositive_minor(sparse({{1, 4}, {-1, 1}})));
  // Murty's (1978), on which pivoting takes 2^n steps: a triangle.
  Matrix murty(12, std::vector<double>(12));
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t j = 0; j <= i; ++j) murty[i][j] = i == j ? 1 : 2;
  }
  CHECK(class_of(murty) == Class::dominant);
  CHECK(!nonpositive_minor(sparse(murty)));
  // The cyclic one of Cottle, Pang, Stone (1992), section 4.2.
  CHECK(class_of({{1, 2, 0}, {0, 1, 2}, {2, 0, 1}}) == Class::p_matrix);
  CHECK(class_of({}) == Class::dominant);
}

TEST_CASE("large matrices") {
  const auto proof = [](const MixedProblem& p) {
    Effort effort(10'000'000'000);
    return prove_unique(p, effort);
  };
  const MixedProblem chain = band_problem(20'000, {-1, 2, -1});  // sweeps would take n^2 of them
  REQUIRE(proof(chain));
  CHECK(proof(chain)->kind == Class::dominant);
  MixedProblem bent = band_problem(2'000, {-1, 2, -1});  // elimination from below leaves a_11 - 1 + 1 / n
  bent.A.value[0] = 1 - 0.99 / 2000;
  CHECK(proof(bent));
  bent.A.value[0] = 1 - 1.01 / 2000;
  CHECK(!proof(bent));
  const MixedProblem beam = band_problem(1'000, {1, -4, 6.001, -4, 1});
  REQUIRE(proof(beam));
  CHECK(proof(beam)->kind == Class::definite);
  CHECK(!proof(band_problem(1'000, {1, -4, 5.99, -4, 1})));

  Draw draw(3);
  const Matrix A = draw.definite(80, 1);
  CHECK(class_of(A) == Class::definite);
  Matrix singular = A;
  for (std::size_t i = 0; i < 80; ++i) singular[i][79] = i < 79 ? -A[79][i] : 0;  // the symmetric part has a row of 0
  CHECK(class_of(singular) == std::nullopt);
  Effort little(1000);
  CHECK(!prove_unique(problem(A, std::vector<double>(80)), little));
}

TEST_CASE("a factor is found nearly as long as a matrix is definite, and never longer") {
  for (std::size_t n = 2; n <= 16; ++n) {
    CAPTURE(n);
    const Matrix A = hilbert(n);
    Effort effort(10'000'000'000);
    const auto L = definite_factor(sparse(A), effort);
    if (n <= 11) CHECK(L);  // the eleventh leaves 5e-15: bounds of rounding errors are more than that
    if (L) CHECK(positive_definite(exact(A)));
    if (L) CHECK(is_definite(sparse(A), *L));
  }
  Draw draw(4);
  int found = 0;
  for (int i = 0; i < 300; ++i) {  // B^T B of low rank, and a little on the diagonal or off it
    const std::size_t n = draw.size(3, 6);
    const Matrix B = draw.matrix(n - 1, n, -3, 3);
    Matrix A(n, std::vector<double>(n));
    for (std::size_t r = 0; r < n; ++r) {
      for (std::size_t s = 0; s < n; ++s) {
        for (const auto& row : B) A[r][s] += row[r] * row[s];
      }
      A[r][r] += std::ldexp(draw.whole(-1, 3), -draw.whole(20, 50));
    }
    Effort effort(10'000'000'000);
    if (!std::all_of(A.begin(), A.end(),
                     [&](const auto& row) { return row[static_cast<std::size_t>(&row - A.data())] > 0; }))
      continue;
    const auto L = definite_factor(sparse(A), effort);
    if (L) REQUIRE(positive_definite(exact(A)));
    found += L ? 1 : 0;
  }
  CHECK(found > 30);
}

TEST_CASE("rounding does not decide") {
  const SparseMatrix L = sparse({{1, 0}, {1, 0}});  // L L^T is full of ones
  const double next = 1 + 0x1p-52;
  CHECK(!is_definite(sparse({{1, 0}, {0, 1}}), L));  // [1 -1; -1 1] is left
  CHECK(is_definite(sparse({{next, 0}, {0, next}}), L));
  CHECK(!is_definite(sparse({{next, 0}, {0, 1}}), L));
  // The last entry of A + A^T - L L^T is 1 - k 2^-56 - (1 - 2^-53)^2. In floating point it is 2^-52 for any k.
  for (const std::size_t k : {15U, 16U}) {
    Matrix A(17, std::vector<double>(17)), small = A;
    for (std::size_t i = 0; i < 16; ++i) A[i][i] = 1;
    A[16][16] = 0.5;
    for (std::size_t j = 0; j < k; ++j) small[16][j] = 0x1p-28;
    small[16][16] = 1 - 0x1p-53;
    CHECK(is_definite(sparse(A), sparse(small)) == (k == 15));
  }
  CHECK(is_dominant(sparse({{next, 1}, {1, next}}), std::vector<double>{1, 1}));
  CHECK(!is_dominant(sparse({{next, 1}, {1, next}}), std::vector<double>{1, next}));
  CHECK(!is_dominant(sparse({{1, 1}, {0, 1}}), std::vector<double>{1, 1}));
  const double tiny = std::numeric_limits<double>::denorm_min();
  CHECK(is_dominant(sparse({{tiny, 0}, {0, tiny}}), std::vector<double>{tiny, tiny}));  // whose products underflow
  CHECK(!is_definite(sparse({{tiny, tiny}, {tiny, tiny}}), sparse({{tiny, 0}, {0, tiny}})));
  CHECK(!is_definite(sparse({{1e300, 0}, {0, 1e300}}), sparse({{1e200, 0}, {0, 1e200}})));  // whose squares overflow
}

TEST_CASE("forged proofs fail") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const MixedProblem wide = problem({{1, 3}, {0.25, 1}}, {0, 0});
  const auto dominant = [&](std::vector<double> d) { return proves({Class::dominant, std::move(d), {}}, wide); };
  CHECK(dominant({3.5, 1}));
  for (const auto& d : std::vector<std::vector<double>>{
           {3, 1}, {4, 1}, {-3.5, -1}, {3.5, 0}, {nan, 1}, {3.5, infinity}, {3.5}, {3.5, 1, 1}, {}}) {
    CHECK(!dominant(d));
  }
  CHECK(!proves({Class::dominant, {1, 1}, {}}, problem({{-2, 1}, {1, 2}}, {0, 0})));
  CHECK(!proves({Class::dominant, {1, 1}, {}}, problem({{2, 1}, {1, 2}}, {0, 0}, {0})));  // friction

  CHECK(!proves({Class::dominant, {1}, {}}, problem({{infinity}}, {0})));
  CHECK(!proves({Class::p_matrix, {}, {}}, problem({{nan}}, {0})));

  Draw draw(5);
  const Matrix A = draw.definite(20, 1);
  const MixedProblem p = problem(A, std::vector<double>(20));
  const UniqueProof proof = *proof_of(A);
  REQUIRE(proof.kind == Class::definite);
  REQUIRE(proves(proof, p));
  for (std::size_t k = 0; k < proof.factor.entries(); k += 7) {
    for (const double factor : {0.5, -1.5, 1.1, nan, infinity}) {
      UniqueProof forged = proof;
      forged.factor.value[k] = factor * forged.factor.value[k] + 0.5;
      CHECK(!proves(forged, p));
    }
  }
  UniqueProof upper = proof;
  upper.factor = transposed(upper.factor);
  CHECK(!proves(upper, p));
  CHECK(is_definite(sparse({{1, 0}, {0, 1}}), sparse({{1, 0}, {0.5, 1}})));
  CHECK(!is_definite(sparse({{1, 0}, {0, 1}}), sparse({{1, 0.5}, {0, 1}})));  // true, but not in the form of a factor
  UniqueProof smaller = proof;
  smaller.factor = sparse({{1}});
  CHECK(!proves(smaller, p));

  const MixedProblem contact = problem({{1, 0.5}, {0.5, 1}}, {0, 0}, {0.75}),
                     steep = problem({{1, 0.5}, {0.5, 1}}, {0, 0}, {2});
  Effort effort(1'000'000);
  const SparseMatrix lowered = prove_unique(contact, effort)->factor, whole = *definite_factor(contact.A, effort);
  CHECK(proves({Class::bound, {}, lowered}, contact));
  CHECK(proves({Class::determinants, {}, whole}, contact));
  CHECK_FALSE(proves({Class::bound, {}, whole}, contact));
  CHECK_FALSE(proves({Class::bound, {}, lowered}, steep));
  CHECK_FALSE(proves({Class::determinants, {}, whole}, steep));
  CHECK_FALSE(proves({Class::determinants, {}, sparse({{1, 0}, {0, 3}})}, contact));
  CHECK_FALSE(proves({Class::definite, {}, whole}, contact));
  CHECK_FALSE(proves({Class::bound, {}, lowered}, problem({{1, 0.75}, {0.25, 1}}, {0, 0}, {0.75})));

  const MixedProblem two = problem({{1, 2}, {2, 1}}, {-1, -1});
  for (const Class kind : {Class::dominant, Class::definite, Class::p_matrix}) {
    CHECK(!proves({kind, {1, 1}, sparse({{1, 0}, {0, 1}})}, two));
  }
  CHECK(proves({Class::p_matrix, {}, {}}, problem({{1, 4}, {-1, 1}}, {0, 0})));
  CHECK(!proves({Class::p_matrix, {}, {}},
                band_problem(max_minors_size + 1, {1})));  // is one, but beyond what is looked at
}
