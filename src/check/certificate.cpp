#include "check/certificate.hpp"

#include <cstdio>

namespace slipproof::check {
namespace {

/// A rule with branches that is not closed yet.
struct Split {
  std::string rule;
  std::string name;
  std::vector<std::pair<std::string, Formula>> branches;  ///< label, and the formula assumed in that branch
  std::size_t next = 0;
  std::size_t scope = 0;  ///< hypotheses in force before the split
};

class Checker {
 public:
  Checker(const Statement& statement, std::istream& input) : statement_(statement), input_(input) {}

  void run() {
    try {
      read_header();
      for (const auto& [name, formula] : statement_.assumptions()) assume(name, formula);
      if (statement_.unknowns().empty()) assume("goal", negation(statement_.shown({})));
      while (!finished_) step();
      if (next()) fail("the proof is complete, but the certificate goes on");
    } catch (const SyntaxError& error) {
      fail(error.what());
    } catch (const LimitError& error) {
      fail(error.what());
    }
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw Failure(rule_, number_, message); }

  bool next() { return next_line(input_, line_, number_); }

  LineReader need_line() {
    if (!next()) fail("the certificate ends before the proof is complete");
    return LineReader(line_);
  }

  void read_header() {
    rule_ = "header";
    if (!next() || line_ != "slipproof-certificate 1") fail("expected 'slipproof-certificate 1'");
    LineReader reader = need_line();
    rule_ = "theorem";
    if (!reader.accept_word("theorem") || reader.label() != statement_.theorem()) {
      fail("the certificate is for another theorem");
    }
    char expected[17];
    std::snprintf(expected, sizeof expected, "%016llx", static_cast<unsigned long long>(statement_.fingerprint()));
    if (!reader.accept(expected)) fail("the certificate is for another statement of this theorem");
    reader.expect_end();
  }

  /// Adds a formula to the hypotheses: of a conjunction its parts, NAME.1, NAME.2, ...
  void assume(const std::string& name, const Formula& formula) {
    if (formula.kind == Formula::Kind::conjunction) {
      for (std::size_t i = 0; i < formula.parts.size(); ++i)
        assume(name + "." + std::to_string(i + 1), formula.parts[i]);
      return;
    }
    if (hypotheses_.size() >= kMaxHypotheses) throw LimitError("too many hypotheses");
    if (!hypotheses_.emplace(name, formula).second) fail("the name '" + name + "' is given twice");
    order_.push_back(name);
  }

  void forget(std::size_t scope) {
    for (; order_.size() > scope; order_.pop_back()) hypotheses_.erase(order_.back());
  }

  const Formula& hypothesis(const std::string& name) const {
    const auto place = hypotheses_.find(name);
    if (place == hypotheses_.end()) fail("there is no hypothesis '" + name + "' here");
    return place->second;
  }

  void step() {
    LineReader reader = need_line();
    rule_ = reader.word();
    if (rule_ == "split") {
      const std::string name = reader.label();
      reader.expect(":");
      const Polynomial p = reader.polynomial(statement_.environment());
      open({"split",
            name,
            {{"negative", atom(-p, Relation::positive)},
             {"zero", atom(p, Relation::zero)},
             {"positive", atom(p, Relation::positive)}}},
           reader);
    } else if (rule_ == "cases") {
      const std::string name = reader.label();
      const Formula& formula = hypothesis(name);
      if (formula.kind != Formula::Kind::disjunction) fail("'" + name + "' is not a disjunction");
      Split split{"cases", name, {}};
      for (std::size_t i = 0; i < formula.parts.size(); ++i) {
        split.branches.emplace_back(std::to_string(i + 1), formula.parts[i]);
      }
      open(std::move(split), reader);
    } else if (rule_ == "have") {
      have(reader);
    } else if (rule_ == "witness") {
      witness(reader);
    } else if (rule_ == "contradiction") {
      reader.expect_end();
      identity();
      close_branch();
    } else {
      fail("unknown rule '" + rule_ + "'");
    }
  }

  void open(Split split, LineReader& reader) {
    reader.expect_end();
    if (splits_.size() >= kMaxDepth) throw LimitError("the splits are nested too deeply");
    split.scope = order_.size();
    splits_.push_back(std::move(split));
    next_branch();
  }

  /// Goes on with the next branch of the innermost split, or, after the last, reads its `end`.
  void next_branch() {
    Split& split = splits_.back();
    forget(split.scope);
    LineReader reader = need_line();
    rule_ = split.rule;
    if (split.next == split.branches.size()) {
      if (!reader.accept_word("end")) fail("expected 'end' after the last branch");
      reader.expect_end();
      splits_.pop_back();
      close_branch();
      return;
    }
    const auto& [label, formula] = split.branches[split.next++];
    if (!reader.accept_word("branch") || !reader.accept(label)) fail("expected 'branch " + label + "'");
    reader.expect_end();
    assume(split.rule == "cases" ? split.name + "." + label : split.name, formula);
  }

  void close_branch() {
    if (splits_.empty()) {
      finished_ = true;
    } else {
      next_branch();
    }
  }

  /// `have NAME: p > 0`, `p >= 0` or `p = 0`: an identity refutes its negation, which stands under the same name (for
  /// an equation first p > 0, then p < 0).
  void have(LineReader& reader) {
    const std::string name = reader.label();
    reader.expect(":");
    const Polynomial p = reader.polynomial(statement_.environment());
    const Relation relation = reader.accept(">=")  ? Relation::non_negative
                              : reader.accept(">") ? Relation::positive
                                                   : Relation::zero;
    if (relation == Relation::zero) reader.expect("=");
    if (reader.natural() != 0) fail("expected 0 on the right");
    reader.expect_end();
    const Formula claim = atom(p, relation);
    const Formula opposite = negation(claim);
    const std::size_t scope = order_.size();
    for (std::size_t i = 0; i < (relation == Relation::zero ? 2 : 1); ++i) {
      assume(name, relation == Relation::zero ? opposite.parts[i] : opposite);
      identity();
      forget(scope);
    }
    assume(name, claim);
  }

  /// `witness NAME`, then `set UNKNOWN = EXPRESSION` for each unknown in turn: the conclusion fails for these values.
  void witness(LineReader& reader) {
    const std::string name = reader.label();
    reader.expect_end();
    if (statement_.unknowns().empty()) fail("the statement has no unknowns");
    std::vector<Fraction> values;
    for (const std::string& unknown : statement_.unknowns()) {
      LineReader line = need_line();
      if (!line.accept_word("set") || !line.accept_word(unknown)) fail("expected 'set " + unknown + " = ...'");
      line.expect("=");
      values.push_back(line.expression(statement_.environment()));
      line.expect_end();
    }
    // A value that is not defined is no value: its divisors must not vanish, used in the conclusion or not.
    std::vector<Formula> failures;
    for (const Fraction& value : values) {
      for (const Polynomial& divisor : value.divisors) failures.push_back(atom(divisor, Relation::zero));
    }
    failures.push_back(negation(statement_.shown(values)));
    assume(name, combine(Formula::Kind::disjunction, std::move(failures)));
  }

  /// Reads `term` and `equation` lines up to `qed`; they must add up to zero with a strict term among them.
  void identity() {
    Polynomial sum;
    bool strict = false;
    for (LineReader reader = need_line(); !reader.accept_word("qed"); reader = need_line()) {
      if (reader.accept_word("equation")) {
        const Formula& formula = hypothesis(reader.label());
        if (formula.kind != Formula::Kind::atom || formula.relation != Relation::zero) fail("not an equation");
        reader.expect(":");
        sum = sum + reader.polynomial(statement_.environment()) * formula.polynomial;
        reader.expect_end();
        continue;
      }
      if (!reader.accept_word("term")) fail("expected 'term', 'equation' or 'qed'");
      mpq_class coefficient = reader.natural();
      if (reader.accept("/")) {
        const mpz_class denominator = reader.natural();
        coefficient = denominator == 0 ? mpq_class(0) : mpq_class(coefficient / denominator);
      }
      if (coefficient <= 0) fail("a coefficient is not positive");
      Polynomial product(coefficient);
      bool all_strict = true;
      while (!reader.at_end()) {
        const Formula& formula = hypothesis(reader.label());
        if (formula.kind != Formula::Kind::atom || formula.relation == Relation::zero) fail("not an inequality");
        const mpz_class exponent = reader.accept("^") ? reader.natural() : mpz_class(1);
        if (exponent < 1 || exponent > kMaxExponent) fail("an exponent is out of range");
        product = product * formula.polynomial.power(static_cast<unsigned>(exponent.get_ui()));
        all_strict = all_strict && formula.relation == Relation::positive;
      }
      sum = sum + product;
      strict = strict || all_strict;
    }
    LineReader last(line_);
    last.accept_word("qed");
    last.expect_end();
    if (!sum.is_zero()) fail("the terms do not add up to zero");
    if (!strict) fail("no term of the identity is strict");
  }

  const Statement& statement_;
  std::istream& input_;
  std::string line_;
  std::size_t number_ = 0;
  std::string rule_ = "header";
  std::map<std::string, Formula> hypotheses_;
  std::vector<std::string> order_;
  std::vector<Split> splits_;
  bool finished_ = false;
};

}  // namespace

void check_certificate(const Statement& statement, std::istream& certificate) {
  Checker(statement, certificate).run();
}

}  // namespace slipproof::check
