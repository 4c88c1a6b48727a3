// In the plane and without friction all solutions are known from all modes: the tree has to find the same.
#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "contact/complete/complete.hpp"
#include "contact/complete/random_contacts.hpp"
#include "contact/problem/solutions.hpp"
#include "support/how_many.hpp"

using namespace slipproof;

namespace {

using Velocities = std::set<std::vector<Rational>>;

Velocities velocities_of(const CompleteSolutions& all) {
  Velocities result;
  for (const SpatialMotion& motion : all.motions) {
    CHECK(motion.is_exact());
    CHECK(motion.u == velocities(all.scaled.contacts, motion.r));
    CHECK(satisfies_law(all.scaled.contacts, motion.r, motion.u));
    result.insert(in_given_units(motion.u, all.scaled.velocity_unit));
  }
  CHECK(result.size() == all.motions.size());
  return result;
}

/// How many of the problems the tree decides.
struct PlanarCount {
  int decided = 0, undecided = 0, several = 0, none = 0, families = 0;
};

void compare(const ExactContacts& contacts, PlanarCount& count) {
  const ContactProblem problem{contacts.W, contacts.q, contacts.dimension == 1 ? std::vector<Rational>{} : contacts.mu};
  const auto known = ContactSolver(problem).all();
  REQUIRE(known);
  CompleteOptions options;
  options.most_nodes = 3000;
  const CompleteSolutions all = all_solutions(contacts, options);
  const Velocities found = velocities_of(all);
  Velocities expected;
  for (const ContactSolution& solution : known->solutions) expected.insert(solution.w);
  Effort effort(unlimited);
  for (const ContactContinuum& continuum : known->continua) {
    for (const auto& z : continuum.two(effort)) expected.insert(accelerations(problem, z));
  }
  if (all.complete()) {
    CHECK(std::ranges::includes(found, expected));
  }
  if (known->continua.empty()) {
    CHECK(std::ranges::includes(expected, found));
  } else {
    ++count.families;
  }
  ++(all.complete() ? count.decided : count.undecided);
  count.several += found.size() > 1;
  count.none += found.empty();
}

}  // namespace

TEST_CASE("problems in the plane have the motions that all modes have") {
  RandomContacts random(1);
  PlanarCount count;
  const int problems = test::how_many("SLIPPROOF_PLANAR_PROBLEMS", 300);
  for (std::size_t i = 0; i < static_cast<std::size_t>(problems); ++i) {
    const std::size_t k = 1 + i % 3, rank = i % 4 == 0 ? 2 : 2 * k;
    ExactContacts problem = i % 2 == 0 ? random.symmetric(2, k, rank, 2, 2) : random.any(2, k, 2, 2);
    if (i % 4 == 0) random.let_rest(problem);
    compare(problem, count);
  }
  MESSAGE(count.decided << " decided, " << count.undecided << " not, " << count.families << " with families, "
                        << count.several << " with several motions, " << count.none << " with none");
  CHECK(count.several > problems / 10);
  CHECK(count.none > problems / 10);
  CHECK(count.undecided <= problems / 50);
}

TEST_CASE("linear complementarity problems have the solutions that all modes have") {
  RandomContacts random(2);
  PlanarCount count;
  const int problems = test::how_many("SLIPPROOF_PLANAR_PROBLEMS", 300);
  for (std::size_t i = 0; i < static_cast<std::size_t>(problems); ++i) {
    const std::size_t k = 1 + i % 4;
    ExactContacts problem = i % 3 == 0 ? random.symmetric(1, k, 1 + k / 2, 2, 2) : random.any(1, k, 2, 2);
    if (i % 6 == 0) random.let_rest(problem);
    compare(problem, count);
  }
  MESSAGE(count.decided << " decided, " << count.undecided << " not, " << count.families << " with families, "
                        << count.several << " with several motions, " << count.none << " with none");
  CHECK(count.several > problems / 10);
  CHECK(count.none > problems / 10);
  CHECK(count.undecided <= problems / 50);
}
