#include "contact/problem/solutions.hpp"

#include <doctest/doctest.h>

#include <random>
#include <set>

#include "support/bicycle/motions.hpp"
#include "support/eigen_rational.hpp"
#include "support/scenes/bicycle_scenes.hpp"
#include "support/scenes/random_scene.hpp"

using namespace slipproof;

namespace {

using ExactMatrix = Eigen::Matrix<Rational, Eigen::Dynamic, Eigen::Dynamic>;

class RandomProblems {
 public:
  explicit RandomProblems(std::uint64_t seed) : engine_(seed) {}
  Rational fraction(int size, int denominator) {
    const auto span = static_cast<std::uint64_t>(2 * size + 1);
    return Rational(static_cast<int>(engine_() % span) - size,
                    1 + static_cast<int>(engine_() % static_cast<std::uint64_t>(denominator)));
  }
  ContactProblem lcp(std::size_t n, int size, int denominator) {
    ContactProblem p;
    for (std::size_t i = 0; i < n; ++i) {
      p.W.emplace_back();
      for (std::size_t j = 0; j < n; ++j) p.W.back().push_back(fraction(size, denominator));
      p.q.push_back(fraction(size, denominator));
    }
    return p;
  }
  /// A matrix B^T B + I, times -1 for the skew part that leaves it definite.
  ContactProblem definite(std::size_t n) {
    ContactProblem b = lcp(n, 3, 4), p = b;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        p.W[i][j] = i == j ? 1 : i < j ? b.W[i][j] : Rational(-b.W[j][i]);
        for (std::size_t k = 0; k < n; ++k) p.W[i][j] += b.W[k][i] * b.W[k][j];
      }
    }
    return p;
  }

 private:
  std::mt19937_64 engine_;
};

/// All solutions of an LCP from the 2n equations w - M z = q, z_i = 0 or w_i = 0; nothing if one of these is singular.
std::optional<std::set<std::vector<Rational>>> by_full_pivoting(const ContactProblem& p) {
  const auto n = static_cast<int>(p.size());
  std::set<std::vector<Rational>> found;
  for (int basis = 0; basis < 1 << n; ++basis) {
    ExactMatrix A = ExactMatrix::Zero(2 * n, 2 * n), b = ExactMatrix::Zero(2 * n, 1);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) A(i, j) = -p.W[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      A(i, n + i) = 1;
      b(i, 0) = p.q[static_cast<std::size_t>(i)];
      A(n + i, (basis >> i & 1) != 0 ? n + i : i) = 1;
    }
    Eigen::FullPivLU<ExactMatrix> lu(A);
    lu.setThreshold(Rational(0));
    if (lu.rank() < 2 * n) return std::nullopt;
    const ExactMatrix x = lu.solve(b);
    bool fits = true;
    for (int i = 0; i < 2 * n; ++i) fits = fits && x(i, 0) >= 0;
    if (!fits) continue;
    std::vector<Rational> z;
    for (int i = 0; i < n; ++i) z.push_back(x(i, 0));
    found.insert(z);
  }
  return found;
}

/// The definition: whether z solves a problem in a mode.
bool solves(const ContactProblem& p, const ProblemMode& mode, const std::vector<Rational>& z) {
  const auto w = accelerations(p, z);
  for (std::size_t i = 0; i < mode.size(); ++i) {
    if (!p.frictional()) {
      const bool open = mode[i] == ElementState::lift;
      if (open ? z[i] != 0 || w[i] < 0 : w[i] != 0 || z[i] < 0) return false;
      continue;
    }
    const Rational &N = z[2 * i], &T = z[2 * i + 1], &gap = w[2 * i], &slip = w[2 * i + 1];
    const Rational limit = p.mu[i] * N;
    const bool fits = mode[i] == ElementState::lift            ? N == 0 && T == 0 && gap >= 0
                      : mode[i] == ElementState::stick         ? gap == 0 && slip == 0 && N >= 0 && abs(T) <= limit
                      : mode[i] == ElementState::slip_forward  ? gap == 0 && T == -limit && N >= 0 && slip >= 0
                      : mode[i] == ElementState::slip_backward ? gap == 0 && T == limit && N >= 0 && slip <= 0
                                                               : false;
    if (!fits) return false;
  }
  return true;
}

std::set<std::vector<Rational>> points(const ContactSolutions& all) {
  std::set<std::vector<Rational>> z;
  for (const auto& s : all.solutions) z.insert(s.z);
  return z;
}

/// Friction as an LCP: (N, S+, S-, gamma) of each contact, against (gap, slip + gamma, -slip + gamma, mu N - S+ - S-).
ContactProblem as_lcp(const ContactProblem& p) {
  const std::size_t n = 4 * p.contacts();
  ContactProblem lcp{RationalMatrix(n, std::vector<Rational>(n)), std::vector<Rational>(n), {}};
  for (std::size_t i = 0; i < p.contacts(); ++i) {
    const auto put = [&](std::size_t row, std::size_t from, int sign) {
      for (std::size_t j = 0; j < p.contacts(); ++j) {
        lcp.W[row][4 * j] = sign * p.W[from][2 * j];
        lcp.W[row][4 * j + 1] = sign * p.W[from][2 * j + 1];
        lcp.W[row][4 * j + 2] = -sign * p.W[from][2 * j + 1];
      }
      lcp.q[row] = sign * p.q[from];
    };
    put(4 * i, 2 * i, 1);
    put(4 * i + 1, 2 * i + 1, 1);
    put(4 * i + 2, 2 * i + 1, -1);
    lcp.W[4 * i + 1][4 * i + 3] = lcp.W[4 * i + 2][4 * i + 3] = 1;
    lcp.W[4 * i + 3][4 * i] = p.mu[i];
    lcp.W[4 * i + 3][4 * i + 1] = lcp.W[4 * i + 3][4 * i + 2] = -1;
  }
  return lcp;
}

}  // namespace

TEST_CASE("all solutions of an LCP are those of another algorithm on other equations") {
  RandomProblems draw(11);
  std::size_t compared = 0, none = 0, several = 0;
  for (int trial = 0; trial < 250; ++trial) {
    const ContactProblem p = draw.lcp(1 + static_cast<std::size_t>(trial) % 4, 6, 3);
    const auto expected = by_full_pivoting(p);
    if (!expected) continue;
    const auto all = ContactSolver(p).all();
    REQUIRE(all);
    CHECK(all->continua.empty());
    CHECK(points(*all) == *expected);
    for (const auto& s : all->solutions) {
      CHECK(s.w == accelerations(p, s.z));
      for (const auto& mode : s.modes) CHECK(solves(p, mode, s.z));
    }
    ++compared;
    none += expected->empty() ? 1 : 0;
    several += expected->size() > 1 ? 1 : 0;
  }
  CHECK(compared > 100);
  CHECK(none > 10);
  CHECK(several > 10);
}

TEST_CASE("the contacts of a bicycle have the solutions that its motions are") {
  test::RandomScenes random(61);
  std::size_t motions = 0, several = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const auto bicycle = random.bicycle(true);
    const auto road = random.road();
    const ForceKind kind = trial % 2 == 0 ? ForceKind::internal : ForceKind::external;
    const ModeTable table(bicycle, road, kind);
    std::vector<Rational> forces{random.any()};
    for (const Cell& cell : partition(table)) forces.push_back(cell.forces.sample());
    for (const Rational& F : forces) {
      const auto found = motions_at(table, F);
      const ContactProblem problem = test::contacts_of(bicycle, road, kind, F);
      CHECK(mistake_in(problem).empty());
      const auto all = ContactSolver(problem).all();
      REQUIRE(all);
      CHECK(all->continua.size() == found.continua.size());
      if (!found.continua.empty()) continue;
      REQUIRE(all->solutions.size() == found.motions.size());
      for (const auto& motion : found.motions) {
        const std::vector<Rational> z{motion.values[Quantity::N2], motion.values[Quantity::S2],
                                      motion.values[Quantity::N3], motion.values[Quantity::S3]};
        const auto same = std::find_if(all->solutions.begin(), all->solutions.end(),
                                       [&](const ContactSolution& s) { return s.z == z; });
        REQUIRE(same != all->solutions.end());
        CHECK(same->strict == motion.strict);
        std::set<std::string> modes, expected;
        for (const auto& mode : same->modes) modes.insert(name(problem, mode));
        for (const auto& mode : motion.modes) expected.insert(name(mode));
        CHECK(modes == expected);
        ++motions;
      }
      several += found.motions.size() > 1 ? 1 : 0;
    }
  }
  CHECK(motions > 500);
  CHECK(several > 5);
}

TEST_CASE("friction as an LCP has the same contact forces") {
  RandomProblems draw(12);
  std::size_t compared = 0;
  for (int trial = 0; trial < 120; ++trial) {
    ContactProblem p = draw.definite(2 * (1 + static_cast<std::size_t>(trial % 6 == 0)));
    for (std::size_t i = 0; i < p.size() / 2; ++i) p.mu.push_back(abs(draw.fraction(4, 3)));
    const auto all = ContactSolver(p).all();
    const ContactProblem lcp = as_lcp(p);
    const auto other = ContactSolver(lcp).all();
    REQUIRE(all);
    REQUIRE(other);
    if (!all->continua.empty()) continue;
    std::set<std::vector<Rational>> forces;
    const auto insert = [&](const std::vector<Rational>& z) {
      std::vector<Rational> contact;
      for (std::size_t i = 0; i < z.size(); i += 4) {
        contact.push_back(z[i]);
        contact.push_back(z[i + 1] - z[i + 2]);
      }
      forces.insert(contact);
    };
    for (const auto& s : other->solutions) insert(s.z);
    // Without friction, or off the ground, gamma, S+ and S- are not determined; the forces are.
    for (const auto& c : other->continua) {
      insert(c.at(minimize({0, std::vector<Rational>(c.directions.size())}, c.conditions).x));
    }
    CHECK(forces == points(*all));
    ++compared;
  }
  CHECK(compared > 100);
}

TEST_CASE("a definite matrix has one solution, found without trying all modes") {
  RandomProblems draw(13);
  for (std::size_t n = 1; n <= 8; ++n) {
    const ContactProblem p = draw.definite(n);
    const ContactSolver solver(p);
    const auto all = solver.all();
    REQUIRE(all);
    REQUIRE(all->one());
    for (const ElementState start : {ElementState::touch, ElementState::lift}) {
      const auto only = solver.unique_solution(ProblemMode(n, start));
      REQUIRE(only);
      CHECK(only->z == all->solutions.front().z);
    }
  }
  const ContactProblem large = draw.definite(20);
  const ContactSolver solver(large);
  CHECK_FALSE(solver.all());
  const auto only = solver.unique_solution(ProblemMode(20, ElementState::touch));
  REQUIRE(only);
  CHECK(solves(large, only->modes.front(), only->z));
  ContactProblem indefinite = large;
  indefinite.W[7][7] = 0;
  CHECK_FALSE(positive_definite(indefinite.W));
  CHECK_FALSE(ContactSolver(indefinite).unique_solution(ProblemMode(20, ElementState::touch)));
  CHECK(positive_definite({{1, 5}, {-5, 1}}));
  CHECK_FALSE(positive_definite({{1, 3}, {0, 1}}));
  CHECK_FALSE(positive_definite({{1, 1}, {1, 1}}));
}

TEST_CASE("a continuum is reported with its conditions, and one that shrinks to a point is a point") {
  // Two contacts carry one load: N1 + N2 = 1.
  const ContactProblem shared{{{1, 1}, {1, 1}}, {-1, -1}, {}};
  const auto all = ContactSolver(shared).all();
  REQUIRE(all);
  CHECK(all->solutions.empty());  // (1, 0) and (0, 1) are ends of the continuum
  REQUIRE(all->continua.size() == 1);
  CHECK(name(shared, all->continua[0].mode) == "zz");
  for (const Rational& t : {Rational(0), Rational(1, 3), Rational(1)}) {
    CHECK(solves(shared, all->continua[0].mode, all->continua[0].at({t})));
  }
  // N1 + N2 = 0 leaves nothing but N1 = N2 = 0.
  const ContactProblem idle{{{1, 1}, {1, 1}}, {0, 0}, {}};
  const auto point = ContactSolver(idle).all();
  REQUIRE(point);
  CHECK(point->one());
  CHECK(point->solutions.front().modes.size() == 4);
  CHECK(point->solutions.front().z == std::vector<Rational>{0, 0});
  // N1 + N2 = 1 and N1 + N2 = 2: no solution there.
  const ContactProblem torn{{{1, 1}, {1, 1}}, {-1, -2}, {}};
  const auto ends = ContactSolver(torn).all();
  REQUIRE(ends);
  CHECK(ends->continua.empty());
  CHECK(points(*ends) == std::set<std::vector<Rational>>{{0, 2}});
}

TEST_CASE("names of modes are read back, and nothing else is") {
  const ContactProblem lcp{{{1, 0}, {0, 1}}, {1, 1}, {}}, friction{{{1, 0}, {0, 1}}, {1, 1}, {1}};
  ContactProblem two = lcp;
  two.W = RationalMatrix(4, std::vector<Rational>(4));
  two.q.resize(4);
  two.mu = {1, 1};
  for (const char* text : {"zz", "zw", "wz", "ww"}) CHECK(name(lcp, *parse_mode(lcp, text)) == text);
  for (const char* text : {"stick", "slip+", "slip-", "lift"}) {
    CHECK(name(friction, *parse_mode(friction, text)) == text);
    CHECK(name(two, *parse_mode(two, std::string(text) + "/lift")) == std::string(text) + "/lift");
  }
  for (const char* text : {"", "z", "zzz", "zx", "z/w", "ZW"}) CHECK_FALSE(parse_mode(lcp, text));
  for (const char* text : {"", "stick/", "/stick", "stick/stick", "slip", "stick//lift"}) {
    CHECK_FALSE(parse_mode(friction, text));
  }
}

TEST_CASE("problems of a wrong shape or outside the domain are told") {
  const auto message = [](const ContactProblem& p) { return mistake_in(p); };
  CHECK(message({{}, {}, {}}) == "found 0 components of q, expected 1 to 64");
  CHECK(message({{{1}}, {1, 2}, {}}) == "found 1 rows of W, expected 2 as in q");
  CHECK(message({{{1, 2}, {1}}, {1, 2}, {}}) == "found 1 entries in row 2 of W, expected 2 as in q");
  CHECK(message({{{1}}, {1}, {1}}).starts_with("found 1 coefficients mu for 1 components of q"));
  CHECK(message({{{1, 0}, {0, 1}}, {1, 2}, {-1}}) == "found mu1 = -1, expected >= 0");
  CHECK(message({{{1, 0}, {0, 1}}, {1, 2}, {0}}).empty());
  const Rational tiny(1, Integer(1) << 100000U);
  CHECK(message({{{1, tiny}, {0, 1}}, {1, 2}, {}}).empty());  // how many digits are too many, an effort says
}
