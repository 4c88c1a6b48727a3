// Solutions that only rounding determines: found along paths, enclosed in long numbers, checked by others.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "base/number/dice.hpp"
#include "contact/convex/lawful_problem.hpp"
#include "contact/convex/second_reading.hpp"
#include "contact/formats/read_files.hpp"
#include "contact/judge/certificate.hpp"
#include "contact/judge/find/find.hpp"
#include "contact/judge/judge.hpp"
#include "contact/path/long_box.hpp"
#include "contact/path/solve.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

/// A rigid body of mass 1 and inertia 1 on points of a floor, pressed and pushed: W = H^T H in binary64, of rank 6.
MixedProblem body_on_floor(Dice& dice, std::size_t contacts) {
  const auto number = [&](int most) { return dice.number(-most, most) / 7.0; };
  const std::size_t n = 3 * contacts;
  std::vector<std::array<double, 6>> H;  // of each component: what it moves
  for (std::size_t k = 0; k < contacts; ++k) {
    const double x = number(9), y = number(9), z = -0.7;
    H.push_back({0, 0, 1, y, -x, 0});
    H.push_back({1, 0, 0, 0, z, -y});
    H.push_back({0, 1, 0, -z, 0, x});
  }
  const std::array<double, 6> free{number(2), number(2), -1, number(1) / 4, number(1) / 4, number(1) / 4};
  MixedProblem p;
  std::vector<double> W(n * n, 0);
  p.c.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t a = 0; a < 6; ++a) {
      for (std::size_t j = 0; j < n; ++j) W[i * n + j] += H[i][a] * H[j][a];
      p.c[i] += H[i][a] * free[a];
    }
  }
  p.A = from_dense(n, n, W);
  p.mu.assign(contacts, 0.4);
  return p;
}

/// A body of mass 1 and weight 10 on two points of a floor, on a line below its centre, up to rounding: so the force
/// that pushes the points apart, along this line, is not open.
MixedProblem body_on_two_points(Dice& dice, double before, double behind) {
  constexpr std::size_t free = 6, n = 12;
  const double angle = dice.number(0, 628) / 100.0;
  std::vector<std::array<double, free>> H;
  for (const double at : {-before, behind}) {
    const double x = at * std::cos(angle), y = at * std::sin(angle);
    H.push_back({0, 0, 1, y, -x, 0});
    H.push_back({1, 0, 0, 0, -0.5, -y});
    H.push_back({0, 1, 0, 0.5, 0, x});
  }
  std::vector<double> A(n * n, 0);
  for (std::size_t i = 0; i < free; ++i) {
    A[i * n + i] = i < 3 ? 1 : 1.0 / 6;
    for (std::size_t k = 0; k < free; ++k) {
      if (i > 2) H[k][i] *= 1 + dice.number(-1, 1) * 0x1p-52;
      A[i * n + free + k] = -H[k][i];
      A[(free + k) * n + i] = H[k][i];
    }
  }
  MixedProblem p;
  p.free = free;
  p.A = from_dense(n, n, A);
  p.c.assign(n, 0);
  p.c[2] = 10;
  p.mu.assign(2, 0.3);
  return p;
}

/// A number as a file has it that was printed with six digits.
double with_six_digits(double x) {
  return std::stod(fmt::format("{:.6g}", x));
}

/// Discs on each other and on the floor: W = H^T M^-1 H, printed with six digits, and hence indefinite.
MixedProblem printed_discs(Dice& dice, std::size_t discs, std::size_t contacts) {
  const std::size_t n = 2 * contacts, m = 3 * discs;
  std::vector<double> H(n * m, 0);
  for (std::size_t k = 0; k < contacts; ++k) {
    const auto any = [&](int least) { return dice.number(least, static_cast<int>(discs) - 1); };
    const int body = k < discs ? static_cast<int>(k) : any(0), other = k < discs ? body - 1 : any(-1);
    const double angle = 1.5707963 + dice.number(-100, 100) / 100.0, x = std::cos(angle), y = std::sin(angle);
    for (const auto& [disc, sign] : {std::pair(body, 1.0), std::pair(other, -1.0)}) {
      if (disc < 0) continue;
      const std::size_t at = 2 * k * m + 3 * static_cast<std::size_t>(disc);
      H[at] += sign * x;
      H[at + 1] += sign * y;
      H[at + m] -= sign * y;
      H[at + m + 1] += sign * x;
      H[at + m + 2] -= 0.5;
    }
  }
  MixedProblem p;
  p.dimension = 2;
  p.mu.assign(contacts, 0.5);
  std::vector<double> W(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    double weight = 0;
    for (std::size_t a = 1; a < m; a += 3) weight += H[i * m + a];
    p.c.push_back(with_six_digits(-weight / 1000));
    for (std::size_t j = 0; j < n; ++j) {
      double sum = 0;
      for (std::size_t a = 0; a < m; ++a) sum += H[i * m + a] * H[j * m + a] * (a % 3 == 2 ? 8 : 1);
      W[i * n + j] = with_six_digits(500 * sum);
    }
  }
  p.A = from_dense(n, n, W);
  return p;
}

}  // namespace

TEST_CASE("forces that only rounding determines are open, and the velocities are certified") {
  // By subtraction of their rows, r_2 = 2^50 (q_1 - q_2) = quarters / 4, whatever the answer says.
  for (const int quarters : {1, 2, 3}) {
    const MixedProblem p = one_place(2, {-1, 0, 0, -1 - quarters * 0x1p-52, 0, 0});
    for (const double r1 : {1.0, 0.625, 0.125}) {
      CAPTURE(quarters);
      CAPTURE(r1);
      const ContactJudgement j = judge_contacts(p, {r1, 0, 0, 1 - r1, 0, 0}, {}, {});
      REQUIRE(j.verdict == ContactVerdict::velocities_of_a_solution);
      REQUIRE(j.enclosure->proof);
      const Rational& r2 = j.enclosure->proof->center[j.enclosure->system.unknown(3)];
      CHECK(abs(r2 - Rational(quarters, 4)) <= to_rational(j.enclosure->proof->radius[3]));
      CHECK(j.eta <= 0x1p-50);
      CHECK(j.rho >= std::abs(1 - r1 - quarters / 4.0));
    }
    // The exact solution itself is as right as any.
    const ContactJudgement right = judge_contacts(p, {1 - quarters / 4.0, 0, 0, quarters / 4.0, 0, 0}, {}, {});
    CHECK(right.verdict == ContactVerdict::solution_within_rho);
  }
}

TEST_CASE("bodies on too many points: solutions are enclosed, and two checkers accept their certificates") {
  int far = 0, found = 0;
  for (std::uint64_t i = 0; i < 12; ++i) {
    Dice dice(77, i);
    const MixedProblem p = body_on_floor(dice, static_cast<std::size_t>(dice.number(4, 6)));
    const std::vector<double> x = approximate_solution(p);
    const ContactJudgement j = judge_contacts(p, x, {}, {});
    CAPTURE(i);
    CAPTURE(j.reason);
    if (!j.enclosure || !j.enclosure->proof) continue;
    ++found;
    far += j.verdict == ContactVerdict::velocities_of_a_solution;
    const std::string certificate = contact_certificate(p, j);
    CHECK(accepted(certificate));
    const std::size_t named = certificate.find("problem ");
    std::string text = certificate;
    text.erase(named, text.find('\n', named) - named);
    CHECK(second_reading(text) == "accepted");
  }
  MESSAGE("found " << found << ", far " << far);
  CHECK(found >= 6);
  CHECK(far >= 3);
}

TEST_CASE("a body on two points below its centre: one of them slides by less than 106 bits tell") {
  int found = 0;
  for (std::uint64_t i = 0; i < 20; ++i) {
    CAPTURE(i);
    Dice dice(79, i);
    const double before = dice.number(30, 130) / 100.0, behind = dice.number(50, 150) / 100.0;
    const MixedProblem p = body_on_two_points(dice, before, behind);
    const ContactJudgement j = judge_contacts(p, approximate_solution(p), {}, {});
    if (!j.enclosure) continue;
    ++found;
    CHECK(accepted(contact_certificate(p, j)));
    // By hand: the body does not move, so the points share its weight as a lever does.
    const std::vector<double> x = center_of(*j.enclosure);
    CHECK(x[6] == doctest::Approx(10 * behind / (before + behind)));
    CHECK(x[9] == doctest::Approx(10 * before / (before + behind)));
  }
  MESSAGE("found " << found);
  CHECK(found >= 17);
}

TEST_CASE("bodies on too many points: what is found without an answer is right up to rounding") {
  int right = 0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    Dice dice(78, i);
    const MixedProblem p = body_on_floor(dice, static_cast<std::size_t>(dice.number(4, 9)));
    const std::vector<double> x = approximate_solution(p);
    REQUIRE(x.size() == p.size());
    right += residual(p, x, exact_rows(p, x)).backward_error() <= 1e-13;
  }
  CHECK(right >= 38);
}

TEST_CASE("a few discs printed with six digits: most solutions are found, also where sweeps and paths end nowhere") {
  int found = 0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    Dice dice(80, i);
    const MixedProblem p = printed_discs(dice, 5, 10);
    const std::vector<double> x = approximate_solution(p);
    found += residual(p, x, exact_rows(p, x)).backward_error() <= 1e-12;
  }
  MESSAGE("found " << found);
  CHECK(found >= 35);
}

TEST_CASE("a certificate whose velocities are claimed too near is refused, by both") {
  const MixedProblem p = one_place(2, {-1, 0, 0, -1 - 0x1p-52, 0, 0});
  const ContactJudgement j = judge_contacts(p, {0.5, 0, 0, 0.5, 0, 0}, {}, {});
  REQUIRE(j.verdict == ContactVerdict::velocities_of_a_solution);
  std::string text = contact_certificate(p, j);
  const std::size_t named = text.find("problem ");
  text.erase(named, text.find('\n', named) - named);
  REQUIRE(accepted(text));
  REQUIRE(second_reading(text) == "accepted");
  const std::size_t at = text.find("velocities ") + 11, end = text.find('\n', at);
  for (const char* eta : {"0", "-1", "0x1p-60"}) {
    const std::string other = std::string(text).replace(at, end - at, eta);
    CHECK(!accepted(other));
    CHECK(second_reading(other) != "accepted");
  }
}

TEST_CASE("the shipped file has the verdict that its page says") {
  const ReadProblem read = read_problem_file(SLIPPROOF_SOURCE_DIR "/cases/contact-problems/open-forces.json");
  const ContactJudgement j = judge_contacts(mixed_problem(read.problem), read.answers.front().r, {}, {});
  REQUIRE(j.verdict == ContactVerdict::velocities_of_a_solution);
  CHECK(j.rho == doctest::Approx(0.125));
  CHECK(j.contacts == std::vector<std::size_t>{0, 1});
}

TEST_CASE("a real problem: OneObject of Siconos, whose solution is elsewhere") {
  const char* given = std::getenv("SLIPPROOF_SHARED");
  const std::filesystem::path shared = given != nullptr ? given : SLIPPROOF_SOURCE_DIR "/../shared/data";
  const auto file = shared / "siconos/OneObject-i1028-138.hdf5.dat";
  if (!std::filesystem::exists(file)) return;
  const MixedProblem p = coulomb_problem(read_problem_file(file.string()).problem);
  const std::vector<double> x = approximate_solution(p);
  const ContactJudgement j = judge_contacts(p, x, {}, {});
  CHECK(j.verdict == ContactVerdict::velocities_of_a_solution);
  CHECK(j.eta < 1e-13);
  CHECK(j.rho > 0.01);
  CHECK(accepted(contact_certificate(p, j)));
}

TEST_CASE("an end of a path is a solution only if the conditions of its mode hold") {
  const auto encloses = [](std::vector<double> q, ConeState state, std::vector<Rational> r, Rational slip = 0,
                           std::optional<ConeState> found = {}) {
    MixedProblem p;  // a point of mass 1, mu = 1/2
    p.A = from_dense(3, 3, std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1});
    p.c = std::move(q);
    p.mu = {0.5};
    Effort effort(1'000'000'000);
    const auto box = enclose_in_long_numbers(p, {ConeMode{state}, std::move(r), {std::move(slip)}}, effort);
    return box && box->system.mode() == ConeMode{found.value_or(state)};
  };
  using enum ConeState;
  CHECK(encloses({-10, 4, 0}, stick, {10, -4, 0}));
  CHECK_FALSE(encloses({-10, 6, 0}, stick, {10, -6, 0}));                   // outside the cone:
  CHECK(encloses({-10, 6, 0}, stick, {10, -6, 0}, 0, slide));               // it slides
  CHECK_FALSE(encloses({10, 0, 0}, stick, {-10, 0, 0}));                    // it pulls
  CHECK(encloses({-10, 6, 0}, slide, {10, -5, 0}, Rational(1, 5)));         // |u_T| = 1 over mu r_N = 5
  CHECK_FALSE(encloses({-10, 4, 0}, slide, {10, -5, 0}, Rational(-1, 5)));  // it would slide along its friction
  CHECK(encloses({1, 0, 0}, open, {0, 0, 0}));
  CHECK_FALSE(encloses({-1, 0, 0}, open, {0, 0, 0}));  // it goes into the floor
}
