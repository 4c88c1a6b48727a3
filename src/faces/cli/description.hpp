// The program's own description, as its subcommands declare it: what man pages and completions are written from.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace slipproof::cli {

struct DescribedOption {
  std::vector<std::string> names;  ///< "-o", "--out"; for a positional argument only its name, "SCENE"
  std::string text;                ///< what it is for, in one line
  std::string type;                ///< "TEXT", "FLOAT"; empty for a flag
  std::string limits;              ///< "INTEGER from 0 to 4096", or empty
  std::vector<std::string> choices;
  std::string usual;  ///< the default, where one is shown
  bool positional = false, required = false, optional_value = false, repeated = false;

  /// "--out TEXT", "--law cone|box|diamond", "[INPUT...]".
  std::string usage() const;
  bool takes_value() const { return !type.empty(); }
  /// Text that names a mechanism: a file, or one that is shipped.
  bool is_mechanism() const;
};

struct DescribedCommand {
  std::string name;  ///< "solve"; empty for the program itself
  std::string text;  ///< in one line
  std::vector<DescribedOption> options;

  std::vector<DescribedOption> with_names() const;  ///< without positional arguments
  std::vector<DescribedOption> positional() const;
};

/// A command with the options of its groups.
DescribedCommand describe(const CLI::App& command);
/// The subcommands that help shows, in its order.
std::vector<DescribedCommand> described_subcommands(const CLI::App& app);

/// The name and contents of a file.
struct WrittenPage {
  std::string name, text;
};

/// slipproof.1, one for each subcommand, and those of the programs that check certificates.
std::vector<WrittenPage> manual_pages(const CLI::App& app, const std::string& version);

std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);

}  // namespace slipproof::cli
