#include <string>

#include "faces/cli/description.hpp"
#include "mechanics/reading/shipped.hpp"

namespace slipproof::cli {

namespace {

std::string shipped_names() {
  std::string names;
  for (const ShippedMechanism& one : shipped_mechanisms()) names += (names.empty() ? "" : " ") + std::string(one.name);
  return names;
}

/// All names of all options, with `between` between them.
std::string names_of(const DescribedOption& option, const char* between) {
  std::string text;
  for (const std::string& name : option.names) text += (text.empty() ? "" : between) + name;
  return text;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// The values that bash offers for an option: words or files; nothing for a number.
std::string bash_values(const DescribedOption& option) {
  if (!option.choices.empty()) return "words='" + joined(option.choices) + "'";
  if (option.is_mechanism()) return "words='" + shipped_names() + "' files=yes";
  return option.type == "TEXT" ? "files=yes" : ":";
}

std::string bash_case(const DescribedCommand& command) {
  std::string text = "    " + command.name + ")\n      case $previous in\n", all;
  for (const DescribedOption& option : command.with_names()) {
    all += (all.empty() ? "" : " ") + names_of(option, " ");
    if (!option.takes_value()) continue;
    text += "        " + names_of(option, "|") + ") " + bash_values(option) + " ;;\n";
  }
  std::string otherwise = "files=yes";
  for (const DescribedOption& option : command.positional()) {
    if (option.is_mechanism()) otherwise = bash_values(option);
  }
  return text + "        *) if [[ $current == -* ]]; then words='" + all + "'; else " + otherwise +
         "; fi ;;\n      esac ;;\n";
}

/// Escapes text for an argument of zsh's _arguments in single quotes.
std::string zsh_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
    } else if (c == '[' || c == ']' || c == ':') {
      result += {'\\', c};
    } else {
      result += c;
    }
  }
  return result;
}

std::string zsh_values(const DescribedOption& option) {
  if (!option.choices.empty()) return "(" + joined(option.choices) + ")";
  if (option.is_mechanism())
    return "{_alternative \"names:mechanism:(" + shipped_names() + ")\" \"files:file:_files\"}";
  return option.type == "TEXT" ? "_files" : " ";
}

std::string zsh_case(const DescribedCommand& command) {
  std::string text = "    " + command.name + ") _arguments \\\n";
  for (const DescribedOption& option : command.with_names()) {
    for (const std::string& name : option.names) {
      text += "      '" + name + "[" + zsh_text(option.text) + "]";
      if (option.takes_value()) text += (option.optional_value ? "::" : ":") + option.type + ":" + zsh_values(option);
      text += "' \\\n";
    }
  }
  std::string values = "_files";
  for (const DescribedOption& option : command.positional()) values = zsh_values(option);
  return text + "      '*:argument:" + values + "' ;;\n";
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::string commands, cases;
  for (const DescribedCommand& command : described_subcommands(app)) {
    commands += (commands.empty() ? "" : " ") + command.name;
    cases += bash_case(command);
  }
  std::string of_program;
  for (const DescribedOption& option : describe(app).with_names()) of_program += " " + names_of(option, " ");
  return "# Completion of slipproof's commands, options and files in bash.\n"
         "_slipproof() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command= words= files= "
         "word\n"
         "  if [[ $current == = ]]; then\n"
         "    current=\n"
         "  elif [[ $previous == = ]]; then\n"
         "    previous=${COMP_WORDS[COMP_CWORD - 2]}\n"
         "  fi\n"
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    [[ $word == -* ]] || { command=$word; break; }\n"
         "  done\n"
         "  case $command in\n"
         "    '') words='" +
         commands + of_program + "' ;;\n" + cases +
         "  esac\n"
         "  COMPREPLY=()\n"
         "  while IFS= read -r word; do COMPREPLY+=(\"$word\"); done < <(compgen -W \"$words\" -- \"$current\")\n"
         "  [[ $files ]] || return 0\n"
         "  compopt -o filenames 2>/dev/null\n"
         "  while IFS= read -r word; do COMPREPLY+=(\"$word\"); done < <(compgen -f -- \"$current\")\n"
         "}\n"
         "complete -F _slipproof slipproof\n";
}

std::string zsh_completion(const CLI::App& app) {
  std::string commands, cases;
  for (const DescribedCommand& command : described_subcommands(app)) {
    commands += "      '" + command.name + ":" + zsh_text(command.text) + "'\n";
    cases += zsh_case(command);
  }
  return "#compdef slipproof\n"
         "# Completion of slipproof's commands, options and files in zsh.\n"
         "_slipproof() {\n"
         "  local state line\n"
         "  typeset -A opt_args\n"
         "  local -a commands=(\n" +
         commands +
         "  )\n"
         "  _arguments -C '--help[Help]' '--version[Version]' '1:command:->command' '*::argument:->argument'\n"
         "  case $state in\n"
         "    command) _describe command commands; return ;;\n"
         "    argument) ;;\n"
         "    *) return ;;\n"
         "  esac\n"
         "  case $words[1] in\n" +
         cases +
         "  esac\n"
         "}\n"
         "_slipproof \"$@\"\n";
}

}  // namespace slipproof::cli
