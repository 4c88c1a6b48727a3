#include "contact/judge/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/number/binary64.hpp"
#include "base/parallel/failure.hpp"
#include "contact/enclosure/sizes.hpp"
#include "contact/exact/no_solution.hpp"
#include "contact/judge/find/find.hpp"
#include "contact/judge/others.hpp"
#include "contact/judge/small.hpp"
#include "contact/path/solve.hpp"

namespace slipproof {

namespace {

/// Whether the modes of the law have equations (ModeSystem).
bool have_modes(const MixedProblem& problem) {
  using enum FrictionLaw;
  return problem.is_coulomb() || problem.law.kind == associated || problem.law.kind == box;
}

/// An answer that is to be judged, and what is known of it so far.
class ContactCase {
 public:
  ContactCase(const MixedProblem& problem, std::span<const double> u, const ContactJudgeOptions& options,
              ContactJudgement& judgement)
      : problem_(problem),
        u_(u),
        options_(options),
        j_(judgement),
        effort_(options.effort),
        beyond_(work_beyond_verdict(problem, options.effort)) {}

  /// A solution near the answer, and whether there are others.
  void look_near() {
    bool settled = false;
    if (problem_.is_coulomb()) extra("all solutions", [&] { settled = judge_among_all(); });
    if (!settled && have_modes(problem_)) extra("a solution near the answer", [&] { enclose(); });
    const bool known = j_.has_solution();
    if (known) j_.error = j_.enclosure ? error_from(*j_.enclosure) : error_from(j_.exact);
    if (!settled && known && problem_.is_coulomb()) exclude_others();
    if (is_convex(problem_) && !(known && problem_.is_coulomb())) {
      extra("a bound on every solution", [&] { bound_every_solution(problem_, u_, known, effort_, j_); });
    }
  }

  /// What fails beyond the residual costs nothing but itself.
  template <class Find>
  void extra(const char* what, const Find& find) {
    if (const std::string failure = failure_of(find); !failure.empty()) j_.left_out.push_back(what + (": " + failure));
  }

  /// Looks for multipliers that show that there is no solution at all.
  bool none_at_all() {
    if (j_.all && j_.all->none()) return true;
    if (problem_.size() > 60) return false;
    std::optional<std::vector<Rational>> found;
    extra("why there is no solution", [&] {
      const bool near = converged_answer(problem_, {.start = j_.x, .elsewhere = false}, options_.tolerance).has_value();
      Effort little(std::min(options_.effort, (near ? 1 : 100) * beyond_));  // near one, multipliers are hardly found
      found = infeasibility(problem_, options_.refine && !near ? effort_ : little);
    });
    if (found) j_.multipliers = std::move(*found);
    return found.has_value();
  }

  /// Forces along which nothing moves, where there may be such.
  void look_for_open_forces() {
    using enum ContactVerdict;
    const bool long_numbers = j_.enclosure && j_.enclosure->proof;
    const bool maybe = j_.undetermined > 0 || long_numbers || j_.verdict == ambiguous ||
                       j_.verdict == velocities_within_rho || (j_.verdict == eps_solution && !j_.contacts.empty());
    if (!maybe) return;
    Effort effort(std::min(options_.effort, 25 * beyond_));
    extra("ranges of open forces", [&] { j_.open = open_forces(problem_, j_.x, options_.tolerance, effort); });
  }

  /// All solutions of a small problem, and the mode of an answer that is none.
  std::optional<SmallCase> tell_all() {
    auto small = small_case(problem_, j_.x, u_, options_.tolerance, effort_);
    if (small) j_.all = small->found.all, j_.own = small->found.own;
    return small;
  }

  /// All solutions of any problem by Coulomb's law, with proof.
  void find_all(std::shared_ptr<const SolutionTree> tree) {
    if (!problem_.is_coulomb() || j_.all) return;
    extra("all solutions", [&] {
      if (!tree) {
        auto found = solution_tree(problem_, options_.effort, options_.progress);
        if (!found) throw std::runtime_error("the free unknowns are not determined by the forces, or too many");
        tree = std::make_shared<const SolutionTree>(*std::move(found));
      }
      AllSolutions all = all_solutions_of(*tree);
      if (!all.complete()) {
        j_.some = std::move(all);
        throw std::runtime_error(j_.some->open_words());
      }
      j_.all = std::move(all);
      j_.tree = std::move(tree);
    });
  }

  bool certainly_several() const {
    const bool among_all = j_.tree && j_.all->several_motions(), among_some = j_.some && j_.some->several_motions();
    return j_.other || !j_.other_exact.empty() || among_all || among_some;
  }
  bool certainly_one() const { return j_.unique_by || (j_.every && j_.every->unique()) || (j_.all && j_.all->one()); }
  /// Whether the known solution is the nearest there is. Of families in space it need not be.
  bool knows_all() const {
    return (j_.all && (!j_.tree || j_.all->are_points())) || j_.unique_by || (j_.every && j_.every->unique());
  }

 private:
  template <class Solution>
  double error_from(const Solution& solution) const {
    return error_of(problem_, j_.x, u_, solution);
  }

  /// Holds the answer against all solutions of a small problem; true if that settles it.
  bool judge_among_all() {
    const auto small = tell_all();
    if (small && small->found.nearest) take(small->eliminated, small->found);
    return small.has_value();
  }

  void take(const EliminatedProblem& small, const SmallJudgement& found) {
    const std::vector<Rational> nearest = values_of(found.all.solutions[*found.nearest].r);
    j_.exact = small.with_free(nearest);
    j_.rho = distance_from(j_.exact, j_.x);
    if (found.all.one()) j_.unique_by = prove_unique(problem_, effort_);
    std::vector<std::vector<Rational>> others;
    for (const FoundSolution& s : found.all.solutions) others.push_back(values_of(s.r));
    std::rotate(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(found.all.singles()), others.end());
    for (const ContactContinuum& continuum : found.continua) {
      for (auto& z : continuum.two(effort_)) others.push_back(std::move(z));
    }
    j_.undetermined = found.all.solutions[*found.nearest].open_directions;
    const ContactProblem& contacts = small.problem;
    const auto motion = [&](const auto& z) { return contacts.frictional() ? accelerations(contacts, z) : z; };
    const auto own = motion(nearest);
    const auto other = std::ranges::find_if(others, [&](const auto& z) { return motion(z) != own; });
    if (other != others.end()) j_.other_exact = small.with_free(*other);
  }

  void take(Enclosure box) {
    j_.exact.clear();
    j_.rho = distance_from(box, j_.x);
    j_.undetermined = box.undetermined();
    j_.enclosure = std::move(box);
  }

  void enclose() {
    const bool right = j_.residual->backward_error() <= options_.tolerance, quick = !right && !options_.refine;
    const EnclosureOptions options = quick ? with_little_work(options_.enclosure) : options_.enclosure;
    std::vector<double> start = quick ? improved_answer(problem_, j_.x, options_) : j_.x;
    auto failure = enclose_from(start, options, right);
    if (failure && far_ && start != j_.x) failure = enclose_from(j_.x, options, right);
    if (!failure) return;
    if (problem_.is_coulomb() && solve_exactly(start, right) && error_from(j_.exact) <= options_.tolerance) return;
    if (failure->at_border) {
      auto box = enclose_touching(problem_, j_.x, failure->contacts, options_.enclosure);
      if (box) return take(std::move(*box));
    }
    if (!right && !quick) {
      start = improved_answer(problem_, j_.x, options_);
      if (start != j_.x) extra("a solution from an improved answer", [&] { enclose_from(start, options, right); });
      if (j_.enclosure) return;
    }
    if (problem_.is_coulomb()) extra("forces inside of their cones", [&] { move_inside(start, right); });
    if (j_.enclosure) return;
    const bool follows = right || options_.refine || (start != j_.x && !far_);
    if (follows && problem_.is_coulomb()) extra("a solution along a path", [&] { follow(start); });
    if (!j_.has_solution() && far_) take(*std::move(far_));
    if (j_.has_solution()) return;
    j_.reason = std::move(failure->reason);
    j_.contacts = std::move(failure->contacts);
  }

  /// Takes a solution that is found from there, unless others may be nearer to the answer.
  std::optional<NoEnclosure> enclose_from(const std::vector<double>& start, const EnclosureOptions& options,
                                          bool right) {
    auto found = enclose_solution(problem_, start, options);
    if (auto* failure = std::get_if<NoEnclosure>(&found)) return std::move(*failure);
    auto& box = std::get<Enclosure>(found);
    if (right || !problem_.is_coulomb() || error_from(box) <= contact_near) {
      take(std::move(box));
      return std::nullopt;
    }
    if (!far_ || error_from(box) < error_from(*far_)) far_ = std::move(box);
    return NoEnclosure{"the solution that was found is too far from the answer", {}};
  }

  /// Where no enclosure is found, at a border between modes: the solution itself.
  bool solve_exactly(const std::vector<double>& start, bool right) {
    Effort little(beyond_);
    auto solution = exact_solution_near(problem_, start, right || is_complementarity(problem_) ? effort_ : little);
    if (!solution) return false;
    j_.exact = std::move(solution->x);
    j_.undetermined = solution->undetermined;
    j_.rho = distance_from(j_.exact, j_.x);
    return true;
  }

  /// Where forces at the edge of their cones could be elsewhere. `start` has the velocities, and the forces are to be
  /// near the answer's.
  void move_inside(const std::vector<double>& start, bool right) {
    Effort effort(std::min(options_.effort, (right ? 100 : 10) * beyond_));
    const bool improved = start != j_.x;
    const double rough = std::max(contact_near, 2 * j_.residual->backward_error());
    auto box = enclose_inside(problem_, start, right || improved ? options_.tolerance : rough, options_.enclosure,
                              effort, improved ? j_.x : std::vector<double>());
    if (!box) return;
    j_.moved_inside = true;
    j_.eta = velocity_distance(problem_, *box, j_.x);
    take(std::move(*box));
  }

  /// Where equations depend on each other up to rounding.
  void follow(const std::vector<double>& start) {
    Effort effort(options_.refine ? options_.effort : std::min(options_.effort, 25 * beyond_));
    auto box = solve_along_path(problem_, start, effort, answer_from_elsewhere);
    if (!box) return;
    j_.eta = velocity_distance(problem_, *box, j_.x);
    take(std::move(*box));
  }

  void exclude_others() {
    extra("whether it is the only solution", [&] { j_.unique_by = prove_unique(problem_, effort_); });
    if (j_.unique_by) return;
    if (j_.error > options_.tolerance && !options_.refine) return;  // no verdict on it depends on another one
    extra("another solution in a linear mode", [&] { look_in_linear_modes(problem_, Effort(10 * beyond_), j_); });
    if (!j_.other_exact.empty() || !j_.enclosure || !j_.enclosure->pinned.empty()) return;
    if (j_.enclosure->proof || j_.enclosure->system.size() > options_.others_up_to) return;
    extra("another solution", [&] { j_.other = another_solution(problem_, *j_.enclosure, {.effort = beyond_}); });
  }

  const MixedProblem& problem_;
  std::span<const double> u_;
  const ContactJudgeOptions& options_;
  ContactJudgement& j_;
  Effort effort_;
  const Work beyond_;
  std::optional<Enclosure> far_;  ///< a solution that is not near the answer
};

}  // namespace

bool is_judged_by_residual(const MixedProblem& problem) {
  return !have_modes(problem) && !is_convex(problem);
}

ContactJudgement judge_contacts(const MixedProblem& problem, std::vector<double> x, std::span<const double> u,
                                const ContactJudgeOptions& options, std::shared_ptr<const SolutionTree> tree) {
  ContactJudgement judgement;
  judgement.x = std::move(x);
  judgement.law = problem.law.kind;
  const auto finite = [](double value) { return std::isfinite(value); };
  const auto bad = std::find_if_not(judgement.x.begin(), judgement.x.end(), finite);
  if (bad != judgement.x.end() || !std::all_of(u.begin(), u.end(), finite)) {
    judgement.reason = "found a number that is not finite";
    return judgement;
  }
  const std::vector<Rational> w = exact_rows(problem, judgement.x);
  judgement.residual = residual(problem, judgement.x, w);
  judgement.velocity_error = slipproof::velocity_error(problem, w, u);
  if (problem.is_coulomb()) judgement.exclusion = exclusion(problem, judgement.x, w);
  const double backward = judgement.residual->backward_error();
  const double velocity_error = judgement.velocity_error / judgement.residual->scale;
  const bool right = std::max(backward, velocity_error) <= options.tolerance;
  ContactCase found(problem, u, options, judgement);
  const bool strong = !is_judged_by_residual(problem);
  const bool other_convex = !problem.is_coulomb() && is_convex(problem);  // then every answer has a certified distance
  if (strong && (right || options.refine || other_convex || may_be_near(problem, judgement, w, options.within)))
    found.look_near();
  if (options.all) found.find_all(std::move(tree));
  const bool known = judgement.has_solution();
  const bool near = known && (options.within ? judgement.rho <= *options.within : judgement.error <= contact_near);
  const bool only_forces_open = judgement.every && !judgement.every->unique();
  if (problem.is_coulomb() && !known && (!right || options.refine) && found.none_at_all()) {
    judgement.verdict = ContactVerdict::no_solution;
  } else if (options.within && judgement.excluded() > *options.within) {
    judgement.verdict = ContactVerdict::none_within_rho;
  } else if (known && judgement.error <= options.tolerance) {
    judgement.verdict = found.certainly_several() ? ContactVerdict::ambiguous
                        : found.certainly_one()   ? ContactVerdict::unique
                                                  : ContactVerdict::solution_within_rho;
  } else if (auto open =
                 known && right ? open_contacts(problem, judgement, options.tolerance) : std::vector<std::size_t>();
             !open.empty()) {
    judgement.verdict = ContactVerdict::velocities_of_a_solution;
    judgement.reason = judgement.enclosure->proof
                           ? "forces that hardly move any contact are determined by rounding alone"
                           : "forces that move no contact are open";
    judgement.contacts = std::move(open);
  } else if (near) {
    judgement.verdict = right ? ContactVerdict::inaccurate : ContactVerdict::not_converged;
  } else if (right && !known && only_forces_open &&
             judgement.every->eta <= options.tolerance * judgement.residual->scale) {
    judgement.verdict = ContactVerdict::velocities_within_rho;
    judgement.undetermined = judgement.every->open;
    judgement.reason.clear();
    judgement.contacts.clear();
  } else if (right && !found.knows_all()) {
    judgement.verdict = ContactVerdict::eps_solution;
    if (known) judgement.reason = "the solution that was found is too far from the answer";
    if (!strong) judgement.reason = "of this law only the residual is judged";
    if (judgement.reason.empty()) judgement.reason = "no bound on solutions is as narrow as the tolerance";
  } else {
    judgement.verdict = ContactVerdict::wrong;
    judgement.reason.clear();  // why nothing is enclosed is no news any more
    judgement.contacts.clear();
    if (backward > options.tolerance) {
      found.extra("a pyramid that it fits",
                  [&] { judgement.right_for = pyramid_that_fits(problem, judgement.x, w, options.tolerance); });
    } else if (velocity_error > options.tolerance) {
      judgement.reason = "the velocities are not those of the forces";
    } else {
      judgement.reason = "the nearest solution is farther from it than a hundredth of the largest force";
    }
  }
  if (judgement.verdict == ContactVerdict::wrong && problem.is_coulomb() && !judgement.all) found.tell_all();
  if (right) found.look_for_open_forces();
  return judgement;
}

}  // namespace slipproof
