// Solutions that only rounding determines: found along paths, enclosed in long numbers, checked by others.
#include <doctest/doctest.h>

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
  const auto encloses = [](std::vector<double> q, ConeState state, std::vector<Rational> r, Rational slip = 0) {
    MixedProblem p;  // a point of mass 1, mu = 1/2
    p.A = from_dense(3, 3, std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1});
    p.c = std::move(q);
    p.mu = {0.5};
    Effort effort(1'000'000'000);
    return enclose_in_long_numbers(p, {ConeMode{state}, std::move(r), {std::move(slip)}}, effort).has_value();
  };
  using enum ConeState;
  CHECK(encloses({-10, 4, 0}, stick, {10, -4, 0}));
  CHECK_FALSE(encloses({-10, 6, 0}, stick, {10, -6, 0}));                   // outside the cone
  CHECK_FALSE(encloses({10, 0, 0}, stick, {-10, 0, 0}));                    // it pulls
  CHECK(encloses({-10, 6, 0}, slide, {10, -5, 0}, Rational(1, 5)));         // |u_T| = 1 over mu r_N = 5
  CHECK_FALSE(encloses({-10, 4, 0}, slide, {10, -5, 0}, Rational(-1, 5)));  // it would slide along its friction
  CHECK(encloses({1, 0, 0}, open, {0, 0, 0}));
  CHECK_FALSE(encloses({-1, 0, 0}, open, {0, 0, 0}));  // it goes into the floor
}
