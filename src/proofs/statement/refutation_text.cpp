#include "proofs/statement/refutation_text.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "base/number/parse.hpp"
#include "proofs/statement/statement_text.hpp"
#include "proofs/statement/zero_divisors.hpp"

namespace slipproof {

namespace {

using Kind = Directive::Kind;

constexpr std::string_view no_formula = "0 = 0";

/// The formula after the colon of `assume NAME: FORMULA`, or after `show`.
std::string formula_of(const std::string& line, Kind kind) {
  const std::string text = line.substr(kind == Kind::show ? line.find("show") + 4 : line.find(':') + 1);
  const std::size_t begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t\r");
  return text.substr(begin, end + 1 - begin);
}

class RefutationWriter {
 public:
  RefutationWriter(const NamedStatement& statement, const NamedValues& values)
      : name_(statement.name), text_(read_statement(statement.name, statement.text)) {
    std::istringstream lines(statement.text);
    for (std::string line; std::getline(lines, line);) lines_.push_back(line);
    for (const auto& [name, value] : values) numbers_ += "let " + name + " = " + value.str() + '\n';
  }

  NamedStatement met() const {
    std::string text = opening(".refuted.met"), shown;
    for (const Directive& directive : text_.directives) {
      if (directive.kind == Kind::exists && !directive.names.empty()) break;
      if (is_abbreviation(directive)) text += line(directive) + '\n';
      if (directive.kind != Kind::assume) continue;
      shown += (shown.empty() ? "{" : " and {") + formula_of(line(directive), directive.kind) + "}";
    }
    text += "show " + (shown.empty() ? std::string(no_formula) : shown) + '\n';
    return {name_ + ".refuted.met", without_zero_divisors(std::move(text))};
  }

  NamedStatement fails() const {
    std::string text = opening(".refuted.fails");
    for (const Directive& directive : text_.directives) {
      if (is_abbreviation(directive)) text += line(directive) + '\n';
      if (directive.kind == Kind::exists) {
        text += "real";
        for (const std::string& unknown : directive.names) text += ' ' + unknown;
        text += '\n';
      }
      if (directive.kind != Kind::show) continue;
      text += "assume " + unused("conclusion") + ": " + formula_of(line(directive), directive.kind) + "\nshow false\n";
    }
    return {name_ + ".refuted.fails", without_zero_divisors(std::move(text))};
  }

 private:
  static bool is_abbreviation(const Directive& directive) {
    return directive.kind == Kind::let || directive.kind == Kind::define;
  }
  const std::string& line(const Directive& directive) const { return lines_[directive.line - 1]; }

  std::string opening(const char* suffix) const {
    return "slipproof-statement 1\ntheorem " + text_.theorem + suffix + "\n# where " + text_.theorem + " is false\n" +
           numbers_;
  }

  std::string unused(std::string name) const {
    const auto is_given = [&](const Directive& directive) {
      return std::find(directive.names.begin(), directive.names.end(), name) != directive.names.end();
    };
    while (std::any_of(text_.directives.begin(), text_.directives.end(), is_given)) name += '\'';
    return name;
  }

  std::string name_;
  StatementText text_;
  std::vector<std::string> lines_;
  std::string numbers_;
};

}  // namespace

std::vector<NamedStatement> refutation_at(const NamedStatement& statement, const NamedValues& values) {
  const RefutationWriter writer(statement, values);
  return {writer.met(), writer.fails()};
}

std::optional<NamedValues> refuting_values(const NamedStatement& statement, const std::string& met) {
  std::map<std::string, std::string> given;
  std::istringstream lines(met);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find(" = ");
    if (line.starts_with("let ") && equals != line.npos)
      given.emplace(line.substr(4, equals - 4), line.substr(equals + 3));
  }
  NamedValues result;
  for (const Directive& directive : read_statement(statement.name, statement.text).directives) {
    if (directive.kind != Kind::real) continue;
    for (const std::string& name : directive.names) {
      const auto found = given.find(name);
      if (found == given.end()) return std::nullopt;
      try {
        result.emplace_back(name, parse_rational(found->second));
      } catch (const NumberError&) {
        return std::nullopt;
      }
    }
  }
  return result;
}

}  // namespace slipproof
