#include "proofs/statement/statement_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/input/diagnostic.hpp"

namespace slipproof {

namespace {

constexpr std::size_t max_bytes = 1U << 20U;
constexpr std::array<std::string_view, 6> spellings{"real", "let", "define", "assume", "exists", "show"};
constexpr std::string_view hint = "# split:";

class TextReader {
 public:
  explicit TextReader(const std::string& file) : file_(file) {}

  StatementText read(std::string_view text) {
    if (text.size() > max_bytes) throw InputError({{file_, 0, 0, "the statement has more than 2^20 bytes"}});
    while (!text.empty()) {
      const std::string_view line = text.substr(0, text.find('\n'));
      text.remove_prefix(std::min(text.size(), line.size() + 1));
      ++number_;
      try {
        read_line(line);
      } catch (const ExpressionError& error) {
        complain(error.column(), error.what());
      }
    }
    ++number_;
    if (stage_ != Stage::end) complain(0, std::string("the file ends before ") + awaited());
    if (mistakes_.empty()) check_assumptions();
    if (!mistakes_.empty()) throw InputError(std::move(mistakes_));
    result_.fingerprint = fmt::format("{:016x}", fingerprint_);
    return std::move(result_);
  }

 private:
  enum class Stage : std::uint8_t { header, theorem, directives, end };

  void complain(std::size_t column, std::string message) {
    mistakes_.push_back({file_, number_, column, std::move(message)});
  }

  const char* awaited() const {
    return stage_ == Stage::header    ? "its first line, `slipproof-statement 1`"
           : stage_ == Stage::theorem ? "its line `theorem NAME`"
                                      : "its last line, `show FORMULA`";
  }

  /// Whatever else is wrong with such a text, it shows something else than it says.
  void refuse_invisible(std::string_view line) {
    const auto odd = std::find_if(line.begin(), line.end(), [](char c) { return c < ' ' || c > '~'; });
    if (odd == line.end()) return;
    complain(static_cast<std::size_t>(odd - line.begin()) + 1,
             fmt::format("found a byte of value {}, expected printable ASCII", static_cast<unsigned char>(*odd)));
    throw InputError(std::move(mistakes_));
  }

  void read_line(std::string_view line) {
    refuse_invisible(line);
    StatementLine words(line, given_);
    if (line.starts_with(hint)) return read_hint(words);
    if (words.at_end() || line[words.column() - 1] == '#') return;
    for (const char c : std::string(line) + '\n') {
      fingerprint_ = (fingerprint_ ^ static_cast<unsigned char>(c)) * 1099511628211U;
    }
    switch (stage_) {
      case Stage::header:
        stage_ = Stage::theorem;
        if (line != "slipproof-statement 1") words.fail("the first line to be `slipproof-statement 1`");
        return;
      case Stage::theorem:
        stage_ = Stage::directives;
        return read_theorem(line, words);
      case Stage::directives:
        return read_directive(words);
      case Stage::end:
        words.fail("nothing after `show`");
    }
  }

  void read_theorem(std::string_view line, StatementLine& words) {
    constexpr std::string_view word = "theorem ";
    constexpr std::size_t longest = 100;
    const auto is_alphanumeric = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    };
    const auto is_allowed = [&](char c) { return is_alphanumeric(c) || std::string_view("_'.-").find(c) != line.npos; };
    words.expect("theorem");
    result_.theorem = line.substr(std::min(word.size(), line.size()));
    const std::string& name = result_.theorem;
    if (!line.starts_with(word) || name.empty() || name.size() > longest || !is_alphanumeric(name.front()) ||
        !std::all_of(name.begin(), name.end(), is_allowed)) {
      words.fail(
          "one blank and the theorem's name: a letter or digit, then letters, digits, `_`, `'`, `.` and `-`, at most "
          "100 in all");
    }
  }

  void read_directive(StatementLine& words) {
    const auto found = std::find_if(spellings.begin(), spellings.end(), [&](auto word) { return words.accept(word); });
    if (found == spellings.end()) words.fail("one of real, let, define, assume, exists, show");
    Directive directive;
    directive.kind = static_cast<Directive::Kind>(found - spellings.begin());
    directive.line = number_;
    const bool variables = directive.kind == Directive::Kind::real || directive.kind == Directive::Kind::exists;
    if (directive.kind == Directive::Kind::show) stage_ = Stage::end;
    if (unknowns_ && (variables || directive.kind == Directive::Kind::assume)) {
      throw ExpressionError(1, fmt::format("`{}` may not follow `exists`", *found));
    }
    if (variables) {
      read_variables(words, directive);
      unknowns_ = unknowns_ || directive.kind == Directive::Kind::exists;
    } else {
      read_body(words, directive);
      words.expect_end();
    }
    result_.directives.push_back(std::move(directive));
  }

  void read_variables(StatementLine& words, Directive& directive) {
    do {
      const std::size_t column = words.column();
      directive.names.push_back(words.name());
      given_.values.insert(directive.names.back());
      give(directive.names.back(), column);
      if (++variables_ > max_statement_variables) throw ExpressionError(column, "more than 64 variables");
    } while (!words.at_end());
  }

  void read_body(StatementLine& words, Directive& directive) {
    if (directive.kind == Directive::Kind::show) {
      directive.body = words.formula();
      return;
    }
    const std::size_t column = words.column();
    const std::string name = words.name();
    directive.names = {name};
    if (directive.kind == Directive::Kind::assume) assumptions_.insert(name);
    const bool value = directive.kind == Directive::Kind::let;
    try {
      give(name, column);
      words.expect(value ? "=" : ":");
      directive.body = value ? words.expression() : words.formula();
    } catch (const ExpressionError&) {
      introduce(directive);  // so that the lines below are not blamed for using it
      throw;
    }
    introduce(directive);
  }

  void introduce(const Directive& directive) {
    if (directive.kind == Directive::Kind::let) given_.values.insert(directive.names.front());
    if (directive.kind == Directive::Kind::define) given_.formulas.insert(directive.names.front());
  }

  void give(const std::string& name, std::size_t column) {
    if (name == "and" || name == "or" || name == "false") {
      throw ExpressionError(column, "`" + name + "` is a word of the language, expected another name");
    }
    if (!names_.insert(name).second) throw ExpressionError(column, "the name `" + name + "` is given twice");
  }

  void read_hint(StatementLine& words) {
    for (const std::string_view word : {"#", "split", ":"}) words.expect(word);
    result_.hints.push_back({number_, words.expression()});
    words.expect_end();
  }

  /// The parts of a hypothesis `a` are `a.1`, `a.1.2`, ..., and `goal` is the negated conclusion: with an assumption of
  /// such a name no certificate could be right.
  void check_assumptions() {
    for (const Directive& line : result_.directives) {
      if (line.kind != Directive::Kind::assume) continue;
      const std::string& name = line.names.front();
      std::vector<std::string> wholes;
      std::string whole = name;
      for (std::size_t dot; whole[dot = whole.find_last_not_of("0123456789")] == '.';) {
        whole.erase(dot);
        wholes.push_back(whole);
      }
      number_ = line.line;
      if (name == "goal" || std::find(wholes.begin(), wholes.end(), "goal") != wholes.end()) {
        complain(0, "`" + name + "` names the negated conclusion in certificates, expected another name");
      }
      for (const std::string& other : wholes) {
        if (!assumptions_.contains(other)) continue;
        complain(0, "`" + name + "` names a part of `" + other + "`, expected another name");
      }
    }
  }

  const std::string& file_;
  std::size_t number_ = 0;
  Stage stage_ = Stage::header;
  bool unknowns_ = false;
  GivenNames given_;
  std::size_t variables_ = 0;
  std::set<std::string> names_, assumptions_;
  std::uint64_t fingerprint_ = 14695981039346656037U;
  std::vector<Diagnostic> mistakes_;
  StatementText result_;
};

}  // namespace

StatementText read_statement(const std::string& file, std::string_view text) {
  return TextReader(file).read(text);
}

std::string formula_statement(std::string_view formula) {
  const GivenNames none;
  std::vector<std::string> names;
  for (StatementLine words(formula, none); !words.at_end();) {
    std::string word = words.take();
    const bool is_letter = (word[0] >= 'a' && word[0] <= 'z') || (word[0] >= 'A' && word[0] <= 'Z');
    if (!is_letter || word == "and" || word == "or" || word == "false") continue;
    if (std::find(names.begin(), names.end(), word) == names.end()) names.push_back(std::move(word));
  }
  if (names.empty()) names.emplace_back("x");  // a statement has a variable
  return fmt::format("slipproof-statement 1\ntheorem formula\nreal {}\n{}{}\n", fmt::join(names, " "), formula_prefix,
                     formula);
}

Expression parse_witness_value(const StatementText& statement, std::string_view value) {
  GivenNames given;
  for (const Directive& directive : statement.directives) {
    if (directive.kind == Directive::Kind::exists) break;
    if (directive.kind == Directive::Kind::real || directive.kind == Directive::Kind::let) {
      given.values.insert(directive.names.begin(), directive.names.end());
    }
  }
  StatementLine words(value, given);
  Expression result = words.expression();
  words.expect_end();
  return result;
}

}  // namespace slipproof
