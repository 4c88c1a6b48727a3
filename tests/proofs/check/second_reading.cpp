#include "proofs/check/second_reading.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "base/expression/parser.hpp"
#include "base/input/diagnostic.hpp"
#include "proofs/other_provers/certificate_reader.hpp"

namespace slipproof::test {

namespace {

struct NotConfirmed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

void must(bool condition, const std::string& otherwise) {
  if (!condition) throw NotConfirmed(otherwise);
}

using SecondWords = std::vector<std::string>;

bool second_word(const std::string& token) {
  return std::isalnum(static_cast<unsigned char>(token.front())) != 0;
}

/// Words of all characters of names and numbers, `>=`, and single characters, without blanks.
SecondWords second_words(const std::string& line) {
  const std::string in_word = "_'.";
  const auto belongs = [&](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || in_word.find(c) != std::string::npos;
  };
  SecondWords result;
  for (std::size_t at = 0; at < line.size();) {
    std::size_t end = at;
    while (end < line.size() && belongs(line[end])) ++end;
    end = std::max(end, at + (line.compare(at, 2, ">=") == 0 ? 2 : 1));
    if (line[at] != ' ' && line[at] != '\t') result.push_back(line.substr(at, end - at));
    at = end;
  }
  return result;
}

/// A certificate as the prover writes it: no superfluous blanks, and in the statement's variables alone.
class Expansion {
 public:
  explicit Expansion(const std::string& statement) {
    std::istringstream lines(statement);
    for (std::string line; std::getline(lines, line);) {
      const SecondWords words = second_words(line);
      if (words.empty()) continue;
      if (words[0] == "exists") break;
      if (words[0] == "real") variables_.insert(words.begin() + 1, words.end());
      if (words[0] == "let") abbreviations_[words.at(1)] = "(" + expression({words.begin() + 3, words.end()}) + ")";
    }
  }

  std::string line(const std::string& text) const {
    const SecondWords words = second_words(text);
    if (words.empty() || words[0] == "#") return "";
    const std::string& rule = words[0];
    if (rule == "set") {
      must(words.size() > 3 && words[2] == "=", "`set` without a value");
      return "set " + words[1] + " = " + expression({words.begin() + 3, words.end()});
    }
    if (rule == "have" || rule == "split" || rule == "equation") {
      must(words.size() > 3 && words[2] == ":", "`" + rule + "` without a polynomial");
      const auto relation = rule == "have" ? std::find_if(words.begin(), words.end(), is_relation) : words.end();
      std::string result = rule + " " + words[1] + ": " + expression({words.begin() + 3, relation});
      if (rule == "have") must(words.end() - relation == 2, "`have` without a comparison with 0");
      return rule == "have" ? result + " " + *relation + " " + words.back() : result;
    }
    std::string result = rule;
    for (std::size_t i = 1; i < words.size(); ++i) {
      result += (words[i] == "^" || words[i - 1] == "^" ? "" : " ") + words[i];
    }
    return result;
  }

 private:
  static bool is_relation(const std::string& word) { return word == ">" || word == ">=" || word == "="; }

  std::string expression(const SecondWords& words) const {
    std::string result;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::string& word = words[i];
      must(i == 0 || !second_word(word) || !second_word(words[i - 1]), "two words without a sign between them");
      const bool name = std::isalpha(static_cast<unsigned char>(word.front())) != 0;
      const auto abbreviation = abbreviations_.find(word);
      must(!name || variables_.contains(word) || abbreviation != abbreviations_.end(), "unknown name " + word);
      result += abbreviation == abbreviations_.end() ? word : abbreviation->second;
    }
    return result;
  }

  std::set<std::string> variables_;
  std::map<std::string, std::string> abbreviations_;
};

using InForce = std::map<std::string, prove::Formula>;

void put_in_force(InForce& hypotheses, const std::string& name, const prove::Formula& formula) {
  if (formula.kind != prove::Formula::Kind::conjunction) {
    must(hypotheses.emplace(name, formula).second, "a second hypothesis " + name);
    return;
  }
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    put_in_force(hypotheses, name + "." + std::to_string(i + 1), formula.parts[i]);
  }
}

const prove::Formula& found_in_force(const InForce& hypotheses, const std::string& name, prove::Formula::Kind kind) {
  const auto place = hypotheses.find(name);
  must(place != hypotheses.end() && place->second.kind == kind, "no such hypothesis: " + name);
  return place->second;
}

void confirm_identity(const prove::Statement& statement, const InForce& hypotheses, const prove::Identity& identity) {
  prove::Polynomial sum(statement.ring());
  bool strict = false;
  for (const auto& [coefficient, product] : identity.terms) {
    must(coefficient > 0, "a coefficient that is not positive");
    prove::Polynomial term(statement.ring(), coefficient);
    bool all_strict = true;
    for (const auto& [name, exponent] : product) {
      const prove::Formula& factor = found_in_force(hypotheses, name, prove::Formula::Kind::atom);
      must(factor.sign != prove::Sign::zero, name + " is not an inequality");
      all_strict = all_strict && factor.sign == prove::Sign::positive;
      for (unsigned i = 0; i < exponent; ++i) term *= factor.polynomial.front();
    }
    strict = strict || all_strict;
    sum += term;
  }
  for (const auto& [name, multiplier] : identity.equations) {
    const prove::Formula& equation = found_in_force(hypotheses, name, prove::Formula::Kind::atom);
    must(equation.sign == prove::Sign::zero, name + " is not an equation");
    sum += multiplier * equation.polynomial.front();
  }
  must(sum.is_zero(), "an identity does not hold");
  must(strict, "an identity without a strict term");
}

prove::Formula witness_failure(const prove::Statement& statement, const prove::Step& step) {
  std::vector<std::string> values;
  for (const auto& [unknown, value] : step.values) values.push_back(value);
  must(!values.empty() && values.size() == statement.unknowns().size(), "a witness of other unknowns");
  std::vector<prove::Formula> failures;
  for (const prove::Polynomial& p : statement.divisors(values)) failures.push_back(atom(p, prove::Sign::zero));
  failures.push_back(negation(statement.shown(values)));
  return combine(prove::Formula::Kind::disjunction, std::move(failures));
}

void confirm_have(const prove::Statement& statement, InForce& hypotheses, const prove::Step& step) {
  const prove::Formula claim = prove::atom(step.polynomial.front(), step.sign), opposite = negation(claim);
  const std::vector<prove::Formula> parts =
      step.sign == prove::Sign::zero ? opposite.parts : std::vector<prove::Formula>{opposite};
  must(parts.size() == step.identities.size(), "a fact with another number of identities");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    put_in_force(hypotheses, step.name, parts[i]);
    confirm_identity(statement, hypotheses, step.identities[i]);
    hypotheses.erase(step.name);
  }
  put_in_force(hypotheses, step.name, claim);
}

/// That the hypotheses cannot all hold.
void confirm_steps(const prove::Statement& statement, InForce hypotheses, const prove::Proof& proof) {
  const auto branch = [&](const std::string& name, const prove::Formula& formula, const prove::Proof& steps) {
    InForce more = hypotheses;
    put_in_force(more, name, formula);
    confirm_steps(statement, std::move(more), steps);
  };
  for (const prove::Step& step : proof) {
    switch (step.rule) {
      case prove::Step::Rule::have:
        confirm_have(statement, hypotheses, step);
        break;
      case prove::Step::Rule::witness:
        put_in_force(hypotheses, step.name, witness_failure(statement, step));
        break;
      case prove::Step::Rule::contradiction:
        return confirm_identity(statement, hypotheses, step.identities.at(0));
      case prove::Step::Rule::split: {
        const prove::Polynomial& p = step.polynomial.front();
        branch(step.name, prove::atom(-p, prove::Sign::positive), step.branches.at(0));
        branch(step.name, prove::atom(p, prove::Sign::zero), step.branches.at(1));
        branch(step.name, prove::atom(p, prove::Sign::positive), step.branches.at(2));
        return;
      }
      case prove::Step::Rule::cases: {
        const auto& parts = found_in_force(hypotheses, step.name, prove::Formula::Kind::disjunction).parts;
        must(parts.size() == step.branches.size(), "other alternatives of " + step.name);
        for (std::size_t i = 0; i < parts.size(); ++i) {
          branch(step.name + "." + std::to_string(i + 1), parts[i], step.branches[i]);
        }
        return;
      }
    }
  }
  throw NotConfirmed("a branch stays open");
}

}  // namespace

std::string unconfirmed(const std::string& statement_text, const std::string& certificate) {
  try {
    const prove::Statement statement("statement", statement_text);
    const Expansion expansion(statement_text);
    std::string expanded;
    std::istringstream lines(certificate);
    for (std::string line; std::getline(lines, line);) {
      const bool header = line.starts_with("slipproof-certificate") || line.starts_with("theorem");
      expanded += (header ? line : expansion.line(line)) + '\n';
    }
    const prove::Proof proof = read_certificate(statement, "certificate", expanded);
    InForce hypotheses;
    for (const auto& [name, formula] : statement.assumptions()) put_in_force(hypotheses, name, formula);
    if (statement.unknowns().empty()) put_in_force(hypotheses, "goal", negation(statement.shown()));
    confirm_steps(statement, std::move(hypotheses), proof);
    return "";
  } catch (const NotConfirmed& error) {
    return error.what();
  } catch (const InputError& error) {
    return to_string(error.diagnostics().front());
  } catch (const ExpressionError& error) {
    return error.what();
  }
}

}  // namespace slipproof::test
