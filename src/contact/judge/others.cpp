#include "contact/judge/others.hpp"

#include "base/number/binary64.hpp"
#include "contact/exact/linear_modes.hpp"

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

void look_in_linear_modes(const MixedProblem& problem, Work allowed, ContactJudgement& judgement) {
  LinearSearch& search = judgement.linear_modes.emplace(LinearSearch{linear_modes(problem, Slides::none), false});
  const Work free = problem.free, components = problem.size() - free;
  const Work elimination = times(times(free, free), times(free, 8));
  if (plus(elimination, times(search.modes, components * components)) > allowed) return;
  const auto contacts = eliminated(problem);
  if (!contacts) return;
  const auto can_try = [&](Slides slides) {
    return work_of_linear_modes(problem, contacts->problem, slides) <= allowed;
  };
  if (!can_try(Slides::none)) return;
  const Slides slides = can_try(Slides::axes) ? Slides::axes : Slides::none;
  const KnownSolution known(problem, judgement);
  std::vector<Rational> other;
  each_linear_solution(problem, contacts->problem, slides, std::span(judgement.x).subspan(problem.free),
                       [&](const std::vector<Rational>& r) {
                         std::vector<Rational> x = contacts->with_free(r);
                         if (known.is_not(x)) other = std::move(x);
                         return other.empty();
                       });
  search = {linear_modes(problem, slides), true};
  judgement.other_exact = std::move(other);
}

}  // namespace slipproof
