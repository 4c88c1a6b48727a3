// Stacks of boxes at rest: their forces are open, and a solver leaves some of them at the edge of their cones.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/enclosure/dependence.hpp"
#include "contact/judge/certificate.hpp"
#include "contact/judge/find/find.hpp"
#include "contact/judge/judge.hpp"
#include "contact/ranges/forces_inside.hpp"
#include "proofs/check_contact/record.hpp"

using namespace slipproof;

namespace {

using Point = std::array<double, 3>;

/// Boxes of size 1 and mass 1, each a little aside of the one below, on their corners; mu = 1/2. A push to the side
/// acts on each of them. In dimension 2 x and z are left of space.
class Stack {
 public:
  Stack(std::size_t boxes, std::size_t dimension, double push) : d_(dimension), own_(dimension == 3 ? 6 : 3) {
    p_.dimension = dimension;
    p_.free = own_ * boxes;
    for (std::size_t k = 0; k < boxes; ++k) {
      for (std::size_t i = 0; i < own_; ++i) add(own_ * k + i, own_ * k + i, i < d_ ? 1 : 0.125);
      p_.c.insert(p_.c.end(), own_, 0);
      p_.c[own_ * k] = -push;
      p_.c[own_ * k + d_ - 1] = 10;
    }
    for (std::size_t k = 0; k < boxes; ++k) {
      for (const double x : {-0.4375, 0.4375}) {
        for (const double y : {-0.4375, 0.4375}) {
          if (d_ == 3 || y > 0) touch(k, {x, d_ == 3 ? y : 0, 0});
        }
      }
    }
    std::vector<MatrixEntry> twice;
    p_.A = sparse_matrix(p_.c.size(), p_.c.size(), entries_, twice);
  }

  const MixedProblem& problem() const { return p_; }

 private:
  void add(std::size_t row, std::size_t column, double value) {
    entries_.push_back({static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column), value});
  }

  /// Box k and the one below, at a point that is given from the middle of the lower face of box k.
  void touch(std::size_t k, const Point& at) {
    const double aside = k % 2 == 0 ? 0.03125 : -0.03125;
    const std::array<Point, 3> axes{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}};
    for (std::size_t t = 0; t < d_; ++t) {
      const std::size_t row = p_.c.size();
      p_.c.push_back(0);
      push(row, k, axes[t], {at[0], at[1], -0.5}, 1);
      if (k > 0) push(row, k - 1, axes[t], {at[0] + aside, at[1], 0.5}, -1);
    }
    p_.mu.push_back(0.5);
  }

  void push(std::size_t row, std::size_t k, const Point& n, const Point& arm, double sign) {
    const Point turn{arm[1] * n[2] - arm[2] * n[1], arm[2] * n[0] - arm[0] * n[2], arm[0] * n[1] - arm[1] * n[0]};
    const std::array<double, 6> space{n[0], n[1], n[2], turn[0], turn[1], turn[2]}, plane{n[0], n[2], turn[1], 0, 0, 0};
    for (std::size_t i = 0; i < own_; ++i) {
      const double h = sign * (d_ == 3 ? space[i] : plane[i]);
      if (h == 0) continue;
      add(own_ * k + i, row, -h);
      add(row, own_ * k + i, h);
    }
  }

  const std::size_t d_, own_;
  MixedProblem p_;
  std::vector<MatrixEntry> entries_;
};

std::vector<double> solved(const MixedProblem& problem) {
  return approximate_solution(problem);
}

bool is_accepted(const MixedProblem& problem, const ContactJudgement& judgement) {
  const std::string certificate = contact_certificate(problem, judgement);
  return check_contact::checked_on_record(certificate).kind == check_contact::ContactVerdict::Kind::accepted;
}

}  // namespace

TEST_CASE("a stack at rest has a solution within rho, whatever its forces") {
  for (const std::size_t boxes : {1U, 2U, 3U, 6U, 9U}) {  // of few all solutions are known
    const Stack stack(boxes, 2, 0);
    const ContactJudgement found = judge_contacts(stack.problem(), solved(stack.problem()), {}, {});
    CAPTURE(boxes);
    CHECK(found.verdict == ContactVerdict::solution_within_rho);
    CHECK(found.undetermined > 0);
    CHECK(found.others_excluded() == (boxes < 4));
    CHECK(is_accepted(stack.problem(), found));
  }
}

TEST_CASE("right answers to stacks in space are certified, with forces inside of their cones") {
  for (const double push : {0.0, 1.0, 2.0}) {
    const Stack stack(3, 3, push);
    const std::vector<double> answer = solved(stack.problem());
    const ContactJudgement found = judge_contacts(stack.problem(), answer, {}, {});
    CAPTURE(push);
    CHECK(found.residual->backward_error() <= contact_tolerance);
    CHECK(is_certified(found.verdict));
    REQUIRE(found.enclosure);
    CHECK(found.eta <= contact_tolerance * found.residual->scale);
    CHECK(is_accepted(stack.problem(), found));
    // Nothing is certified that is not there.
    std::vector<double> off = answer;
    for (std::size_t i = stack.problem().free; i < off.size(); ++i) off[i] += i % 2 == 0 ? 0.01 : -0.01;
    const ContactJudgement near = judge_contacts(stack.problem(), off, {}, {});
    CHECK(!is_certified(near.verdict));
    if (push < 2) CHECK(name(near.verdict) == "not converged");  // with more, no forces are well inside
    CHECK(is_accepted(stack.problem(), near));
  }
}

TEST_CASE("a tall stack is certified, with more dependent equations than are found densely") {
  constexpr std::size_t boxes = 90;
  static_assert(7 * boxes > largest_dependent);
  const Stack stack(boxes, 2, 0);
  const ContactJudgement found = judge_contacts(stack.problem(), solved(stack.problem()), {}, {});
  CHECK(found.verdict == ContactVerdict::solution_within_rho);
  CHECK(found.undetermined == boxes);  // one of four forces between two boxes
  REQUIRE(found.enclosure);
  CHECK(found.enclosure->dropped.size() == boxes);
  CHECK(is_accepted(stack.problem(), found));
}

TEST_CASE("forces of more than 800 rows are moved inside of their cones, at the same velocities") {
  const Stack stack(130, 2, 0);
  const MixedProblem& p = stack.problem();
  REQUIRE(p.size() > 800);
  const std::vector<double> answer = solved(p);
  const double largest = *std::ranges::max_element(answer);
  constexpr double margin = 1e-3;
  Effort effort(3'000'000'000);
  const auto inside = forces_inside(p, answer, contact_tolerance, margin, effort);
  REQUIRE(inside);
  for (std::size_t k = 0; k < p.contacts(); ++k) {
    const std::size_t n = p.normal(k);
    CHECK(inside->x[n] > margin / 2 * largest);
    CHECK(std::abs(inside->x[n + 1]) < p.mu[k] * inside->x[n]);
    CHECK(inside->mode[k] == ConeState::stick);
  }
  CHECK(residual(p, inside->x, exact_rows(p, inside->x)).backward_error() <= 1e-4);
}

TEST_CASE("an answer that is 9e-3 of the largest force away from a solution has not converged") {
  for (const auto& [boxes, dimension] : {std::pair(1U, 3U), {2U, 3U}, {4U, 3U}, {8U, 2U}}) {
    const Stack stack(boxes, dimension, dimension == 3 ? 1 : 0);
    std::vector<double> answer = solved(stack.problem());
    const double largest =
        *std::max_element(answer.begin() + static_cast<std::ptrdiff_t>(stack.problem().free), answer.end());
    for (std::size_t i = stack.problem().free; i < answer.size(); ++i) {
      answer[i] += (i * i % 7 < 3 ? 9e-3 : -9e-3) * largest;
    }
    std::fill_n(answer.begin(), stack.problem().free, 0.0);
    CAPTURE(boxes);
    for (const bool refine : {false, true}) {
      ContactJudgeOptions options;
      options.refine = refine;
      const ContactJudgement found = judge_contacts(stack.problem(), answer, {}, options);
      CHECK(name(found.verdict) == "not converged");
      CHECK(found.error <= contact_near);
      CHECK(is_accepted(stack.problem(), found));
    }
  }
}

TEST_CASE("a wrong answer to a stack is as wrong with little effort") {
  const Stack stack(3, 3, 1);
  std::vector<double> wrong = solved(stack.problem());
  for (std::size_t i = stack.problem().free; i < wrong.size(); i += 3) wrong[i] *= i % 2 == 0 ? 1.5 : 0.75;
  ContactJudgeOptions little;
  little.effort = 1'000'000;
  CHECK(name(judge_contacts(stack.problem(), wrong, {}, {}).verdict) == "wrong");
  CHECK(name(judge_contacts(stack.problem(), wrong, {}, little).verdict) == "wrong");
  // Pushed harder than friction holds it slides, and the answer of the stack at rest is wrong.
  const Stack pushed(3, 3, 6);
  CHECK(name(judge_contacts(pushed.problem(), solved(stack.problem()), {}, {}).verdict) == "wrong");
}

TEST_CASE("each part of a problem is swept as if it were alone") {
  const Stack one(3, 3, 1), two(2, 3, 0);
  const MixedProblem &a = one.problem(), &b = two.problem();
  MixedProblem both;  // free unknowns of one, then of the other, then contacts
  both.free = a.free + b.free;
  std::vector<MatrixEntry> entries, twice;
  const auto add = [&](const MixedProblem& own, std::size_t free_before, std::size_t forces_before) {
    const auto place = [&](std::size_t i) {
      return static_cast<std::uint32_t>(i < own.free ? free_before + i : both.free + forces_before + i - own.free);
    };
    for (std::size_t i = 0; i < own.size(); ++i) {
      for (std::size_t e = own.A.starts[i]; e < own.A.starts[i + 1]; ++e) {
        entries.push_back({place(i), place(own.A.column[e]), own.A.value[e]});
      }
      both.c[place(i)] = own.c[i];
    }
    both.mu.insert(both.mu.end(), own.mu.begin(), own.mu.end());
  };
  both.c.assign(a.size() + b.size(), 0);
  add(a, 0, 0);
  add(b, a.free, a.size() - a.free);
  both.A = sparse_matrix(both.size(), both.size(), entries, twice);
  std::vector<double> alone = solved(a), other = solved(b), together = solved(both);
  alone.erase(alone.begin(), alone.begin() + static_cast<std::ptrdiff_t>(a.free));
  alone.insert(alone.end(), other.begin() + static_cast<std::ptrdiff_t>(b.free), other.end());
  together.erase(together.begin(), together.begin() + static_cast<std::ptrdiff_t>(both.free));
  CHECK(together == alone);
}

TEST_CASE("answers from elsewhere are right, and have other forces") {
  const Stack stack(3, 3, 1);
  const MixedProblem& p = stack.problem();
  const std::vector<double> first = solved(p);
  int number = 0;
  for (std::vector<double> x; !(x = answer_from_elsewhere(p, number)).empty(); ++number) {
    CHECK(residual(p, x, exact_rows(p, x)).backward_error() <= contact_tolerance);
    double apart = 0;
    for (std::size_t i = p.free; i < p.size(); ++i) apart = std::max(apart, std::abs(x[i] - first[i]));
    CHECK(apart > 0.01);
  }
  CHECK(number == 3);
}
