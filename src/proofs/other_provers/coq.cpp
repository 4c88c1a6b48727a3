#include "proofs/other_provers/coq.hpp"

#include <fmt/format.h>

#include "base/input/diagnostic.hpp"
#include "proofs/other_provers/certificate_reader.hpp"
#include "proofs/other_provers/coq_statement.hpp"
#include "proofs/other_provers/integer_terms.hpp"

namespace slipproof {

namespace {

using prove::Polynomial;
using prove::Proof;
using prove::Step;

/// An identity that no rule can use, or a hypothesis that is not there.
struct NoProof : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A hypothesis in force: an atom or a disjunction. The polynomial of an atom is written `scale` times itself.
struct Hypothesis {
  coq::Formula formula;
  Integer scale = 1;
};

class Writer {
 public:
  explicit Writer(const prove::Statement& statement)
      : statement_(statement), lines_(statement.text().directives), normalizer_(statement) {}

  std::string write(const Proof& proof) {
    std::size_t i = 0;
    for (; lines_[i].kind != Directive::Kind::exists && lines_[i].kind != Directive::Kind::show; ++i) {
      const Directive& line = lines_[i];
      std::string pattern;
      if (line.kind == Directive::Kind::assume) pattern = assume(line.names.front(), normalizer_.normal(line.body));
      normalizer_.introduce(line, pattern);
      out_ += normalizer_.take();
    }
    conclusion_ = i;
    if (lines_[i].kind == Directive::Kind::show) refute_conclusion();
    write_steps(proof);
    return std::move(out_);
  }

 private:
  /// `goal` is the negated conclusion from here on, and False what is to be shown.
  void refute_conclusion() {
    const Expression& shown = lines_[conclusion_].body;
    const coq::Formula formula = normalizer_.normal(shown);
    out_ += fmt::format("destruct ({}) as [_ok | {}]. {{ refine (Steps.backward _ _ok).\n", either(formula),
                        assume("goal", negation(formula)));
    normalizer_.prove_same(shown);
    out_ += normalizer_.take() + "}\nexfalso.\n";
  }

  /// Different names stay different: motion.2.1 is a part of motion, motion_2.1 one of motion_2.
  static std::string identifier(const std::string& hypothesis) { return "_" + coq::name(hypothesis); }

  /// Puts a formula in force; the pattern that takes it apart.
  std::string assume(const std::string& name, const coq::Formula& formula, const Integer& scale = 1) {
    if (formula.kind != coq::Formula::Kind::conjunction || formula.parts.empty()) {
      hypotheses_.insert_or_assign(name, Hypothesis{formula, scale});
      order_.push_back(name);
      return identifier(name);
    }
    std::string pattern;
    for (std::size_t i = 0; i < formula.parts.size(); ++i) {
      pattern += (i == 0 ? "(" : " & ") + assume(fmt::format("{}.{}", name, i + 1), formula.parts[i]);
    }
    return pattern + ")";
  }

  void forget(std::size_t scope) {
    for (; order_.size() > scope; order_.pop_back()) hypotheses_.erase(order_.back());
  }

  const Hypothesis& hypothesis(const std::string& name) const {
    const auto found = hypotheses_.find(name);
    if (found == hypotheses_.end()) throw NoProof("there is no hypothesis '" + name + "' here");
    return found->second;
  }

  void write_steps(const Proof& proof) {
    const std::size_t scope = order_.size();
    std::size_t open = 0;
    for (const Step& step : proof) {
      switch (step.rule) {
        case Step::Rule::have:
          write_have(step);
          break;
        case Step::Rule::witness:
          write_witness(step);
          ++open;
          break;
        case Step::Rule::contradiction:
          if (!statement_.unknowns().empty()) out_ += "exfalso. ";
          write_identity(step.identities.front());
          break;
        case Step::Rule::split:
          write_split(step);
          break;
        case Step::Rule::cases:
          write_cases(step);
          break;
      }
    }
    for (; open > 0; --open) out_ += "}\n";
    forget(scope);
  }

  void write_have(const Step& step) {
    const Polynomial& p = step.polynomial.front();
    const Integer scale = common_denominator(p);
    const std::string polynomial = coq::text(p, scale);
    const coq::Formula claim = coq::atom(polynomial, step.sign), opposite = negation(claim);
    const std::string id = identifier(step.name);
    out_ += fmt::format("assert ({} : {}). {{\n", id, text(claim));
    const std::size_t scope = order_.size();
    if (step.sign == prove::Sign::zero) {
      out_ += fmt::format("destruct ({}) as [{} | [{} | {}]]; [exact {} | exfalso | exfalso].\n", either(claim), id, id,
                          id, id);
    } else {
      out_ += fmt::format("destruct ({}) as [{} | {}]; [exact {} | exfalso].\n", either(claim), id, id, id);
    }
    for (std::size_t i = 0; i < step.identities.size(); ++i) {
      assume(step.name, step.sign == prove::Sign::zero ? opposite.parts.at(i) : opposite, scale);
      if (step.identities.size() > 1) out_ += "{ ";
      write_identity(step.identities[i]);
      if (step.identities.size() > 1) out_ += "}\n";
      forget(scope);
    }
    out_ += "}\n";
    assume(step.name, claim, scale);
  }

  void write_split(const Step& step) {
    const Polynomial& p = step.polynomial.front();
    const Integer scale = common_denominator(p);
    const std::string polynomial = coq::text(p, scale), id = identifier(step.name);
    out_ += fmt::format("destruct (Steps.signs ({0})) as [{1} | [{1} | {1}]].\n", polynomial, id);
    const coq::Formula signs[] = {coq::atom("- (" + polynomial + ")", prove::Sign::positive),
                                  coq::atom(polynomial, prove::Sign::zero),
                                  coq::atom(polynomial, prove::Sign::positive)};
    for (std::size_t i = 0; i < step.branches.size(); ++i) {
      const std::size_t scope = order_.size();
      assume(step.name, signs[i], scale);
      out_ += "{ ";
      write_steps(step.branches[i]);
      out_ += "}\n";
      forget(scope);
    }
  }

  void write_cases(const Step& step) {
    const coq::Formula disjunction = hypothesis(step.name).formula;
    if (disjunction.kind != coq::Formula::Kind::disjunction || disjunction.parts.size() != step.branches.size()) {
      throw NoProof("'" + step.name + "' has other alternatives");
    }
    const std::size_t scope = order_.size();
    std::vector<std::string> patterns;
    for (std::size_t i = 0; i < step.branches.size(); ++i) {
      patterns.push_back(assume(fmt::format("{}.{}", step.name, i + 1), disjunction.parts[i]));
      forget(scope);
    }
    std::string pattern = patterns.empty() ? "" : patterns.back();
    for (std::size_t i = patterns.size(); i-- > 1;) pattern = "[" + patterns[i - 1] + " | " + pattern + "]";
    out_ += "destruct " + identifier(step.name) + (pattern.empty() ? "" : " as " + pattern) + ".\n";
    for (std::size_t i = 0; i < step.branches.size(); ++i) {
      assume(fmt::format("{}.{}", step.name, i + 1), disjunction.parts[i]);
      out_ += "{ ";
      write_steps(step.branches[i]);
      out_ += "}\n";
      forget(scope);
    }
  }

  /// Either the values are there and what is shown holds for them, and all is done; or the hypothesis of the step.
  void write_witness(const Step& step) {
    coq::Normalizer values = normalizer_;
    std::vector<Expression> expressions;
    std::vector<coq::Formula> required;
    std::vector<std::pair<Polynomial, std::string>> non_zero;
    std::string pattern, either_term;
    std::vector<std::string> decisions;
    std::vector<coq::Formula> failures;
    for (const auto& [unknown, value] : step.values) {
      expressions.push_back(parse_witness_value(statement_.text(), value));
      for (const Polynomial& divisor : normalizer_.divisors(expressions.back())) {
        const std::string polynomial = coq::text(divisor);
        non_zero.emplace_back(divisor, fmt::format("_w{}", non_zero.size() + 1));
        pattern += (pattern.empty() ? "(" : " & ") + non_zero.back().second;
        decisions.push_back(fmt::format("Steps.nonzero_or ({})", polynomial));
        failures.push_back(coq::atom(polynomial, prove::Sign::zero));
      }
    }
    for (std::size_t i = 0; i < expressions.size(); ++i)
      values.give_value(step.values[i].first, expressions[i], non_zero);
    std::string script = values.take() + "exists ";
    for (std::size_t i = 0; i < expressions.size(); ++i)
      script += (i == 0 ? "" : ", ") + coq::name(step.values[i].first);
    script += ".\n";
    for (std::size_t i = conclusion_ + 1; i + 1 < lines_.size(); ++i) values.introduce(lines_[i]);
    const coq::Formula shown = values.normal(lines_.back().body);
    script += values.take() + "refine (Steps.backward _ _ok).\n";
    values.prove_same(lines_.back().body);
    script += values.take();
    decisions.push_back(either(shown));
    failures.push_back(negation(shown));
    pattern += pattern.empty() ? "_ok" : " & _ok)";
    const coq::Formula failure = coq::combine(coq::Formula::Kind::disjunction, std::move(failures));
    out_ += fmt::format("destruct ({}) as [{} | {}].\n{{ {}}}\n{{ ", coq::right_nested("Steps.either_and", decisions),
                        pattern, assume(step.name, failure), script);
  }

  /// Closes the goal False.
  void write_identity(const prove::Identity& identity) {
    struct Term {
      Rational coefficient;
      std::vector<std::pair<std::string, unsigned>> factors;
      bool strict = true;
    };
    Integer common = 1;
    std::vector<Term> terms;
    for (const auto& [coefficient, product] : identity.terms) {
      Term& term = terms.emplace_back(Term{coefficient, {}});
      for (const auto& [name, exponent] : product) {
        const Hypothesis& h = hypothesis(name);
        term.strict = term.strict && h.formula.sign == prove::Sign::positive;
        term.coefficient /= Rational(pow(h.scale, exponent));
        term.factors.emplace_back(name, exponent);
      }
      common = lcm(common, denominator(term.coefficient));
    }
    std::vector<std::pair<std::string, Polynomial>> equations;
    for (const auto& [name, multiplier] : identity.equations) {
      equations.emplace_back(name, multiplier.scaled(1 / Rational(hypothesis(name).scale)));
      common = lcm(common, common_denominator(equations.back().second));
    }
    const auto strict = std::stable_partition(terms.begin(), terms.end(), [](const Term& term) { return term.strict; });
    if (strict == terms.begin()) throw NoProof("no term of the identity is strict");
    std::string sum;
    for (const Term& term : terms) {
      const std::string coefficient = numerator(Rational(term.coefficient * common)).str();
      const bool first = sum.empty();
      const std::string proof = product_proof(coefficient, term.factors, first);
      sum = first ? proof : fmt::format("Steps.add ({}) ({})", sum, proof);
    }
    for (const auto& [name, multiplier] : equations) {
      sum = fmt::format("Steps.multiple ({}) ({}) {}", coq::text(multiplier, common), sum, identifier(name));
    }
    out_ += fmt::format("refine (Steps.absurd _ ({}) _). ring.\n", sum);
  }

  /// A term that proves 0 < coefficient * product, or, not strict, 0 <= ... .
  std::string product_proof(const std::string& coefficient,
                            const std::vector<std::pair<std::string, unsigned>>& factors, bool strict) const {
    const auto weak = [&](const std::string& proof, bool is_strict) {
      return strict || !is_strict ? proof : "Steps.weak (" + proof + ")";
    };
    std::vector<std::string> proofs;
    if (coefficient != "1" || factors.empty()) proofs.push_back(weak("IZR_lt 0 " + coefficient + " eq_refl", true));
    for (const auto& [name, exponent] : factors) {
      const std::string proof = weak(identifier(name), hypothesis(name).formula.sign == prove::Sign::positive);
      proofs.push_back(exponent == 1 ? proof
                                     : fmt::format("Steps.{} {} ({})", strict ? "power" : "power0", exponent, proof));
    }
    return coq::right_nested(strict ? "Steps.mul" : "Steps.mul0", proofs);
  }

  const prove::Statement& statement_;
  const std::vector<Directive>& lines_;
  coq::Normalizer normalizer_;
  std::size_t conclusion_ = 0;  ///< index of the line `exists` or `show`
  std::map<std::string, Hypothesis> hypotheses_;
  std::vector<std::string> order_;
  std::string out_;
};

}  // namespace

std::string coq_text(const std::string& file, const std::string& statement_text, const std::string& certificate_file,
                     const std::string& certificate) {
  const prove::Statement statement(file, statement_text);
  const Proof proof = read_certificate(statement, certificate_file, certificate);
  try {
    return "(* The theorem is the statement of the same name, the proof its certificate. *)\n"
           "From Coq Require Import Reals Lra.\nLocal Open Scope R_scope.\nNotation real := Rdefinitions.R.\n\n" +
           std::string(coq::kSteps) + "\n" + coq::theorem(statement) + "Proof.\n" + Writer(statement).write(proof) +
           "Qed.\n";
  } catch (const NoProof& error) {
    throw InputError({{certificate_file, 0, 0, error.what()}});
  } catch (const ExpressionError& error) {
    throw InputError({{file, 0, 0, error.what()}});
  }
}

}  // namespace slipproof
