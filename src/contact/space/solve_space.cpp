#include "contact/space/solve_space.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "contact/judge/all_in_space.hpp"
#include "contact/space/from_contacts.hpp"
#include "mechanics/points/degrees.hpp"

namespace slipproof {

namespace {

Range point(const Rational& value) {
  return {value, value};
}

/// The angles in degrees of all vectors in a box, seen from 0; nothing if it holds 0. The box lies in half a turn, and
/// a corner is first of all where no other is clockwise of it.
std::optional<Range> angles(const Range& x, const Range& y) {
  const bool holds_zero = x.lower->sign() <= 0 && x.upper->sign() >= 0 && y.lower->sign() <= 0 && y.upper->sign() >= 0;
  if (holds_zero) return std::nullopt;
  std::array<std::pair<Rational, Rational>, 4> corners;
  std::size_t next = 0;
  for (const auto& cx : {*x.lower, *x.upper}) {
    for (const auto& cy : {*y.lower, *y.upper}) corners[next++] = {cx, cy};
  }
  const auto is_clockwise_of = [](const auto& a, const auto& b) { return a.first * b.second > a.second * b.first; };
  const auto &first = *std::ranges::min_element(corners, is_clockwise_of),
             &last = *std::ranges::max_element(corners, is_clockwise_of);
  const auto between = [&](unsigned decimals) {
    Range range{degrees_of_direction(first.first, first.second, decimals).first,
                degrees_of_direction(last.first, last.second, decimals).second};
    const bool beyond_half_a_turn = *range.upper < *range.lower, below = (*y.lower + *y.upper).sign() < 0;
    if (beyond_half_a_turn) (below ? * range.lower -= 360 : * range.upper += 360);
    return range;
  };
  constexpr unsigned least = 12, most = 60;
  unsigned decimals = least;  // a hundredth of the width
  const Range narrow = between(most);
  const Rational width = *narrow.upper - *narrow.lower;
  for (Rational unit = Rational(1, 10'000'000'000); decimals < most && unit > width; unit /= 10) ++decimals;
  return between(decimals);
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
    motion.open_directions = found.may_be_open ? std::nullopt : std::optional(found.open_directions);
    motion.strict = found.strict;
    motion.modes.assign(m_.contacts.size(), "lift");
    motion.slips.resize(m_.contacts.size());
    for (std::size_t i = 0; i < m_.contacts.size(); ++i) {
      if (m_.contacts[i].bilateral) motion.modes[i] = "touch";
    }
    for (std::size_t k = 0; k < found.states.size(); ++k) {
      motion.modes[p_.contacts[k].contact] = state_of(k, found.states[k].kind, found);
    }
    add_accelerations(motion, found);
    add_forces(motion, found);
    if (motion.is_continuum()) add_continuum(motion, found);
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

  /// A slip without a speed is none.
  std::string state_of(std::size_t k, ContactState::Kind kind, const FoundSolution& found) const {
    using Kind = ContactState::Kind;
    const bool slides = p_.contacts[k].sliding.has_value();
    if (kind == Kind::closed) return slides ? "slip" : "touch";
    if (kind != Kind::slip) return kind == Kind::stick ? "stick" : "lift";
    const auto is_zero = [&](std::size_t i) { return found.u[i].is_point() && found.u[i].lower->is_zero(); };
    return !slides && is_zero(3 * k + 1) && is_zero(3 * k + 2) ? "stick" : "slip";
  }

  void add_slips(SpaceMotion& motion, const std::vector<Range>& u) const {
    for (std::size_t k = 0; k < p_.contacts.size(); ++k) {
      const SpaceContact& contact = p_.contacts[k];
      if (motion.modes[contact.contact] != "slip") continue;
      const auto& known = contact.toward ? contact.toward : contact.sliding;
      motion.slips[contact.contact] =
          known ? angles(point((*known)[0]), point((*known)[1])) : angles(u[3 * k + 1], u[3 * k + 2]);
    }
  }

  /// Where the mode says that a row of u is 0, it is. What follows from rows that are known exactly is exact.
  void add_accelerations(SpaceMotion& motion, const FoundSolution& found) const {
    std::vector<Range> u = found.u;
    std::vector<std::size_t> known;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const std::string& mode = motion.modes[p_.contacts[i / 3].contact];
      if (i % 3 == 0 ? mode != "lift" : mode == "stick") u[i] = point(0);
      if (u[i].is_point()) known.push_back(i);
    }
    const ExactContacts& contacts = reduced_.contacts;
    const auto slips = from_contacts(contacts, known, u, contacts.W, contacts.q);
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = slips[i].value_or(u[i]);
    const auto exact = from_contacts(contacts, known, u, reduced_.V, reduced_.v0);
    for (std::size_t j = 0; j < exact.size(); ++j) {
      motion.accelerations.push_back(exact[j] ? *exact[j] : weighted(reduced_.V[j], found.r, reduced_.v0[j]));
    }
    add_gaps_and_slips(motion.accelerations, u);
    add_slips(motion, u);
  }

  /// Those of closed contacts are u, more narrowly than what follows from the accelerations of bodies, which are there.
  void add_gaps_and_slips(std::vector<Range>& accelerations, const std::vector<Range>& u) const {
    const std::size_t bodies = accelerations.size();
    std::size_t row = 0, closed = 0;
    for (std::size_t i = 0; i < m_.contacts.size(); ++i) {
      const bool in_problem = closed < p_.contacts.size() && p_.contacts[closed].contact == i;
      for (std::size_t t = 0; t < (m_.contacts[i].second ? 3U : 1U); ++t, ++row) {
        if (in_problem && (t == 0 || !p_.contacts[closed].toward)) {
          accelerations.push_back(u[3 * closed + t]);
          continue;
        }
        std::vector<Rational> weights(bodies);
        for (const auto& [j, weight] : p_.rows[row].terms) weights[j] = weight;
        accelerations.push_back(weighted(weights, accelerations, p_.rows[row].constant));
      }
      closed += in_problem ? 1 : 0;
    }
  }

  /// Forces are open, so that the accelerations of all of them follow from u alone.
  void add_continuum(SpaceMotion& motion, const FoundSolution& found) const {
    for (const FoundSolution& other : found.others) motion.others.push_back(read(other));
    std::vector<std::size_t> rows(found.around.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    for (auto& range : from_contacts(reduced_.contacts, rows, found.around, reduced_.V, reduced_.v0)) {
      motion.all_accelerations.push_back(range.value_or(Range{}));
    }
    add_gaps_and_slips(motion.all_accelerations, found.around);
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

SolvedSpace read_motions(MechanismScene scene, const SpaceProblem& problem, const ReducedSpace& free,
                         const AllSolutions& all) {
  SolvedSpace solved;
  const MotionReader reader(scene.mechanism, problem, free);
  for (const FoundSolution& found : all.solutions) solved.motions.push_back(reader.read(found));
  solved.undecided = all.unexamined;
  solved.open_speed = all.open_speed;
  solved.scene = std::move(scene);
  return solved;
}

SolvedSpace solve_space(MechanismScene scene, const CompleteOptions& options) {
  const SpaceProblem problem = space_problem(scene);
  const ReducedSpace free = reduced(problem, scene.mechanism);
  if (problem.contacts.empty()) {
    AllSolutions one;
    one.solutions.emplace_back().strict = true;
    return read_motions(std::move(scene), problem, free, one);
  }
  const SolutionTree tree{all_solutions(free.contacts, options), {}};
  SolvedSpace solved = read_motions(std::move(scene), problem, free, all_solutions_of(tree));
  solved.programs = tree.solutions.programs;
  return solved;
}

}  // namespace slipproof
