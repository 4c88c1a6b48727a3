#include "faces/cli/description.hpp"

#include <algorithm>

namespace slipproof::cli {

namespace {

std::string in_one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

std::vector<std::string> split(std::string_view text) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t comma = std::min(text.find(','), text.size());
    parts.emplace_back(text.substr(0, comma));
    text.remove_prefix(std::min(comma + 1, text.size()));
  }
  return parts;
}

/// "TEXT:{cone,box}", "UINT:INTEGER from 1 to 7", "FLOAT:FLOAT from 0 to 1".
void describe_type(const std::string& type, DescribedOption& option) {
  const std::size_t colon = type.find(':');
  option.type = type.substr(0, colon);
  if (option.type == "UINT" || option.type == "INT") option.type = "INTEGER";
  if (colon == std::string::npos) return;
  const std::string limits = type.substr(colon + 1);
  if (limits.starts_with('{') && limits.ends_with('}')) {
    option.choices = split(std::string_view(limits).substr(1, limits.size() - 2));
  } else {
    option.limits = limits;
  }
}

DescribedOption described_option(const CLI::Option& option) {
  DescribedOption result;
  result.positional = option.get_positional();
  if (result.positional) {
    result.names.push_back(option.get_name(true));
  } else {
    for (const std::string& name : option.get_snames()) result.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) result.names.push_back("--" + name);
  }
  result.text = in_one_line(option.get_description());
  if (option.get_type_size() != 0) {
    describe_type(option.get_type_name(), result);
    result.usual = option.get_default_str();
    result.optional_value = option.get_expected_min() == 0 && !result.positional;
    result.repeated = option.get_expected_max() > 1;
  }
  result.required = option.get_required();
  return result;
}

void add_options(const CLI::App& from, DescribedCommand& to) {
  const bool is_group = from.get_name().empty() && from.get_parent() != nullptr;
  for (const CLI::Option* option : from.get_options()) {
    if (is_group && option == from.get_help_ptr()) continue;  // its command already has one
    to.options.push_back(described_option(*option));
  }
  for (const CLI::App* group : from.get_subcommands([](const CLI::App* app) { return app->get_name().empty(); })) {
    add_options(*group, to);
  }
}

std::vector<DescribedOption> only(const std::vector<DescribedOption>& options, bool positional) {
  std::vector<DescribedOption> result;
  std::ranges::copy_if(options, std::back_inserter(result), [&](const auto& o) { return o.positional == positional; });
  return result;
}

}  // namespace

std::string DescribedOption::usage() const {
  std::string value = type;
  if (!choices.empty()) {
    value.clear();
    for (const std::string& choice : choices) value += (value.empty() ? "" : "|") + choice;
  }
  if (positional) {
    value = names.front() + (repeated ? "..." : "");
    return required ? value : "[" + value + "]";
  }
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  if (!takes_value()) return text;
  if (repeated) value += " " + value;
  return text + (optional_value ? " [" + value + "]" : " " + value);
}

bool DescribedOption::is_mechanism() const {
  return names.back() == "MECHANISM" || names.back() == "--mechanism";
}

std::vector<DescribedOption> DescribedCommand::with_names() const {
  return only(options, false);
}

std::vector<DescribedOption> DescribedCommand::positional() const {
  return only(options, true);
}

DescribedCommand describe(const CLI::App& command) {
  DescribedCommand result{command.get_name(), in_one_line(command.get_description()), {}};
  add_options(command, result);
  return result;
}

std::vector<DescribedCommand> described_subcommands(const CLI::App& app) {
  std::vector<DescribedCommand> result;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (!command->get_group().empty() && !command->get_name().empty()) result.push_back(describe(*command));
  }
  return result;
}

}  // namespace slipproof::cli
