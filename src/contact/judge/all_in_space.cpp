#include "contact/judge/all_in_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numbers>

#include "base/number/binary64.hpp"
#include "contact/complete/closing.hpp"
#include "contact/complete/motion/forces_at.hpp"

namespace slipproof {

namespace {

using Kind = ContactState::Kind;

constexpr std::size_t most_free = 60;

/// The inverse of the block of free unknowns; empty if it has none.
RationalMatrix inverse_of_free(const MixedProblem& problem) {
  const std::size_t free = problem.free;
  RationalMatrix rows(free, std::vector<Rational>(2 * free));
  for (std::size_t i = 0; i < free; ++i) {
    const auto columns = problem.A.columns_of(i);
    const auto values = problem.A.values_of(i);
    for (std::size_t e = 0; e < columns.size(); ++e) {
      if (columns[e] < free) rows[i][columns[e]] = to_rational(values[e]);
    }
    rows[i][free + i] = 1;
  }
  const Echelon echelon = eliminate(rows);
  if (echelon.rank(free) < free) return {};
  RationalMatrix inverse(free, std::vector<Rational>(free));
  for (std::size_t i = 0; i < free; ++i) {
    for (std::size_t j = 0; j < free; ++j) inverse[i][j] = Rational(echelon.rows[i][free + j], echelon.pivot);
  }
  return inverse;
}

const char* state_word(const ContactState& state) {
  switch (state.kind) {
    case Kind::any:
      return "any";
    case Kind::open:
      return "lift";
    case Kind::closed:
      return "closed";
    case Kind::stick:
      return "stick";
    default:
      return "slip";
  }
}

/// With `arcs` also between which directions a contact slips in space: `stick/slip from 0 to 90 degrees`.
std::string mode_text(const ContactPattern& mode, std::size_t dimension, bool arcs = false) {
  std::string text;
  for (const ContactState& state : mode) {
    text += (text.empty() ? "" : "/") + std::string(state_word(state));
    if (state.kind != Kind::slip) continue;
    if (dimension == 2) text += state.from.x.sign() > 0 ? '+' : '-';
    if (dimension < 3 || !arcs) continue;
    const double from = state.from.angle(), degree = std::numbers::pi / 180;
    text += fmt::format(" from {:.6g} to {:.6g} degrees", from / degree, (from + state.width()) / degree);
  }
  return text;
}

/// Whether no condition of its mode holds with equality.
bool is_strict(const ExactContacts& contacts, const SpatialMotion& motion) {
  // The box of other forces would not be in the cones.
  if (!motion.is_exact()) return std::ranges::none_of(motion.touching, std::identity());
  for (std::size_t k = 0; k < motion.mode.size(); ++k) {
    const std::size_t i = contacts.normal(k);
    const bool is_open = motion.mode[k].kind == Kind::open;
    if ((is_open ? motion.u[i] : motion.r[i]).sign() <= 0) return false;
    if (is_open || !contacts.has_friction(k)) continue;
    Rational force, speed;
    for (std::size_t t = 1; t < contacts.dimension; ++t) {
      force += motion.r[i + t] * motion.r[i + t];
      speed += motion.u[i + t] * motion.u[i + t];
    }
    const Rational limit = contacts.mu[k] * motion.r[i];
    if (motion.mode[k].kind == Kind::stick ? force >= limit * limit : speed.is_zero()) return false;
  }
  return true;
}

std::vector<Range> ranges(const std::vector<Rational>& centers, const std::vector<Rational>& radii,
                          const std::vector<Rational>& units) {
  std::vector<Range> result;
  for (std::size_t i = 0; i < centers.size(); ++i) {
    result.push_back({Rational((centers[i] - radii[i]) * units[i]), Rational((centers[i] + radii[i]) * units[i])});
  }
  return result;
}

}  // namespace

std::optional<SolutionTree> solution_tree(const MixedProblem& problem, Work effort, const SearchProgress& progress) {
  if (problem.free > most_free) return std::nullopt;
  RationalMatrix inverse;
  if (problem.free > 0) {
    inverse = inverse_of_free(problem);
    if (inverse.empty()) return std::nullopt;
  }
  auto reduced = eliminated(problem);
  if (!reduced) return std::nullopt;
  ExactContacts contacts{problem.dimension, std::move(reduced->problem.W), std::move(reduced->problem.q),
                         to_rationals(problem.mu)};
  CompleteOptions options;
  options.effort = effort;
  options.progress = progress;
  return SolutionTree{all_solutions(contacts, options), std::move(inverse)};
}

namespace {

std::vector<Range> ranges(const VelocityBox& box, const std::vector<Rational>& units) {
  std::vector<Range> result;
  for (std::size_t i = 0; i < box.low.size(); ++i) {
    result.push_back({Rational(box.low[i] * units[i]), Rational(box.high[i] * units[i])});
  }
  return result;
}

/// Of each motion the one in whose place its own is: itself, or the first other one.
std::vector<std::size_t> hosts_of(const CompleteSolutions& found) {
  std::vector<std::size_t> hosts;
  for (std::size_t m = 0; m < found.motions.size(); ++m) {
    hosts.push_back(m);
    for (std::size_t h = 0; h < found.motions.size() && hosts[m] == m; ++h) {
      const bool is_host = h != m && !found.within[h].empty() && (h > m || hosts[h] == h);
      if (is_host && place_of(found, h).contains(place_of(found, m))) hosts[m] = h;
    }
  }
  for (std::size_t& host : hosts) {
    while (hosts[host] != host) host = hosts[host];
  }
  return hosts;
}

/// Whether no other forces give an exact motion: the columns of W of all forces that the patterns that it stands for
/// allow are independent.
bool has_one_force(const CompleteSolutions& found, std::size_t m) {
  const ExactContacts& contacts = found.scaled.contacts;
  std::vector<bool> pressed(contacts.contacts(), false);
  for (const PatternNode& node : found.nodes) {
    const bool own = node.end == PatternNode::End::motion || node.end == PatternNode::End::frictionless;
    if (!own || node.motion != m) continue;
    for (std::size_t k = 0; k < pressed.size(); ++k) pressed[k] = pressed[k] || node.pattern[k].kind != Kind::open;
  }
  for (std::size_t k = 0; k < pressed.size(); ++k) {  // where u is that of the motion everywhere
    if (found.motions[m].u[contacts.normal(k)].sign() > 0) pressed[k] = false;
  }
  return open_directions(contacts, pressed) == 0;
}

/// The motion by other forces with the same velocities, in the mode that is theirs.
SpatialMotion by_forces(const ExactContacts& contacts, SpatialMotion motion, ForceFamily family) {
  motion.r = std::move(family.r);
  motion.open_directions = family.open_directions;
  for (std::size_t k = 0; k < motion.mode.size(); ++k) {
    const std::size_t i = contacts.normal(k);
    if (motion.mode[k].kind != Kind::open || motion.r[i].is_zero()) continue;
    const auto slip = std::span(motion.u).subspan(i + 1, contacts.dimension - 1);
    const bool slips = std::ranges::any_of(slip, [](const Rational& x) { return !x.is_zero(); });
    motion.mode[k].kind = !contacts.has_friction(k) ? Kind::closed : slips ? Kind::slip : Kind::stick;
    if (slips) motion.mode[k].from.x = slip.front().sign();  // in space no matter
  }
  return motion;
}

FoundSolution solution_of(const CompleteSolutions& found, std::size_t m) {
  const ScaledContacts& scaled = found.scaled;
  SpatialMotion motion = found.motions[m];
  FoundSolution solution;
  solution.one_motion = found.within[m].empty() && (motion.is_exact() || !motion.alone.is_zero());
  bool are_all = !motion.alone.is_zero() || has_one_force(found, m);
  if (!are_all && motion.is_exact()) {
    ForceFamily family = forces_at(scaled.contacts, motion);
    are_all = family.are_all || family.open_directions > 0;
    motion = by_forces(scaled.contacts, std::move(motion), std::move(family));
  } else if (!are_all && !motion.touching.empty()) {
    auto pressing = pressing_motion(scaled.contacts, motion);
    if (pressing) motion = std::move(*pressing);
  }
  solution.alone = solution.one_motion && are_all;
  solution.may_be_open = !are_all && motion.open_directions == 0;
  solution.modes = {mode_text(motion.mode, scaled.contacts.dimension)};
  solution.states = motion.mode;
  solution.r = ranges(motion.r, motion.r_radius, scaled.force_unit);
  solution.u = ranges(motion.u, motion.u_radius, scaled.velocity_unit);
  if (!found.within[m].empty()) solution.around = ranges(place_of(found, m), scaled.velocity_unit);
  solution.open_directions = motion.open_directions;
  solution.strict = is_strict(scaled.contacts, motion);
  return solution;
}

/// The largest |u_i| in patterns that stay open, in the units of the problem; nothing where it is not bounded.
std::optional<double> open_speed(const CompleteSolutions& found) {
  constexpr std::size_t most_looked_at = 50;  // else of all patterns together
  const SearchProblem problem(found.scaled.contacts);
  const bool together = found.undecided() > most_looked_at;
  Rational largest;
  for (const PatternNode& node : found.nodes) {
    if (together ? &node != found.nodes.data() : node.end != PatternNode::End::undecided) continue;
    PatternProgram program(problem.exact, problem.integers, problem.floating, node.pattern);
    if (!program.feasibility().y.empty()) continue;  // it was not looked at, and is empty
    std::size_t programs = 0;
    const auto bounded = bound_velocities(problem, node.pattern, nullptr, programs);
    if (!bounded) return std::nullopt;
    for (std::size_t i = 0; i < bounded->box.low.size(); ++i) {
      const Rational most = std::max(Rational(abs(bounded->box.low[i])), Rational(abs(bounded->box.high[i])));
      largest = std::max(largest, Rational(most * found.scaled.velocity_unit[i]));
    }
  }
  return enclose(largest).upper;
}

}  // namespace

AllSolutions all_solutions_of(const SolutionTree& tree) {
  const CompleteSolutions& found = tree.solutions;
  AllSolutions result;
  result.dimension = found.scaled.contacts.dimension;
  const std::vector<std::size_t> hosts = hosts_of(found);
  for (std::size_t m = 0; m < hosts.size(); ++m) {
    if (hosts[m] != m) continue;
    FoundSolution& solution = result.solutions.emplace_back(solution_of(found, m));
    for (std::size_t other = 0; other < hosts.size(); ++other) {
      if (other == m || hosts[other] != m) continue;
      solution.others.push_back(solution_of(found, other));
      // Motions at the ends of a continuum, where contacts touch without a force, leave nothing open by themselves.
      solution.open_directions =
          std::max({solution.open_directions, found.motions[other].open_directions, std::size_t{1}});
      solution.may_be_open = false;
    }
  }
  for (const PatternNode& node : found.nodes) {
    if (node.end == PatternNode::End::undecided) {
      result.unexamined.push_back(mode_text(node.pattern, result.dimension, true));
    }
  }
  if (!result.complete()) result.open_speed = open_speed(found);
  return result;
}

}  // namespace slipproof
