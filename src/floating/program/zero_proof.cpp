#include "floating/program/zero_proof.hpp"

#include <string>

#include "floating/program/tape.hpp"

namespace slipproof {

namespace {

constexpr std::uint64_t steps_of_a_proof = 300'000;

std::unique_ptr<PolynomialRing> ring_of(std::size_t inputs, std::size_t circles) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < inputs + circles; ++i) names.push_back("x" + std::to_string(i));
  return std::make_unique<PolynomialRing>(std::move(names));
}

}  // namespace

ZeroProver::ZeroProver(std::size_t inputs, std::vector<std::pair<std::size_t, std::size_t>> circles)
    : ring_(ring_of(inputs, circles.size())), circles_(std::move(circles)), inputs_(inputs) {}

bool ZeroProver::is_zero(const TapeNode& node, const std::vector<TapeNode>& nodes,
                         const std::vector<Rational>& constants) {
  try {
    ring_->budget().renew(steps_of_a_proof);
    return vanishes(of(node, nodes, constants).numerator);
  } catch (const Budget::Spent&) {
    return false;  // results computed so far are kept
  }
}

/// Whether p is 0 on the circles, each parametrised by the tangent of half its angle.
bool ZeroProver::vanishes(MultiPolynomial p) const {
  const MultiPolynomial one(*ring_, 1);
  for (std::size_t i = 0; i < circles_.size() && !p.is_zero(); ++i) {
    const MultiPolynomial t = MultiPolynomial::variable(*ring_, inputs_ + i);
    p = substitute(p, circles_[i].first, one - t * t, one + t * t);
    p = substitute(p, circles_[i].second, t.scaled(2), one + t * t);
  }
  return p.is_zero();
}

ZeroProver::Fraction ZeroProver::sum(const Fraction& x, const Fraction& y) const {
  if (x.denominator == y.denominator) return {x.numerator + y.numerator, x.denominator};
  return {x.numerator * y.denominator + y.numerator * x.denominator, x.denominator * y.denominator};
}

const ZeroProver::Fraction& ZeroProver::at(std::uint32_t place, const std::vector<TapeNode>& nodes,
                                           const std::vector<Rational>& constants) {
  const auto found = known_.find(place);
  if (found != known_.end()) return found->second;
  return known_.emplace(place, of(nodes[place], nodes, constants)).first->second;
}

ZeroProver::Fraction ZeroProver::of(const TapeNode& node, const std::vector<TapeNode>& nodes,
                                    const std::vector<Rational>& constants) {
  const MultiPolynomial one(*ring_, 1);
  if (node.operation == TapeOperation::constant) return {MultiPolynomial(*ring_, constants[node.first]), one};
  if (node.operation == TapeOperation::input) return {MultiPolynomial::variable(*ring_, node.first), one};
  const Fraction x = at(node.first, nodes, constants);
  if (node.operation == TapeOperation::negate) return {-x.numerator, x.denominator};
  const Fraction y = at(node.second, nodes, constants);
  switch (node.operation) {
    case TapeOperation::add:
      return sum(x, y);
    case TapeOperation::subtract:
      return sum(x, {-y.numerator, y.denominator});
    case TapeOperation::multiply:
      return {x.numerator * y.numerator, x.denominator * y.denominator};
    default:
      if (vanishes(y.numerator)) throw Budget::Spent{};  // the divisor is 0, so nothing is proved about the quotient
      return {x.numerator * y.denominator, x.denominator * y.numerator};
  }
}

}  // namespace slipproof
