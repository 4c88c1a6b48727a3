#include "contact/judge/all_in_space.hpp"

#include <fmt/format.h>

#include "base/number/binary64.hpp"

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

std::string mode_text(const ContactPattern& mode, std::size_t dimension) {
  std::string text;
  for (const ContactState& state : mode) {
    text += (text.empty() ? "" : "/") + std::string(state_word(state));
    if (state.kind == Kind::slip && dimension == 2) text += state.from.x.sign() > 0 ? '+' : '-';
  }
  return text;
}

/// Whether no condition of its mode holds with equality.
bool is_strict(const ExactContacts& contacts, const SpatialMotion& motion) {
  if (!motion.is_exact()) return true;  // the box of its forces would not be in the cones
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

std::optional<SolutionTree> solution_tree(const MixedProblem& problem, Work effort) {
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
  return SolutionTree{all_solutions(contacts, options), std::move(inverse)};
}

AllSolutions all_solutions_of(const SolutionTree& tree) {
  const CompleteSolutions& found = tree.solutions;
  const ScaledContacts& scaled = found.scaled;
  AllSolutions result;
  result.dimension = scaled.contacts.dimension;
  for (const SpatialMotion& motion : found.motions) {
    FoundSolution& solution = result.solutions.emplace_back();
    solution.modes = {mode_text(motion.mode, result.dimension)};
    solution.r = ranges(motion.r, motion.r_radius, scaled.force_unit);
    solution.u = ranges(motion.u, motion.u_radius, scaled.velocity_unit);
    solution.open_directions = motion.open_directions;
    solution.strict = is_strict(scaled.contacts, motion);
    solution.alone = motion.is_exact() || !motion.alone.is_zero();
  }
  for (const PatternNode& node : found.nodes) {
    if (node.end == PatternNode::End::undecided) {
      result.unexamined.push_back(mode_text(node.pattern, result.dimension));
    }
  }
  return result;
}

}  // namespace slipproof
