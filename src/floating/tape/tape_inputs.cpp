#include "floating/tape/tape_inputs.hpp"

#include <algorithm>

namespace slipproof {

namespace {

/// What a domain such as `x > 0` says about the sign of a parameter.
InputSign sign_of(const Expression& domain, const std::string& symbol) {
  const Node& node = *domain;
  if (node.operation == Operation::logical_and) {
    return std::max(sign_of(node.operands[0], symbol), sign_of(node.operands[1], symbol));
  }
  if (node.operation != Operation::compare || node.operands.size() != 2) return InputSign::unknown;
  const bool first = is_symbol(node.operands[0], symbol);
  const Node& other = *node.operands[first ? 1 : 0];
  if (!is_symbol(node.operands[first ? 0 : 1], symbol) || other.operation != Operation::number) {
    return InputSign::unknown;
  }
  const Relation relation = node.relations[0];
  if (relation == (first ? Relation::greater : Relation::less)) return InputSign::positive;
  if (relation != (first ? Relation::greater_equal : Relation::less_equal)) return InputSign::unknown;
  return other.number.is_zero() ? InputSign::not_negative : InputSign::positive;
}

}  // namespace

std::vector<InputSign> input_signs(const Mechanism& mechanism) {
  std::vector<InputSign> signs;
  for (const MechanismParameter& p : mechanism.parameters) signs.push_back(sign_of(p.domain.expression, p.symbol));
  for (const MechanismAngle& angle : mechanism.angles) {
    signs.push_back(sign_of(angle.domain.expression, angle.cosine));
    signs.push_back(sign_of(angle.domain.expression, angle.sine));
  }
  signs.push_back(InputSign::unknown);
  return signs;
}

std::vector<std::pair<std::size_t, std::size_t>> circles(const Mechanism& mechanism) {
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (std::size_t i = 0; i < mechanism.angles.size(); ++i) {
    const std::size_t cosine = mechanism.parameters.size() + 2 * i;
    result.emplace_back(cosine, cosine + 1);
  }
  return result;
}

}  // namespace slipproof
