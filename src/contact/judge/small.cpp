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
    result_.looks_like = answer_.mode ? *answer_.mode : mode_of_answer();
    result_.all = solutions();
    if (result_.all) {
      judge_among(*result_.all);
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
    if (auto only = solver_.unique_solution(result_.looks_like, effort_)) {
      result_.unique_by = EveryLoad::Reason::definite;
      all.emplace();
      all->solutions.push_back(std::move(*only));
      return all;
    }
    return few ? std::nullopt : solver_.all(effort_);
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

  void consider(const std::vector<ProblemMode>& modes, const Compared& to) {
    if (answer_.mode && std::find(modes.begin(), modes.end(), *answer_.mode) == modes.end()) return;
    Distance d = distance_to(to);
    if (!result_.meant || is_nearer(d, result_.meant->distance, tolerance_))
      result_.meant = {modes, to.z, std::move(d)};
  }

  void judge_among(const ContactSolutions& all) {
    for (const auto& s : all.solutions) consider(s.modes, determined(s.z));
    for (const auto& c : all.continua) {
      Compared member = nearest_member(c);
      consider({c.mode}, member);
      result_.members.push_back(std::move(member.z));
    }
    if (result_.near()) {
      accept(all.one() ? ContactVerdict::unique : ContactVerdict::ambiguous);
      return;
    }
    result_.verdict = ContactVerdict::wrong;
    Effort again(allowed_);
    result_.own = solver_.solve(result_.looks_like, again);
  }

  /// Judges the answer by its own mode.
  void judge_alone() {
    const Work needed = solver_.work_of_all();  // continua take more
    result_.needed = needed > allowed_ ? needed : unlimited;
    result_.own = solver_.solve(result_.looks_like, effort_);
    result_.verdict = answer_.mode ? ContactVerdict::wrong : ContactVerdict::undecided;
    const std::optional<ContactContinuum>& continuum = result_.own->continuum;
    if (continuum) {
      consider({result_.looks_like}, nearest_member(*continuum));
    } else if (result_.own->kind == ModeOutcome::Kind::solution) {
      consider({result_.looks_like}, determined(result_.own->z));
    }
    if (!result_.near()) return;
    if (!continuum && is_unique_by_bound(problem_)) result_.unique_by = EveryLoad::Reason::bound;
    accept(continuum           ? ContactVerdict::ambiguous  // it always has many solutions
           : result_.unique_by ? ContactVerdict::unique
                               : ContactVerdict::undecided);
  }

  void accept(ContactVerdict if_accurate) {
    const bool accurate = result_.meant->distance.scaled <= tolerance_;
    result_.verdict = accurate ? if_accurate : ContactVerdict::inaccurate;
  }

  const ContactProblem& problem_;
  const ProblemAnswer& answer_;
  const Rational tolerance_;
  const ContactSolver solver_;
  const Work allowed_;
  Effort& effort_;
  Rational force_ = 0;
  SmallJudgement result_;
};

}  // namespace

bool SmallJudgement::near() const {
  return meant && meant->distance.scaled <= to_rational(contact_near);
}

SmallJudgement judge_small(const ContactProblem& problem, const ProblemAnswer& answer, double tolerance,
                           Effort& effort) {
  return SmallJudge(problem, answer, tolerance, effort).judge();
}

std::shared_ptr<const SmallCase> small_case(const MixedProblem& problem, std::span<const double> x,
                                            std::span<const double> u, double tolerance, Effort& effort) {
  const std::size_t n = problem.size(), free = problem.free, most_free = 200;
  if (problem.dimension == 3 || free > most_free || n - free > few_components || (n == free && n > 0)) return nullptr;
  try {
    effort.spend(times(times(free, free), times(free, 8)));
    auto eliminated = slipproof::eliminated(problem);
    if (!eliminated) return nullptr;
    ProblemAnswer answer{to_rationals(x.subspan(free)), std::nullopt, std::nullopt};
    if (!u.empty()) answer.w = to_rationals(u);
    SmallJudgement found = judge_small(eliminated->problem, answer, tolerance, effort);
    if (!found.all) return nullptr;
    return std::make_shared<SmallCase>(SmallCase{*std::move(eliminated), std::move(answer), std::move(found)});
  } catch (const TooMuchWork&) {
    return nullptr;
  }
}

}  // namespace slipproof
