#include "proofs/statement/proof.hpp"

#include <fmt/format.h>

#include <iterator>

namespace slipproof::prove {
namespace {

using Names = std::set<std::string>;

bool is_part(const std::string& name, const std::string& whole) {
  return name.starts_with(whole) && (name.size() == whole.size() || name[whole.size()] == '.');
}

/// Takes the names of a hypothesis and its parts out; whether there were any.
bool take(Names& names, const std::string& whole) {
  return std::erase_if(names, [&](const std::string& name) { return is_part(name, whole); }) > 0;
}

Names names_in(const std::vector<Identity>& identities) {
  Names result;
  for (const Identity& identity : identities) {
    for (const WeightedProduct& term : identity.terms) {
      for (const auto& [name, exponent] : term.product) result.insert(name);
    }
    for (const auto& [name, multiplier] : identity.equations) result.insert(name);
  }
  return result;
}

Names prune_and_name(Proof& proof) {
  Names used;
  for (std::size_t i = proof.size(); i-- > 0;) {
    Step& step = proof[i];
    if (step.rule == Step::Rule::split || step.rule == Step::Rule::cases) {
      if (step.rule == Step::Rule::cases && step.branches.empty()) used.insert(step.name);
      for (std::size_t k = 0; k < step.branches.size(); ++k) {
        Names names = prune_and_name(step.branches[k]);
        const std::string hypothesis =
            step.rule == Step::Rule::split ? step.name : fmt::format("{}.{}", step.name, k + 1);
        if (!take(names, hypothesis)) {  // this branch holds without the split
          Proof branch = std::move(step.branches[k]);
          proof.erase(proof.begin() + static_cast<std::ptrdiff_t>(i), proof.end());
          proof.insert(proof.end(), std::make_move_iterator(branch.begin()), std::make_move_iterator(branch.end()));
          used = std::move(names);
          break;
        }
        used.merge(names);
        if (k + 1 == step.branches.size() && step.rule == Step::Rule::cases) used.insert(step.name);
      }
    } else if (step.rule == Step::Rule::have && !used.contains(step.name)) {
      proof.erase(proof.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      take(used, step.name);
      Names names = names_in(step.identities);
      if (step.rule == Step::Rule::have) names.erase(step.name);
      used.merge(names);
    }
  }
  return used;
}

/// Multiplies by the common denominator: certificates have integer coefficients.
void clear_denominators(Identity& identity) {
  Integer common = 1;
  const auto include = [&](const Rational& x) { common = lcm(common, denominator(x)); };
  for (const WeightedProduct& term : identity.terms) include(term.coefficient);
  for (const auto& [name, multiplier] : identity.equations) {
    for (const Term& term : multiplier.terms()) include(term.coefficient);
  }
  if (common == 1) return;
  for (WeightedProduct& term : identity.terms) term.coefficient *= common;
  for (auto& [name, multiplier] : identity.equations) multiplier = multiplier.scaled(Rational(common));
}

/// Where the fact 0 > 0 has been derived, its derivation is a contradiction already, without the terms of that fact.
void close_at_absurdity(Proof& proof) {
  for (std::size_t i = 0; i < proof.size(); ++i) {
    Step& step = proof[i];
    for (Proof& branch : step.branches) close_at_absurdity(branch);
    if (step.rule != Step::Rule::have || step.sign != Sign::positive || !step.polynomial.front().is_zero()) continue;
    Step last;
    last.identities = std::move(step.identities);
    std::erase_if(last.identities.front().terms,
                  [&](const WeightedProduct& term) { return term.product.contains(step.name); });
    proof.erase(proof.begin() + static_cast<std::ptrdiff_t>(i), proof.end());
    proof.push_back(std::move(last));
  }
}

void clear_denominators(Proof& proof) {
  for (Step& step : proof) {
    for (Identity& identity : step.identities) clear_denominators(identity);
    for (Proof& branch : step.branches) clear_denominators(branch);
  }
}

void write(std::string& out, const Identity& identity) {
  for (const WeightedProduct& term : identity.terms) {
    out += "term " + term.coefficient.str();
    for (const auto& [name, exponent] : term.product) {
      out += exponent == 1 ? " " + name : fmt::format(" {}^{}", name, exponent);
    }
    out += '\n';
  }
  for (const auto& [name, multiplier] : identity.equations) {
    out += "equation " + name + ": " + multiplier.text() + '\n';
  }
  out += "qed\n";
}

void write(std::string& out, const Proof& proof) {
  for (const Step& step : proof) {
    switch (step.rule) {
      case Step::Rule::have:
        out += fmt::format("have {}: {} {} 0\n", step.name, step.polynomial.front().text(),
                           step.sign == Sign::zero       ? "="
                           : step.sign == Sign::positive ? ">"
                                                         : ">=");
        break;
      case Step::Rule::contradiction:
        out += "contradiction\n";
        break;
      case Step::Rule::split:
        out += "split " + step.name + ": " + step.polynomial.front().text() + '\n';
        break;
      case Step::Rule::cases:
        out += "cases " + step.name + '\n';
        break;
      case Step::Rule::witness:
        out += "witness " + step.name + '\n';
        for (const auto& [unknown, value] : step.values) out += "set " + unknown + " = " + value + '\n';
        break;
    }
    for (const Identity& identity : step.identities) write(out, identity);
    if (step.rule != Step::Rule::split && step.rule != Step::Rule::cases) continue;
    static constexpr const char* kSigns[] = {"negative", "zero", "positive"};
    for (std::size_t i = 0; i < step.branches.size(); ++i) {
      out += "branch " + (step.rule == Step::Rule::split ? std::string(kSigns[i]) : std::to_string(i + 1)) + '\n';
      write(out, step.branches[i]);
    }
    out += "end\n";
  }
}

}  // namespace

void multiply(Product& product, const Product& other, unsigned exponent) {
  if (exponent == 0) return;
  for (const auto& [name, power] : other) product[name] += power * exponent;
}

void prune(Proof& proof) {
  close_at_absurdity(proof);
  prune_and_name(proof);
  clear_denominators(proof);
}

std::string certificate_text(const Statement& statement, const Proof& proof) {
  std::string out = "slipproof-certificate 1\ntheorem " + statement.theorem() + " " + statement.fingerprint() + '\n';
  write(out, proof);
  return out;
}

}  // namespace slipproof::prove
