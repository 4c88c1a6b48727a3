#include <fmt/format.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "base/input/text_file.hpp"
#include "base/output/output_file.hpp"
#include "claims/reading/paper_folder.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/commands/papers/prove_run.hpp"
#include "faces/cli/crew_run.hpp"
#include "faces/cli/interrupt.hpp"
#include "faces/cli/warnings.hpp"
#include "proofs/other_provers/coq.hpp"
#include "proofs/other_provers/smtlib.hpp"

namespace slipproof::cli {

namespace {

struct ProveArguments {
  CommonOptions common;
  ProveOptions prove;
  CrewArguments crew;
  std::vector<std::string> inputs;
  std::string out, smtlib, coq;
};

constexpr std::size_t max_certificate_size = std::size_t{1} << 28U;

/// A statement, and its name in the output folder.
struct StatementFile {
  std::filesystem::path file, name;
};

std::vector<StatementFile> statements_below(const std::filesystem::path& folder) {
  std::vector<StatementFile> result;
  for (const std::filesystem::path& file : statements_in(folder)) {
    result.push_back({file, file.lexically_relative(folder)});
  }
  return result;
}

/// The statements of a paper: those made from its claims, and those written by hand.
std::vector<StatementFile> statements_of(const PaperFolder& paper) {
  std::vector<StatementFile> result = statements_below(paper.folder);
  std::erase_if(result, [&](const StatementFile& statement) { return !paper.owns(statement.file); });
  return result;
}

/// Statements that do not belong to a claims file: files, and folders of files.
std::vector<StatementFile> own_statements(const std::vector<std::string>& inputs) {
  std::vector<StatementFile> result;
  for (const std::filesystem::path input : inputs) {
    const auto refuse = [&](const char* found) {
      throw InputError({{input.string(), 0, 0, std::string("found ") + found + ", expected a statement or a folder"}});
    };
    if (std::filesystem::is_directory(input)) {
      const std::vector<StatementFile> below = statements_below(input);
      if (below.empty()) refuse("a folder without *.statement");
      result.insert(result.end(), below.begin(), below.end());
    } else if (input.extension() == ".statement") {
      result.push_back({input, input.filename()});
    } else {
      refuse("another file");
    }
  }
  return result;
}

/// In one folder, statements with the same name would overwrite each other.
void refuse_equal_names(const std::vector<StatementFile>& statements) {
  std::map<std::filesystem::path, std::filesystem::path> files;
  for (const auto& [file, name] : statements) {
    const auto [first, is_new] = files.emplace(name, file);
    if (is_new) continue;
    throw InputError({{file.string(), 0, 0,
                       "found a statement of the same name as " + first->second.string() +
                           ", expected one of each name for one folder"}});
  }
}

/// Writes the result of `text_of` for each statement, under the same name. Does not write empty texts.
void export_statements(const std::vector<StatementFile>& statements, const std::filesystem::path& out,
                       const char* extension, const std::function<std::string(const std::filesystem::path&)>& text_of) {
  Inputs inputs;
  for (const StatementFile& statement : statements) {
    inputs.add(statement.file);
    inputs.add(certificate_of(statement.file));
  }
  const OutputFolder folder(out, inputs);
  std::size_t written = 0;
  for (const StatementFile& statement : statements) {
    const std::string text = text_of(statement.file);
    if (text.empty()) continue;
    std::filesystem::path name = statement.name;
    folder.write(name.replace_extension(extension), text);
    ++written;
  }
  print("s EXPORTED " + std::to_string(written) + " *" + extension + " to " + out.string() + '\n');
}

/// The result of `make` for the statement and its certificate; empty if there is no certificate.
template <class Make>
std::string with_certificate(const std::filesystem::path& statement, const Make& make) {
  const std::filesystem::path certificate = certificate_of(statement);
  std::error_code error;
  if (!std::filesystem::exists(certificate, error)) return "";
  const std::string text = read_found_file(certificate, max_certificate_size);
  if (text.starts_with("slipproof-undecided ")) return "";
  return make(statement.string(), read_found_file(statement), certificate.string(), text);
}

void export_smtlib(const std::vector<StatementFile>& statements, const std::filesystem::path& out) {
  export_statements(statements, out, ".smt2", [](const std::filesystem::path& file) {
    return smtlib_text(file.string(), read_found_file(file));
  });
  export_statements(statements, out, ".witness.smt2",
                    [](const std::filesystem::path& file) { return with_certificate(file, smtlib_witness_text); });
}

void export_coq(const std::vector<StatementFile>& statements, const std::filesystem::path& out) {
  export_statements(statements, out, ".v", [](const std::filesystem::path& file) {
    std::string text = with_certificate(file, coq_text);
    if (text.empty()) print("no certificate: " + file.string() + '\n');
    return text;
  });
}

/// Copies the statements to a folder; their certificates will be written there.
std::vector<StatementFile> copied(const std::vector<StatementFile>& statements, const std::filesystem::path& out) {
  Inputs inputs;
  for (const StatementFile& statement : statements) inputs.add(statement.file);
  const OutputFolder folder(out, inputs);
  for (const StatementFile& statement : statements) inputs.refuse(certificate_of(out / statement.name));
  std::vector<StatementFile> result;
  std::error_code error;
  for (const auto& [file, name] : statements) {
    if (!std::filesystem::equivalent(out / name, file, error)) folder.write(name, read_found_file(file));
    result.push_back({out / name, name});
  }
  return result;
}

/// Copies the statements in the folder of a claims file and below.
void copy_statements(const PaperFolder& paper, const std::filesystem::path& out) {
  if (out == paper.folder) return;
  std::vector<StatementFile> statements = statements_of(paper);
  std::erase_if(statements, [&](const StatementFile& statement) {
    const std::filesystem::path inside = statement.file.lexically_normal().lexically_relative(out.lexically_normal());
    return !inside.empty() && *inside.begin() != "..";  // it is inside `out`, left by an earlier run
  });
  copied(statements, out);
}

std::vector<std::filesystem::path> files_of(const std::vector<StatementFile>& statements) {
  std::vector<std::filesystem::path> files;
  for (const StatementFile& statement : statements) files.push_back(statement.file);
  return files;
}

Exit run_prove(ProveArguments& options) {
  const auto work = [&] {
    return fmt::format("prove effort {} again {}\n", options.prove.limits.steps, options.prove.again);
  };
  CrewRun crew(options.crew, options.common.threads, work,
               Inputs(std::vector<std::filesystem::path>(options.inputs.begin(), options.inputs.end())),
               [&](std::string_view request) { return answer_statement(request, options.prove); });
  if (crew.served()) return as_it_should_be;
  options.prove.crew = crew.crew();
  const std::filesystem::path first = options.inputs.empty() ? "" : options.inputs.front();
  std::error_code error;
  const bool own =
      options.inputs.size() > 1 || first.extension() == ".statement" || std::filesystem::is_directory(first, error);
  const std::filesystem::path claims = own ? std::filesystem::path() : claims_path(first.string());
  PaperFolder paper = own ? PaperFolder{} : paper_folder(claims);
  const bool exports = !options.smtlib.empty() || !options.coq.empty();
  if (own || exports) {
    const std::vector<StatementFile> statements = own ? own_statements(options.inputs) : statements_of(paper);
    if (exports || !options.out.empty()) refuse_equal_names(statements);
    if (!options.smtlib.empty()) export_smtlib(statements, options.smtlib);
    if (!options.coq.empty()) export_coq(statements, options.coq);
    if (exports) return as_it_should_be;
    ProveRun run(options.prove, options.common);
    run.prove(files_of(options.out.empty() ? statements : copied(statements, options.out)));
    return run.conclude();
  }
  const std::filesystem::path out = options.out.empty() ? paper.folder : std::filesystem::path(options.out);
  const ClaimsFile file = read_claims(claims);
  print_warnings(file, options.common);
  const OutputFolder made(out, Inputs{claims});
  copy_statements(paper, out);
  paper.folder = out;
  const OutputFolder made_inside(paper.generated(), Inputs{claims});
  ProveRun run(options.prove, options.common, Inputs{claims});
  run.prove_claims(file, paper);
  return run.conclude();
}

Continuation by_certificates(const ProveArguments& options) {
  Continuation left{"each certificate so far is in its file, and is not searched for again"};
  if (!options.crew.checkpoint.empty()) {
    left = by_checkpoint(options.crew);
  } else if (options.prove.again) {
    left.left_out = "--again";
  }
  return left;
}

}  // namespace

void add_prove(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ProveArguments>();
  CLI::App& command = *app.add_subcommand(
      "prove",
      "Prove the claims of a paper, or your own statements, for all parameters;\nwrite a certificate for each");
  command.add_option(
      "INPUT", options->inputs,
      "A claims file, with your own statements next to it and below, except those in folders of\n"
      "other papers; default: the shipped paper. Or, without claims: files *.statement and folders of them");
  command.add_option(
      "--out", options->out,
      "Folder for statements and certificates; default: next to your own statements, those of claims in\n"
      "`certificates` next to the claims file, or `NAME.certificates` if NAME.toml is one of several");
  command.add_option("--smtlib", options->smtlib,
                     "Do not search; write the negation of each statement to this folder as SMT-LIB 2");
  command.add_option("--coq", options->coq,
                     "Do not search; write each statement with its certificate to this folder as a Coq file");
  command
      .add_option("--effort", options->prove.limits.steps,
                  "Steps of polynomial arithmetic for each statement: the same on every machine, unlike time")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000'000}))
      ->capture_default_str();
  command.add_flag("--again", options->prove.again, "Search again for theorems that have an accepted certificate");
  add_crew_options(command, options->crew);
  add_common_options(command, options->common);
  command.callback([options, &exit_code] {
    exit_code = stoppable([&] { return run_prove(*options); }, [&] { return by_certificates(*options); });
  });
}

}  // namespace slipproof::cli
