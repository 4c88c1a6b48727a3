#include "report/html/second_opinions.hpp"

#include <algorithm>
#include <optional>

#include "base/input/diagnostic.hpp"
#include "base/input/near_match.hpp"
#include "base/input/text_file.hpp"

namespace slipproof {

namespace {

constexpr std::string_view opinions_header = "statement,z3,cvc5,coq";

/// A cell of a line, and its column.
struct OpinionCell {
  std::string_view text;
  std::size_t column;
};

std::vector<OpinionCell> opinion_cells(std::string_view line) {
  std::vector<OpinionCell> cells;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back({line.substr(begin, end - begin), begin + 1});
    if (end == line.size()) return cells;
    begin = end + 1;
  }
}

class OpinionReader {
 public:
  OpinionReader(std::string file, const std::vector<std::string>& statements)
      : mistakes_(std::move(file)), known_(statements.begin(), statements.end()) {}

  SecondOpinions read(std::string_view text) {
    std::size_t number = 0;
    for (std::string_view rest = text; !rest.empty();
         rest.remove_prefix(std::min(rest.find('\n'), rest.size() - 1) + 1)) {
      std::string_view line = rest.substr(0, rest.find('\n'));
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (++number == 1) {
        check_header(line);
      } else if (!line.empty()) {
        read_row(line, number);
      }
    }
    if (number == 0) check_header("");
    mistakes_.refuse_if_any();
    return std::move(opinions_);
  }

 private:
  void check_header(std::string_view line) {
    if (line != opinions_header) {
      mistakes_.add({1, 1}, "found the header " + in_quotes(line) + ", expected " + in_quotes(opinions_header));
    }
  }

  void read_row(std::string_view line, std::size_t number) {
    const auto cells = opinion_cells(line);
    if (cells.size() != 1 + opinion_programs.size()) {
      mistakes_.add({number, 1}, "found " + std::to_string(cells.size()) + " cells, expected " +
                                     std::to_string(1 + opinion_programs.size()));
      return;
    }
    const std::string_view statement = cells[0].text;
    check_statement(statement, number);
    Opinions row{};
    for (std::size_t i = 0; i < row.size(); ++i) {
      const OpinionCell& cell = cells[i + 1];
      const bool proves = opinion_programs[i] == "Coq";
      const std::string_view agrees = proves ? "accepted" : "unsat";
      const auto opinion = opinion_of(cell.text, agrees);
      if (opinion) {
        row[i] = *opinion;
      } else {
        mistakes_.add({number, cell.column}, "found " + in_quotes(cell.text) + ", expected " + std::string(agrees) +
                                                 ", timeout, unknown or -, as " + std::string(opinion_programs[i]) +
                                                 " has it");
      }
    }
    if (!opinions_.emplace(statement, row).second) {
      mistakes_.add({number, 1}, "statement " + in_quotes(statement) + " has a line before this one");
    }
  }

  void check_statement(std::string_view statement, std::size_t number) {
    if (std::find(known_.begin(), known_.end(), statement) != known_.end()) return;
    const auto near = near_match(statement, known_);
    mistakes_.add({number, 1}, "there is no statement " + in_quotes(statement) + " beside this file" +
                                   (near ? "; did you mean " + in_quotes(*near) + "?" : ""));
  }

  static std::optional<Opinion> opinion_of(std::string_view text, std::string_view agrees) {
    if (text == agrees) return Opinion::agrees;
    if (text == "timeout") return Opinion::timeout;
    if (text == "unknown") return Opinion::unknown;
    if (text == "-") return Opinion::not_asked;
    return std::nullopt;
  }

  Mistakes mistakes_;
  std::vector<std::string_view> known_;
  SecondOpinions opinions_;
};

}  // namespace

SecondOpinions read_second_opinions(const std::filesystem::path& path, const std::vector<std::string>& statements) {
  return OpinionReader(path.string(), statements).read(read_found_file(path));
}

}  // namespace slipproof
