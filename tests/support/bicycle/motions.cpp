#include "support/bicycle/motions.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace slipproof {

namespace {

using Kind = ModeSolution::Kind;

template <class V>
void add(std::vector<FoundMotion<V>>& motions, ContactMode mode, bool strict, Motion<V> values) {
  for (auto& found : motions) {
    if (found.values == values) {
      found.modes.push_back(mode);
      found.strict = found.strict || strict;
      return;
    }
  }
  motions.push_back({{mode}, strict, std::move(values)});
}

Motion<Rational> at(const Motion<Affine<Rational>>& motion, const Rational& force) {
  Motion<Rational> result;
  for (const Quantity q : all_quantities()) result[q] = motion[q].at(force);
  return result;
}

/// A continuum whose consistent motions at the force shrink to one, gives that one.
std::optional<Motion<Rational>> only_motion(const Continuum& c, const std::vector<ForceInterval>& ranges,
                                            const Rational& force) {
  Motion<Rational> result = at(c.base, force);
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    if (!ranges[k].is_point()) return std::nullopt;
    for (const Quantity q : all_quantities()) result[q] += *ranges[k].lower() * c.directions[k][q];
  }
  return result;
}

/// Where two motions that are affine in the force agree, if at one force only.
std::optional<Rational> crossing(const Motion<Affine<Rational>>& x, const Motion<Affine<Rational>>& y) {
  std::optional<Rational> force;
  for (const Quantity q : all_quantities()) {
    const Affine<Rational> d = x[q] - y[q];
    if (sign(d.beta) == 0) {
      if (sign(d.alpha) != 0) return std::nullopt;
      continue;
    }
    const Rational root = -d.alpha / d.beta;
    if (force && *force != root) return std::nullopt;
    force = root;
  }
  return force;
}

void add_ends(std::vector<Rational>& points, const ForceInterval& interval) {
  if (interval.lower()) points.push_back(*interval.lower());
  if (interval.upper()) points.push_back(*interval.upper());
}

/// Every force at which the set of motions can change.
std::vector<Rational> breakpoints(const ModeTable& table) {
  std::vector<Rational> points;
  std::vector<const ModeSolution*> on_boundary;  // consistent on an interval, yet nowhere strict
  for (const ModeSolution& s : table.solutions()) {
    add_ends(points, s.closed());
    if (s.kind() == Kind::continuum) add_ends(points, s.strict());
    if (s.kind() == Kind::regular && !s.closed().empty() && s.strict().empty()) on_boundary.push_back(&s);
  }
  for (const ModeSolution* s : on_boundary) {
    for (const ModeSolution& t : table.solutions()) {
      if (&t == s || t.kind() != Kind::regular || t.closed().empty()) continue;
      if (auto force = crossing(s->motion(), t.motion())) points.push_back(std::move(*force));
    }
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// What a mode gives at a force.
void visit(const ModeSolution& s, const Rational& force, MotionsAtForce& result) {
  if (!s.closed().contains(force)) return;
  if (s.kind() == Kind::regular) {
    add(result.motions, s.mode(), s.strict().contains(force), at(s.motion(), force));
    return;
  }
  auto ranges = s.continuum().parameter_ranges(force);
  if (!ranges) return;
  if (auto motion = only_motion(s.continuum(), *ranges, force)) {
    add(result.motions, s.mode(), false, std::move(*motion));
  } else {
    result.continua.push_back({s.shared_continuum(), std::move(*ranges), s.strict().contains(force)});
  }
}

Cell point_cell(const ModeTable& table, const Rational& force) {
  Cell cell;
  cell.forces = ForceInterval::point(force);
  MotionsAtForce found;
  for (const ModeSolution& s : table.solutions()) visit(s, force, found);
  for (auto& motion : found.motions) {
    Motion<Affine<Rational>> values;
    for (const Quantity q : all_quantities()) values[q] = motion.values[q];
    cell.motions.push_back({std::move(motion.modes), motion.strict, std::move(values)});
  }
  for (const auto& c : found.continua) cell.continua.push_back(c.continuum->mode);
  return cell;
}

/// The same over a cell. The motions at all forces are a polytope, convex: if those at one force inside are one motion,
/// so are those at every other, and it is affine in the force.
std::optional<Motion<Affine<Rational>>> only_motion(const Continuum& c, ForceInterval forces) {
  forces.intersect(c.closed);
  const Rational x = forces.sample();
  const Rational y = ForceInterval::open_between(x, forces.upper()).sample();
  std::array<std::optional<Motion<Rational>>, 2> found;
  for (const std::size_t i : {0U, 1U}) {
    const Rational& force = i == 0 ? x : y;
    const auto ranges = c.parameter_ranges(force);
    if (ranges) found[i] = only_motion(c, *ranges, force);
    if (!found[i]) return std::nullopt;
  }
  Motion<Affine<Rational>> result;
  for (const Quantity q : all_quantities()) {
    const Rational slope = ((*found[1])[q] - (*found[0])[q]) / (y - x);
    result[q] = {(*found[0])[q] - slope * x, slope};
  }
  return result;
}

Cell open_cell(const ModeTable& table, const ForceInterval& forces) {
  Cell cell;
  cell.forces = forces;
  const Rational inside = forces.sample();
  for (const ModeSolution& s : table.solutions()) {
    if (!s.closed().contains(inside)) continue;
    if (s.kind() == Kind::continuum) {
      if (auto motion = only_motion(s.continuum(), forces)) {
        add(cell.motions, s.mode(), false, std::move(*motion));
      } else {
        cell.continua.push_back(s.mode());
      }
    } else {
      add(cell.motions, s.mode(), s.strict().contains(inside), s.motion());
    }
  }
  return cell;
}

}  // namespace

MotionsAtForce motions_at(const ModeTable& table, const Rational& force) {
  MotionsAtForce result;
  for (const ModeSolution& s : table.solutions()) visit(s, force, result);
  return result;
}

MotionsAtForce motions_at(const ForcedScene<Rational>& s) {
  return motions_at(ModeTable(s.bicycle, s.road, s.force_kind), s.F);
}

MotionsAtForce motions_at(const ForcedScene<double>& scene) {
  return motions_at(to_rational(scene));
}

std::vector<Cell> partition(const ModeTable& table) {
  std::vector<Cell> cells;
  std::optional<Rational> below;
  for (const Rational& point : breakpoints(table)) {
    cells.push_back(open_cell(table, ForceInterval::open_between(below, point)));
    cells.push_back(point_cell(table, point));
    below = point;
  }
  cells.push_back(open_cell(table, ForceInterval::open_between(below, std::nullopt)));
  return cells;
}

}  // namespace slipproof
