#include "floating/program/tape.hpp"

#include <algorithm>
#include <random>

namespace slipproof {

namespace {

constexpr std::uint64_t prime = (std::uint64_t{1} << 61U) - 1;

std::uint64_t times_modulo(std::uint64_t x, std::uint64_t y) {
  __extension__ using Wide = unsigned __int128;
  return static_cast<std::uint64_t>(Wide{x} * y % prime);
}

std::uint64_t plus_modulo(std::uint64_t x, std::uint64_t y) {
  return (x + y) % prime;
}

std::uint64_t minus_modulo(std::uint64_t x) {
  return x == 0 ? 0 : prime - x;
}

/// The inverse by Fermat's theorem; 0 for 0.
std::uint64_t inverse_modulo(std::uint64_t x) {
  std::uint64_t result = 1;
  for (std::uint64_t n = prime - 2; n != 0; n /= 2) {
    if (n % 2 == 1) result = times_modulo(result, x);
    x = times_modulo(x, x);
  }
  return result;
}

std::uint64_t modulo(const Integer& x) {
  const long rest = (x % prime).to_long();
  return rest < 0 ? prime - static_cast<std::uint64_t>(-rest) : static_cast<std::uint64_t>(rest);
}

std::uint64_t modulo(const Rational& x) {
  return times_modulo(modulo(numerator(x)), inverse_modulo(modulo(denominator(x))));
}

}  // namespace

TapeBuilder::TapeBuilder(std::vector<InputSign> inputs, std::vector<std::pair<std::size_t, std::size_t>> circles)
    : prover_(inputs.size(), circles) {
  constant(0);
  constant(1);
  std::mt19937_64 random(20250301);
  std::vector<Residues> values(inputs.size());
  for (Residues& value : values) value = {random() % prime, random() % prime};
  for (const auto& [cosine, sine] : circles) {
    for (std::size_t k = 0; k < 2; ++k) {
      const std::uint64_t t = random() % prime, square = times_modulo(t, t);
      const std::uint64_t scale = inverse_modulo(plus_modulo(1, square));
      values[cosine][k] = times_modulo(plus_modulo(1, minus_modulo(square)), scale);
      values[sine][k] = times_modulo(plus_modulo(t, t), scale);
    }
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Signs known{inputs[i] != InputSign::unknown, false, inputs[i] == InputSign::positive};
    inputs_.push_back(push({TapeOperation::input, static_cast<TapeRef>(i), 0}, values[i], known));
  }
}

const Rational* TapeBuilder::literal(TapeRef x) const {
  const TapeNode& node = nodes_[x];
  return node.operation == TapeOperation::constant ? &constants_[node.first] : nullptr;
}

TapeRef TapeBuilder::push(const TapeNode& node, const Residues& residues, const Signs& signs) {
  nodes_.push_back(node);
  residues_.push_back(residues);
  signs_.push_back(signs);
  return static_cast<TapeRef>(nodes_.size() - 1);
}

TapeRef TapeBuilder::constant(const Rational& value) {
  const auto [place, is_new] = literals_.emplace(value, 0);
  if (!is_new) return place->second;
  const std::uint64_t residue = modulo(value);
  const int s = sign(value);
  constants_.push_back(value);
  return place->second = push({TapeOperation::constant, static_cast<TapeRef>(constants_.size() - 1), 0},
                              {residue, residue}, {s >= 0, s <= 0, s != 0});
}

TapeRef TapeBuilder::add(TapeRef x, TapeRef y) {
  if (x == zero) return y;
  if (y == zero) return x;
  if (literal(x) && literal(y)) return constant(*literal(x) + *literal(y));
  if (nodes_[y].operation == TapeOperation::negate) return subtract(x, nodes_[y].first);
  if (nodes_[x].operation == TapeOperation::negate) return subtract(y, nodes_[x].first);
  return make(TapeOperation::add, std::min(x, y), std::max(x, y));
}

TapeRef TapeBuilder::subtract(TapeRef x, TapeRef y) {
  if (x == y) return zero;
  if (x == zero) return negate(y);
  if (y == zero) return x;
  if (literal(x) && literal(y)) return constant(*literal(x) - *literal(y));
  if (nodes_[y].operation == TapeOperation::negate) return add(x, nodes_[y].first);
  if (nodes_[x].operation == TapeOperation::negate) return negate(add(nodes_[x].first, y));
  if (x > y) return negate(make(TapeOperation::subtract, y, x));
  return make(TapeOperation::subtract, x, y);
}

TapeRef TapeBuilder::multiply(TapeRef x, TapeRef y) {
  if (x == zero || y == zero) return zero;
  if (x == one) return y;
  if (y == one) return x;
  if (literal(x) && literal(y)) return constant(*literal(x) * *literal(y));
  if (literal(x) && *literal(x) == -1) return negate(y);
  if (literal(y) && *literal(y) == -1) return negate(x);
  if (nodes_[x].operation == TapeOperation::negate) return negate(multiply(nodes_[x].first, y));
  if (nodes_[y].operation == TapeOperation::negate) return negate(multiply(x, nodes_[y].first));
  return make(TapeOperation::multiply, std::min(x, y), std::max(x, y));
}

TapeRef TapeBuilder::divide(TapeRef x, TapeRef y) {
  if (x == zero) return zero;
  if (y == one) return x;
  if (x == y) return one;
  if (literal(x) && literal(y)) return constant(*literal(x) / *literal(y));
  if (literal(y) && *literal(y) == -1) return negate(x);
  if (nodes_[x].operation == TapeOperation::negate) return negate(divide(nodes_[x].first, y));
  if (nodes_[y].operation == TapeOperation::negate) return negate(divide(x, nodes_[y].first));
  return make(TapeOperation::divide, x, y);
}

TapeRef TapeBuilder::divide_often(TapeRef x, TapeRef y) {
  const bool shorter = x == zero || x == y || literal(y) != nullptr || negate(x) == y;
  return shorter ? divide(x, y) : multiply(x, divide(one, y));
}

TapeRef TapeBuilder::negate(TapeRef x) {
  if (literal(x)) return constant(-*literal(x));
  if (nodes_[x].operation == TapeOperation::negate) return nodes_[x].first;
  return make(TapeOperation::negate, x, zero);
}

TapeBuilder::Residues TapeBuilder::residues(TapeOperation operation, TapeRef x, TapeRef y) const {
  Residues result;
  for (std::size_t k = 0; k < result.size(); ++k) {
    const std::uint64_t a = residues_[x][k], b = residues_[y][k];
    switch (operation) {
      case TapeOperation::add:
        result[k] = plus_modulo(a, b);
        break;
      case TapeOperation::subtract:
        result[k] = plus_modulo(a, minus_modulo(b));
        break;
      case TapeOperation::multiply:
        result[k] = times_modulo(a, b);
        break;
      case TapeOperation::divide:
        result[k] = times_modulo(a, inverse_modulo(b));
        break;
      default:
        result[k] = minus_modulo(a);
    }
  }
  return result;
}

TapeBuilder::Residues TapeBuilder::quotient_residues(TapeRef x, TapeRef y) const {
  return residues(TapeOperation::divide, x, y);
}

TapeBuilder::Signs TapeBuilder::signs(TapeOperation operation, TapeRef first, TapeRef second) const {
  const Signs x = signs_[first];
  Signs y = signs_[second];
  switch (operation) {
    case TapeOperation::negate:
      return {x.not_positive, x.not_negative, x.not_zero};
    case TapeOperation::subtract:
      std::swap(y.not_negative, y.not_positive);
      [[fallthrough]];
    case TapeOperation::add: {
      const bool up = x.not_negative && y.not_negative, down = x.not_positive && y.not_positive;
      return {up, down, (up || down) && (x.not_zero || y.not_zero)};
    }
    default:
      return {first == second || (x.not_negative && y.not_negative) || (x.not_positive && y.not_positive),
              (x.not_negative && y.not_positive) || (x.not_positive && y.not_negative), x.not_zero && y.not_zero};
  }
}

TapeRef TapeBuilder::make(TapeOperation operation, TapeRef x, TapeRef y) {
  const auto [place, is_new] = known_.emplace(std::tuple(operation, x, y), 0);
  if (!is_new) return place->second;
  const TapeNode node{operation, x, y};
  const Residues values = residues(operation, x, y);
  if (values == Residues{0, 0} && prover_.is_zero(node, nodes_, constants_)) return place->second = zero;
  return place->second = push(node, values, signs(operation, x, y));
}

TapeBuilder::Doubt TapeBuilder::doubt_as_divisor(TapeRef x) const {
  if (literal(x)) return Doubt::literal;
  if (residues_[x] == Residues{0, 0}) return Doubt::looks_like_zero;
  if (signs_[x].not_zero) return Doubt::nonzero_in_domain;
  return signs_[x].not_negative || signs_[x].not_positive ? Doubt::one_sign : Doubt::any;
}

}  // namespace slipproof
