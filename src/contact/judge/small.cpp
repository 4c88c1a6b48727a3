#include "contact/judge/small.hpp"

#include <algorithm>

#include "base/number/binary64.hpp"
#include "contact/problem/tolerance.hpp"

namespace slipproof {

namespace {

class SmallJudge {
 public:
  SmallJudge(const ContactProblem& problem, const ProblemAnswer& answer, double tolerance, Effort& effort)
      : problem_(problem),
        answer_(answer),
        tolerance_(to_rational(tolerance)),
        solver_(problem),
        allowed_(effort.left()),
        effort_(effort) {
    for (std::size_t i = 0; i < problem.size(); ++i) {
      if (!problem.W[i][i].is_zero()) force_ = std::max(force_, Rational(abs(problem.q[i] / problem.W[i][i])));
    }
  }

  SmallJudgement judge() {
    own_ = answer_.mode ? *answer_.mode : mode_of_answer();
    result_.all.dimension = problem_.frictional() ? 2 : 1;
    if (auto all = solutions()) {
      judge_among(*std::move(all));
    } else {
      judge_alone();
    }
    return std::move(result_);
  }

 private:
  /// A solution to compare the answer with, and which of its components a continuum leaves open.
  struct Compared {
    std::vector<Rational> z, w;
    std::vector<bool> open_z, open_w;
  };
  /// The yardsticks of z and of w.
  struct Sizes {
    Rational z, w;
  };

  Compared determined(std::vector<Rational> z) const {
    auto w = accelerations(problem_, z);
    const std::vector<bool> none(problem_.size(), false);
    return {std::move(z), std::move(w), none, none};
  }

  Compared at_base(const ContactContinuum& c) const {
    Compared result = determined(c.base);
    for (const auto& direction : c.directions) {
      const auto slope = slope_of_w(direction);
      for (std::size_t i = 0; i < problem_.size(); ++i) {
        if (!direction[i].is_zero()) result.open_z[i] = true;
        if (!slope[i].is_zero()) result.open_w[i] = true;
      }
    }
    return result;
  }

  /// How w varies with z.
  std::vector<Rational> slope_of_w(const std::vector<Rational>& direction) const {
    std::vector<Rational> slope = accelerations(problem_, direction);
    for (std::size_t i = 0; i < problem_.size(); ++i) slope[i] -= problem_.q[i];
    return slope;
  }

  Sizes sizes(const Compared& to) const {
    Yardsticks largest(2);
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      largest.take(0, to.open_z[i] ? answer_.z[i] : to.z[i]);
      largest.take(1, problem_.q[i]);
      if (!to.open_w[i]) largest.take(1, to.w[i]);
      if (to.open_w[i] && answer_.w) largest.take(1, (*answer_.w)[i]);
    }
    return {largest[0].is_zero() ? force_ : largest[0], largest[1]};
  }

  Distance distance_to(const Compared& to) const {
    Distance d{0, 0};
    const Sizes size = sizes(to);
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      compare({answer_.z[i], to.z[i], size.z, to.open_z[i]}, d);
      if (answer_.w) compare({(*answer_.w)[i], to.w[i], size.w, to.open_w[i]}, d);
    }
    return d;
  }

  std::optional<ContactSolutions> solutions() {
    const bool few = problem_.size() <= few_components;
    std::optional<ContactSolutions> all;
    if (few) all = solver_.all(effort_);
    if (all) return all;
    if (auto only = solver_.unique_solution(own_, effort_)) {
      result_.unique_by = EveryLoad::Reason::definite;
      all.emplace();
      all->solutions.push_back(std::move(*only));
      return all;
    }
    return few ? std::nullopt : solver_.all(effort_);
  }

  bool moves(const ContactContinuum& c) const {
    return std::ranges::any_of(c.directions, [&](const std::vector<Rational>& direction) {
      return std::ranges::any_of(slope_of_w(direction), [](const Rational& slope) { return !slope.is_zero(); });
    });
  }

  /// The solution of a continuum that is nearest to the answer, measured by the largest error of a component.
  Compared nearest_member(const ContactContinuum& c) {
    Compared member = at_base(c);
    const Sizes size = sizes(member);
    std::vector<OpenComponent> open;
    const auto add = [&](std::size_t i, const Rational& base, const RationalMatrix& slopes, const Rational& answer,
                         const Rational& yardstick) {
      AffineForm form{base, {}};
      for (const auto& slope : slopes) form.coefficients.push_back(slope[i]);
      open.push_back({std::move(form), answer, yardstick});
    };
    RationalMatrix slopes;
    for (const auto& direction : c.directions) slopes.push_back(slope_of_w(direction));
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      if (member.open_z[i]) add(i, member.z[i], c.directions, answer_.z[i], size.z);
      if (member.open_w[i] && answer_.w) add(i, member.w[i], slopes, (*answer_.w)[i], size.w);
    }
    member.z = c.at(nearest_solution(open, c.conditions, c.directions.size(), effort_));
    member.w = accelerations(problem_, member.z);
    return member;
  }

  /// The mode that the answer suggests, if the solver names none.
  ProblemMode mode_of_answer() const {
    const auto w = accelerations(problem_, answer_.z);
    ProblemMode mode;
    for (std::size_t i = 0; i < problem_.contacts(); ++i) {
      const std::size_t normal = problem_.frictional() ? 2 * i : i;
      const Rational& N = answer_.z[normal];
      const Rational size = abs(problem_.W[normal][normal]);
      const bool nothing = N.is_zero() && (!problem_.frictional() || answer_.z[normal + 1].is_zero());
      if (nothing || N * (size.is_zero() ? Rational(1) : size) <= w[normal]) {
        mode.push_back(ElementState::lift);
      } else if (!problem_.frictional()) {
        mode.push_back(ElementState::touch);
      } else if (abs(answer_.z[normal + 1]) < problem_.mu[i] * N * Rational(999999, 1000000)) {
        mode.push_back(ElementState::stick);
      } else {
        mode.push_back(answer_.z[normal + 1].sign() < 0 ? ElementState::slip_forward : ElementState::slip_backward);
      }
    }
    return mode;
  }

  void add(const std::vector<ProblemMode>& modes, bool strict, const Compared& solution, std::size_t directions = 0) {
    FoundSolution& found = result_.all.solutions.emplace_back();
    for (const ProblemMode& mode : modes) found.modes.push_back(name(problem_, mode));
    found.r = points(solution.z);
    found.u = points(solution.w);
    found.open_directions = directions;
    found.strict = strict;
    if (answer_.mode && std::find(modes.begin(), modes.end(), *answer_.mode) == modes.end()) return;
    Distance d = distance_to(solution);
    if (result_.nearest && !is_nearer(d, result_.distance, tolerance_)) return;
    result_.nearest = result_.all.solutions.size() - 1;
    result_.distance = std::move(d);
  }

  void add(ContactContinuum c) {
    add({c.mode}, false, nearest_member(c), c.directions.size());
    result_.all.solutions.back().moves = moves(c);
    result_.continua.push_back(std::move(c));
  }

  void judge_among(ContactSolutions all) {
    for (const auto& s : all.solutions) add(s.modes, s.strict, determined(s.z));
    for (auto& c : all.continua) add(std::move(c));
    const FoundSolution* meant = result_.meant();
    accept(result_.all.verdict(meant));
    if (meant != nullptr) return;
    Effort again(allowed_);
    tell_own(solver_.solve(own_, again));
  }

  /// Judges the answer by its own mode.
  void judge_alone() {
    const Work needed = solver_.work_of_all();  // continua take more
    result_.needed = needed > allowed_ ? needed : unlimited;
    result_.all.unexamined.emplace_back("the other modes");
    ModeOutcome outcome = solver_.solve(own_, effort_);
    const bool open = outcome.continuum.has_value();  // then it always has many solutions
    if (open) add(*std::move(outcome.continuum));
    if (outcome.kind == ModeOutcome::Kind::solution) add({own_}, outcome.strict, determined(outcome.z));
    if (result_.meant() == nullptr) {
      result_.verdict = answer_.mode ? ContactVerdict::wrong : ContactVerdict::undecided;
      return tell_own(outcome);
    }
    if (!open && is_unique_by_bound(problem_)) result_.unique_by = EveryLoad::Reason::bound;
    accept(result_.all.several_motions() ? ContactVerdict::ambiguous
           : result_.unique_by           ? ContactVerdict::unique
                                         : ContactVerdict::undecided);
  }

  void accept(ContactVerdict if_accurate) {
    const bool inaccurate = result_.meant() != nullptr && result_.distance.scaled > tolerance_;
    result_.verdict = inaccurate ? ContactVerdict::inaccurate : if_accurate;
  }

  void tell_own(const ModeOutcome& outcome) {
    OwnMode& own = result_.own.emplace();
    own.mode = name(problem_, own_);
    own.claimed = answer_.mode.has_value();
    if (outcome.kind == ModeOutcome::Kind::violated) {
      own.violated = name(problem_, *outcome.condition);
      own.margin = outcome.margin;
    } else {
      own.reason = outcome.kind == ModeOutcome::Kind::inconsistent ? "the mode has no solution"
                                                                   : "the mode is right, its numbers are not";
    }
  }

  const ContactProblem& problem_;
  const ProblemAnswer& answer_;
  const Rational tolerance_;
  const ContactSolver solver_;
  const Work allowed_;
  Effort& effort_;
  Rational force_ = 0;
  ProblemMode own_;  ///< the mode that the answer claims, or suggests
  SmallJudgement result_;
};

}  // namespace

const FoundSolution* SmallJudgement::meant() const {
  return nearest && distance.scaled <= to_rational(contact_near) ? &all.solutions[*nearest] : nullptr;
}

SmallJudgement judge_small(const ContactProblem& problem, const ProblemAnswer& answer, double tolerance,
                           Effort& effort) {
  return SmallJudge(problem, answer, tolerance, effort).judge();
}

std::optional<SmallCase> small_case(const MixedProblem& problem, std::span<const double> x, std::span<const double> u,
                                    double tolerance, Effort& effort) {
  const std::size_t n = problem.size(), free = problem.free, most_free = 200;
  if (problem.dimension == 3 || free > most_free || n - free > few_components || (n == free && n > 0))
    return std::nullopt;
  try {
    effort.spend(times(times(free, free), times(free, 8)));
    auto eliminated = slipproof::eliminated(problem);
    if (!eliminated) return std::nullopt;
    ProblemAnswer answer{to_rationals(x.subspan(free)), std::nullopt, std::nullopt};
    if (!u.empty()) answer.w = to_rationals(u);
    SmallJudgement found = judge_small(eliminated->problem, answer, tolerance, effort);
    if (!found.all.complete()) return std::nullopt;
    return SmallCase{*std::move(eliminated), std::move(found)};
  } catch (const TooMuchWork&) {
    return std::nullopt;
  }
}

}  // namespace slipproof
