// Friction elements at contacts: which modes there are.
#include "mechanics/elements/element.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/scenes/random_scene.hpp"

using namespace slipproof;
using Law = ElementKind::Law;
using State = ElementState;

TEST_CASE("rolling resistance is free where its contact lifts, and nowhere else") {
  const std::vector<ElementKind> wheel{{.law = Law::coulomb}, {.law = Law::limited, .contact = 0}};
  const auto modes = modes_of(wheel);
  CHECK(modes.size() == 10);
  CHECK(modes.back() == MechanismMode{State::lift, State::free});
  CHECK_FALSE(has_mode(wheel, {State::lift, State::stick}));
  CHECK_FALSE(has_mode(wheel, {State::stick, State::free}));
  CHECK(conditions(wheel[1], State::free).size() == 0);
}

TEST_CASE("rolling resistance of a guide is pulled where the guide is") {
  const std::vector<ElementKind> guided{{.law = Law::coulomb, .bilateral = true},
                                        {.law = Law::limited, .bilateral = true, .contact = 0}};
  CHECK(modes_of(guided).size() == 18);
  CHECK(has_mode(guided, {State::pulled_stick, State::pulled_slip_forward}));
  CHECK_FALSE(has_mode(guided, {State::pulled_stick, State::slip_forward}));
  const std::vector<ElementKind> smooth{{.law = Law::frictionless, .bilateral = true},
                                        {.law = Law::limited, .bilateral = true, .contact = 0}};
  CHECK(modes_of(smooth).size() == 6);  // either sign of a force without friction
}

TEST_CASE("modes are counted as they are enumerated") {
  test::RandomScenes random(10);
  for (int round = 0; round < 50; ++round) {
    std::vector<ElementKind> kinds;
    const auto contacts = static_cast<std::size_t>(random.integer(1, 3));
    for (std::size_t i = 0; i < contacts; ++i) {
      ElementKind kind{.law = random.integer(0, 1) == 0 ? Law::coulomb : Law::frictionless};
      kind.bilateral = random.integer(0, 2) == 0;
      kind.lifts = random.integer(0, 2) != 0;
      if (!kind.bilateral && random.integer(0, 4) == 0) kind.start = ElementKind::Start::open;
      kinds.push_back(kind);
    }
    for (std::size_t i = 0; i < contacts; ++i) {
      ElementKind kind{.law = Law::limited};
      if (random.integer(0, 2) != 0) {
        kind.contact = i;
        kind.bilateral = kinds[i].bilateral;
        kind.lifts = kinds[i].lifts;
        if (kinds[i].start == ElementKind::Start::open) kind.start = kinds[i].start;
      }
      kinds.push_back(kind);
    }
    const auto modes = modes_of(kinds);
    CHECK(static_cast<double>(modes.size()) == mode_count(kinds));
    CHECK(std::ranges::all_of(modes, [&](const MechanismMode& mode) { return has_mode(kinds, mode); }));
  }
}
