// The tree is a proof: its nodes are proved again, and its children cover their parents.
#include <doctest/doctest.h>

#include "base/parallel/in_parallel.hpp"
#include "contact/complete/closing.hpp"
#include "contact/complete/complete.hpp"
#include "contact/complete/random_contacts.hpp"

using namespace slipproof;

namespace {

using StateKind = ContactState::Kind;
using NodeEnd = PatternNode::End;

bool is_direction(const Direction& d) {
  return d.length.sign() > 0 && d.x * d.x + d.y * d.y == d.length * d.length;
}

/// Slips from `at` on, each below half a turn and where the one before ends.
bool is_chain(std::span<const ContactState> arcs) {
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (arcs[i].kind != StateKind::slip || !is_direction(arcs[i].from) || cross(arcs[i].from, arcs[i].to).sign() <= 0)
      return false;
    if (i > 0 && arcs[i].from != arcs[i - 1].to) return false;
  }
  return !arcs.empty();
}

bool covers(const ContactState& parent, const std::vector<ContactState>& children, std::size_t dimension) {
  switch (parent.kind) {
    case StateKind::any:
      return children.size() == 2 && children[0].kind == StateKind::open && children[1].kind == StateKind::closed;
    case StateKind::closed: {
      if (children.empty() || children[0].kind != StateKind::stick) return false;
      if (dimension == 2) return children.size() == 3 && children[1].from.x == 1 && children[2].from.x == -1;
      const auto arcs = std::span(children).subspan(1);
      return is_chain(arcs) && arcs.back().to == arcs.front().from;
    }
    case StateKind::slip:
      return is_chain(children) && children.front().from == parent.from && children.back().to == parent.to;
    default:
      return false;
  }
}

class ProofReader {
 public:
  explicit ProofReader(const CompleteSolutions& all)
      : all_(all), exact_(all.scaled.contacts), integers_(exact_), seen_(all.nodes.size(), false) {}

  void read() {
    for (const ContactState& state : all_.nodes[0].pattern) CHECK(state == ContactState{});
    seen_[0] = true;
    for (const PatternNode& node : all_.nodes) {
      if (node.end == NodeEnd::empty) CHECK(proves_empty(exact_, integers_, node.pattern, node.y));
      if (node.end == NodeEnd::motion) read_bounds(node);
      if (node.end == NodeEnd::frictionless) read_squares(node);
      if (node.end == NodeEnd::split) read_split(node);
    }
    CHECK(std::ranges::count(seen_, false) == 0);
  }

 private:
  /// W is the sum of the squares, and the motion needs no friction.
  void read_squares(const PatternNode& node) {
    const SpatialMotion& motion = all_.motions.at(node.motion);
    CHECK(satisfies_law(exact_, motion.r, motion.u));
    CHECK(motion.u == velocities(exact_, motion.r));
    for (std::size_t i = 0; i < exact_.size(); ++i) {
      const std::size_t k = i / exact_.dimension;
      CHECK((i == exact_.normal(k) || motion.r[i].is_zero()));
      CHECK((i == exact_.normal(k) || !exact_.has_friction(k) || motion.u[i].is_zero()));
      for (std::size_t j = 0; j < exact_.size(); ++j) {
        Rational sum;
        for (const WeightedSquare& square : all_.squares) sum += square.factor * square.form[i] * square.form[j];
        CHECK(sum == exact_.W[i][j]);
      }
    }
    for (const WeightedSquare& square : all_.squares) CHECK(square.factor.sign() > 0);
  }

  void read_bounds(const PatternNode& node) {
    const SpatialMotion& motion = all_.motions.at(node.motion);
    const VelocityBox place = place_of(all_, node.motion);
    std::vector<std::pair<std::size_t, int>> bounded;
    for (const PatternNode::Bound& bound : node.bounds) {
      const auto proved = lower_bound(exact_, integers_, node.pattern, bound.form, bound.y);
      REQUIRE(proved);
      if (!motion.alone.is_zero()) {
        Rational at_motion, radius;
        for (const auto& [i, f] : bound.form.u) at_motion += f * motion.u[i], radius += abs(f) * motion.u_radius[i];
        for (const auto& [i, f] : bound.form.r) at_motion += f * motion.r[i], radius += abs(f) * motion.r_radius[i];
        CHECK(proved->value <= at_motion + radius);
        continue;
      }
      const auto& [i, f] = bound.form.u.at(0);
      CHECK(abs(f) == 1);
      CHECK(proved->value >= (f > 0 ? place.low[i] : Rational(-place.high[i])));
      bounded.emplace_back(i, f.sign());
    }
    for (std::size_t i = 0; i < exact_.size() && motion.alone.is_zero(); ++i) {
      const StateKind kind = node.pattern[i / exact_.dimension].kind;
      const bool zero =
          kind == StateKind::stick || (i % exact_.dimension == 0 && kind != StateKind::any && kind != StateKind::open);
      if (zero) CHECK((place.low[i].sign() <= 0 && place.high[i].sign() >= 0));
      for (const int side : {1, -1}) CHECK(std::ranges::count(bounded, std::pair(i, side)) == (zero ? 0 : 1));
    }
  }

  void read_split(const PatternNode& node) {
    std::vector<ContactState> states;
    for (std::size_t c = node.first_child; c < node.first_child + node.children; ++c) {
      ContactPattern child = all_.nodes.at(c).pattern;
      CHECK_FALSE(seen_[c]);
      seen_[c] = true;
      states.push_back(child[node.contact]);
      child[node.contact] = node.pattern[node.contact];
      CHECK(child == node.pattern);
    }
    CHECK(covers(node.pattern[node.contact], states, exact_.dimension));
  }

  const CompleteSolutions& all_;
  const ExactContacts& exact_;
  const IntegerContacts integers_;
  std::vector<bool> seen_;
};

}  // namespace

TEST_CASE("every node of a tree is proved, and its children cover it") {
  RandomContacts random(4);
  std::size_t boxes = 0;
  for (std::size_t i = 0; i < 30; ++i) {
    const ExactContacts problem = i % 3 == 0 ? random.any(2, 3, 2, 4) : random.body(1 + i % 3, 1);
    CompleteOptions options;
    options.most_nodes = 2000;
    const CompleteSolutions all = all_solutions(problem, options);
    CHECK(all.complete());
    ProofReader(all).read();
    for (const SpatialMotion& motion : all.motions) boxes += motion.is_exact() ? 0 : 1;
  }
  CHECK(boxes > 5);
}

TEST_CASE("what needs no friction is closed at once, and the squares of its W are proved again") {
  for (const std::size_t boxes : {1U, 2U, 4U}) {
    const CompleteSolutions all = all_solutions(stack(boxes, Rational(1, 2), 0));
    CHECK(all.complete());
    CHECK(all.nodes.size() == 1);
    CHECK(all.programs == 0);
    ProofReader(all).read();
  }
  CHECK(all_solutions(stack(1, Rational(1, 2), Rational(1, 4))).nodes.size() > 1);  // friction holds it
}

TEST_CASE("a motion is alone within so many radii of its box that nothing is pinned in, at least one") {
  RandomContacts random(5);
  int alone = 0;
  for (int i = 0; i < 20; ++i) {
    for (const SpatialMotion& motion : all_solutions(random.body(2, 1)).motions) {
      if (motion.alone.is_zero()) continue;
      ++alone;
      CHECK(motion.alone.sign() > 0);
      CHECK_FALSE(motion.is_exact());
      CHECK(motion.pinned.empty());
    }
  }
  CHECK(alone > 5);
}

TEST_CASE("one thread and two find the same tree") {
  RandomContacts random(6);
  for (int i = 0; i < 5; ++i) {
    const ExactContacts problem = random.body(3, 1);
    const auto solve = [&] { return all_solutions(problem); };
    const CompleteSolutions one = on_threads(1, solve), two = on_threads(2, solve);
    REQUIRE(one.nodes.size() == two.nodes.size());
    for (std::size_t k = 0; k < one.nodes.size(); ++k) {
      CHECK(one.nodes[k].pattern == two.nodes[k].pattern);
      CHECK(one.nodes[k].end == two.nodes[k].end);
      CHECK(one.nodes[k].y == two.nodes[k].y);
    }
    CHECK(one.programs == two.programs);
    REQUIRE(one.motions.size() == two.motions.size());
    for (std::size_t m = 0; m < one.motions.size(); ++m) CHECK(one.motions[m].r == two.motions[m].r);
  }
}
