#include "mechanics/bodies/identity.hpp"

#include <map>
#include <string>
#include <vector>

#include "base/algebra/polynomial.hpp"

namespace slipproof::bodies_in_motion {

namespace {

struct Quotient {
  MultiPolynomial over, under;
};

/// What no polynomial says.
struct NoQuotient {};

PolynomialRing ring_of(const Mechanism& mechanism) {
  const auto names = value_names(mechanism);
  return PolynomialRing({names.begin(), names.end()});
}

class Quotients {
 public:
  explicit Quotients(const Mechanism& mechanism) : mechanism_(mechanism), ring_(ring_of(mechanism)) {
    constexpr std::uint64_t enough = 2'000'000;
    ring_.budget() = Budget(enough);
    for (std::size_t i = 0; i < ring_.size(); ++i)
      symbols_.emplace(ring_.name(i), whole(MultiPolynomial::variable(ring_, i)));
    for (std::size_t i = 0; i < mechanism.angles.size(); ++i) {
      const MultiPolynomial t = MultiPolynomial::variable(ring_, mechanism.parameters.size() + i);
      const MultiPolynomial one(ring_, 1), square = t * t;
      symbols_.insert_or_assign(mechanism.angles[i].cosine, Quotient{one - square, one + square});
      symbols_.insert_or_assign(mechanism.angles[i].sine, Quotient{t.scaled(2), one + square});
    }
  }

  Quotient of(const Expression& e) {
    switch (e->operation) {
      case Operation::number:
        return whole(MultiPolynomial(ring_, e->number));
      case Operation::symbol:
        return symbol(e->symbol);
      case Operation::negate: {
        const Quotient x = of(e->operands[0]);
        return {-x.over, x.under};
      }
      case Operation::power:
        return raised(of(e->operands[0]), e->exponent);
      case Operation::add:
      case Operation::subtract:
      case Operation::multiply:
      case Operation::divide:
        return combined(e->operation, of(e->operands[0]), of(e->operands[1]));
      default:
        throw NoQuotient{};
    }
  }

 private:
  Quotient whole(const MultiPolynomial& polynomial) const { return {polynomial, MultiPolynomial(ring_, 1)}; }

  Quotient symbol(const std::string& name) {
    if (const auto known = symbols_.find(name); known != symbols_.end()) return known->second;
    for (const MechanismDefinition& definition : mechanism_.definitions) {
      if (definition.symbol != name) continue;
      const Quotient value = of(definition.expression.expression);
      symbols_.emplace(name, value);
      return value;
    }
    throw NoQuotient{};
  }

  Quotient raised(const Quotient& base, int exponent) const {
    const auto n = static_cast<std::size_t>(exponent < 0 ? -exponent : exponent);
    const Quotient result{power(base.over, n), power(base.under, n)};
    return exponent < 0 ? Quotient{result.under, result.over} : result;
  }

  static Quotient combined(Operation operation, const Quotient& x, const Quotient& y) {
    switch (operation) {
      case Operation::multiply:
        return {x.over * y.over, x.under * y.under};
      case Operation::divide:
        return {x.over * y.under, x.under * y.over};
      default:
        break;
    }
    const bool minus = operation == Operation::subtract;
    if (x.under == y.under) return {minus ? x.over - y.over : x.over + y.over, x.under};
    const MultiPolynomial left = x.over * y.under, right = y.over * x.under;
    return {minus ? left - right : left + right, x.under * y.under};
  }

  const Mechanism& mechanism_;
  PolynomialRing ring_;
  std::map<std::string, Quotient> symbols_;
};

}  // namespace

bool vanishes_identically(const Mechanism& mechanism, const Expression& expression) {
  if (is_literal_zero(expression)) return true;
  try {
    Quotients quotients(mechanism);
    const Quotient value = quotients.of(expression);
    return value.over.is_zero() && !value.under.is_zero();
  } catch (const NoQuotient&) {
  } catch (const Budget::Spent&) {
  }
  return false;
}

}  // namespace slipproof::bodies_in_motion
