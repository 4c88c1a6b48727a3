// Tactics that bring the lines of a statement to their normal forms.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "proofs/other_provers/coq_statement.hpp"

namespace slipproof::coq {

using prove::Polynomial;

/// Closes an equation between polynomials.
void Normalizer::prove_ring() {
  if (!transparent_.empty()) script_ += fmt::format("cbv delta [{}]; ", fmt::join(transparent_, " "));
  script_ += "ring. ";
}

bool Normalizer::is_non_zero(const Polynomial& divisor) const {
  return std::any_of(non_zero_.begin(), non_zero_.end(), [&](const auto& fact) { return fact.first == divisor; });
}

std::string Normalizer::non_zero(const Polynomial& divisor) const {
  for (const auto& [polynomial, hypothesis] : non_zero_) {
    if (polynomial == divisor) return hypothesis;
  }
  throw std::logic_error("a divisor of which nothing is known");
}

std::string Normalizer::add_non_zero(const Polynomial& divisor) {
  non_zero_.emplace_back(divisor, fmt::format("_z{}", non_zero_.size() + 1));
  return non_zero_.back().second;
}

/// Tactics for the goal `frac e numerator denominator`.
void Normalizer::prove_fraction(const Expression& e) {
  const Value whole = value(e);
  if (!whole.divides) {
    script_ += "apply Steps.frac_poly. ";
    return prove_ring();
  }
  if (e->operation == Operation::symbol) {
    script_ += "exact (_F_" + name(e->symbol);
    for (const Polynomial& premise : premises_.at(e->symbol)) script_ += " " + non_zero(premise);
    script_ += "). ";
    return;
  }
  const Value x = value(e->operands[0]);
  const std::string n = coq::text(x.numerator), d = coq::text(x.denominator);
  if (e->operation == Operation::negate) {
    script_ += fmt::format("apply (Steps.frac_opp _ ({})). ", n);
  } else if (e->operation == Operation::power) {
    script_ += fmt::format("apply (Steps.frac_pow {} _ ({}) ({})). ", e->exponent, n, d);
  } else {
    const Value y = value(e->operands[1]);
    const std::string m = coq::text(y.numerator), c = coq::text(y.denominator);
    const bool sum = e->operation == Operation::add || e->operation == Operation::subtract;
    if (sum && x.denominator == y.denominator) {
      script_ += fmt::format("apply (Steps.frac_{}_same _ _ ({}) ({})). ",
                             e->operation == Operation::add ? "add" : "sub", n, m);
    } else {
      script_ += fmt::format("apply (Steps.frac_{} _ _ ({}) ({}) ({}) ({})). ",
                             e->operation == Operation::add        ? "add"
                             : e->operation == Operation::subtract ? "sub"
                             : e->operation == Operation::multiply ? "mul"
                                                                   : "div",
                             n, d, m, c);
    }
  }
  for (const Expression& operand : e->operands) {
    script_ += "{ ";
    prove_fraction(operand);
    script_ += "} ";
  }
  if (e->operation == Operation::divide) {
    const Polynomial divisor = value(e->operands[1]).numerator;
    script_ += divisor.is_constant() ? "{ lra. } " : "{ exact " + non_zero(divisor) + ". } ";
  }
  script_ += "all: ring. ";
}

/// Matches the theorem's guards `x <> 0` with those of the normal form, in order. Values of the unknowns add
/// guards of their own to the normal form, and remove those that they make constant or equal to another.
void Normalizer::prove_guards(const Expression& difference, const std::vector<Divisor>& divisors) {
  auto next = divisors.begin();
  const auto known = [&] {
    script_ += fmt::format("apply (Steps.known ({}) {}). ", coq::text(next->polynomial), non_zero(next->polynomial));
    ++next;
  };
  for (const Divisor& guard : theorem_values_.empty() ? divisors : value(difference, true).divisors) {
    const Value x = value(guard.expression);
    const bool constant = x.numerator.is_constant();
    if (!constant) {
      while (next != divisors.end() && !(next->polynomial == x.numerator) && is_non_zero(next->polynomial)) known();
    }
    const bool stays = !constant && next != divisors.end() && next->polynomial == x.numerator;
    const std::string p = coq::text(x.numerator), d = coq::text(x.denominator);
    if (stays) {
      script_ += fmt::format("apply (Steps.guard _ ({}) ({})). {{ ", p, d);
    } else {
      script_ += fmt::format(
          "refine (iff_trans (Steps.guard _ ({0}) ({1}) _ (fun _ => _)) (iff_sym (Steps.known ({0}) {2} (iff_refl "
          "_)))). {{ ",
          p, d, constant ? "ltac:(lra)" : non_zero(x.numerator));
    }
    prove_fraction(guard.expression);
    script_ += "} ";
    if (!stays) continue;
    script_ += "intros " + add_non_zero(x.numerator) + ". ";
    ++next;
  }
  while (next != divisors.end()) known();
}

void Normalizer::prove_same(const Link& link) {
  const Expression difference = make(Operation::subtract, {link.left, link.right});
  const Value d = value(difference);
  const std::size_t known = non_zero_.size();
  prove_guards(difference, d.divisors);
  constexpr std::array<const char*, 6> names{"lt", "le", "gt", "ge", "eq", "ne"};
  const char* name = names[static_cast<std::size_t>(link.relation)];
  if (!d.divides) {
    script_ += fmt::format("apply Steps.poly_{}. ", name);
    prove_ring();
  } else {
    script_ +=
        fmt::format("apply (Steps.frac_{} _ _ ({}) ({})). {{ ", name, coq::text(d.numerator), coq::text(d.denominator));
    prove_fraction(difference);
    script_ += "} ring. ";
  }
  non_zero_.erase(non_zero_.begin() + static_cast<std::ptrdiff_t>(known), non_zero_.end());
}

void Normalizer::prove_same(const Expression& e) {
  if (e->operation == Operation::truth) {
    script_ += "exact (iff_refl False). ";
    return;
  }
  if (e->operation == Operation::symbol) {
    script_ += "exact _same_" + name(e->symbol) + ". ";
    return;
  }
  const bool comparison = e->operation == Operation::compare;
  const std::vector<Link> chain = comparison ? links(e) : std::vector<Link>{};
  const std::vector<Expression> parts = comparison ? std::vector<Expression>{} : joined_parts(e);
  const std::size_t count = chain.size() + parts.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (i + 1 < count) {
      script_ += e->operation == Operation::logical_or ? "apply Steps.same_or. { " : "apply Steps.same_and. { ";
    }
    if (comparison) {
      prove_same(chain[i]);
    } else {
      prove_same(parts[i]);
    }
    if (i + 1 < count) script_ += "}\n";
  }
}

/// States what fraction an abbreviation is, where its divisors do not vanish.
void Normalizer::state_fraction(const std::string& symbol, const Expression& body) {
  Value v = value(body);
  if (!v.divides) {
    transparent_.push_back(name(symbol));
  } else {
    const std::size_t known = non_zero_.size();
    std::string premises, introduced;
    std::vector<Polynomial>& needed = premises_[symbol];
    needed.clear();
    for (const Divisor& divisor : v.divisors) {
      if (is_non_zero(divisor.polynomial)) continue;
      needed.push_back(divisor.polynomial);
      premises += coq::text(divisor.polynomial) + " <> 0 -> ";
      introduced += " " + add_non_zero(divisor.polynomial);
    }
    script_ += fmt::format("assert (_F_{0} : {1}Steps.frac {0} ({2}) ({3})). {{ ", name(symbol), premises,
                           coq::text(v.numerator), coq::text(v.denominator));
    if (!introduced.empty()) script_ += "intros" + introduced + ". ";
    script_ += "unfold " + name(symbol) + ". ";
    prove_fraction(body);
    script_ += "}\n";
    non_zero_.erase(non_zero_.begin() + static_cast<std::ptrdiff_t>(known), non_zero_.end());
  }
  if (!theorem_values_.empty()) theorem_values_.insert_or_assign(symbol, value(body, true));
  values_.insert_or_assign(symbol, std::move(v));
}

void Normalizer::introduce(const Directive& line, const std::string& pattern) {
  if (line.kind == Directive::Kind::real) {
    script_ += "intros";
    for (const std::string& variable : line.names) script_ += " " + name(variable);
    script_ += ".\n";
    return;
  }
  const std::string& label = line.names.front();
  if (line.kind == Directive::Kind::let) {
    script_ += "intros " + name(label) + ".\n";
    return state_fraction(label, line.body);
  }
  const Formula formula = normal(line.body);
  if (line.kind == Directive::Kind::define) {
    script_ += fmt::format("intros {0}. assert (_same_{0} : {0} <-> {1}). {{ unfold {0}. ", name(label),
                           coq::text(formula, true));
    prove_same(line.body);
    script_ += "}\n";
    formulas_.insert_or_assign(label, formula);
    return;
  }
  script_ += fmt::format("intros _assumed. assert ({}) as {}. {{ refine (Steps.forward _ _assumed).\n",
                         coq::text(formula), pattern);
  prove_same(line.body);
  script_ += "}\nclear _assumed.\n";
}

void Normalizer::give_value(const std::string& unknown, const Expression& value_text,
                            const std::vector<std::pair<Polynomial, std::string>>& non_zero) {
  non_zero_ = non_zero;
  const Value in_theorem = value(make_symbol(unknown));
  script_ += fmt::format("pose ({} := {}).\n", name(unknown), text(value_text));
  state_fraction(unknown, value_text);
  for (Divisor& divisor : values_.at(unknown).divisors) divisor.expression = nullptr;
  theorem_values_.insert_or_assign(unknown, in_theorem);
}

}  // namespace slipproof::coq
