#include "proofs/search/prove.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <sstream>

#include "base/input/diagnostic.hpp"
#include "proofs/check/judge.hpp"
#include "proofs/search/instance.hpp"
#include "proofs/search/search.hpp"

namespace slipproof {

namespace {

using prove::Formula;
using prove::Statement;

/// The statement that its assumptions contradict each other.
std::string contradiction_text(const Statement& statement, const std::string& text) {
  std::string result;
  std::istringstream lines(text);
  std::string line;
  const auto& directives = statement.text().directives;
  auto directive = directives.begin();
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    while (directive->line < number && std::next(directive) != directives.end()) ++directive;
    if (directive->line == number &&
        (directive->kind == Directive::Kind::exists || directive->kind == Directive::Kind::show)) {
      break;
    }
    result += line + '\n';
  }
  return result + "show false\n";
}

class Prover {
 public:
  Prover(const std::string& file, const std::string& text, const prove::Limits& limits)
      : file_(file), text_(text), limits_(limits), statement_(file, text) {}

  ProofOutcome run() {
    outcome_.theorem = statement_.theorem();
    if (refute(limits_.quick_samples, at_least(limits_.steps / 1000, 100'000))) return std::move(outcome_);
    prove::Search search(statement_, limits_);
    const auto proof = search.prove();
    outcome_.steps = search.steps();
    if (proof) {
      accept(certificate_text(statement_, *proof));
      ask_the_checker();
    } else if (!refute(limits_.samples, at_least(limits_.steps / 20, 200'000))) {
      outcome_.leftover = search.leftover().facts;
      outcome_.exhausted = search.leftover().exhausted;
    }
    return std::move(outcome_);
  }

 private:
  using Accept = std::function<bool(const std::vector<Rational>& values)>;

  /// The steps for additional work: a part of the limit, or as many as it needs, if there are that many.
  std::uint64_t at_least(std::uint64_t part, std::uint64_t needed) const {
    return std::min(limits_.steps, std::max(part, needed));
  }
  bool asks_for_values() const { return !statement_.unknowns().empty(); }

  void accept(std::string certificate) {
    outcome_.verdict = ProofOutcome::Verdict::proved;
    outcome_.certificate = std::move(certificate);
    if (limits_.samples == 0 || evident(statement_.shown()) == false) return;
    if (uses_assumptions_only(outcome_.certificate)) {
      outcome_.vacuous = true;
    } else if (!instance(assumptions(), limits_.samples, at_least(limits_.steps / 100, 200'000))) {
      // A proof that happens to use the conclusion may not have to.
      const Statement contradiction(file_, contradiction_text(statement_, text_));
      prove::Limits limits = limits_;
      limits.sums_of_squares = false;  // it is only asked whether the statement says something
      prove::Search search(contradiction, limits);
      const auto proof = search.prove();
      if (!proof) return;
      outcome_.vacuous = true;
      outcome_.certificate = certificate_text(statement_, *proof);
    }
  }

  /// The checker has limits that the search has not, on exponents and lengths: what it refuses is not proved.
  void ask_the_checker() {
    const check::Judgement judgement = check::judge(text_, outcome_.certificate);
    if (judgement.verdict == check::Verdict::accepted) return;
    outcome_.verdict = ProofOutcome::Verdict::undecided;
    outcome_.certificate.clear();
    outcome_.vacuous = false;
    outcome_.leftover = {"a certificate that slipproof-check does not accept: " + judgement.message};
  }

  Formula assumptions() const {
    Formula all;
    for (const auto& [name, formula] : statement_.assumptions()) all.parts.push_back(formula);
    return all;
  }

  std::optional<std::vector<Rational>> instance(const Formula& formula, int attempts, std::uint64_t steps,
                                                const Accept& accept = {}) const {
    const prove::Ring& ring = statement_.ring();
    ring.budget().renew(steps);
    try {
      return find_instance(
          ring, formula,
          {.boundaries = statement_.hints(), .attempts = attempts, .roots = true, .accept = [&](const auto& values) {
             return holds_at(formula, values) && (!accept || accept(values));
           }});
    } catch (const Budget::Spent&) {
      return std::nullopt;
    }
  }

  /// Whether numbers were found at which it is false.
  bool refute(int attempts, std::uint64_t steps) {
    if (attempts == 0 || statement_.unknowns().size() == statement_.ring().size()) return false;
    Formula formula = assumptions();
    if (!asks_for_values()) formula.parts.push_back(negation(statement_.shown()));
    int tries = attempts / 8;  // each of them is a search of its own
    bool found = false;
    const auto values = instance(formula, attempts, steps, [&](const std::vector<Rational>& values) {
      found = !asks_for_values() || fails_at(named(values));
      return found || --tries < 0;
    });
    if (!found || !values) return false;
    outcome_.verdict = ProofOutcome::Verdict::refuted;
    outcome_.counterexample = named(*values);
    return true;
  }

  NamedValues named(const std::vector<Rational>& values) const {
    NamedValues result;
    for (std::size_t i = 0; i + statement_.unknowns().size() < statement_.ring().size(); ++i) {
      result.emplace_back(statement_.ring().name(i), values[i]);
    }
    return result;
  }

  /// Whether no values of the unknowns do.
  bool fails_at(const NamedValues& values) const {
    const NamedStatement fails = refutation_at({statement_.theorem(), text_}, values).back();
    prove::Limits limits = limits_;
    limits.steps = limits_.steps / 1000;
    limits.sums_of_squares = false;
    try {
      const Statement statement(fails.name, fails.text);
      return prove::Search(statement, limits).prove().has_value();
    } catch (const InputError&) {
      return false;  // something is divided by a number that is 0
    }
  }

  const std::string& file_;
  const std::string& text_;
  const prove::Limits& limits_;
  Statement statement_;
  ProofOutcome outcome_;
};

/// `goal`, the negated conclusion, and its parts.
bool is_goal(std::string_view word) {
  return word.starts_with("goal") && (word.size() == 4 || word[4] == '.' || word[4] == '^');
}

}  // namespace

std::string_view name(ProofOutcome::Verdict verdict) {
  static constexpr std::array<std::string_view, 3> names{"proved", "refuted", "undecided"};
  return names[static_cast<std::size_t>(verdict)];
}

ProofOutcome prove_statement(const std::string& file, const std::string& text, const prove::Limits& limits) {
  return Prover(file, text, limits).run();
}

ProofOutcome prove_formula(const std::string& formula, const prove::Limits& limits) {
  try {
    return prove_statement("formula", formula_statement(formula), limits);
  } catch (const InputError& error) {
    std::vector<Diagnostic> mistakes = error.diagnostics();
    for (Diagnostic& mistake : mistakes) {
      mistake.line = 1;
      mistake.column -= std::min(mistake.column, formula_prefix.size());
    }
    throw InputError(std::move(mistakes));
  }
}

bool uses_assumptions_only(std::string_view certificate) {
  std::istringstream lines{std::string(certificate)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string rule, name;
    words >> rule;
    if (rule == "witness") return false;
    if (rule != "term" && rule != "cases" && rule != "equation") continue;
    while (words >> name && !name.ends_with(':')) {
      if (is_goal(name)) return false;
    }
    if (name.ends_with(':') && is_goal(name.substr(0, name.size() - 1))) return false;
  }
  return true;
}

bool claims_contradiction(const std::string& file, const std::string& text) {
  return evident(Statement(file, text).shown()) == false;
}

}  // namespace slipproof
