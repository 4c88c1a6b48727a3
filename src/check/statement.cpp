#include "check/statement.hpp"

namespace slipproof::check {
namespace {

void require_fresh(const std::string& name, const Environment& environment) {
  if (name == "and" || name == "or" || name == "false") throw SyntaxError("'" + name + "' is a reserved word");
  if (environment.values.contains(name) || environment.formulas.contains(name)) {
    throw SyntaxError("the name '" + name + "' is given twice");
  }
}

/// `let NAME = EXPRESSION` and `define NAME: FORMULA`.
bool read_abbreviation(LineReader& reader, const std::string& directive, Environment& environment) {
  if (directive != "let" && directive != "define") return false;
  const std::string name = reader.word();
  require_fresh(name, environment);
  if (directive == "let") {
    reader.expect("=");
    environment.values.emplace(name, reader.expression(environment));
  } else {
    reader.expect(":");
    environment.formulas.emplace(name, reader.formula(environment));
  }
  reader.expect_end();
  return true;
}

template <class Action>
auto located(const std::string& rule, std::size_t line, Action action) {
  try {
    return action();
  } catch (const SyntaxError& error) {
    throw Failure(rule, line, error.what());
  } catch (const LimitError& error) {
    throw Failure(rule, line, error.what());
  }
}

}  // namespace

bool next_line(std::istream& input, std::string& line, std::size_t& number) {
  while (true) {
    line.clear();
    ++number;
    int c = input.get();
    if (c == std::istream::traits_type::eof()) return false;
    for (; c != '\n' && c != std::istream::traits_type::eof(); c = input.get()) {
      if (line.size() >= kMaxLineLength) throw Failure("line", number, "the line is too long");
      line.push_back(static_cast<char>(c));
    }
    const std::size_t first = line.find_first_not_of(" \t");
    if (first != std::string::npos && line[first] != '#') return true;
  }
}

Statement::Statement(std::istream& input) {
  std::string line;
  std::size_t number = 0;
  std::string directive = "statement";
  std::size_t count = 0;
  bool shown_line = false;
  while (next_line(input, line, number)) {
    for (const char c : line + '\n') fingerprint_ = (fingerprint_ ^ static_cast<unsigned char>(c)) * 1099511628211U;
    if (++count > kMaxStatementLines) throw Failure("statement", number, "the statement has too many lines");
    if (shown_line) throw Failure("show", number, "nothing may follow `show`");
    located(directive, number, [&] {
      LineReader reader(line);
      directive = count == 1 ? "header" : reader.word();
      if (count == 1) {
        if (line != "slipproof-statement 1") throw SyntaxError("expected 'slipproof-statement 1'");
      } else if (count == 2) {
        if (directive != "theorem") throw SyntaxError("expected 'theorem NAME'");
        theorem_ = reader.label();
        reader.expect_end();
      } else if (!conclusion_.empty() || directive == "exists" || directive == "show") {
        conclusion_.emplace_back(number, line);
        shown_line = directive == "show";
        if (directive == "exists") {
          if (conclusion_.size() > 1) throw SyntaxError("`exists` is given twice");
          Environment scratch = environment_;
          declare_variables(reader, unknowns_, scratch);
        }
      } else {
        read_universal(reader, directive);
      }
    });
  }
  if (!shown_line) throw Failure("statement", number, "the statement ends without `show`");
  Environment free = environment_;  // reads the conclusion once with free unknowns, so that its mistakes are found
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    free.values[unknowns_[i]] = {Polynomial::variable(variables_ - unknowns_.size() + i)};
  }
  read_conclusion(std::move(free));
}

void Statement::declare_variables(LineReader& reader, std::vector<std::string>& names, Environment& environment) {
  do {
    const std::string name = reader.word();
    require_fresh(name, environment);
    if (variables_ >= kMaxVariables) throw LimitError("too many variables");
    environment.values[name] = {Polynomial::variable(variables_++)};
    names.push_back(name);
  } while (!reader.at_end());
}

void Statement::read_universal(LineReader& reader, const std::string& directive) {
  std::vector<std::string> ignored;
  if (directive == "real") {
    declare_variables(reader, ignored, environment_);
  } else if (directive == "assume") {
    const std::string name = reader.label();
    if (!names_.insert(name).second) throw SyntaxError("the assumption '" + name + "' is given twice");
    reader.expect(":");
    assumptions_.emplace_back(name, reader.formula(environment_));
    reader.expect_end();
  } else if (!read_abbreviation(reader, directive, environment_)) {
    throw SyntaxError("unknown directive '" + directive + "'");
  }
}

Formula Statement::read_conclusion(Environment environment) const {
  Formula result;
  for (const auto& [number, line] : conclusion_) {
    LineReader reader(line);
    const std::string directive = reader.word();
    located(directive, number, [&] {
      if (directive == "exists") return;
      if (directive == "show") {
        result = reader.formula(environment);
        reader.expect_end();
      } else if (!read_abbreviation(reader, directive, environment)) {
        throw SyntaxError("unknown directive '" + directive + "'");
      }
    });
  }
  return result;
}

Formula Statement::shown(const std::vector<Fraction>& witness) const {
  Environment environment = environment_;
  for (std::size_t i = 0; i < unknowns_.size(); ++i) environment.values[unknowns_[i]] = witness.at(i);
  return read_conclusion(std::move(environment));
}

}  // namespace slipproof::check
