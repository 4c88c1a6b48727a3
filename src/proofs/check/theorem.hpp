// Statements, and certificates that prove them (proofs/FORMAT.md).
#pragma once

#include <set>

#include "proofs/check/formula.hpp"

namespace slipproof::check {

inline constexpr std::size_t kMaxStatement = 1 << 20;  ///< bytes

/// Reads a line `let` or `define` and returns the name that it gives.
inline std::string abbreviate(FormulaReader& reader) {
  const bool is_value = reader.rule == "let";
  require(is_value || reader.rule == "define", "unknown directive, or one that may not follow `exists`");
  std::string name = reader.name();
  reader.expect(is_value ? "=" : ":");
  if (is_value) reader.names.values[name] = reader.value();
  if (!is_value) reader.names.formulas[name] = reader.formula();
  return name;
}

/// For all values of the variables, if the assumptions hold, then the formula shown holds; with unknowns: then there
/// are values of them for which it holds.
class Statement {
 public:
  /// Throws Rejection.
  explicit Statement(FormulaReader& reader) : reader_(reader) {
    reader_.expect_line("slipproof-statement 1");
    require(reader_.size() <= kMaxStatement, "the statement is too long");
    theorem = reader_.theorem();
    do {
      reader_.need_line();
      reader_.rule = reader_.name();
      if (!unknowns.empty()) conclusion_.append(reader_.line()) += '\n';
      read_directive();
      reader_.expect_end();
    } while (reader_.rule != "show");
    keep_parts_apart();
    fingerprint = reader_.fingerprint();
    require(!reader_.next_line(), "nothing may follow `show`");
  }

  /// The formula shown, with these values for the unknowns.
  Formula shown_for(const std::vector<Fraction>& values) const {
    FormulaReader again(conclusion_);
    again.names = names;
    for (std::size_t i = 0; i < unknowns.size(); ++i) again.names.values[unknowns[i]] = values.at(i);
    while (true) {
      again.need_line();
      again.rule = again.name();
      if (again.rule == "show") return again.formula();
      abbreviate(again);
    }
  }

  Work work;  ///< first, as the members after it cost some
  std::string theorem, fingerprint;
  Names names;  ///< those before `exists`
  std::vector<std::pair<std::string, Formula>> assumptions;
  std::vector<std::string> unknowns;
  Formula shown;

 private:
  void read_directive() {
    const std::string& directive = reader_.rule;
    const bool universal = unknowns.empty();  // `exists` is still to come, if at all
    if (universal && (directive == "real" || directive == "exists")) {
      if (directive == "exists") names = reader_.names;
      do {
        const std::string name = reader_.name();
        give(name);
        reader_.names.values[name] = variable();
        if (directive == "exists") unknowns.push_back(name);
      } while (!reader_.at_end());
    } else if (universal && directive == "assume") {
      const std::string name = reader_.name();
      give(name);
      reader_.expect(":");
      assumptions.emplace_back(name, reader_.formula());
    } else if (directive == "show") {
      if (universal) names = reader_.names;
      shown = reader_.formula();
    } else {
      give(abbreviate(reader_));
    }
  }

  /// The parts of a hypothesis H are H.1, H.2, H.2.1, ..., and `goal` is the negated conclusion: no assumption may have
  /// a name of these.
  void keep_parts_apart() const {
    std::set<std::string> wholes = {"goal"};
    for (const auto& assumption : assumptions) wholes.insert(assumption.first);
    require(wholes.size() > assumptions.size(), "an assumption is called `goal`");
    for (std::string name : wholes) {
      for (std::size_t dot; name[dot = name.find_last_not_of("0123456789")] == '.';) {
        name.erase(dot);
        if (wholes.contains(name)) throw Rejection("an assumption has the name of a part of `" + name + "`");
      }
    }
  }

  void give(const std::string& name) { require(given_.insert(name).second, "the name is given twice"); }

  Fraction variable() {
    require(variables_ < kMaxVariables, "too many variables");
    Exponents exponents{};
    exponents[variables_++] = 1;
    return {Polynomial(1, exponents)};
  }

  FormulaReader& reader_;
  std::set<std::string> given_;
  std::size_t variables_ = 0;
  std::string conclusion_;  ///< the lines after `exists`
};

/// A certificate: a proof by contradiction from the assumptions and the negated conclusion.
class Proof {
 public:
  /// Reads what follows the first line. Returns if the certificate proves the statement, otherwise throws Rejection.
  Proof(const Statement& statement, FormulaReader& reader) : statement_(statement), reader_(reader) {
    reader_.names = statement.names;
    reader_.expect_line("theorem " + statement.theorem + " " + statement.fingerprint);
    for (const auto& [name, formula] : statement.assumptions) assume(name, formula);
    if (statement.unknowns.empty()) assume("goal", negation(statement.shown));
    close_branch();
    require(!reader_.next_line(), "the proof is complete, but the certificate goes on");
  }

 private:
  /// Adds a formula to the hypotheses in force: for a conjunction its parts, NAME.1, NAME.2, ...
  void assume(const std::string& name, const Formula& formula) {
    if (formula.kind == Kind::conjunction) {
      std::size_t number = 0;
      for (const Formula& part : formula.parts) assume(name + "." + std::to_string(++number), part);
    } else {
      const auto [place, is_new] = hypotheses_.emplace(name, formula);
      require(is_new, "the name of a hypothesis is given twice");
      order_.push_back(place);
    }
  }

  /// Takes a formula as a hypothesis for the time of an action.
  template <class Action>
  void with(const std::string& name, const Formula& formula, Action action) {
    const std::size_t before = order_.size();
    assume(name, formula);
    action();
    for (; order_.size() > before; order_.pop_back()) hypotheses_.erase(order_.back());
  }

  /// Reads the name of a hypothesis in force.
  const Formula& hypothesis() {
    used_ = used_ || reader_.peek() == to_use_;
    const auto place = hypotheses_.find(reader_.name());
    require(place != hypotheses_.end(), "there is no such hypothesis here");
    return place->second;
  }

  /// Reads `have` and `witness`, and then one rule that closes the branch.
  void close_branch() {
    while (true) {
      reader_.need_line();
      reader_.rule = reader_.name();
      if (reader_.rule == "split") return split();
      if (reader_.rule == "cases") return cases();
      if (reader_.rule == "contradiction") return identity();
      require(reader_.rule == "have" || reader_.rule == "witness", "unknown rule");
      if (reader_.rule == "have") have();
      if (reader_.rule == "witness") witness();
    }
  }

  /// `split NAME: p`: NAME is p < 0, p = 0, p > 0 in the three branches.
  void split() {
    const std::string name = reader_.name();
    reader_.expect(":");
    const Polynomial p = reader_.polynomial();
    reader_.expect_end();
    branch("negative", name, {Kind::positive, -p});
    branch("zero", name, {Kind::zero, p});
    branch("positive", name, {Kind::positive, p});
    reader_.expect_line("end");
  }

  /// `cases NAME`: NAME.1, NAME.2, ... are the alternatives in the branches.
  void cases() {
    const std::string name(reader_.peek());
    const Formula& alternatives = hypothesis();
    require(alternatives.kind == Kind::disjunction, "the hypothesis is not a disjunction");
    reader_.expect_end();
    for (std::size_t i = 0; i < alternatives.parts.size(); ++i) {
      const std::string number = std::to_string(i + 1);
      branch(number, name + "." + number, alternatives.parts[i]);
    }
    reader_.expect_line("end");
  }

  void branch(const std::string& label, const std::string& name, const Formula& formula) {
    require(depth_ < kMaxNesting, "the branches are nested too deeply");
    reader_.expect_line("branch " + label);
    ++depth_;
    with(name, formula, [this] { close_branch(); });
    --depth_;
  }

  /// `have NAME: p > 0`, `p >= 0` or `p = 0`: an identity refutes the negation, which has the same name; for an
  /// equation there are two, one for p > 0 and one for p < 0.
  void have() {
    const std::string name = reader_.name();
    reader_.expect(":");
    const Polynomial p = reader_.polynomial();
    const Kind kind = reader_.accept(">=") ? Kind::non_negative : reader_.accept(">") ? Kind::positive : Kind::zero;
    if (kind == Kind::zero) reader_.expect("=");
    reader_.expect("0");
    const Formula opposite = negation({kind, p});
    for (const Formula& part : kind == Kind::zero ? opposite.parts : std::vector{opposite})
      with(name, part, [&] { identity(name); });
    assume(name, {kind, p});
  }

  /// `witness NAME`, then `set UNKNOWN = EXPRESSION` for each unknown in turn. NAME says that these values fail: one of
  /// their divisors is zero, or the conclusion is false for them.
  void witness() {
    require(!statement_.unknowns.empty(), "the statement has no `exists`");
    const std::string name = reader_.name();
    reader_.expect_end();
    std::vector<Fraction> values;
    std::vector<Formula> failures;
    for (const std::string& unknown : statement_.unknowns) {
      reader_.need_line();
      reader_.expect("set");
      reader_.expect(unknown);
      reader_.expect("=");
      values.push_back(reader_.value());
      reader_.expect_end();
      for (const Polynomial& divisor : values.back().divisors) failures.push_back({Kind::zero, divisor});
    }
    failures.push_back(negation(statement_.shown_for(values)));
    assume(name, combine(Kind::disjunction, std::move(failures)));
  }

  /// Lines up to `qed`. If all hypotheses held, the sum would be positive; yet it is zero. Uses the named hypothesis.
  void identity(const std::string& to_use = "") {
    reader_.expect_end();
    to_use_ = to_use;
    used_ = to_use.empty();
    Polynomial sum;
    bool strict = false, superfluous = false;
    int lines = 0;
    for (reader_.need_line(); !reader_.accept("qed"); reader_.need_line(), ++lines) {
      Polynomial line = reader_.accept("equation") ? equation() : term(strict);
      superfluous = superfluous || line.is_zero();
      sum += std::move(line);
      reader_.expect_end();
    }
    reader_.expect_end();
    require(sum.is_zero(), "the lines do not add up to zero");
    require(strict, "no term is strict");
    require(used_, "the negation is not used");
    require(lines == 1 || !superfluous, "a line is zero, and not the only one");
  }

  /// `equation E: q` is worth q p, where E is p = 0.
  Polynomial equation() {
    const Formula& equation = hypothesis();
    require(equation.kind == Kind::zero, "not an equation");
    reader_.expect(":");
    return reader_.polynomial() * equation.polynomial;
  }

  /// `term C H K^2 ...` is worth the positive number C times these inequalities, and strict if all of them are.
  Polynomial term(bool& strict) {
    reader_.expect("term");
    Polynomial product(reader_.number());
    require(!product.is_zero(), "the coefficient is zero");
    bool all_strict = true;
    while (!reader_.at_end()) {
      const Formula& factor = hypothesis();
      require(factor.kind == Kind::positive || factor.kind == Kind::non_negative, "not an inequality");
      all_strict = all_strict && factor.kind == Kind::positive;
      for (int n = reader_.accept("^") ? reader_.exponent() : 1; n > 0; --n) product = product * factor.polynomial;
    }
    strict = strict || all_strict;
    return product;
  }

  Work work_;
  const Statement& statement_;
  FormulaReader& reader_;
  std::map<std::string, Formula> hypotheses_;                    ///< those in force
  std::vector<std::map<std::string, Formula>::iterator> order_;  ///< the same in the order in which they came
  int depth_ = 0;                                                ///< of the branch
  std::string to_use_;                                           ///< in the present identity
  bool used_ = false;
};

}  // namespace slipproof::check
