#include "enclosure/judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "enclosure/exact_lcp.hpp"
#include "enclosure/find.hpp"
#include "enclosure/multiple.hpp"
#include "enclosure/no_solution.hpp"
#include "number/binary64.hpp"

namespace slipproof {

namespace {

constexpr std::array<std::string_view, 9> verdict_names{
    "invalid",     "wrong",     "eps-solution", "solution within rho", "unique", "no solution within rho",
    "no solution", "ambiguous", "undecided"};

/// The largest |u_i - (A x + c)_i|, rounded up.
double velocity_error_of(const MixedProblem& problem, std::span<const Rational> w, std::span<const double> u) {
  double largest = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const Rational difference = to_rational(u[i]) - w[problem.free + i];
    largest = std::max(largest, enclose(abs(difference)).upper);
  }
  return largest;
}

/// Wrong for the law that was asked about: would it be right for one that engines use instead?
std::optional<FrictionLaw> pyramid_that_fits(const MixedProblem& problem, std::span<const double> x,
                                             std::span<const Rational> w, const ContactJudgeOptions& options) {
  if (problem.dimension != 3 || options.law != FrictionLaw::cone) return std::nullopt;
  for (const FrictionLaw law : {FrictionLaw::box, FrictionLaw::diamond}) {
    if (residual(problem, x, w, law).backward_error() <= options.tolerance) return law;
  }
  return std::nullopt;
}

/// An answer that is to be judged, and what is known of it so far.
class ContactCase {
 public:
  ContactCase(const MixedProblem& problem, const ContactJudgeOptions& options, ContactJudgement& judgement)
      : problem_(problem), options_(options), j_(judgement), effort_(options.effort) {}

  /// A solution near the answer, and whether there are others.
  void look_near() {
    if (count_all()) return;
    auto found = enclose_solution(problem_, j_.x, options_.enclosure);
    if (auto* box = std::get_if<Enclosure>(&found)) {
      j_.rho = distance_from(*box, j_.x);
      j_.enclosure = std::move(*box);
    } else {
      auto& failure = std::get<NoEnclosure>(found);
      j_.reason = std::move(failure.reason);
      j_.contacts = std::move(failure.contacts);
      solve_exactly();
    }
    if (j_.has_solution()) exclude_others();
  }

  /// Multipliers that show that there is none at all.
  bool none_at_all() {
    if (counted_ && count_.kind == SolutionCount::Kind::none) return true;
    if (problem_.size() > 60) return false;
    auto found = infeasibility(problem_, effort_);
    if (found) j_.multipliers = std::move(*found);
    return found.has_value();
  }

  bool certainly_several() const {
    if (j_.other || !j_.other_exact.empty()) return true;
    // With friction a continuum of forces is the usual case; of a complementarity problem x itself is asked for.
    const bool forces_vary = problem_.dimension > 1 && j_.enclosure && !j_.enclosure->pinned.empty();
    return counted_ && count_.kind == SolutionCount::Kind::continuum && !forces_vary;
  }
  bool certainly_one() const { return j_.unique_by || (counted_ && count_.kind == SolutionCount::Kind::one); }

 private:
  /// All solutions of a small problem without free unknowns, in the plane or without friction: true if that settles it.
  bool count_all() {
    const std::size_t few = problem_.dimension == 1 ? 12 : 6;
    if (problem_.free > 0 || problem_.dimension > 2 || problem_.contacts() > few) return false;
    count_ = count_solutions(problem_, effort_);
    counted_ = count_.kind != SolutionCount::Kind::unknown;
    if (!counted_) return false;
    const auto nearer = [&](const auto& a, const auto& b) { return distance_from(a, j_.x) < distance_from(b, j_.x); };
    std::sort(count_.solutions.begin(), count_.solutions.end(), nearer);
    if (count_.solutions.empty()) return count_.kind == SolutionCount::Kind::none;
    if (count_.kind == SolutionCount::Kind::continuum && problem_.dimension > 1) return false;
    j_.exact = count_.solutions.front();
    j_.rho = distance_from(j_.exact, j_.x);
    if (count_.kind == SolutionCount::Kind::one) j_.unique_by = prove_unique(problem_, effort_);
    if (count_.solutions.size() > 1) j_.other_exact = count_.solutions[1];
    // Of a continuum members nearer to the answer may exist than those that are shown.
    return count_.kind != SolutionCount::Kind::continuum || j_.rho <= options_.tolerance;
  }

  /// Where no enclosure is found, at a border between modes: the solution itself, of problems without friction.
  void solve_exactly() {
    if (!is_complementarity(problem_) || problem_.size() > 1000) return;
    std::vector<bool> active;
    for (const double x : j_.x) active.push_back(x > 0);
    const auto found = solve_lcp(problem_, std::move(active), effort_);
    if (!found) return;
    for (std::size_t i = 0; i < found->x.size(); ++i) j_.exact.push_back(found->x.at(i));
    j_.rho = distance_from(j_.exact, j_.x);
  }

  void exclude_others() {
    if (certainly_several()) return;
    j_.unique_by = prove_unique(problem_, effort_);
    if (j_.unique_by || !j_.enclosure || !j_.enclosure->pinned.empty()) return;
    if (j_.enclosure->system.size() > options_.others_up_to) return;
    j_.other = another_solution(problem_, *j_.enclosure);
  }

  const MixedProblem& problem_;
  const ContactJudgeOptions& options_;
  ContactJudgement& j_;
  Effort effort_;
  bool counted_ = false;
  SolutionCount count_;
};

}  // namespace

std::string_view name(ContactVerdict verdict) {
  return verdict_names[static_cast<std::size_t>(verdict)];
}

bool is_certified(ContactVerdict verdict) {
  return verdict == ContactVerdict::solution_within_rho || verdict == ContactVerdict::unique;
}

ContactJudgement judge_contacts(const MixedProblem& problem, std::vector<double> x, std::span<const double> u,
                                const ContactJudgeOptions& options) {
  ContactJudgement judgement;
  judgement.x = std::move(x);
  judgement.law = options.law;
  const auto finite = [](double value) { return std::isfinite(value); };
  const auto bad = std::find_if_not(judgement.x.begin(), judgement.x.end(), finite);
  if (bad != judgement.x.end() || !std::all_of(u.begin(), u.end(), finite)) {
    judgement.reason = "found a number that is not finite";
    return judgement;
  }
  const std::vector<Rational> w = exact_rows(problem, judgement.x);
  judgement.residual = residual(problem, judgement.x, w, options.law);
  judgement.velocity_error = velocity_error_of(problem, w, u);
  judgement.exclusion = exclusion(problem, judgement.x, w);
  const double error =
      std::max(judgement.residual->backward_error(), judgement.velocity_error / judgement.residual->scale);
  const bool right = error <= options.tolerance;
  ContactCase found(problem, options, judgement);
  const bool exact_law = options.law == FrictionLaw::cone || problem.dimension < 3;
  if (exact_law && (right || options.refine)) found.look_near();
  if (exact_law && !judgement.has_solution() && (!right || options.refine) && found.none_at_all()) {
    judgement.verdict = ContactVerdict::no_solution;
  } else if (options.within && judgement.exclusion->radius > *options.within) {
    judgement.verdict = ContactVerdict::none_within_rho;
  } else if (!right) {
    judgement.verdict = ContactVerdict::wrong;
    judgement.reason.clear();  // why nothing is enclosed is no news any more
    judgement.contacts.clear();
    if (judgement.residual->backward_error() > options.tolerance) {
      judgement.right_for = pyramid_that_fits(problem, judgement.x, w, options);
    } else {
      judgement.reason = "the velocities are not those of the forces";
    }
  } else if (!judgement.has_solution()) {
    judgement.verdict = ContactVerdict::eps_solution;
  } else {
    judgement.verdict = found.certainly_several() ? ContactVerdict::ambiguous
                        : found.certainly_one()   ? ContactVerdict::unique
                                                  : ContactVerdict::solution_within_rho;
  }
  return judgement;
}

}  // namespace slipproof
