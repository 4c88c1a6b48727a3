#include "faces/cli/help.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "base/input/utf8.hpp"
#include "base/output/listed.hpp"

namespace slipproof::cli {

namespace {

constexpr std::size_t right_column = 26;
constexpr const char* work_group = "Work";

/// What an option takes, by the name of its type and the words of its validators: `UINT:INTEGER from 1 to 9`.
struct Value {
  std::string name;   ///< `N`; empty for a flag
  std::string range;  ///< `1 to 9`; empty: any
};

Value value_of(const CLI::Option& option) {
  if (option.get_type_size() == 0) return {};
  const std::string type = option.get_type_name();
  const std::size_t colon = type.find(':');
  const std::string base = type.substr(0, colon), check = colon == std::string::npos ? "" : type.substr(colon + 1);
  const auto after = [&](std::string_view word) { return check.substr(word.size()); };
  constexpr std::string_view whole = "INTEGER from ", number = "FLOAT from ", largest = " to 18446744073709551615";
  if (check.starts_with(whole)) {
    const std::string range = after(whole);
    return {"N", range.ends_with(largest) ? range.substr(0, range.size() - largest.size()) + " or more" : range};
  }
  if (check.starts_with(number)) return {"NUMBER", after(number)};
  if (!check.starts_with('{')) return {check.empty() ? base : check, {}};
  std::string words;
  for (const char c : check.substr(1, check.find('}') - 1)) words += c == ',' ? std::string(", ") : std::string(1, c);
  return {"WORD", words};
}

/// The entry of a name: what it is begins in the right column, below the name if this is long.
std::string entry(std::string name, const std::string& text) {
  name.insert(0, "  ");
  std::string above;
  if (name.size() + 2 > right_column) {
    above = name + '\n';
    name.clear();
  }
  name.resize(right_column, ' ');
  return above + wrapped(name, text);
}

std::string names_of(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  std::ranges::sort(names);  // the set is ordered by addresses
  return listed(names);
}

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* command, std::string name, CLI::AppFormatMode) const override {
    std::string text = wrapped("", command->get_description()) + make_usage(command, std::move(name));
    const auto group = [&](const std::string& heading, const std::vector<const CLI::Option*>& options) {
      if (!options.empty()) text += "\n" + wrapped("", heading + ":");
      for (const CLI::Option* option : options) text += option_entry(*option);
    };
    group("Positionals", command->get_options([](const CLI::Option* option) { return option->get_positional(); }));
    std::vector<std::string> headings = command->get_groups();
    std::stable_partition(headings.begin(), headings.end(),
                          [](const std::string& heading) { return heading != work_group; });
    for (const std::string& heading : headings) {
      group(heading, command->get_options([&](const CLI::Option* option) {
        return option->nonpositional() && option->get_group() == heading;
      }));
    }
    std::string commands;
    for (const CLI::App* inside : command->get_subcommands({})) {
      if (inside->get_name().empty()) {
        group(inside->get_group() + ": " + inside->get_description(),
              inside->get_options([&](const CLI::Option* option) { return option != inside->get_help_ptr(); }));
      } else {
        commands += entry(inside->get_name(), inside->get_description());
      }
    }
    if (!commands.empty()) text += "\nSubcommands:\n" + commands;
    return text + "\n" + command->get_footer() + "\n";
  }

 private:
  std::string option_entry(const CLI::Option& option) const {
    const Value value = value_of(option);
    const bool is_positional = option.get_positional(), may_be_empty = option.get_expected_min() == 0;
    std::string name = make_option_name(&option, is_positional);
    if (!is_positional && !value.name.empty()) name += may_be_empty ? " [" + value.name + "]" : " " + value.name;
    std::vector<std::string> facts;
    const auto add = [&](const char* word, const std::string& fact) {
      if (!fact.empty()) facts.push_back(word + fact);
    };
    add("", value.range);
    add("default ", option.get_default_str());
    add("", option.get_required() && !is_positional ? "required" : "");
    add("with ", names_of(option.get_needs()));
    add("not with ", names_of(option.get_excludes()));
    return entry(name, option.get_description() + (facts.empty() ? "" : " [" + listed(facts, "; ") + "]"));
  }
};

}  // namespace

std::shared_ptr<CLI::Formatter> help_formatter() {
  return std::make_shared<HelpFormatter>();
}

void group_options(CLI::App& command) {
  constexpr std::array<std::string_view, 16> output{
      "--json",   "--markdown", "--quiet", "--digits", "--out",    "--output",      "--svg",    "--png",
      "--report", "--summary",  "--sarif", "--names",  "--errata", "--certificate", "--smtlib", "--lemmas"};
  constexpr std::array<std::string_view, 7> work{"--seed",    "--threads", "--effort",        "--checkpoint",
                                                 "--samples", "--lines",   "--second-checker"};
  for (CLI::Option* option : command.get_options({})) {
    const auto is_in = [&](const auto& names) {
      return std::ranges::any_of(names, [&](std::string_view name) { return option->check_name(std::string(name)); });
    };
    if (is_in(output)) option->group("Output");
    if (is_in(work)) option->group(work_group);
  }
}

}  // namespace slipproof::cli
