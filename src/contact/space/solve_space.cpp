#include "contact/space/solve_space.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/number/binary64.hpp"
#include "contact/judge/all_in_space.hpp"
#include "contact/space/space_problem.hpp"

namespace slipproof {

namespace {

Range point(const Rational& value) {
  return {value, value};
}

/// constant + the sum of weights[i] * ranges[i].
Range weighted(const std::vector<Rational>& weights, const std::vector<Range>& ranges, const Rational& constant) {
  Rational low = constant, high = constant;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i].is_zero()) continue;
    const bool up = weights[i].sign() > 0;
    low += weights[i] * (up ? *ranges[i].lower : *ranges[i].upper);
    high += weights[i] * (up ? *ranges[i].upper : *ranges[i].lower);
  }
  return {low, high};
}

/// The angles in degrees of all vectors in a box that is narrow, seen from 0; nothing if it holds 0, or might. An angle
/// of binary64 is right to 1e-13 degrees.
std::optional<Range> angles(const Range& x, const Range& y) {
  const auto number = [](const Rational& value) { return nearest_binary64(value); };
  const double middle = std::atan2(number(Rational(*y.lower + *y.upper)), number(Rational(*x.lower + *x.upper)));
  const bool holds_zero = x.lower->sign() <= 0 && x.upper->sign() >= 0 && y.lower->sign() <= 0 && y.upper->sign() >= 0;
  if (holds_zero) return std::nullopt;
  double low = middle, high = middle;
  for (const auto& cx : {x.lower, x.upper}) {
    for (const auto& cy : {y.lower, y.upper}) {
      const double from_middle = std::remainder(std::atan2(number(*cy), number(*cx)) - middle, 2 * std::numbers::pi);
      low = std::min(low, middle + from_middle);
      high = std::max(high, middle + from_middle);
    }
  }
  constexpr double step = 1e9, slack = 1e-11;
  const auto degrees = [&](double angle, double margin) { return (angle * 180 / std::numbers::pi + margin) * step; };
  const auto whole = [](double value) { return Rational(Integer(static_cast<long>(value)), Integer(1'000'000'000)); };
  return Range{whole(std::floor(degrees(low, -slack))), whole(std::ceil(degrees(high, slack)))};
}

/// Reads a motion of the contact problem as one of the mechanism.
class MotionReader {
 public:
  MotionReader(const Mechanism& mechanism, const SpaceProblem& problem, const ReducedSpace& reduced)
      : m_(mechanism), p_(problem), reduced_(reduced) {}

  SpaceMotion read(const FoundSolution& found) const {
    SpaceMotion motion;
    motion.exists = found.exists;
    motion.unique = found.one_motion && found.others.empty();
    if (!motion.unique && found.others.empty()) motion.others_within = distance_of_others(found);
    motion.open_directions = found.open_directions;
    motion.strict = found.strict;
    const std::vector<std::string> states = parts_of(found.modes.front());
    motion.modes.assign(m_.contacts.size(), "lift");
    motion.slips.resize(m_.contacts.size());
    for (std::size_t i = 0; i < m_.contacts.size(); ++i) {
      if (m_.contacts[i].bilateral) motion.modes[i] = "touch";
    }
    for (std::size_t k = 0; k < states.size(); ++k) add_state(motion, k, states[k], found);
    for (std::size_t j = 0; j < reduced_.V.size(); ++j) {
      motion.accelerations.push_back(weighted(reduced_.V[j], found.r, reduced_.v0[j]));
    }
    add_gaps_and_slips(motion, found);
    add_forces(motion, found);
    return motion;
  }

 private:
  static Rational distance_of_others(const FoundSolution& found) {
    Rational largest;
    const std::vector<Range>& around = found.around.empty() ? found.u : found.around;
    for (std::size_t i = 0; i < around.size(); ++i) {
      largest = std::max(
          {largest, Rational(*around[i].upper - *found.u[i].lower), Rational(*found.u[i].upper - *around[i].lower)});
    }
    return largest;
  }

  static std::vector<std::string> parts_of(const std::string& mode) {
    std::vector<std::string> parts;
    for (std::size_t from = 0; from < mode.size();) {
      const std::size_t end = std::min(mode.find('/', from), mode.size());
      parts.push_back(mode.substr(from, end - from));
      from = end + 1;
    }
    return parts;
  }

  void add_state(SpaceMotion& motion, std::size_t k, const std::string& state, const FoundSolution& found) const {
    const SpaceContact& contact = p_.contacts[k];
    std::string& mode = motion.modes[contact.contact];
    const auto is_zero = [&](std::size_t i) { return found.u[i].is_point() && found.u[i].lower->is_zero(); };
    const bool at_rest = !contact.sliding && is_zero(3 * k + 1) && is_zero(3 * k + 2);
    mode = state == "closed" ? (contact.sliding ? "slip" : "touch") : state == "slip" && at_rest ? "stick" : state;
    if (mode != "slip") return;
    std::optional<Range>& angle = motion.slips[contact.contact];
    if (const auto& along = contact.toward ? contact.toward : contact.sliding) {
      angle = angles(point((*along)[0]), point((*along)[1]));
    } else {
      angle = angles(found.u[3 * k + 1], found.u[3 * k + 2]);
    }
  }

  /// Those of closed contacts are u, more narrowly than what follows from all accelerations, and 0 where the mode says
  /// so.
  void add_gaps_and_slips(SpaceMotion& motion, const FoundSolution& found) const {
    const std::size_t bodies = motion.accelerations.size();
    std::size_t row = 0, closed = 0;
    for (std::size_t i = 0; i < m_.contacts.size(); ++i) {
      const bool in_problem = closed < p_.contacts.size() && p_.contacts[closed].contact == i;
      for (std::size_t t = 0; t < (m_.contacts[i].second ? 3U : 1U); ++t, ++row) {
        if (in_problem && (t == 0 || !p_.contacts[closed].toward)) {
          const std::string& mode = motion.modes[i];
          const bool zero = t == 0 ? mode != "lift" : mode == "stick";
          motion.accelerations.push_back(zero ? point(0) : found.u[3 * closed + t]);
          continue;
        }
        std::vector<Rational> weights(bodies);
        for (const auto& [j, weight] : p_.rows[row].terms) weights[j] = weight;
        motion.accelerations.push_back(weighted(weights, motion.accelerations, p_.rows[row].constant));
      }
      closed += in_problem ? 1 : 0;
    }
  }

  void add_forces(SpaceMotion& motion, const FoundSolution& found) const {
    motion.forces.assign(m_.unknowns.size() - m_.accelerations, point(0));
    const auto force = [&](std::size_t unknown) -> std::optional<Range>& {
      return motion.forces[unknown - m_.accelerations];
    };
    for (std::size_t k = 0; k < p_.contacts.size(); ++k) {
      const SpaceContact& contact = p_.contacts[k];
      const MechanismContact& c = m_.contacts[contact.contact];
      const Range& normal = found.r[3 * k];
      force(c.normal) = normal;
      if (!c.second) continue;
      for (std::size_t t = 0; t < 2; ++t) {
        std::optional<Range>& tangent = force(t == 0 ? *c.tangent : c.second->force);
        tangent = found.r[3 * k + 1 + t];
        if (contact.sliding) tangent = weighted({Rational(-contact.mu * (*contact.sliding)[t])}, {normal}, 0);
      }
    }
    for (std::size_t j = 0; j < p_.held.size(); ++j) {
      if (reduced_.determined[j]) {
        force(p_.held[j]) = weighted(reduced_.L[j], found.r, reduced_.l0[j]);
      } else {
        force(p_.held[j]) = std::nullopt;
      }
    }
  }

  const Mechanism& m_;
  const SpaceProblem& p_;
  const ReducedSpace& reduced_;
};

}  // namespace

SolvedSpace solve_space(MechanismScene scene, const CompleteOptions& options) {
  const SpaceProblem problem = space_problem(scene);
  const ReducedSpace free = reduced(problem, scene.mechanism);
  SolvedSpace solved;
  const MotionReader reader(scene.mechanism, problem, free);
  if (problem.contacts.empty()) {
    FoundSolution none;
    none.modes = {""};
    none.strict = true;
    solved.motions.push_back(reader.read(none));
  } else {
    const SolutionTree tree{all_solutions(free.contacts, options), {}};
    const AllSolutions all = all_solutions_of(tree);
    for (const FoundSolution& found : all.solutions) solved.motions.push_back(reader.read(found));
    solved.undecided = all.unexamined;
    solved.open_speed = all.open_speed;
    solved.programs = tree.solutions.programs;
  }
  solved.scene = std::move(scene);
  return solved;
}

}  // namespace slipproof
