#include "contact/rest/can_rest.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slipproof {

namespace {

constexpr int most_rounds = 40;
constexpr double nearly = 1e-7;  // what floating point may have made of 0: then the exact program decides

double angle_of(const CirclePoint& point) {
  return std::atan2(point[1].to_double(), point[0].to_double());
}

/// Adds points in the direction of a tangent that lies outside of the polygon in the circle of that radius. False if it
/// lies inside, or the polygon is as fine there as it gets.
bool add_points(std::vector<CirclePoint>& polygon, double radius, double x, double y) {
  constexpr double finest = 1e-7, full = 2 * std::numbers::pi;
  if (!(std::hypot(x, y) > 1e-12 * radius)) return false;
  const double angle = std::atan2(y, x);
  double before = -full, after = full;  // of the neighbours, from there
  for (const CirclePoint& point : polygon) {
    double from = std::remainder(angle_of(point) - angle, full);
    (from <= 0 ? before : after) = from <= 0 ? std::max(before, from) : std::min(after, from);
  }
  if (before < -std::numbers::pi || after > std::numbers::pi) return false;
  const double half = (after - before) / 2, from_middle = (after + before) / 2;
  if (half < finest || std::hypot(x, y) * std::cos(from_middle) <= radius * std::cos(half) * (1 + 1e-13)) return false;
  bool added = false;
  for (const double at : {before / 8, 0.0, after / 8}) {
    const CirclePoint point = circle_point_near(angle + at);
    if (std::ranges::find(polygon, point) != polygon.end()) continue;
    const auto place =
        std::ranges::find_if(polygon, [&](const CirclePoint& p) { return angle_of(p) > angle_of(point); });
    polygon.insert(place, point);
    added = true;
  }
  return added;
}

bool is_power_gained(const std::optional<VirtualMotion>& motion) {
  return motion && motion->power.sign() > 0;
}

}  // namespace

RestSolver::RestSolver(const RestProblem& problem, Effort& effort)
    : problem_(problem), effort_(effort), polygons_(first_polygons(problem)) {
  has_circles_ = std::ranges::any_of(polygons_, [](const auto& polygon) { return !polygon.empty(); });
  for (std::vector<CirclePoint>& polygon : polygons_) {
    std::ranges::sort(polygon, {}, angle_of);
  }
}

RestSolver::Answer RestSolver::answer(const SparseProgram& program) {
  ++programs_;
  Answer result;
  result.proposed = proposed(program);
  if (!result.proposed || result.proposed->kind == ProposedOptimum::Kind::other) {
    make_exact(program, result);
    return result;
  }
  result.least = result.proposed->least;
  result.feasible = result.proposed->kind == ProposedOptimum::Kind::optimal;
  return result;
}

void RestSolver::make_exact(const SparseProgram& program, Answer& answer) {
  if (answer.exact) return;
  answer.exact = minimize(program, answer.proposed ? answer.proposed->basis : std::vector<std::size_t>(), effort_);
  answer.feasible = answer.exact->kind != SparseOptimum::Kind::infeasible;
  Rational least;
  for (std::size_t j = 0; j < program.columns.size(); ++j) least += program.columns[j].cost * answer.exact->x[j];
  answer.least = least.to_double();
}

std::vector<double> RestSolver::forces_of(const RestProgram& program, const Answer& answer, bool margin) const {
  if (!answer.exact) return program.forces(answer.proposed->x, margin);
  std::vector<double> x;
  for (const Rational& value : answer.exact->x) x.push_back(value.to_double());
  return program.forces(x, margin);
}

bool RestSolver::refine(const std::vector<double>& forces) {
  bool any = false;
  for (std::size_t k = 0; k < polygons_.size(); ++k) {
    if (polygons_[k].empty()) continue;
    const RestProblem::Contact& contact = problem_.contacts[k];
    const double radius = contact.mu.to_double() * forces[contact.normal];
    any = add_points(polygons_[k], radius, forces[contact.tangents[0]], forces[contact.tangents[1]]) || any;
  }
  return any;
}

/// Forces from polygons inside. True if nothing more is to be found.
bool RestSolver::settle(const RestPush& push, const RestProgram& within, RestDecision& decision) {
  const SparseProgram program = within.margin(push);
  Answer inside = answer(program);
  if (has_circles_ && (!inside.feasible || inside.least > nearly)) return false;
  make_exact(program, inside);
  const SparseOptimum& exact = *inside.exact;
  if (exact.kind == SparseOptimum::Kind::optimal && exact.x[within.last_column()].sign() >= 0) {
    std::vector<Rational> forces = within.forces(exact.x, true);
    if (holds(problem_, push, forces)) {
      decision.can = true;
      decision.forces = std::move(forces);
      if (exact.x[within.last_column()].sign() > 0) return true;
    }
  }
  if (has_circles_) return false;
  auto motion = virtual_motion(problem_, push, exact.y);
  if (decision.can) {
    decision.touching = motion && motion->power.is_zero() && motion->opens_or_resists;
    if (decision.touching) decision.border = std::move(motion);
  } else if (is_power_gained(motion)) {
    decision.can = false;
    decision.fall = std::move(motion);
  }
  return true;
}

RestDecision RestSolver::decide(const RestPush& push) {
  RestDecision decision;
  for (int round = 0; round < most_rounds; ++round) {
    if (settle(push, RestProgram(problem_, polygons_, RestProgram::Cones::within), decision)) return decision;
    const RestProgram around(problem_, polygons_, RestProgram::Cones::around);
    const SparseProgram program = around.margin(push);
    Answer outside = answer(program);
    if (!outside.feasible || outside.least > -nearly) {
      make_exact(program, outside);
      auto motion = virtual_motion(problem_, push, outside.exact->y);
      if (!decision.can && is_power_gained(motion)) {
        decision.can = false;
        decision.fall = std::move(motion);
        return decision;
      }
      if (decision.can && motion && motion->power.is_zero() && motion->opens_or_resists) {
        decision.touching = true;
        decision.border = std::move(motion);
        return decision;
      }
    }
    if (!outside.feasible || !refine(forces_of(around, outside, true))) break;
  }
  return decision;
}

RestLoads RestSolver::loads(const RestPush& push, const RestPush& unit, bool not_negative) {
  RestLoads result;
  find_end(push, unit, -1, not_negative, result);
  if (result.none) return result;
  if (not_negative) {
    result.from = ProvedEnd{0, 0};
  } else {
    find_end(push, unit, 1, false, result);
  }
  return result;
}

RestSolver::Side RestSolver::side(RestProgram::Cones cones, const RestPush& push,
                                  const std::vector<VariedLoad>& loads) {
  Side side{RestProgram(problem_, polygons_, cones), {}, {}};
  side.program = side.cones.extreme(push, loads);
  side.answer = answer(side.program);
  return side;
}

RestExtreme RestSolver::unbounded(const Side& inner, std::size_t loads, std::vector<Rational> more) {
  const SparseOptimum& within = *inner.answer.exact;
  const std::size_t last = inner.cones.last_column();
  RestExtreme result{RestExtreme::Kind::unbounded, {}, {}, {}, std::move(more), {}};
  for (std::size_t k = 0; k < loads; ++k) result.inner.push_back(within.x[last + k]);
  result.forces = inner.cones.forces(within.x, false);
  if (loads > 1 || !result.more.empty()) return result;
  result.more = inner.cones.forces(within.direction, false);
  for (Rational& force : result.more) force /= abs(within.direction[last]);
  return result;
}

RestExtreme RestSolver::proved(Side& inner, Side& outer, std::size_t loads) {
  RestExtreme result;
  make_exact(outer.program, outer.answer);
  const SparseOptimum& around = *outer.answer.exact;
  if (around.kind == SparseOptimum::Kind::infeasible) {
    result.kind = RestExtreme::Kind::none;
    result.multipliers = around.y;
    return result;
  }
  make_exact(inner.program, inner.answer);
  const SparseOptimum& within = *inner.answer.exact;
  if (within.kind == SparseOptimum::Kind::unbounded) return unbounded(inner, loads, {});
  if (within.kind != SparseOptimum::Kind::optimal || around.kind != SparseOptimum::Kind::optimal) return result;
  for (std::size_t k = 0; k < loads; ++k) {
    result.inner.push_back(within.x[inner.cones.last_column() + k]);
    result.outer.push_back(around.x[outer.cones.last_column() + k]);
  }
  result.kind = RestExtreme::Kind::found;
  result.forces = inner.cones.forces(within.x, false);
  result.multipliers = around.y;
  return result;
}

std::vector<Rational> RestSolver::what_holds_more(const VariedLoad& load) {
  RestPush unit = load.unit;
  for (std::vector<Rational>* part : {&unit.f, &unit.limits}) {
    for (Rational& value : *part) value *= -load.cost.sign();
  }
  return decide(unit).forces;
}

RestExtreme RestSolver::extreme(const RestPush& push, const std::vector<VariedLoad>& loads, const Nearness& near) {
  std::optional<std::vector<Rational>> more;  // what holds a unit of the load, beyond any that is held
  for (int round = 1;; ++round) {
    Side inner = side(RestProgram::Cones::within, push, loads);
    if (!has_circles_) return proved(inner, inner, loads.size());
    const auto is = [](const Side& side, SparseOptimum::Kind kind) {
      return side.answer.exact && side.answer.exact->kind == kind;
    };
    if (is(inner, SparseOptimum::Kind::unbounded)) return unbounded(inner, loads.size(), {});
    Side outer = side(RestProgram::Cones::around, push, loads);
    if (!outer.answer.feasible) make_exact(outer.program, outer.answer);
    if (is(outer, SparseOptimum::Kind::infeasible)) return proved(inner, outer, loads.size());
    if (is(outer, SparseOptimum::Kind::unbounded) && loads.size() == 1 && !more) more = what_holds_more(loads[0]);
    if (more && !more->empty() && inner.answer.feasible) {
      make_exact(inner.program, inner.answer);
      if (inner.answer.feasible) return unbounded(inner, 1, std::move(*more));
    }
    const double gap = std::abs(inner.answer.least - outer.answer.least);
    const bool close = inner.answer.feasible && !is(outer, SparseOptimum::Kind::unbounded) &&
                       gap <= std::max(near.relative * std::abs(inner.answer.least), near.absolute);
    const bool finer = !close && round < most_rounds && refine(forces_of(outer.cones, outer.answer, false));
    if (!finer) return proved(inner, outer, loads.size());
  }
}

void RestSolver::find_end(const RestPush& push, const RestPush& unit, int direction, bool not_negative,
                          RestLoads& loads) {
  const std::optional<Rational> from = not_negative ? std::optional<Rational>(0) : std::nullopt;
  RestExtreme found = extreme(push, {{unit, direction, from, std::nullopt}}, {});
  loads.none = found.kind == RestExtreme::Kind::none;
  if (found.kind == RestExtreme::Kind::undecided) loads.decided = false;
  if (found.kind == RestExtreme::Kind::found) {
    const auto [lower, upper] = std::minmax(found.inner[0], found.outer[0]);
    (direction < 0 ? loads.to : loads.from) = ProvedEnd{lower, upper};
  } else if (found.kind == RestExtreme::Kind::unbounded) {
    EndlessLoad endless{found.inner[0], std::move(found.forces), std::move(found.more)};
    (direction < 0 ? loads.above : loads.below) = std::move(endless);
  }
}

}  // namespace slipproof
