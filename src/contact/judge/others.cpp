#include "contact/judge/others.hpp"

#include <algorithm>

#include "base/number/binary64.hpp"
#include "contact/enclosure/residual.hpp"
#include "contact/exact/exact_lcp.hpp"
#include "contact/exact/exclusion.hpp"
#include "contact/exact/linear_modes.hpp"
#include "contact/judge/find/find.hpp"
#include "contact/path/solve.hpp"
#include "contact/ranges/forces_inside.hpp"

namespace slipproof {

namespace {

/// The known solution: numbers, or a box that holds it.
class KnownSolution {
 public:
  KnownSolution(const MixedProblem& problem, const ContactJudgement& judgement)
      : problem_(problem), j_(judgement), x_(j_.enclosure ? to_rationals(center_of(*j_.enclosure)) : j_.exact) {}

  /// Whether x is certainly another one.
  bool is_not(const std::vector<Rational>& x) const {
    for (std::size_t i = problem_.free; i < x.size(); ++i) {
      if (j_.undetermined == 0 && abs(x[i] - x_[i]) > radius(i)) return true;
      const Rational moved = exact_row(problem_, i, x) - exact_row(problem_, i, x_);
      if (abs(moved) > (j_.enclosure ? to_rational(row_radius(problem_, *j_.enclosure, i)) : Rational(0))) return true;
    }
    return false;
  }

 private:
  Rational radius(std::size_t i) const {
    const std::size_t unknown = j_.enclosure ? j_.enclosure->system.unknown(i) : ModeSystem::none;
    return unknown == ModeSystem::none ? Rational(0) : to_rational(j_.enclosure->radius[unknown]);
  }

  const MixedProblem& problem_;
  const ContactJudgement& j_;
  const std::vector<Rational> x_;
};

}  // namespace

Work work_beyond_verdict(const MixedProblem& problem, Work effort) {
  constexpr Work least = 200'000, of_entry = 4'000, many = 2'500, usual = ContactJudgeOptions::usual_effort;
  const Work entries = problem.A.entries() + problem.size();
  const Work work = least + of_entry * entries * std::min(entries, many) / many;
  return effort > usual ? times(work, effort / usual) : std::min(work, effort);
}

EnclosureOptions with_little_work(EnclosureOptions options) {
  constexpr std::size_t large = 1500;
  constexpr int few = 10, few_dependent = 2;
  options.largest_block = std::min(options.largest_block, large);
  options.modes = std::min(options.modes, few);
  options.dependent_modes = std::min(options.dependent_modes, few_dependent);
  return options;
}

bool may_be_near(const MixedProblem& problem, const ContactJudgement& judgement, std::span<const Rational> w,
                 std::optional<double> within) {
  if (judgement.residual->backward_error() <= contact_near) return true;
  if (within) return judgement.excluded() <= *within;
  return problem.is_coulomb() && relative_exclusion(problem, judgement.x, w) <= 2 * contact_near;
}

std::vector<double> improved_answer(const MixedProblem& problem, const std::vector<double>& x,
                                    const ContactJudgeOptions& options) {
  constexpr std::size_t small = 200;
  FindOptions found{.start = x, .elsewhere = false};
  if (!options.refine) found.rounds = 1, found.newton = small;
  return converged_answer(problem, found, options.tolerance).value_or(x);
}

std::optional<BorderSolution> exact_solution_near(const MixedProblem& problem, std::span<const double> x,
                                                  Effort& effort) {
  constexpr std::size_t largest_complementarity = 1000;
  if (auto solution = solve_at_border(problem, x, effort)) return solution;
  if (!is_complementarity(problem) || problem.size() > largest_complementarity) return std::nullopt;
  std::vector<bool> active;
  for (const double value : x) active.push_back(value > 0);
  const auto found = solve_lcp(problem, std::move(active), effort);
  if (!found) return std::nullopt;
  BorderSolution solution{{}, 0};
  for (std::size_t i = 0; i < found->x.size(); ++i) solution.x.push_back(found->x.at(i));
  return solution;
}

void bound_every_solution(const MixedProblem& problem, std::span<const double> u, bool known, Effort& effort,
                          ContactJudgement& j) {
  auto proof = prove_monotone(problem, effort);
  if (!proof) {
    if (!known && j.reason.empty()) j.reason = "its matrix is not proved to be semidefinite with free rows exact";
    return;
  }
  std::vector<std::vector<double>> starts{j.x};
  if (known && j.enclosure) starts.push_back(center_of(*j.enclosure));
  if (!known) starts.push_back(approximate_solution(problem, {.start = j.x}));
  for (const std::vector<double>& start : starts) {
    if (start.size() != j.x.size()) continue;
    auto found = every_solution(problem, start, j.x, *proof);
    if (found && (!j.every || found->energy < j.every->energy)) j.every = std::move(found);
  }
  if (!j.every || known) return;
  j.rho = j.every->rho;
  j.error = error_of(problem, j.x, u, *j.every);
}

void look_in_linear_modes(const MixedProblem& problem, Effort effort, ContactJudgement& judgement) try {
  LinearSearch& search = judgement.linear_modes.emplace(LinearSearch{linear_modes(problem, Slides::none), false});
  const auto can_try = [&](Slides slides) { return effort.allows(least_work_of_linear_modes(problem, slides)); };
  if (!can_try(Slides::none)) return;
  const Work free = problem.free;
  effort.spend(times(times(free, free), times(free, 8)));
  const auto contacts = eliminated(problem);
  if (!contacts) return;
  const KnownSolution known(problem, judgement);
  const ConeMode* mode = judgement.enclosure ? &judgement.enclosure->system.mode() : nullptr;
  for (const Slides slides : {Slides::none, Slides::axes}) {
    const Work modes = linear_modes(problem, slides);
    if ((search.tried && modes == search.modes) || !can_try(slides)) return;
    each_linear_solution(problem, contacts->problem, slides, std::span(judgement.x).subspan(problem.free), mode, effort,
                         [&](const std::vector<Rational>& r) {
                           std::vector<Rational> x = contacts->with_free(r);
                           if (known.is_not(x)) judgement.other_exact = std::move(x);
                           return judgement.other_exact.empty();
                         });
    search = {modes, true};
    if (!judgement.other_exact.empty()) return;
  }
} catch (const TooMuchWork&) {  // what was found before stays
}

std::optional<Enclosure> enclose_inside(const MixedProblem& problem, std::span<const double> x, double near,
                                        const EnclosureOptions& options, Effort& effort,
                                        std::span<const double> toward) {
  constexpr double well = 1e-3;  // of the largest force
  const EnclosureOptions own = with_little_work(options);
  for (const double margin : {toward.empty() ? near / 8 : well / 8, well}) {
    auto inside = forces_inside(problem, x, near, margin, effort, toward);
    if (!inside) continue;
    if (auto box = enclose_in_mode(problem, inside->x, std::move(inside->mode), own)) return box;
  }
  return std::nullopt;
}

std::vector<std::size_t> open_contacts(const MixedProblem& problem, const ContactJudgement& j, double tolerance) {
  if (!j.enclosure || (!j.enclosure->proof && !j.moved_inside) || j.eta > tolerance * j.residual->scale) return {};
  const std::vector<double> scales = contact_scales(problem), distances = force_distances(problem, *j.enclosure, j.x);
  double usual = 0;
  for (std::size_t k = 0; k < scales.size(); ++k) usual = std::max(usual, scales[k] * distances[k]);
  if (usual == 0 || j.eta > tolerance * usual) return {};
  const double farthest = *std::max_element(distances.begin(), distances.end());
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < distances.size(); ++k) {
    if (distances[k] > tolerance * farthest) open.push_back(k);
  }
  return open;
}

std::optional<FrictionLaw> pyramid_that_fits(const MixedProblem& problem, std::span<const double> x,
                                             std::span<const Rational> w, double tolerance) {
  if (problem.dimension != 3 || problem.law.kind != FrictionLaw::cone) return std::nullopt;
  for (const FrictionLaw kind : {FrictionLaw::box, FrictionLaw::diamond}) {
    ContactLaw law;
    law.kind = kind;
    if (residual(problem, x, w, law).backward_error() <= tolerance) return kind;
  }
  return std::nullopt;
}

}  // namespace slipproof
