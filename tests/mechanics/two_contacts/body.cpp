#include "mechanics/two_contacts/body.hpp"

#include <map>
#include <utility>

#include "mechanics/kernel/motions.hpp"
#include "mechanics/reading/read_mechanism.hpp"

namespace slipproof::test::two_contacts {

namespace {

char letter(ElementState state) {
  switch (state) {
    case ElementState::stick:
      return 'S';
    case ElementState::slip_forward:
      return '+';
    case ElementState::slip_backward:
      return '-';
    default:
      return 'O';
  }
}

/// By their symbols in body.toml.
std::map<std::string, Rational> parameters_of(const Body& body) {
  const auto& [one, two] = body.contacts;
  return {{"m", 1},      {"I", body.inertia}, {"x1", one.x},   {"y1", one.y},       {"mu1", one.mu},
          {"x2", two.x}, {"y2", two.y},       {"mu2", two.mu}, {"X", body.load[0]}, {"Y", body.load[1]}};
}

}  // namespace

void Body::set_normals(const Rational& tan_half) {
  const Rational square = tan_half * tan_half;
  contacts[0].normal = {0, 1};
  contacts[1].normal = {(1 - square) / (1 + square), 2 * tan_half / (1 + square)};
}

Library::Library()
    : mechanism_(read_mechanism(SLIPPROOF_SOURCE_DIR "/proofs/two-contacts/body.toml")),
      maker_(mechanism_),
      values_(default_values(mechanism_)) {}

Found Library::solve(const Body& body) {
  const auto numbers = parameters_of(body);
  for (std::size_t i = 0; i < mechanism_.parameters.size(); ++i) {
    values_.parameters[i] = numbers.at(mechanism_.parameters[i].symbol);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    values_.angles[i] = body.contacts[i].normal;
    values_.starts[i] = body.slides(i) ? ElementKind::Start::slides_forward : ElementKind::Start::rest;
  }
  const FrictionProblem problem = without_equations(maker_.problem(values_));
  const std::vector<ConsistentMode> consistent = ModeSolver(problem, body.load[2]).consistent();
  const MergedModes merged = merge(problem, consistent);
  Found found;
  found.boundary = !merged.continua.empty();
  for (const MergedModes::Motion& motion : merged.motions) {
    int strict = 0;
    for (const std::size_t i : motion.modes) {
      if (!consistent[i].solutions.strict) continue;
      ++strict;
      found.modes.insert({letter(consistent[i].mode[0]), letter(consistent[i].mode[1])});
    }
    found.boundary = found.boundary || strict != 1;
  }
  return found;
}

std::string text(const Modes& modes) {
  std::string result;
  for (const std::string& mode : modes) result += (result.empty() ? "" : " ") + mode;
  return result;
}

Modes flipped(const Modes& modes, std::size_t contact) {
  Modes result;
  for (std::string mode : modes) {
    char& state = mode[contact];
    state = state == '+' ? '-' : state == '-' ? '+' : state;
    result.insert(mode);
  }
  return result;
}

Modes exchanged(const Modes& modes) {
  Modes result;
  for (const std::string& mode : modes) result.insert({mode[1], mode[0]});
  return result;
}

}  // namespace slipproof::test::two_contacts
