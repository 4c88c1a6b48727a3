#include "report/planes/motion_cones.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "report/planes/cone_disc.hpp"

namespace slipproof {

namespace {

bool is_positive(const Range& range) {
  return range.lower && range.lower->sign() > 0;
}

bool is_not_zero(const Range& range) {
  return is_positive(range) || (range.upper && range.upper->sign() < 0);
}

/// 0 where the range holds 0: nobody reads 1e-27.
double middle_of(const Range& range) {
  if (!range.lower || !range.upper || !is_not_zero(range)) return 0;
  return Rational((*range.lower + *range.upper) / 2).to_double();
}

ContactMotion contact_motion(const FoundSolution& solution, std::size_t contact, double mu) {
  const Range *r = &solution.r[3 * contact], *u = &solution.u[3 * contact];
  ContactMotion motion;
  const bool pressed = is_positive(r[0]);
  motion.lifts = !pressed && is_positive(u[0]);
  motion.normal = pressed ? middle_of(r[0]) : 0;
  if (pressed && mu > 0) {
    motion.force = {in_cone(middle_of(r[1]), mu, motion.normal), in_cone(middle_of(r[2]), mu, motion.normal)};
  }
  if (motion.lifts || !(is_not_zero(u[1]) || is_not_zero(u[2]))) return motion;
  const double x = middle_of(u[1]), y = middle_of(u[2]), speed = std::hypot(x, y);
  if (speed > 0) motion.slip = {x / speed, y / speed};
  return motion;
}

/// The largest distance of forces from those of the answer.
double distance_of(const FoundSolution& solution, const MixedProblem& problem, const std::vector<double>& x) {
  double most = 0;
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    for (std::size_t t = 0; t < 3; ++t)
      most = std::max(most, std::abs(middle_of(solution.r[3 * k + t]) - x[problem.normal(k) + t]));
  }
  return most;
}

/// Nothing where families are among them: which of their forces are nearest is not known.
std::optional<std::size_t> nearest_of(const AllSolutions& all, const MixedProblem& problem,
                                      const std::vector<double>& x) {
  const bool finite = std::ranges::all_of(x, [](double value) { return std::isfinite(value); });
  if (all.solutions.size() < 2 || all.families() > 0 || x.size() != problem.size() || !finite) return {};
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < all.solutions.size(); ++i) {
    const double distance = distance_of(all.solutions[i], problem, x);
    if (distance < least) least = distance, nearest = i;
  }
  return nearest;
}

std::string_view family_word(const FoundSolution& solution) {
  if (!solution.others.empty()) return "continuum";
  return solution.is_family() ? "forces open" : "";
}

}  // namespace

std::string_view state_of(const ContactMotion& motion) {
  if (motion.lifts) return "lifts";
  if (motion.slip) return "slips";
  if (motion.force) return "sticks";
  return motion.normal > 0 ? "presses" : "touches";
}

std::optional<MotionCones> motion_cones(const MixedProblem& problem, const ContactJudgement& judgement) {
  const bool friction = std::ranges::any_of(problem.mu, [](double mu) { return mu > 0; });
  if (!judgement.all || judgement.all->solutions.empty() || problem.dimension != 3 || !friction) return {};
  const AllSolutions& all = *judgement.all;
  const std::optional<std::size_t> nearest = nearest_of(all, problem, judgement.x);
  MotionCones cones{all.solutions.size(), problem.contacts(), {}};
  for (std::size_t i = 0; i < std::min(cones.motions, MotionCones::most); ++i) {
    const FoundSolution& solution = all.solutions[i];
    MotionRow& row =
        cones.rows.emplace_back(MotionRow{solution.modes.front(), family_word(solution), nearest == i, {}});
    for (std::size_t k = 0; k < cones.columns(); ++k) {
      row.contacts.push_back(contact_motion(solution, k, problem.mu[k]));
    }
  }
  return cones;
}

double degrees_of(const std::array<double, 2>& direction) {
  return std::atan2(direction[1], direction[0]) * 180 / std::numbers::pi;
}

}  // namespace slipproof
