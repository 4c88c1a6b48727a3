// The kernel beside the definition of modes and motions, on random mechanisms.
#include <doctest/doctest.h>

#include <algorithm>

#include "mechanics/kernel/naive.hpp"
#include "mechanics/kernel/random_problem.hpp"
#include "support/how_many.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

using Load = std::optional<Rational>;

std::set<std::string> names_of(const std::vector<MechanismMode>& modes) {
  std::set<std::string> result;
  for (const auto& mode : modes) result.insert(name(mode));
  return result;
}

const NaiveMode& named(const std::vector<NaiveMode>& modes, const MechanismMode& mode) {
  const auto found = std::find_if(modes.begin(), modes.end(), [&](const NaiveMode& m) { return m.name == name(mode); });
  REQUIRE(found != modes.end());
  return *found;
}

bool is_range(const Range& range, const ForceInterval& expected) {
  return range.lower == expected.lower() && range.upper == expected.upper();
}

/// What was met, so that a test knows that it tested something.
struct Counts {
  int several = 0, none = 0, boundary = 0, continua = 0, undetermined = 0, hysteresis = 0, excluded = 0, violated = 0;
};

void check_forces(const std::vector<Range>& found, const std::vector<ForceInterval>& expected, Counts& counts) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    CHECK(is_range(found[i], expected[i]));
    counts.undetermined += expected[i].is_point() ? 0 : 1;
  }
}

/// The kernel's conditions that exclude each other do so by the raw system, and the one that is violated is, by the
/// margin.
void check_rejected(const FrictionProblem& problem, const std::vector<NaiveMode>& modes, const RejectedMode& rejected,
                    const Load& load, Counts& counts) {
  CAPTURE(name(rejected.mode));
  RawSystem system = named(modes, rejected.mode).equations_only(problem, load);
  const auto form = [&](const ViolatedCondition& v) {
    CHECK(v.state == rejected.mode[v.element]);
    return form_of(problem.elements[v.element], v.state, v.condition);
  };
  if (rejected.margin) {
    REQUIRE(rejected.because.size() == 1);
    CHECK(*rejected.margin < 0);
    const ForceInterval values = shadow(system, form(rejected.because[0]));
    CHECK((values.empty() || values == ForceInterval::point(*rejected.margin)));
    ++counts.violated;
  }
  for (const ViolatedCondition& v : rejected.because) system.inequalities.push_back({form(v), false});
  CHECK_FALSE(is_solvable(system));
  counts.excluded += rejected.because.size() > 1 ? 1 : 0;
}

/// The reason of a mode alone: one condition if one suffices, or as many as are needed.
void check_own_reason(const FrictionProblem& problem, const std::vector<NaiveMode>& modes, const MechanismMode& mode,
                      const Load& load, Counts& counts) {
  const ModesOf own = mode_of(problem, mode, load);
  REQUIRE(own.rejected.size() == 1);
  const RejectedMode& rejected = own.rejected[0];
  check_rejected(problem, modes, rejected, load, counts);
  RawSystem system = named(modes, mode).equations_only(problem, load);
  CHECK(rejected.because.empty() == !is_solvable(system));
  if (rejected.margin) return;
  for (const ViolatedCondition& v : rejected.because) {
    system.inequalities.push_back({form_of(problem.elements[v.element], v.state, v.condition), false});
  }
  for (std::size_t i = 0; i < system.inequalities.size(); ++i) {
    RawSystem fewer = system;
    fewer.inequalities.erase(fewer.inequalities.begin() + static_cast<std::ptrdiff_t>(i));
    CHECK(is_solvable(fewer));
  }
}

void check_motions(const FrictionProblem& problem, const std::vector<NaiveMode>& modes, const Load& load,
                   Counts& counts) {
  if (load) CAPTURE(*load);
  const NaiveMotions expected = naive_motions(problem, modes, load);
  const MotionsAtLoad found = motions_of(problem, load);
  CHECK(found.motions.size() == expected.motions.size());
  for (const MotionAtLoad& motion : found.motions) {
    const auto same = expected.motions.find(motion.accelerations);
    REQUIRE(same != expected.motions.end());
    CHECK(names_of(motion.modes) == same->second.modes);
    CHECK(names_of(motion.boundary_modes) == same->second.boundary_modes);
    CHECK(names_of(motion.continua) == same->second.continua);
    check_forces(motion.forces, same->second.forces, counts);
    counts.boundary += motion.strict() ? 0 : 1;
  }
  CHECK(found.continua.size() == expected.continua.size());
  for (const ContinuumAtLoad& continuum : found.continua) {
    const auto same = expected.continua.find(name(continuum.mode));
    REQUIRE(same != expected.continua.end());
    CHECK(continuum.strict == same->second.second);
    std::vector<Range> ranges = continuum.accelerations;
    ranges.insert(ranges.end(), continuum.forces.begin(), continuum.forces.end());
    check_forces(ranges, same->second.first, counts);
  }
  CHECK(names_of(found.hysteresis) == expected.hysteresis);
  CHECK(found.rejected.size() + expected.consistent.size() == modes.size());
  for (const RejectedMode& rejected : found.rejected) {
    check_rejected(problem, modes, rejected, load, counts);
    check_own_reason(problem, modes, rejected.mode, load, counts);
  }
  counts.none += expected.motions.empty() && expected.continua.empty() ? 1 : 0;
  counts.several += expected.motions.size() > 1 ? 1 : 0;
  counts.continua += static_cast<int>(expected.continua.size());
  counts.hysteresis += expected.hysteresis.empty() ? 0 : 1;
}

void add_ends(std::set<Rational>& loads, const ForceInterval& interval) {
  if (interval.lower()) loads.insert(*interval.lower());
  if (interval.upper()) loads.insert(*interval.upper());
}

/// The modes for all loads; returns the ends of their intervals.
std::set<Rational> check_modes(const FrictionProblem& problem, const FrictionProblem& solved,
                               const std::vector<NaiveMode>& modes, Counts& counts) {
  const ModesOf found = modes_of(solved, std::nullopt);
  CHECK(found.consistent.size() + found.rejected.size() == modes.size());
  std::set<Rational> ends;
  std::set<std::string> consistent;
  for (const ConsistentMode& mode : found.consistent) {
    CAPTURE(name(mode.mode));
    consistent.insert(name(mode.mode));
    const NaiveMode& naive = named(modes, mode.mode);
    const ForceInterval loads = shadow(naive.closed(problem, std::nullopt), problem.load_index());
    REQUIRE(!loads.empty());
    CHECK(mode.solutions.loads == loads);
    CHECK(strict_loads(mode.solutions) == shadow(naive.strict(problem, std::nullopt), problem.load_index()));
    const RawSystem inside = naive.closed(problem, problem.has_load ? Load(loads.sample()) : std::nullopt);
    CHECK(mode.determined == std::all_of(problem.accelerations.begin(), problem.accelerations.end(),
                                         [&](const AffineForm& form) { return shadow(inside, form).is_point(); }));
    add_ends(ends, loads);
  }
  for (const NaiveMode& mode : modes) {
    if (consistent.count(mode.name) == 0) CHECK_FALSE(is_solvable(mode.closed(problem, std::nullopt)));
  }
  for (const RejectedMode& rejected : found.rejected) check_rejected(problem, modes, rejected, std::nullopt, counts);
  return ends;
}

void check_cell(const FrictionProblem& solved, const LoadCell& cell, const Rational& load,
                std::vector<std::vector<bool>>& varies) {
  CAPTURE(load);
  const MotionsAtLoad at = motions_of(solved, load);
  REQUIRE(at.motions.size() == cell.motions.size());
  for (std::size_t m = 0; m < at.motions.size(); ++m) {
    const MotionOverLoads& motion = cell.motions[m];
    const auto same = std::find_if(at.motions.begin(), at.motions.end(), [&](const MotionAtLoad& other) {
      return names_of(other.modes) == names_of(motion.modes) &&
             names_of(other.boundary_modes) == names_of(motion.boundary_modes) &&
             names_of(other.continua) == names_of(motion.continua);
    });
    REQUIRE(same != at.motions.end());
    for (std::size_t i = 0; i < motion.accelerations.size(); ++i) {
      CHECK(motion.accelerations[i].at(load) == same->accelerations[i]);
    }
    for (std::size_t i = 0; i < motion.forces.size(); ++i) {
      const Range& range = same->forces[i];
      if (motion.forces[i]) {
        CHECK(range.is_point());
        CHECK(range.lower == motion.forces[i]->at(load));
      } else if (!range.is_point()) {
        varies[m][i] = true;
      }
    }
  }
  std::vector<MechanismMode> continua;
  for (const ContinuumAtLoad& continuum : at.continua) continua.push_back(continuum.mode);
  CHECK(names_of(continua) == names_of(cell.continua));
}

/// Cells fill the domain, and inside each the motions are those at some loads of it.
void check_cells(const FrictionProblem& solved) {
  std::vector<ForceInterval> left{solved.load_domain};
  for (const LoadCell& cell : cells_of(solved, modes_of(solved, std::nullopt).consistent)) {
    CHECK(solved.load_domain.contains(cell.loads.sample()));
    left = difference(left, cell.loads);
    std::vector<std::vector<bool>> varies;
    for (const auto& motion : cell.motions) varies.emplace_back(motion.forces.size());
    const Rational middle = cell.loads.sample();
    check_cell(solved, cell, middle, varies);
    if (!cell.loads.is_point()) {
      check_cell(solved, cell, ForceInterval::between(cell.loads.lower(), false, middle, false).sample(), varies);
      check_cell(solved, cell, ForceInterval::between(middle, false, cell.loads.upper(), false).sample(), varies);
    }
    for (std::size_t m = 0; m < varies.size(); ++m) {
      for (std::size_t i = 0; i < varies[m].size(); ++i) CHECK(varies[m][i] != cell.motions[m].forces[i].has_value());
    }
  }
  CHECK(left.empty());
}

void compare(const FrictionProblem& problem, Counts& counts) {
  const std::vector<NaiveMode> modes = naive_modes(problem);
  const FrictionProblem solved = without_equations(problem);
  std::set<Rational> loads = check_modes(problem, solved, modes, counts);
  check_modes(problem, problem, modes, counts);
  if (!problem.has_load) return check_motions(problem, modes, std::nullopt, counts);
  while (loads.size() > 5) loads.erase(loads.begin());
  loads.insert({Rational(0), Rational(7, 3)});
  add_ends(loads, problem.load_domain);
  for (const Rational& load : loads) check_motions(problem, modes, load, counts);
  check_cells(solved);
}

}  // namespace

TEST_CASE("random mechanisms have the motions that their equations and conditions give one by one") {
  const int count = test::how_many("SLIPPROOF_RANDOM_MECHANISMS", 100);
  RandomProblems random(21);
  Counts counts;
  for (int i = 0; i < count; ++i) {
    CAPTURE(i);
    compare(random.problem(), counts);
  }
  CHECK(counts.several > count / 10);
  CHECK(counts.none > count / 10);
  CHECK(counts.boundary > count / 10);
  CHECK(counts.continua > count / 10);
  CHECK(counts.undetermined > count / 10);
  CHECK(counts.hysteresis > 0);
  CHECK(counts.excluded > count / 10);
  CHECK(counts.violated > count);
}
