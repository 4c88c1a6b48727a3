#include <fmt/format.h>

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
#include "proofs/other_provers/smtlib.hpp"
#include "proofs/statement/theorems.hpp"

namespace slipproof::cli {

namespace {

struct ProveArguments {
  CommonOptions common;
  ProveOptions prove;
  CrewArguments crew;
  std::vector<std::string> inputs;
  std::string out, smtlib;
};

/// A statement, or part of a theorem file, and its name in the output folder.
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

/// Statements that do not belong to a claims file: files, theorem files, and folders of both.
std::vector<StatementFile> own_statements(const std::vector<std::string>& inputs) {
  std::vector<StatementFile> result;
  for (const std::filesystem::path input : inputs) {
    const auto refuse = [&](const char* found) {
      throw InputError({{input.string(), 0, 0,
                         std::string("found ") + found + ", expected a statement, a theorem file or a folder"}});
    };
    if (std::filesystem::is_directory(input)) {
      const std::vector<StatementFile> below = statements_below(input);
      if (below.empty()) refuse("a folder without statements");
      result.insert(result.end(), below.begin(), below.end());
    } else if (is_theorem_file(input)) {
      for (const std::filesystem::path& part : statements_in(input)) {
        result.push_back({part, input.filename() / part.filename()});
      }
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

/// The name in a folder of exports: those of FILE.theorems are in the folder FILE.
std::filesystem::path exported_name(std::filesystem::path name, const char* extension) {
  name.replace_extension(extension);
  std::filesystem::path folder = name.parent_path();
  if (is_theorem_file(folder)) folder.replace_extension();
  return folder / name.filename();
}

/// Writes the result of `text_of` for each statement, under the same name. Does not write empty texts.
template <class TextOf>
void export_statements(const std::vector<StatementFile>& statements, const std::filesystem::path& out,
                       const char* extension, const TextOf& text_of) {
  Inputs inputs;
  std::vector<std::filesystem::path> files;
  for (const StatementFile& statement : statements) {
    files.push_back(statement.file);
    for (const auto& path : {statement.file, certificate_of(statement.file)}) inputs.add(file_of(path));
  }
  const OutputFolder folder(out, inputs);
  const std::vector<StatementSource> sources = read_statements(files);
  std::size_t written = 0;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const std::string text = text_of(sources[i]);
    if (text.empty()) continue;
    folder.write(exported_name(statements[i].name, extension), text);
    ++written;
  }
  print("s EXPORTED " + std::to_string(written) + " *" + extension + " to " + out.string() + '\n');
}

void export_smtlib(const std::vector<StatementFile>& statements, const std::filesystem::path& out) {
  export_statements(statements, out, ".smt2", [](const StatementSource& statement) {
    return smtlib_text(statement.path.string(), statement.text);
  });
  export_statements(statements, out, ".witness.smt2", [](const StatementSource& statement) -> std::string {
    if (!statement.certificate || statement.certificate->starts_with("slipproof-undecided ")) return "";
    return smtlib_witness_text(statement.path.string(), statement.text, certificate_of(statement.path).string(),
                               *statement.certificate);
  });
}

std::vector<std::filesystem::path> files_of(const std::vector<StatementFile>& statements) {
  std::vector<std::filesystem::path> files;
  for (const StatementFile& statement : statements) files.push_back(statement.file);
  return files;
}

/// Copies the statements to a folder, where their certificates will be written. Theorem files are written with these.
std::vector<StatementSource> copied(const std::vector<StatementFile>& statements, const std::filesystem::path& out,
                                    ProveRun& run) {
  Inputs inputs;
  for (const StatementFile& statement : statements) inputs.add(file_of(statement.file));
  const OutputFolder folder(out, inputs);
  TheoremTexts there;
  std::map<std::filesystem::path, TheoremFile> copies;
  std::vector<StatementSource> result = read_statements(files_of(statements));
  for (std::size_t i = 0; i < result.size(); ++i) {
    StatementSource& source = result[i];
    const std::filesystem::path& from = statements[i].file;
    const std::filesystem::path to = out / statements[i].name;
    std::error_code error;
    if (std::filesystem::equivalent(file_of(to), file_of(from), error)) continue;
    source = {.path = to,
              .text = source.text,
              .certificate = there.at(certificate_of(to)),
              .origin = from,
              .line = source.line};
    if (file_of(to) != to) {
      const std::string certificate = source.certificate.value_or("");
      copies[file_of(to)].theorems.push_back({to.stem().string(), source.text, certificate});
    } else {
      inputs.refuse(certificate_of(to));
      folder.write(statements[i].name, source.text);
    }
  }
  for (auto& [file, theorems] : copies) run.contain(file, std::move(theorems));
  return result;
}

/// The statements that were written by hand; in `out`, if that is another folder.
std::vector<StatementSource> by_hand(const PaperFolder& paper, const std::filesystem::path& out, ProveRun& run) {
  std::vector<StatementFile> statements = statements_of(paper);
  std::erase_if(statements, [&](const StatementFile& s) { return s.file.parent_path() == paper.generated(); });
  if (out == paper.folder) return read_statements(files_of(statements));
  std::erase_if(statements, [&](const StatementFile& statement) {
    const std::filesystem::path inside = statement.file.lexically_normal().lexically_relative(out.lexically_normal());
    return !inside.empty() && *inside.begin() != "..";  // it is inside `out`, left by an earlier run
  });
  return copied(statements, out, run);
}

Exit run_prove(ProveArguments& options) {
  const auto work = [&] {
    return fmt::format("prove effort {} again {}\n", options.prove.limits.steps, options.prove.again);
  };
  const auto crew = crew_of(options.crew, options.common.threads, work,
                            Inputs(std::vector<std::filesystem::path>(options.inputs.begin(), options.inputs.end())),
                            [&](std::string_view request) { return answer_statement(request, options.prove); });
  if (crew && crew->serve()) return success;
  options.prove.crew = crew.get();
  const std::filesystem::path first = options.inputs.empty() ? "" : options.inputs.front();
  std::error_code error;
  const bool own = options.inputs.size() > 1 || first.extension() == ".statement" || is_theorem_file(first) ||
                   std::filesystem::is_directory(first, error);
  const std::filesystem::path claims = own ? std::filesystem::path() : claims_path(first.string());
  const PaperFolder paper = own ? PaperFolder{} : paper_folder(claims);
  const bool exports = !options.smtlib.empty();
  if (own || exports) {
    const std::vector<StatementFile> statements = own ? own_statements(options.inputs) : statements_of(paper);
    if (exports || !options.out.empty()) refuse_equal_names(statements);
    if (exports) {
      export_smtlib(statements, options.smtlib);
      return success;
    }
    ProveRun run(options.prove, options.common);
    run.prove(options.out.empty() ? read_statements(files_of(statements)) : copied(statements, options.out, run));
    return run.conclude();
  }
  const std::filesystem::path out = options.out.empty() ? paper.folder : std::filesystem::path(options.out);
  const ClaimsFile file = read_claims(claims);
  print_warnings(file, options.common);
  const OutputFolder made(out, Inputs{claims});
  ProveRun run(options.prove, options.common, Inputs{claims});
  PaperFolder results = paper;
  results.folder = out;
  run.reserve(results.theorems());  // refuses a place where it cannot be written, before anything is read
  run.prove_claims(file, results, by_hand(paper, out, run));
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
      "prove", "Prove the claims of a paper, or your own statements, for all parameters; write a certificate for each");
  command.add_option(
      "INPUT", options->inputs,
      "A claims file, with your own statements next to it and below, except those in folders of "
      "other papers; default: the shipped paper. Or, without claims: files *.statement and *.theorems, and "
      "folders of them");
  command.add_option(
      "--out", options->out,
      "Folder for statements and certificates; default: next to your own statements; those of NAME.toml in "
      "NAME.theorems next to it, which is written whole or not at all");
  command.add_option("--smtlib", options->smtlib,
                     "Do not search; write the negation of each statement to this folder as SMT-LIB 2");
  command
      .add_option("--effort", options->prove.limits.steps,
                  "Steps of polynomial arithmetic for each statement: the same on every machine, unlike time")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000'000}))
      ->capture_default_str();
  command.add_flag("--again", options->prove.again, "Search again for theorems that have an accepted certificate");
  add_crew_options(command, options->crew);
  add_common_options(command, options->common);
  add_examples(command, {"proofs/ladder/claims.toml --out proved"});
  command.callback([options, &exit_code] {
    exit_code = stoppable([&] { return run_prove(*options); }, [&] { return by_certificates(*options); });
  });
}

}  // namespace slipproof::cli
