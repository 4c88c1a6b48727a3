#include "mechanics/kernel/polyhedron.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "base/rounding/approximate.hpp"

namespace slipproof {

namespace {

/// Conditions in the coordinates of a space: `origin` is the index of a condition, or none for an end of the domain.
struct Side {
  AffineForm form;
  std::optional<std::size_t> origin;
};

/// Linear programs over the free variables of a space, and perhaps one more.
class Programs {
 public:
  explicit Programs(const AffineSpace& space) {
    for (std::size_t i = 0; i <= space.unknowns(); ++i) {
      if (space.is_free(i)) variables_.push_back(i);
    }
  }

  /// The form over the free variables, and `slack` times the one more.
  AffineForm compressed(const AffineForm& form, std::optional<int> slack = std::nullopt) const {
    AffineForm result{form.constant, {}};
    for (const std::size_t i : variables_) result.coefficients.push_back(form.coefficients[i]);
    if (slack) result.coefficients.emplace_back(*slack);
    return result;
  }

  /// The least value of -s where all sides are >= s, and s <= 1.
  LinearOptimum most_strict(const std::vector<Side>& sides, Effort* effort) const {
    AffineForm objective{0, std::vector<Rational>(variables_.size() + 1)};
    std::vector<AffineForm> constraints;
    for (const Side& side : sides) constraints.push_back(compressed(side.form, -1));
    objective.coefficients.back() = -1;
    AffineForm limit = objective;
    limit.constant = 1;
    constraints.push_back(std::move(limit));
    return effort == nullptr ? minimize(objective, constraints) : minimize(objective, constraints, *effort);
  }

  std::unique_ptr<LinearProgram> within(const std::vector<AffineForm>& sides) const {
    std::vector<AffineForm> constraints;
    for (const AffineForm& side : sides) constraints.push_back(compressed(side));
    return std::make_unique<LinearProgram>(variables_.size(), constraints);
  }

 private:
  std::vector<std::size_t> variables_;
};

/// Of forms on a space, where the sides are >= 0.
std::vector<Range> ranges_on(const AffineSpace& space, const std::vector<AffineForm>& forms,
                             const std::vector<AffineForm>& sides) {
  const Programs programs(space);
  std::unique_ptr<LinearProgram> program;  // made for the first form that varies
  std::vector<Range> result;
  for (const AffineForm& form : forms) {
    if (is_constant(form)) {
      result.push_back({form.constant, form.constant});
      continue;
    }
    if (!program) program = programs.within(sides);
    Range range;
    range.lower = program->least(programs.compressed(form));
    range.upper = program->least(programs.compressed(-form));
    if (range.upper) *range.upper = -*range.upper;
    result.push_back(std::move(range));
  }
  return result;
}

/// That the load is in an interval, its ends included.
std::vector<Side> ends_of(const AffineSpace& space, const ForceInterval& loads) {
  std::vector<Side> ends;
  if (loads.lower()) ends.push_back({load_minus(*loads.lower(), space.unknowns()), std::nullopt});
  if (loads.upper()) ends.push_back({-load_minus(*loads.upper(), space.unknowns()), std::nullopt});
  return ends;
}

/// One run of narrow().
class Narrowing {
 public:
  Narrowing(AffineSpace space, const std::vector<AffineForm>& conditions, const ForceInterval& domain, Effort* effort,
            std::vector<AffineForm> on_space = {})
      : space_(std::move(space)),
        conditions_(conditions),
        on_space_(std::move(on_space)),
        domain_(domain),
        effort_(effort) {}

  Narrowed run() {
    for (;;) {
      if (auto conflict = collect()) return std::move(*conflict);
      if (sides_.empty() && space_.dimension() == 0 && !space_.load_is_free()) break;
      const Step step = narrow_once();
      if (step == Step::conflict) return std::move(conflict_);
      if (step == Step::done) break;
    }
    return finished();
  }

  /// A conflict, if the first step shows one.
  std::optional<Conflict> first_conflict() {
    if (auto conflict = collect()) return conflict;
    if (narrow_once() == Step::conflict) return std::move(conflict_);
    return std::nullopt;
  }

 private:
  enum class Step { again, done, conflict };

  /// All conditions on the space; those that are decided there are left out.
  std::optional<Conflict> collect() {
    sides_.clear();
    strict_ = true;
    for (std::size_t i = 0; i < conditions_.size(); ++i) {
      AffineForm form = on_space_.empty() ? space_.on(conditions_[i]) : std::move(on_space_[i]);
      if (!is_constant(form)) {
        sides_.push_back({std::move(form), i});
      } else if (form.constant.sign() < 0) {
        return Conflict{{i}, std::move(form.constant)};
      } else if (form.constant.is_zero()) {
        strict_ = false;
      }
    }
    on_space_.clear();  // as it was, before sides vanish
    if (!space_.load_is_free()) {
      if (!domain_.contains(space_.load())) return Conflict{conditions_among(vanished_), std::nullopt};
      return std::nullopt;
    }
    if (domain_.empty()) return Conflict{};
    for (Side& end : ends_of(space_, domain_)) sides_.push_back(std::move(end));
    return std::nullopt;
  }

  Step narrow_once() { return space_.dimension() == 0 ? narrow_loads() : narrow_all(); }

  /// Without free unknowns each side bounds the load.
  Step narrow_loads() {
    std::optional<Bound> lower, upper;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const Bound here(sides_[i].form, i);
      const bool above = sides_[i].form.coefficients.back().sign() > 0;
      auto& end = above ? lower : upper;
      if (!end || (above ? compare(here, *end) > 0 : compare(here, *end) < 0)) end = here;
    }
    const int order = lower && upper ? compare(*lower, *upper) : -1;
    if (order > 0) return conflict_of({lower->side, upper->side});
    if (order == 0) return vanish({lower->side, upper->side});
    const auto load = [&](const auto& end) { return end ? std::optional(load_of(*end)) : std::nullopt; };
    loads_ = ForceInterval::between(load(lower), true, load(upper), true);
    return Step::done;
  }

  /// The load at which a side is 0, with its error.
  struct Bound {
    std::size_t side;
    Approximate near;
    Bound(const AffineForm& form, std::size_t number)
        : side(number), near(-Approximate(form.constant) / Approximate(form.coefficients.back())) {}
  };
  Rational load_of(const Bound& bound) const {
    const AffineForm& form = sides_[bound.side].form;
    return -form.constant / form.coefficients.back();
  }
  int compare(const Bound& x, const Bound& y) const {
    const auto sure = sure_sign(x.near - y.near);
    return sure ? *sure : load_of(x).compare(load_of(y));
  }

  Step narrow_all() {
    if (sides_.empty()) return Step::done;
    const LinearOptimum best = Programs(space_).most_strict(sides_, effort_);
    const int s = -best.value.sign();
    if (s > 0) return Step::done;
    std::vector<std::size_t> tight;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (best.multipliers[i].sign() > 0) tight.push_back(i);
    }
    return s < 0 ? conflict_of(tight) : vanish(tight);
  }

  /// The loads of all solutions, once nothing is left to narrow.
  ForceInterval loads() const {
    if (!space_.load_is_free()) return ForceInterval::point(space_.load());
    if (space_.dimension() == 0) return loads_;
    std::vector<AffineForm> forms;
    for (const Side& side : sides_) forms.push_back(side.form);
    const Range range = ranges_on(space_, {load_minus(0, space_.unknowns())}, forms).front();
    return ForceInterval::between(range.lower, true, range.upper, true);
  }

  /// Sides that are 0 on all solutions.
  Step vanish(const std::vector<std::size_t>& sides) {
    for (const std::size_t i : sides) {
      space_.require(sides_[i].form);
      vanished_.push_back(sides_[i].origin);
    }
    return Step::again;
  }

  Step conflict_of(const std::vector<std::size_t>& sides) {
    std::vector<std::optional<std::size_t>> origins;
    for (const std::size_t i : sides) origins.push_back(sides_[i].origin);
    conflict_.conditions = conditions_among(origins);
    return Step::conflict;
  }

  static std::vector<std::size_t> conditions_among(const std::vector<std::optional<std::size_t>>& origins) {
    std::vector<std::size_t> result;
    for (const auto& origin : origins) {
      if (origin) result.push_back(*origin);
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  Polyhedron finished() {
    ForceInterval whole = loads();
    Polyhedron result{std::move(space_), {}, strict_, std::move(whole)};
    for (Side& side : sides_) {
      if (side.origin) result.sides.push_back(std::move(side.form));
    }
    result.loads.intersect(domain_);
    return result;
  }

  AffineSpace space_;
  const std::vector<AffineForm>& conditions_;
  std::vector<AffineForm> on_space_;  ///< the conditions, where they are known
  const ForceInterval& domain_;
  Effort* effort_;
  std::vector<Side> sides_;
  bool strict_ = true;
  ForceInterval loads_;                               ///< in a space without free unknowns
  std::vector<std::optional<std::size_t>> vanished_;  ///< origins of the sides that became equations
  Conflict conflict_;
};

}  // namespace

Narrowed narrow(AffineSpace space, const std::vector<AffineForm>& conditions, const ForceInterval& domain,
                Effort* effort, std::vector<AffineForm> on_space) {
  return Narrowing(std::move(space), conditions, domain, effort, std::move(on_space)).run();
}

std::optional<Conflict> find_conflict(const AffineSpace& space, const std::vector<AffineForm>& conditions,
                                      const ForceInterval& domain, Effort* effort) {
  return Narrowing(space, conditions, domain, effort).first_conflict();
}

std::optional<Polyhedron> restrict_to_zeros(const Polyhedron& solutions, const std::vector<AffineForm>& vanishing,
                                            Effort* effort) {
  AffineSpace space = solutions.space;
  for (const AffineForm& form : vanishing) {
    if (!space.require(form)) return std::nullopt;
  }
  Narrowed narrowed = narrow(std::move(space), solutions.sides, solutions.loads, effort);
  auto* result = std::get_if<Polyhedron>(&narrowed);
  if (result == nullptr) return std::nullopt;
  result->strict = result->strict && solutions.strict;
  return std::move(*result);
}

std::optional<Polyhedron> at_load(const Polyhedron& solutions, const Rational& load) {
  if (!solutions.space.load_is_free()) {
    return solutions.space.load() == load && solutions.loads.contains(load) ? std::optional(solutions) : std::nullopt;
  }
  return restrict_to_zeros(solutions, {load_minus(load, solutions.space.unknowns())});
}

bool strict_at(const Polyhedron& solutions, const Rational& load) {
  if (solutions.space.dimension() > 0 || !solutions.space.load_is_free()) return at_load(solutions, load)->strict;
  return solutions.strict && std::all_of(solutions.sides.begin(), solutions.sides.end(), [&](const AffineForm& side) {
           return (side.constant + side.coefficients.back() * load).sign() > 0;
         });
}

ForceInterval strict_loads(const Polyhedron& solutions) {
  if (!solutions.strict) return ForceInterval::nothing();
  const ForceInterval& loads = solutions.loads;
  if (loads.is_point()) return loads;
  const auto strict = [&](const std::optional<Rational>& end, bool closed) {
    return closed && strict_at(solutions, *end);
  };
  return ForceInterval::between(loads.lower(), strict(loads.lower(), loads.lower_closed()), loads.upper(),
                                strict(loads.upper(), loads.upper_closed()));
}

std::vector<Range> ranges(const Polyhedron& solutions, const std::vector<AffineForm>& forms) {
  std::vector<AffineForm> sides = solutions.sides;
  if (solutions.space.load_is_free()) {
    for (Side& end : ends_of(solutions.space, solutions.loads)) sides.push_back(std::move(end.form));
  }
  std::vector<AffineForm> on_space;
  for (const AffineForm& form : forms) on_space.push_back(solutions.space.on(form));
  return ranges_on(solutions.space, on_space, sides);
}

}  // namespace slipproof
