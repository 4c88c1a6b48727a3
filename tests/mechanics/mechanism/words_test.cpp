#include "mechanics/mechanism/words.hpp"

#include <doctest/doctest.h>

#include <string>

#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/shipped.hpp"

using namespace slipproof;

namespace {

const std::string text = R"(schema = "slipproof/mechanism/1"
name = "words"
[parameters]
mu = "mu >= 0"
T = "T >= 0"
[unknowns]
accelerations = ["x", "y"]
[motion]
x = "x = 0"
y = "y = -1"
[[contact]]
name = "foot"
gap = "y"
slip = "x"
friction = { static = "mu + 1", kinetic = "mu" }
normal = "N"
tangent = "S"
[[contact]]
name = "guide"
gap = "x"
slip = "y"
friction = "mu"
bilateral = true
[[contact]]
name = "wall"
gap = "x"
[[friction]]
name = "brake"
slip = "x"
limit = { static = "2*T", kinetic = "T" }
)";

/// All names of conditions of a state.
std::string conditions_of(const Mechanism& m, std::size_t element, ElementState state, bool strict = false) {
  std::string result;
  for (const StateCondition condition : conditions(element_kinds(m)[element], state)) {
    result += (result.empty() ? "" : "; ") + condition_name(m, element, state, condition, strict);
  }
  return result;
}

}  // namespace

TEST_CASE("conditions have names as people write them") {
  const Mechanism m = parse_mechanism(text, "words.toml");
  CHECK(conditions_of(m, 0, ElementState::stick) == "N >= 0; |S| <= (mu + 1) N; |S| <= (mu + 1) N");
  CHECK(conditions_of(m, 0, ElementState::stick, true) == "N > 0; |S| < (mu + 1) N; |S| < (mu + 1) N");
  CHECK(conditions_of(m, 0, ElementState::slip_forward) == "N >= 0; slip_foot >= 0");
  CHECK(conditions_of(m, 0, ElementState::slip_backward, true) == "N > 0; slip_foot < 0");
  CHECK(conditions_of(m, 0, ElementState::lift) == "gap_foot >= 0");
  CHECK(conditions_of(m, 1, ElementState::pulled_stick) ==
        "N_guide <= 0; |S_guide| <= -mu N_guide; |S_guide| <= -mu N_guide");
  CHECK(conditions_of(m, 2, ElementState::touch) == "N_wall >= 0");
  CHECK(conditions_of(m, 3, ElementState::stick) == "2 * T >= 0; T >= 0; |S_brake| <= 2 * T; |S_brake| <= 2 * T");
  CHECK(conditions_of(m, 3, ElementState::slip_backward) == "2 * T >= 0; T >= 0; slip_brake <= 0");
}

TEST_CASE("modes are read, with * for any state") {
  const Mechanism m = parse_mechanism(text, "words.toml");
  const auto kinds = element_kinds(m);
  CHECK(mode_count(kinds) == 4 * 6 * 2 * 3);
  Mistakes mistakes("x");
  const auto parse = [&](const std::string& mode) {
    return parse_mode(m, kinds, PlacedText(mode, {7, 3}), "mode", mistakes);
  };
  const auto one = parse("slip+/stick~/touch/slip-");
  REQUIRE(one);
  const MechanismMode mode{ElementState::slip_forward, ElementState::pulled_stick, ElementState::touch,
                           ElementState::slip_backward};
  CHECK(modes_of(*one, kinds) == std::vector<MechanismMode>{mode});
  const auto many = parse("*/stick/*/stick");
  REQUIRE(many);
  CHECK(modes_of(*many, kinds).size() == 8);
  CHECK(modes_of(*parse("*/*/*/*"), kinds).size() == 144);
  CHECK(mistakes.empty());
  const auto said = [&](const std::string& wrong) {
    Mistakes list("x");
    CHECK_FALSE(parse_mode(m, kinds, PlacedText(wrong, {7, 3}), "mode", list));
    try {
      list.refuse_if_any();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  CHECK(said("stick/stick") == "x:7:3: mode: found 'stick/stick', expected 4 states joined by /");
  CHECK(said("stick/stik/touch/stick") == "x:7:9: mode: unknown state of guide 'stik', did you mean 'stick'?");
  CHECK(said("stick/lift/touch/stick") ==
        "x:7:9: mode: unknown state of guide 'lift', expected one of *, stick, slip+, slip-, stick~, slip+~, slip-~");
  CHECK(said("stick/stick/touch/") ==
        "x:7:21: mode: unknown state of brake '', expected one of *, stick, slip+, slip-");
}

TEST_CASE("lift is a state also where it is not modelled") {
  const Mechanism m = open_mechanism("bicycle");
  const auto kinds = element_kinds(m, starts(m), std::vector<bool>(m.parameters.size(), false));
  CHECK(mode_count(kinds) == 9);
  Mistakes mistakes("x");
  const auto pattern = parse_mode(m, kinds, PlacedText("*/lift", {1, 1}), "modes", mistakes);
  REQUIRE(pattern);
  CHECK(modes_of(*pattern, kinds).empty());
  CHECK(modes_of(*pattern, element_kinds(m)).size() == 4);
}
