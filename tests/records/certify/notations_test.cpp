// One problem and one answer have one verdict, in whatever notation and units they are written.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "base/number/binary64.hpp"
#include "base/number/dice.hpp"
#include "contact/problem/solutions.hpp"
#include "support/certified.hpp"
#include "support/how_many.hpp"

using namespace slipproof;
using namespace slipproof::test;
using Json = nlohmann::json;

namespace notations {

namespace {

using Rows = std::vector<std::vector<double>>;
using Numbers = std::vector<double>;

/// Bodies with the masses M, which are powers of two, so that the local form is exact: M v = H r + f, u = H^T v + w.
struct Bodies {
  Numbers M, f, w, mu;
  Rows H;  ///< a row for each coordinate of a body
  std::vector<bool> turns;
  bool frictional() const { return !mu.empty(); }
  std::size_t components() const { return w.size(); }
};

std::size_t below(Dice& dice, std::size_t n) {
  return static_cast<std::size_t>(dice.number(0, static_cast<int>(n) - 1));
}

template <std::size_t n>
double one_of(Dice& dice, const std::array<double, n>& values) {
  return values[below(dice, n)];
}

Bodies random_bodies(Dice& dice) {
  Bodies b;
  const std::size_t contacts = static_cast<std::size_t>(dice.number(1, 2)), coordinates = contacts + 2;
  const bool frictional = !dice.chance(3);
  const std::size_t n = frictional ? 2 * contacts : contacts + 1;
  for (std::size_t i = 0; i < coordinates; ++i) {
    b.M.push_back(std::ldexp(1, dice.number(-2, 2)));
    b.f.push_back(dice.number(-9, 9));
    b.turns.push_back(i + 1 == coordinates);
    b.H.emplace_back();
    for (std::size_t j = 0; j < n; ++j) b.H.back().push_back(dice.chance(3) ? 0 : dice.number(-3, 3));
  }
  for (std::size_t j = 0; j < n; ++j) b.w.push_back(dice.number(-4, 4));
  for (std::size_t k = 0; frictional && k < contacts; ++k)
    b.mu.push_back(one_of(dice, std::array{0.0, 0.25, 1.0, 4.0}));
  return b;
}

/// In units whose mass, length and time are these powers of two of the old ones.
struct Units {
  int mass = 0, length = 0, time = 0;
  double speed(double x) const { return std::ldexp(x, length - time); }
  double impulse(double x) const { return std::ldexp(x, mass + length - time); }
  double compliance(double x) const { return std::ldexp(x, -mass); }
};

Bodies in_units(Bodies b, const Units& units) {
  for (std::size_t i = 0; i < b.M.size(); ++i) {
    const int arm = b.turns[i] ? units.length : 0;
    b.M[i] = std::ldexp(b.M[i], units.mass + 2 * arm);
    b.f[i] = std::ldexp(units.impulse(b.f[i]), arm);
    for (double& h : b.H[i]) h = std::ldexp(h, arm);
  }
  for (double& w : b.w) w = units.speed(w);
  return b;
}

struct Local {
  Rows W;
  Numbers q;
};

Local local_form(const Bodies& b) {
  const std::size_t n = b.components();
  Local local{Rows(n, Numbers(n)), b.w};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t c = 0; c < b.M.size(); ++c) {
      local.q[i] += b.H[c][i] * b.f[c] / b.M[c];
      for (std::size_t j = 0; j < n; ++j) local.W[i][j] += b.H[c][i] * b.H[c][j] / b.M[c];
    }
  }
  return local;
}

ContactProblem exact(const Local& local, const Numbers& mu) {
  ContactProblem problem;
  for (const Numbers& row : local.W) {
    problem.W.emplace_back();
    for (const double x : row) problem.W.back().push_back(to_rational(x));
  }
  for (const double x : local.q) problem.q.push_back(to_rational(x));
  for (const double x : mu) problem.mu.push_back(to_rational(x));
  return problem;
}

Json sparse(const Rows& rows) {
  Json entries = Json::array();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      if (rows[i][j] != 0) entries.push_back({i, j, rows[i][j]});
    }
  }
  return {{"rows", rows.size()}, {"columns", rows.empty() ? 0 : rows[0].size()}, {"entries", entries}};
}

Json dense_line(const Bodies& b, const Numbers& z, const Numbers& u) {
  const Local local = local_form(b);
  Json line{{"W", local.W}, {"q", local.q}, {"z", z}};
  if (b.frictional()) line["mu"] = b.mu;
  if (!u.empty()) line["w"] = u;
  return line;
}

Json sparse_line(const Bodies& b, const Numbers& z, const Numbers& u) {
  Json line = dense_line(b, z, u);
  line["W"] = sparse(local_form(b).W);
  if (b.frictional()) line["dimension"] = 2;
  return line;
}

Json global_line(const Bodies& b, const Numbers& r, const Numbers& u, bool with_v) {
  Rows M(b.M.size(), Numbers(b.M.size()));
  Numbers v;
  for (std::size_t i = 0; i < b.M.size(); ++i) {
    M[i][i] = b.M[i];
    double momentum = b.f[i];
    for (std::size_t j = 0; j < r.size(); ++j) momentum += b.H[i][j] * r[j];
    v.push_back(momentum / b.M[i]);
  }
  Json line{{"M", sparse(M)}, {"H", b.H}, {"f", b.f}, {"w", b.w}, {"mu", b.mu}, {"dimension", 2}, {"r", r}};
  if (with_v) line["v"] = v;
  if (!u.empty()) line["u"] = u;
  return line;
}

/// The same in space: across the plane nothing pushes, and each contact has a compliance of its own.
Json spatial_line(const Bodies& b, const Numbers& r, const Numbers& u, double compliance) {
  const Local local = local_form(b);
  const std::size_t n = local.q.size() / 2 * 3;
  const auto place = [](std::size_t i) { return i / 2 * 3 + i % 2; };
  Rows W(n, Numbers(n));
  Numbers q(n), forces(n), speeds(n);
  for (std::size_t k = 2; k < n; k += 3) W[k][k] = compliance;
  for (std::size_t i = 0; i < local.q.size(); ++i) {
    q[place(i)] = local.q[i];
    forces[place(i)] = r[i];
    if (!u.empty()) speeds[place(i)] = u[i];
    for (std::size_t j = 0; j < local.q.size(); ++j) W[place(i)][place(j)] = local.W[i][j];
  }
  Json line{{"W", W}, {"q", q}, {"mu", b.mu}, {"dimension", 3}, {"r", forces}};
  if (!u.empty()) line["u"] = speeds;
  return line;
}

std::string verdict(const Json& line) {
  CertifyOptions options;
  options.format = RecordFormat::json_lines;
  options.threads = 1;
  const Certified found = certified(line.dump() + "\n", options);
  const std::string word = found.lines().at(0)["verdict"];
  static const std::map<std::string, std::string> same{{"unique", "certified"},
                                                       {"solution within rho", "certified"},
                                                       {"eps-solution", "inaccurate"},
                                                       {"not converged", "inaccurate"},
                                                       {"no solution", "wrong"}};
  const auto at = same.find(word);
  return at == same.end() ? word : at->second;
}

double largest(const Numbers& values) {
  double result = 0;
  for (const double x : values) result = std::max(result, std::abs(x));
  return result;
}

/// Exact solutions, rounded, and one of each continuum; whether there is only one, and whether it is strict.
struct Known {
  std::vector<Numbers> z, w;
  bool one = false, strict = true;
};

Known solutions_of(const Bodies& b) {
  const ContactProblem problem = exact(local_form(b), b.mu);
  const ContactSolutions all = ContactSolver(problem).all().value();
  Known known;
  const auto rounded = [](const std::vector<Rational>& values) {
    Numbers result;
    for (const Rational& x : values) result.push_back(nearest_binary64(x));
    return result;
  };
  for (const ContactSolution& s : all.solutions) {
    known.z.push_back(rounded(s.z));
    known.w.push_back(rounded(s.w));
    known.strict = known.strict && s.strict;
  }
  Effort effort(1'000'000'000);
  for (const ContactContinuum& c : all.continua) {
    const std::vector<Rational> member = c.two(effort)[0];
    known.z.push_back(rounded(member));
    known.w.push_back(rounded(accelerations(problem, member)));
  }
  known.one = all.one();
  return known;
}

}  // namespace

TEST_CASE("one problem and answer have one verdict in every notation and in all units") {
  const std::size_t problems = test::how_many<std::size_t>("SLIPPROOF_NOTATIONS", test::quick(150, 40));
  std::map<std::string, int> seen;
  for (std::size_t i = 0; i < problems; ++i) {
    CAPTURE(i);
    Dice dice(12, i);
    const Bodies b = random_bodies(dice);
    const Known known = solutions_of(b);
    Numbers z(b.components()), u;
    double off = 1;
    if (!known.z.empty()) {
      const std::size_t which = below(dice, known.z.size());
      z = known.z[which];
      if (dice.chance(3)) u = known.w[which];
      off = one_of(dice, std::array{0.0, 1e-8, 1e-4, 0.3});
      z[below(dice, z.size())] += (dice.chance(2) ? off : -off) * largest(z);
    }
    const std::string expected = verdict(dense_line(b, z, u));
    CAPTURE(dense_line(b, z, u).dump());
    ++seen[expected];
    // What the distance from the solution says, where there is one and it is not 0.
    if (known.one && largest(known.z[0]) > 0 && off < 0.1) {
      CHECK(expected == (off < 1e-6 ? "certified" : "inaccurate"));
    }
    std::vector<Units> systems{{}, {20, 0, 0}, {-20, 0, 0}, {0, 10, 0}, {0, 0, -10}};
    systems.push_back({dice.number(-20, 20), dice.number(-20, 20), dice.number(-20, 20)});
    for (const Units& units : systems) {
      CAPTURE(units.mass);
      CAPTURE(units.length);
      CAPTURE(units.time);
      const Bodies scaled = in_units(b, units);
      Numbers r = z, speeds = u;
      for (double& x : r) x = units.impulse(x);
      for (double& x : speeds) x = units.speed(x);
      CHECK(verdict(dense_line(scaled, r, speeds)) == expected);
      CHECK(verdict(sparse_line(scaled, r, speeds)) == expected);
      if (!b.frictional()) continue;
      CHECK(verdict(global_line(scaled, r, speeds, false)) == expected);
      CHECK(verdict(global_line(scaled, r, speeds, true)) == expected);
      // In space borders cannot be decided where contacts slide, and other solutions are not all found.
      if (known.one && known.strict && largest(z) > 0) {
        CHECK(verdict(spatial_line(scaled, r, speeds, units.compliance(1))) == expected);
      }
    }
  }
  for (const char* word : {"certified", "ambiguous", "inaccurate", "wrong"}) CHECK(seen[word] > problems / 100);
}

TEST_CASE("a radius as large as the answer certifies nothing, and small masses make no right answer wrong") {
  const auto point = [](double mass, const Numbers& f, const Numbers& r) {
    const Rows identity{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    Rows M = identity;
    for (std::size_t i = 0; i < 3; ++i) M[i][i] = mass;
    return Json{{"M", M}, {"H", identity}, {"f", f}, {"w", {0, 0, 0}}, {"mu", {0.5}}, {"dimension", 3}, {"r", r}};
  };
  CHECK(verdict(point(1e7, {-1e7, 1e6, 0}, {2e7, -1e6, 0})) == "wrong");
  CHECK(verdict(point(1e7, {-1e7, 1e6, 0}, {1e7, -1e6, 0})) == "certified");
  CHECK(verdict(point(1e7, {-1e7, 1e6, 0}, {1.0001e7, -1e6, 0})) == "inaccurate");
  CHECK(verdict(point(1e-6, {-1e-6, 1e-7, 0}, {1e-6 * (1 + 1e-9), -1e-7, 0})) == "certified");
  CHECK(verdict(point(1e-6, {-1e-6, 1e-7, 0}, {1.0001e-6, -1e-7, 0})) == "inaccurate");
  CHECK(verdict(point(1e-6, {-1e-6, 1e-7, 0}, {2e-6, -1e-7, 0})) == "wrong");
}

TEST_CASE("the shipped problem has one verdict in its four notations") {
  std::ifstream file(std::string(SLIPPROOF_SOURCE_DIR) + "/cases/contact-problems/notations.jsonl");
  int lines = 0;
  for (std::string line; std::getline(file, line); ++lines) {
    CHECK(verdict(Json::parse(line)) == (lines < 4 ? "certified" : "wrong"));
  }
  CHECK(lines == 8);
}

TEST_CASE("a dense matrix and a sparse one are judged by the same tolerance") {
  const Json dense{{"W", {{2, 1}, {1, 2}}}, {"q", {-5, -6}}, {"z", {1.33333335, 2.33333333}}};
  Json other = dense;
  other["W"] = sparse({{2, 1}, {1, 2}});
  CHECK(verdict(dense) == "certified");
  CHECK(verdict(other) == "certified");
  other["z"] = {1.3333, 2.3333};
  CHECK(verdict(other) == "inaccurate");
}

}  // namespace notations
