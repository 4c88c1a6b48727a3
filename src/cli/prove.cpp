#include <functional>
#include <memory>
#include <string>

#include "cli/command.hpp"
#include "cli/output_file.hpp"
#include "export/coq.hpp"
#include "export/smtlib.hpp"
#include "input/text_file.hpp"
#include "prove/claim_statements.hpp"
#include "prove/prove_files.hpp"
#include "report/exact_json.hpp"

namespace slipproof::cli {

namespace {

struct ProveArguments {
  CommonOptions common;
  std::string claims;
  std::string out, smtlib, coq;
};

constexpr std::size_t max_certificate_size = std::size_t{1} << 28U;

std::filesystem::path certificate_of(std::filesystem::path statement) {
  return statement.replace_extension(".cert");
}

/// Writes what `text_of` makes of each statement beside the claims and in the folders below, under the same names.
/// Empty texts are not written.
void export_statements(const std::filesystem::path& folder, const std::filesystem::path& out, const char* extension,
                       const std::function<std::string(const std::filesystem::path&)>& text_of) {
  std::size_t written = 0;
  for (const std::filesystem::path& file : statements_in(folder)) {
    const std::string text = text_of(file);
    if (text.empty()) continue;
    std::filesystem::path target = out / file.lexically_relative(folder);
    write_file(target.replace_extension(extension), text);
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

void export_smtlib(const std::filesystem::path& folder, const std::filesystem::path& out) {
  export_statements(folder, out, ".smt2",
                    [](const std::filesystem::path& file) { return smtlib_text(file.string(), read_text_file(file)); });
  export_statements(folder, out, ".witness.smt2",
                    [](const std::filesystem::path& file) { return with_certificate(file, smtlib_witness_text); });
}

void export_coq(const std::filesystem::path& folder, const std::filesystem::path& out) {
  export_statements(folder, out, ".v", [](const std::filesystem::path& file) {
    std::string text = with_certificate(file, coq_text);
    if (text.empty()) print("no certificate: " + file.string() + '\n');
    return text;
  });
}

/// Writes the statements of the claims, and copies those of one's own that stand beside them and below.
void write_statements(const ClaimsFile& claims, const std::filesystem::path& folder, const std::filesystem::path& out) {
  std::filesystem::create_directories(out);
  if (out != folder) {
    for (const std::filesystem::path& file : statements_in(folder)) {
      const std::filesystem::path inside = file.lexically_relative(out);
      if (!inside.empty() && *inside.begin() != "..") continue;  // what an earlier run left in `out`
      const std::filesystem::path copy = out / file.lexically_relative(folder);
      write_file(copy, read_text_file(file));
    }
  }
  for (const NamedStatement& statement : paper_statements(claims)) {
    write_file(out / (statement.name + ".statement"), statement.text);
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

}  // namespace

void add_prove(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ProveArguments>();
  CLI::App& command = *app.add_subcommand("prove", "The claims for all parameters; writes a certificate for each");
  command.add_option("CLAIMS", options->claims,
                     "Claims file; beside it and below may stand statements of one's own; default: the shipped paper");
  command.add_option("--out", options->out, "Folder for statements and certificates; default: that of the claims file");
  command.add_option("--smtlib", options->smtlib,
                     "Search for nothing, but write the negation of each statement to this folder as SMT-LIB 2");
  command.add_option("--coq", options->coq,
                     "Search for nothing, but write each statement with its certificate to this folder as a Coq file");
  add_common_options(command, options->common);
  command.callback([options, &exit_code] {
    const std::filesystem::path claims = claims_path(options->claims);
    const std::filesystem::path folder = claims.parent_path().empty() ? "." : claims.parent_path();
    if (!options->smtlib.empty()) export_smtlib(folder, options->smtlib);
    if (!options->coq.empty()) export_coq(folder, options->coq);
    if (!options->smtlib.empty() || !options->coq.empty()) return;
    const std::filesystem::path out = options->out.empty() ? folder : std::filesystem::path(options->out);
    write_statements(read_claims(claims), folder, out);
    const auto statements = statements_in(out);
    const auto outcomes = prove_files(statements, options->common.threads);
    std::size_t proved = 0;
    for (std::size_t i = 0; i < statements.size(); ++i) {
      if (!outcomes[i].proved()) continue;
      ++proved;
      write_file(std::filesystem::path(statements[i]).replace_extension(".cert"), outcomes[i].certificate);
    }
    const std::size_t undecided_count = statements.size() - proved;
    exit_code = undecided_count > 0 || statements.empty() ? undecided : as_it_should_be;
    if (options->common.json) return print(dump(as_json(outcomes)));
    print((options->common.quiet ? std::string() : as_text(outcomes)) +
          (exit_code == as_it_should_be ? "s PROVED " : "s UNDECIDED ") + std::to_string(proved) + " proved, " +
          std::to_string(undecided_count) + " undecided\n");
  });
}

}  // namespace slipproof::cli
