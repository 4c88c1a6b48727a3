#include <algorithm>
#include <cctype>

#include "faces/cli/command.hpp"
#include "faces/cli/description.hpp"

namespace slipproof::cli {

namespace {

/// Escapes text for roff: no line becomes a request, and hyphens can be copied as they are typed.
std::string roff(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string exit_status() {
  std::string text = ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : exit_codes)
    text += ".IP " + std::to_string(code) + " 4\n" + roff(std::string(meaning)) + "\n";
  return text;
}

class Page {
 public:
  Page(std::string name, const std::string& version, const std::string& what) : name_(std::move(name)) {
    std::string upper = name_;
    std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    text_ = ".TH " + upper + " 1 \"\" \"slipproof " + version + "\" \"User Commands\"\n.SH NAME\n" + roff(name_) +
            " \\- " + roff(what) + "\n";
  }

  void section(const std::string& title) { text_ += ".SH " + title + "\n"; }
  /// Writes a command in bold, and its arguments.
  void synopsis(const std::string& command, const std::string& arguments) {
    text_ += ".B " + roff(command) + "\n" + (arguments.empty() ? "" : roff(arguments) + "\n");
  }
  void paragraph(const std::string& text) { text_ += ".PP\n" + roff(text) + "\n"; }
  void item(const std::string& term, const std::string& text) {
    text_ += ".TP\n.B " + roff(term) + "\n" + roff(text) + "\n";
  }
  void options(const std::vector<DescribedOption>& options) {
    for (const DescribedOption& option : options) {
      std::string text = option.text;
      if (!option.limits.empty()) text += " (" + option.limits + ")";
      if (!option.usual.empty()) text += " [" + option.usual + "]";
      item(option.usage(), text);
    }
  }
  void see_also(const std::string& pages) { text_ += ".SH SEE ALSO\n" + roff(pages) + "\n"; }
  WrittenPage written() && { return {name_ + ".1", std::move(text_)}; }
  void add(const std::string& roff_text) { text_ += roff_text; }

 private:
  std::string name_, text_;
};

WrittenPage page_of(const DescribedCommand& command, const std::string& version) {
  Page page("slipproof-" + command.name, version, command.text);
  page.section("SYNOPSIS");
  std::string arguments = "[OPTIONS]";
  for (const DescribedOption& option : command.positional()) arguments += " " + option.usage();
  page.synopsis("slipproof " + command.name, arguments);
  const bool also_alone = command.name == "check";
  if (also_alone) {
    page.add(".br\n");
    page.synopsis("slipproof-check", "CERT|STATEMENT|THEOREMS|FOLDER...");
  }
  page.section("DESCRIPTION");
  page.add(roff(command.text) + ".\n");
  if (also_alone) page.paragraph("slipproof-check is a separate program that shares no code with the prover.");
  page.options(command.positional());
  page.section("OPTIONS");
  page.options(command.with_names());
  page.add(exit_status());
  page.see_also("slipproof(1)");
  return std::move(page).written();
}

WrittenPage page_of_program(const CLI::App& app, const std::string& version) {
  const DescribedCommand program = describe(app);
  Page page("slipproof", version, program.text);
  page.section("SYNOPSIS");
  page.synopsis("slipproof", "COMMAND [ARGUMENTS]");
  page.section("DESCRIPTION");
  page.add(
      "With dry friction a pushed bicycle, block or mechanism may have one motion, several, or none. slipproof solves "
      "every\ncase in exact arithmetic, checks what papers and solvers say, and proves thresholds with "
      "certificates.\n");
  page.section("COMMANDS");
  std::string pages;
  for (const DescribedCommand& command : described_subcommands(app)) {
    page.item(command.name, command.text + ": slipproof-" + command.name + "(1)");
    pages += "slipproof-" + command.name + "(1), ";
  }
  page.section("OPTIONS");
  page.options(program.with_names());
  page.section("NUMBERS");
  page.add("Exact in every form: 3/4, 0.1 (one tenth), 1e\\-3, 0x1.8p\\-3.\n");
  page.add(exit_status());
  page.see_also(pages + "slipproof-check-contact(1)");
  return std::move(page).written();
}

/// The checker of contact problems has no options and shares no code with this program.
WrittenPage page_of_check_contact(const std::string& version) {
  Page page("slipproof-check-contact", version, "Check certificates about contact problems");
  page.section("SYNOPSIS");
  page.synopsis("slipproof-check-contact", "[--problem NAME] FILE...");
  page.section("DESCRIPTION");
  page.add(
      "Checks the certificates that\n.B slipproof certify \\-\\-certificate\nwrites. It shares no code with the "
      "program that finds them.\n");
  page.item("FILE...", "Certificates; - is standard input");
  page.section("OPTIONS");
  page.item("--problem NAME", "Reject certificates about a problem with another name");
  page.item("--help", "Show how to use it");
  page.item("--version", "Show its version");
  page.add(exit_status());
  page.see_also("slipproof-certify(1), slipproof-check(1)");
  return std::move(page).written();
}

}  // namespace

std::vector<WrittenPage> manual_pages(const CLI::App& app, const std::string& version) {
  std::vector<WrittenPage> pages{page_of_program(app, version), page_of_check_contact(version)};
  for (const DescribedCommand& command : described_subcommands(app)) pages.push_back(page_of(command, version));
  return pages;
}

}  // namespace slipproof::cli
