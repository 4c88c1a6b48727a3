#include "proofs/other_provers/certificate_reader.hpp"

#include <sstream>

#include "base/input/diagnostic.hpp"
#include "base/number/parse.hpp"

namespace slipproof {

namespace {

using prove::Identity;
using prove::Polynomial;
using prove::Proof;
using prove::Step;

class Reader {
 public:
  Reader(const prove::Statement& statement, const std::string& file, const std::string& text)
      : statement_(statement), file_(file), lines_(text) {}

  Proof read() {
    if (next() != "slipproof-certificate 1") fail("expected `slipproof-certificate 1`");
    if (next() != "theorem " + statement_.theorem() + ' ' + statement_.fingerprint()) {
      fail("the certificate is of another statement");
    }
    return proof(0);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw InputError({{file_, number_, 0, message}}); }

  /// The next line that counts, without blanks at its ends.
  const std::string& next() {
    while (std::getline(lines_, line_)) {
      ++number_;
      line_.erase(0, line_.find_first_not_of(" \t"));
      line_.erase(line_.find_last_not_of(" \t") + 1);
      if (!line_.empty() && line_.front() != '#') return line_;
    }
    fail("the certificate ends before its proof does");
  }

  std::string after(const std::string& word) const {
    if (!line_.starts_with(word)) fail("expected `" + word + "...`");
    return line_.substr(word.size());
  }

  Polynomial polynomial(const std::string& text) const {
    auto result = Polynomial::parse(statement_.ring(), text);
    if (!result) fail("found `" + text + "`, expected a polynomial in the statement's variables");
    return *std::move(result);
  }

  Rational coefficient(const std::string& text) const {
    try {
      Rational value = parse_rational(text);
      if (value > 0) return value;
    } catch (const NumberError&) {
    }
    fail("found `" + text + "`, expected a positive coefficient");
  }

  /// `NAME: REST`.
  std::pair<std::string, std::string> named(const std::string& text) const {
    const auto colon = text.find(": ");
    if (colon == std::string::npos) fail("expected `NAME: ...`");
    return {text.substr(0, colon), text.substr(colon + 2)};
  }

  Proof proof(int depth) {
    if (depth > 1000) fail("the branches are nested too deeply");
    Proof steps;
    while (true) {
      const std::string rule = next().substr(0, line_.find(' '));
      Step& step = steps.emplace_back();
      if (rule == "have") {
        read_have(step);
      } else if (rule == "witness") {
        step.rule = Step::Rule::witness;
        step.name = after("witness ");
        for (const std::size_t unknown : statement_.unknowns()) {
          const std::string& name = statement_.ring().name(unknown);
          next();
          step.values.emplace_back(name, after("set " + name + " = "));
        }
      } else if (rule == "contradiction") {
        step.rule = Step::Rule::contradiction;
        step.identities.push_back(identity());
        return steps;
      } else if (rule == "split") {
        step.rule = Step::Rule::split;
        const auto [name, text] = named(after("split "));
        step.name = name;
        step.polynomial.push_back(polynomial(text));
        for (const std::string label : {"negative", "zero", "positive"}) {
          if (next() != "branch " + label) fail("expected `branch " + label + "`");
          step.branches.push_back(proof(depth + 1));
        }
        if (next() != "end") fail("expected `end`");
        return steps;
      } else if (rule == "cases") {
        step.rule = Step::Rule::cases;
        step.name = after("cases ");
        while (next() != "end") {
          if (line_ != "branch " + std::to_string(step.branches.size() + 1)) fail("expected the next branch");
          step.branches.push_back(proof(depth + 1));
        }
        return steps;
      } else {
        fail("unknown rule `" + rule + "`");
      }
    }
  }

  void read_have(Step& step) {
    step.rule = Step::Rule::have;
    const auto [name, claim] = named(after("have "));
    step.name = name;
    const auto relation = claim.find_first_of("=>");
    if (relation == std::string::npos) fail("expected a comparison with 0");
    const std::string right = claim.substr(relation);
    if (right != "> 0" && right != ">= 0" && right != "= 0") fail("expected a comparison with 0");
    step.sign = right == "> 0"    ? prove::Sign::positive
                : right == ">= 0" ? prove::Sign::non_negative
                                  : prove::Sign::zero;
    step.polynomial.push_back(polynomial(claim.substr(0, relation)));
    for (int i = 0; i < (step.sign == prove::Sign::zero ? 2 : 1); ++i) step.identities.push_back(identity());
  }

  Identity identity() {
    Identity result;
    while (next() != "qed") {
      if (line_.starts_with("equation ")) {
        auto [name, text] = named(after("equation "));
        result.equations.emplace_back(name, polynomial(text));
        continue;
      }
      std::istringstream words(after("term "));
      std::string word;
      words >> word;
      prove::WeightedProduct term{coefficient(word), {}};
      while (words >> word) {
        const auto caret = word.find('^');
        const auto exponent = caret == std::string::npos ? 1 : std::strtoul(word.c_str() + caret + 1, nullptr, 10);
        if (exponent < 1 || exponent > 64) fail("expected an exponent from 1 to 64");
        term.product[word.substr(0, caret)] += static_cast<unsigned>(exponent);
      }
      result.terms.push_back(std::move(term));
    }
    return result;
  }

  const prove::Statement& statement_;
  const std::string& file_;
  std::istringstream lines_;
  std::string line_;
  std::size_t number_ = 0;
};

}  // namespace

Proof read_certificate(const prove::Statement& statement, const std::string& file, const std::string& text) {
  return Reader(statement, file, text).read();
}

}  // namespace slipproof
