// The common parts of subcommands: options, exit codes, and how they join the program.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/document/document.hpp"

namespace slipproof::cli {

/// Exit codes of the program.
enum Exit : int {
  success = 0,
  refuted_or_not_certified = 1,
  usage = 2,
  bad_input = 3,
  undecided = 4,
  certificate_rejected = 5,
  not_written = 6,
  failed = 70,  ///< an error of the program itself; the number is from sysexits.h
};

/// The meaning of each exit code, for the help.
inline constexpr std::array<std::pair<Exit, std::string_view>, 8> exit_codes{{
    {success, "success"},
    {refuted_or_not_certified, "refuted, or not certified"},
    {usage, "wrong usage"},
    {bad_input, "bad input: all mistakes are reported, with file, line and column"},
    {undecided, "undecided, and nothing refuted"},
    {certificate_rejected, "a certificate is rejected"},
    {not_written, "a result could not be written"},
    {failed, "the program failed, through no mistake of yours: please report what it says"},
}};

/// --json, --markdown, --seed, --threads, --quiet.
struct CommonOptions {
  bool json = false;
  bool markdown = false;  ///< only with add_report_options
  std::uint64_t seed = 1;
  unsigned threads = 0;  ///< 0: all cores of the machine
  bool quiet = false;
};

void add_common_options(CLI::App& command, CommonOptions& options);
/// The same and --markdown, for commands that print a document with print_report().
void add_report_options(CLI::App& command, CommonOptions& options);
/// Adds examples to the end of a command's help: what follows `slipproof NAME `. They run in the folder of the sources,
/// and in that of the installed data.
void add_examples(CLI::App& command, const std::vector<std::string>& examples);
/// --digits.
void add_digits_option(CLI::App& command, int& digits);

/// Accepts a whole number from low to high in decimal digits and nothing else: no sign, blank, octal or hexadecimal.
CLI::Validator whole_number(std::uint64_t low, std::uint64_t high = std::numeric_limits<std::uint64_t>::max());

/// Accepts a decimal number from low to high and nothing else: no NaN, blank or hexadecimal.
CLI::Validator number_in(double low, double high);

/// Refuses a file to write whose name ends in none of these, such as `.svg`: a name promises a format. Accepts an empty
/// name, `-`, and what is below /dev. `advice` follows the endings in the message.
void expect_ending(const std::string& option, const std::string& file, const std::vector<std::string_view>& endings,
                   std::string_view advice = {});

/// The same for the name of a page.
void expect_page_name(const std::string& option, const std::string& file);

/// Writes to standard output; on a terminal with colours, `s VERDICT ...` in that of the verdict. Throws OutputError.
void print(std::string_view text);

/// Prints a document as text or Markdown; with --quiet only its status.
void print_document(const Document& document, const CommonOptions& options);

/// Prints JSON or a document, as the options say.
template <class MakeJson, class MakeDocument>
void print_report(const CommonOptions& options, const MakeJson& json, const MakeDocument& document) {
  options.json ? print(json()) : print_document(document(), options);
}

/// The path of a file that comes with the program. It is given by its path in the repository; the file is next to the
/// installed program, or in the sources from which it was built.
std::filesystem::path shipped(const std::filesystem::path& file);

/// The file or folder in the argument; where there is none, the shipped paper of this name; without an argument the
/// first shipped paper. Throws InputError, which lists the papers.
std::filesystem::path claims_path(const std::string& argument);

/// Each function adds its subcommand; running the subcommand sets the exit code.
void add_exchange(CLI::App& app, int& exit_code);  ///< import and export
void add_solve(CLI::App& app, int& exit_code);
void add_rest(CLI::App& app, int& exit_code);
void add_impact(CLI::App& app, int& exit_code);
void add_show(CLI::App& app, int& exit_code);
void add_expect(CLI::App& app, int& exit_code);
void add_critical(CLI::App& app, int& exit_code);
void add_simulate(CLI::App& app, int& exit_code);
void add_search(CLI::App& app, int& exit_code);
void add_trade(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_prove(CLI::App& app, int& exit_code);
void add_certify(CLI::App& app, int& exit_code);
void add_verify(CLI::App& app, int& exit_code);
void add_report(CLI::App& app, int& exit_code);
void add_map(CLI::App& app, int& exit_code);
void add_draw(CLI::App& app, int& exit_code);
void add_explore(CLI::App& app, int& exit_code);

}  // namespace slipproof::cli
