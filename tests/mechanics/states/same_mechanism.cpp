#include "mechanics/states/same_mechanism.hpp"

#include <doctest/doctest.h>

#include <algorithm>

#include "base/expression/parser.hpp"
#include "mechanics/points/problem.hpp"
#include "mechanics/points/sampling.hpp"

namespace slipproof::test {

namespace {

/// At points of the domain: a difference of rational functions that is not 0 is hardly 0 at all of them.
bool identical(const Mechanism& mechanism, const Expression& x, const Expression& y) {
  const ProblemMaker maker(mechanism);
  const Program difference = maker.compiled().compile(make(Operation::subtract, {x, y}));
  constexpr std::size_t enough = 8;
  const auto points = sample_values(mechanism, maker, enough, 7);
  REQUIRE(points.size() == enough);
  return std::ranges::all_of(points, [&](const MechanismValues& point) {
    const auto value = maker.at(point).number(difference);
    return value.number && value.number->is_zero();
  });
}

void check_same_form(const Mechanism& mechanism, const SymbolicForm& one, const SymbolicForm& other) {
  for (std::size_t i = 0; i < mechanism.unknowns.size(); ++i) {
    CAPTURE(mechanism.unknowns[i].symbol);
    CHECK(identical(mechanism, one.coefficient(i), other.coefficient(i)));
  }
  CHECK(identical(mechanism, one.load, other.load));
  CAPTURE(to_string(one.constant));
  CAPTURE(to_string(other.constant));
  CHECK(identical(mechanism, one.constant, other.constant));
}

}  // namespace

bool is_identical(const Mechanism& mechanism, const Expression& expression, const std::string& text) {
  return identical(mechanism, expression, parse_expression(text, Sort::number));
}

void check_same_mechanism(const Mechanism& one, const Mechanism& other) {
  REQUIRE(one.unknowns.size() == other.unknowns.size());
  for (std::size_t i = 0; i < one.unknowns.size(); ++i) CHECK(one.unknowns[i].symbol == other.unknowns[i].symbol);
  CHECK(starts(one) == starts(other));
  REQUIRE(one.equations.size() == other.equations.size());
  for (std::size_t i = 0; i < one.equations.size(); ++i) {
    CAPTURE(one.equations[i].name);
    check_same_form(other, one.equations[i].form, other.equations[i].form);
  }
  REQUIRE(one.links.size() == other.links.size());
  for (std::size_t i = 0; i < one.links.size(); ++i) {
    CAPTURE(one.links[i].name);
    check_same_form(other, one.links[i].form, other.links[i].form);
  }
  REQUIRE(one.contacts.size() == other.contacts.size());
  for (std::size_t i = 0; i < one.contacts.size(); ++i) {
    CAPTURE(one.contacts[i].name);
    CHECK(one.contacts[i].bilateral == other.contacts[i].bilateral);
    check_same_form(other, one.contacts[i].gap_form, other.contacts[i].gap_form);
    check_same_form(other, one.contacts[i].slip_form, other.contacts[i].slip_form);
  }
}

}  // namespace slipproof::test
