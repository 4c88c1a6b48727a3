// The program's description of itself, from its subcommands. Manual pages and completions are written from it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace slipproof::cli {

struct DescribedOption {
  std::vector<std::string> names;  ///< "-o", "--out"; for a positional argument its only name, "SCENE"
  std::string text;                ///< its purpose in one line
  std::string type;                ///< "TEXT", "FLOAT"; empty for a flag
  std::string limits;              ///< "INTEGER from 0 to 4096", or empty
  std::vector<std::string> choices;
  std::string usual;  ///< the default, if it is shown
  bool positional = false, required = false, optional_value = false, repeated = false;

  /// "--out TEXT", "--law cone|box|diamond", "[INPUT...]".
  std::string usage() const;
  bool takes_value() const { return !type.empty(); }
  /// Whether the text names a mechanism: a file, or a shipped mechanism.
  bool is_mechanism() const;
};

struct DescribedCommand {
  std::string name;  ///< "solve"; empty for the program itself
  std::string text;  ///< its purpose in one line
  std::vector<DescribedOption> options;

  std::vector<DescribedOption> with_names() const;  ///< without positional arguments
  std::vector<DescribedOption> positional() const;
};

/// Describes a command with the options of its groups.
DescribedCommand describe(const CLI::App& command);
/// The subcommands that the help shows, in the same order.
std::vector<DescribedCommand> described_subcommands(const CLI::App& app);

/// The name and contents of a file.
struct WrittenPage {
  std::string name, text;
};

/// slipproof.1, a page for each subcommand, and pages for the programs that check certificates.
std::vector<WrittenPage> manual_pages(const CLI::App& app, const std::string& version);

std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);

}  // namespace slipproof::cli
