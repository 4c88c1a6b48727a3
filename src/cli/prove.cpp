#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "export/coq.hpp"
#include "export/smtlib.hpp"
#include "input/diagnostic.hpp"
#include "input/text_file.hpp"
#include "output/output_file.hpp"
#include "prove/prove_files.hpp"
#include "report/exact_json.hpp"
#include "statements/library.hpp"

namespace slipproof::cli {

namespace {

struct ProveArguments {
  CommonOptions common;
  std::vector<std::string> inputs;
  std::string out, smtlib, coq;
};

constexpr std::size_t max_certificate_size = std::size_t{1} << 28U;

/// A statement, and how it is called in the folder for what is written.
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

/// Statements that no claims file is about: files, and folders of them.
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

/// In one folder they would overwrite each other.
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

std::filesystem::path certificate_of(std::filesystem::path statement) {
  return statement.replace_extension(".cert");
}

/// Writes what `text_of` makes of each statement, under the same names. Empty texts are not written.
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

/// What `make` makes of the statement and the certificate beside it; empty where there is none.
template <class Make>
std::string with_certificate(const std::filesystem::path& statement, const Make& make) {
  const std::filesystem::path certificate = certificate_of(statement);
  std::error_code error;
  if (!std::filesystem::exists(certificate, error)) return "";
  return make(statement.string(), read_text_file(statement), certificate.string(),
              read_text_file(certificate, max_certificate_size));
}

void export_smtlib(const std::vector<StatementFile>& statements, const std::filesystem::path& out) {
  export_statements(statements, out, ".smt2",
                    [](const std::filesystem::path& file) { return smtlib_text(file.string(), read_text_file(file)); });
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

/// Copies the statements to a folder, where their certificates will stand beside them.
std::vector<StatementFile> copied(const std::vector<StatementFile>& statements, const std::filesystem::path& out) {
  Inputs inputs;
  for (const StatementFile& statement : statements) inputs.add(statement.file);
  const OutputFolder folder(out, inputs);
  for (const StatementFile& statement : statements) inputs.refuse(certificate_of(out / statement.name));
  std::vector<StatementFile> result;
  std::error_code error;
  for (const auto& [file, name] : statements) {
    if (!std::filesystem::equivalent(out / name, file, error)) folder.write(name, read_text_file(file));
    result.push_back({out / name, name});
  }
  return result;
}

/// Writes the statements of the claims, and copies those of one's own that stand beside the claims file and below.
void write_statements(const std::filesystem::path& claims, const std::filesystem::path& folder,
                      const std::filesystem::path& out) {
  const std::vector<NamedStatement> generated = paper_statements(read_claims(claims));
  const std::filesystem::path place = certificates_folder(out / claims.filename());
  const Inputs inputs{claims};
  const OutputFolder made(out, inputs);
  const OutputFolder results(place, inputs);
  for (const NamedStatement& statement : generated) inputs.refuse(place / (statement.name + ".statement"));
  if (out != folder) {
    std::vector<StatementFile> statements = statements_below(folder);
    std::erase_if(statements, [&](const StatementFile& statement) {
      const std::filesystem::path inside = statement.file.lexically_normal().lexically_relative(out.lexically_normal());
      return !inside.empty() && *inside.begin() != "..";  // what an earlier run left in `out`
    });
    copied(statements, out);
  }
  for (const NamedStatement& statement : generated) {
    results.write(statement.name + ".statement", statement.text);
  }
}

std::string as_text(const std::vector<ProofOutcome>& outcomes) {
  std::string text;
  for (const ProofOutcome& outcome : outcomes) {
    text += (outcome.proved() ? "proved    " : "undecided ") + outcome.theorem + '\n';
    for (const std::string& left : outcome.leftover) text += "          left with " + left + '\n';
  }
  return text;
}

Json as_json(const std::vector<ProofOutcome>& outcomes) {
  Json document, theorems = Json::array();
  for (const ProofOutcome& outcome : outcomes) {
    Json entry;
    entry["theorem"] = outcome.theorem;
    entry["verdict"] = outcome.proved() ? "proved" : "undecided";
    entry["left_with"] = outcome.leftover;
    theorems.push_back(std::move(entry));
  }
  document["schema"] = "slipproof/prove/1";
  document["theorems"] = std::move(theorems);
  return document;
}

/// Proves the statements where they stand, writes the certificates beside them, and says what came of it.
Exit prove_all(const std::vector<StatementFile>& statements, const CommonOptions& common,
               const std::filesystem::path& claims = {}) {
  std::vector<std::filesystem::path> files;
  for (const StatementFile& statement : statements) files.push_back(statement.file);
  Inputs inputs(files);
  inputs.add(claims);
  std::vector<OutputFile> certificates;
  for (const std::filesystem::path& file : files) certificates.emplace_back(certificate_of(file), inputs);
  const std::vector<ProofOutcome> outcomes = prove_files(files, common.threads);
  std::size_t proved = 0;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!outcomes[i].proved()) continue;
    ++proved;
    certificates[i].write(outcomes[i].certificate);
  }
  const std::size_t left = files.size() - proved;
  const Exit exit = left > 0 || files.empty() ? undecided : as_it_should_be;
  if (common.json) {
    print(dump(as_json(outcomes)));
  } else {
    print((common.quiet ? std::string() : as_text(outcomes)) + (exit == undecided ? "s UNDECIDED " : "s PROVED ") +
          std::to_string(proved) + " proved, " + std::to_string(left) + " undecided\n");
  }
  return exit;
}

Exit run_prove(const ProveArguments& options) {
  const std::filesystem::path first = options.inputs.empty() ? "" : options.inputs.front();
  std::error_code error;
  const bool own =
      options.inputs.size() > 1 || first.extension() == ".statement" || std::filesystem::is_directory(first, error);
  const std::filesystem::path claims = own ? std::filesystem::path() : claims_path(first.string());
  const std::filesystem::path folder = claims.has_parent_path() ? claims.parent_path() : ".";
  const bool exports = !options.smtlib.empty() || !options.coq.empty();
  if (own || exports) {
    const std::vector<StatementFile> statements = own ? own_statements(options.inputs) : statements_below(folder);
    if (exports || !options.out.empty()) refuse_equal_names(statements);
    if (!options.smtlib.empty()) export_smtlib(statements, options.smtlib);
    if (!options.coq.empty()) export_coq(statements, options.coq);
    if (exports) return as_it_should_be;
    return prove_all(options.out.empty() ? statements : copied(statements, options.out), options.common);
  }
  const std::filesystem::path out = options.out.empty() ? folder : std::filesystem::path(options.out);
  write_statements(claims, folder, out);
  return prove_all(statements_below(out), options.common, claims);
}

}  // namespace

void add_prove(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ProveArguments>();
  CLI::App& command = *app.add_subcommand(
      "prove", "The claims of a paper, or statements of one's own, for all parameters;\nwrites a certificate for each");
  command.add_option("INPUT", options->inputs,
                     "A claims file, beside which and below may stand statements of one's own; default: the shipped\n"
                     "paper. Or, without claims: files *.statement and folders of them");
  command.add_option("--out", options->out,
                     "Folder for statements and certificates; default: where they stand, those of claims in\n"
                     "`certificates` beside the claims file");
  command.add_option("--smtlib", options->smtlib,
                     "Search for nothing, but write the negation of each statement to this folder as SMT-LIB 2");
  command.add_option("--coq", options->coq,
                     "Search for nothing, but write each statement with its certificate to this folder as a Coq file");
  add_common_options(command, options->common);
  command.callback([options, &exit_code] { exit_code = run_prove(*options); });
}

}  // namespace slipproof::cli
