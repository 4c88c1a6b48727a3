#include "faces/cli/command.hpp"

#include <fast_float/fast_float.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "base/input/diagnostic.hpp"
#include "base/output/listed.hpp"
#include "base/output/standard_output.hpp"
#include "base/output/terminal.hpp"
#include "mechanics/mechanism/names.hpp"

namespace slipproof::cli {

namespace {

/// The line of a result, in the colour of its first word.
std::string coloured_result(std::string_view line) {
  constexpr std::array<std::string_view, 5> bad{"NOT", "REFUTED", "REJECTED", "UNREADABLE", "FALLS"};
  constexpr std::array<std::string_view, 3> open{"UNDECIDED", "MISSING", "UNEXPECTED"};
  const std::string_view word = line.substr(2, line.find(' ', 2) - 2);
  const auto is_in = [&](const auto& words) { return std::ranges::find(words, word) != words.end(); };
  return emphasised(line, is_in(bad) ? Emphasis::bad : is_in(open) ? Emphasis::open : Emphasis::good);
}

}  // namespace

void add_common_options(CLI::App& command, CommonOptions& options) {
  command.add_flag("--json", options.json, "Write JSON to standard output");
  command.add_option("--seed", options.seed, "Seed of all random numbers")
      ->check(whole_number(0))
      ->capture_default_str();
  command.add_option("--threads", options.threads, "Number of threads; 0: all cores")
      ->check(whole_number(0, 4096))
      ->capture_default_str();
  command.add_flag("--quiet", options.quiet, "Print only the result: no progress, no details");
}

void add_report_options(CLI::App& command, CommonOptions& options) {
  add_common_options(command, options);
  command.add_flag("--markdown", options.markdown, "Write the report in Markdown to standard output")
      ->excludes("--json");
}

void add_examples(CLI::App& command, const std::vector<std::string>& examples) {
  std::string text = examples.size() == 1 ? "Example:" : "Examples:";
  for (const std::string& example : examples) text += "\n  slipproof " + command.get_name() + " " + example;
  command.footer(text + "\n\n" + command.get_footer());
}

void add_digits_option(CLI::App& command, int& digits) {
  command.add_option("--digits", digits, "Significant digits of decimals")
      ->check(whole_number(1, 1000))
      ->capture_default_str();
}

void print(std::string_view text) {
  if (!takes_colours(STDOUT_FILENO)) return write_standard_output(text);
  std::string coloured;
  for (std::size_t end = 0; !text.empty(); text.remove_prefix(end)) {
    end = std::min(text.find('\n'), text.size() - 1) + 1;
    const std::string_view line = text.substr(0, end);
    coloured += line.starts_with("s ") && line.ends_with('\n') ? coloured_result(line.substr(0, end - 1)) + '\n' : line;
  }
  write_standard_output(coloured);
}

void print_document(const Document& document, const CommonOptions& options) {
  const auto& blocks = document.blocks();
  if (options.quiet && !blocks.empty() && blocks.back().kind == ReportBlock::Kind::status) {
    return print(blocks.back().line.text() + "\n");
  }
  print(options.markdown ? markdown_of(document)
                         : text_of(document, {is_terminal(STDOUT_FILENO), takes_colours(STDOUT_FILENO)}));
}

void expect_ending(const std::string& option, const std::string& file, const std::vector<std::string_view>& endings,
                   std::string_view advice) {
  if (file.empty() || file == "-" || file.starts_with("/dev/")) return;
  if (std::ranges::any_of(endings, [&](std::string_view ending) { return file.ends_with(ending); })) return;
  throw CLI::ValidationError(option, "found " + in_quotes(file) + ", expected a name that ends in " +
                                         listed(endings, " or ") + std::string(advice));
}

void expect_page_name(const std::string& option, const std::string& file) {
  expect_ending(option, file, {".html", ".htm"});
}

CLI::Validator whole_number(std::uint64_t low, std::uint64_t high) {
  const std::string range = "from " + std::to_string(low) + " to " + std::to_string(high);
  return CLI::Validator(
      [low, high, range](std::string& text) -> std::string {
        std::uint64_t value = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        const bool octal = text.size() > 1 && text[0] == '0';  // the next reader would take it as octal
        if (error == std::errc() && stop == end && !octal && value >= low && value <= high) return {};
        return "found " + in_quotes(text) + ", expected a whole number " + range;
      },
      "INTEGER " + range);
}

CLI::Validator number_in(double low, double high) {
  const std::string range = fmt::format("from {} to {}", low, high);
  return CLI::Validator(
      [low, high, range](std::string& text) -> std::string {
        double value = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = fast_float::from_chars(text.data(), end, value);
        if (error == std::errc() && stop == end && value >= low && value <= high) return {};
        return "found " + in_quotes(text) + ", expected a number " + range;
      },
      "FLOAT " + range);
}

std::filesystem::path shipped(const std::filesystem::path& file) {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) {
    const auto installed = program.parent_path().parent_path() / SLIPPROOF_DATA_DIRECTORY / file;
    if (std::filesystem::exists(installed, error)) return installed;
  }
  return std::filesystem::path(SLIPPROOF_SOURCE_DIRECTORY) / file;
}

std::filesystem::path claims_path(const std::string& argument) {
  if (argument.empty()) return shipped("proofs/rozenblat-yashin/claims.toml");
  std::filesystem::path path = argument;
  std::error_code error;
  if (std::filesystem::exists(path, error) || path.extension() == ".toml") return path;
  std::vector<std::string> papers;
  for (const auto& entry : std::filesystem::directory_iterator(shipped("proofs"), error)) {
    const std::filesystem::path claims = entry.path() / "claims.toml";
    if (!std::filesystem::exists(claims, error)) continue;
    papers.push_back(entry.path().filename().string());
    if (papers.back() == argument) return claims;
  }
  std::ranges::sort(papers);
  throw InputError(
      {{argument, 0, 0,
        "no such file, and " + unknown_name("paper", path.filename().string(), {papers.begin(), papers.end()})}});
}

}  // namespace slipproof::cli
