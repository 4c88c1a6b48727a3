#include "faces/cli/commands/papers/prove_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <optional>
#include <set>

#include "base/input/diagnostic.hpp"
#include "base/number/format.hpp"
#include "base/output/output_file.hpp"
#include "base/parallel/failure.hpp"
#include "claims/statements/canonical_claims.hpp"
#include "claims/statements/claim_statements.hpp"
#include "proofs/statement/statement.hpp"
#include "proofs/statement/undecided.hpp"
#include "report/papers/explain.hpp"

namespace slipproof::cli {

namespace {

std::vector<std::string> reasons(const ProofOutcome& outcome) {
  if (outcome.verdict == ProofOutcome::Verdict::refuted) return {false_at(outcome.counterexample)};
  std::vector<std::string> result;
  for (const std::string& left : outcome.leftover) result.push_back("left with " + left);
  if (result.empty()) result.emplace_back("the search ended without a proof");
  return result;
}

std::string as_text(const FileOutcome& file, std::uint64_t effort) {
  const ProofOutcome& outcome = file.outcome;
  const std::string verdict(file.kept ? "kept" : name(outcome.verdict));
  std::string text = verdict + std::string(10 - verdict.size(), ' ') + outcome.theorem;
  if (outcome.vacuous) text += ", its assumptions contradict each other";
  if (outcome.verdict == ProofOutcome::Verdict::refuted) text += " at " + at_numbers(outcome.counterexample);
  text += '\n';
  for (const std::string& left : outcome.leftover) text += "          left with " + left + '\n';
  if (outcome.exhausted) text += "          more steps may help: --effort " + std::to_string(10 * effort) + '\n';
  return text;
}

Json as_json(const FileOutcome& file) {
  const ProofOutcome& outcome = file.outcome;
  Json entry;
  entry["theorem"] = outcome.theorem;
  entry["verdict"] = name(outcome.verdict);
  if (file.kept) entry["kept"] = true;
  if (outcome.proved()) entry["vacuous"] = outcome.vacuous;
  if (outcome.verdict == ProofOutcome::Verdict::refuted) {
    for (const auto& [name, value] : outcome.counterexample) entry["counterexample"][name] = value.str();
  }
  if (!file.kept) entry["steps"] = outcome.steps;
  entry["left_with"] = outcome.leftover;
  return entry;
}

/// Adds to each mistake the claim that the statement was made from.
InputError naming_claims(const InputError& error, const std::map<std::string, std::string>& claims) {
  std::vector<Diagnostic> diagnostics = error.diagnostics();
  for (Diagnostic& diagnostic : diagnostics) {
    const auto claim = claims.find(diagnostic.file);
    if (claim != claims.end()) diagnostic.message = claim->second + ": " + diagnostic.message;
  }
  return InputError(std::move(diagnostics));
}

}  // namespace

/// The statements of a claim in a reading, as `expect` requires.
struct ProveRun::Stated {
  const Claim* claim;
  Reading reading;
  std::vector<NamedStatement> statements;
};

ProveRun::ProveRun(const ProveOptions& options, const CommonOptions& common, Inputs inputs)
    : options_(options), common_(common), inputs_(std::move(inputs)), line_(!common.quiet) {
  options_.threads = common.threads;
  if (line_.is_shown()) options_.progress = [this](const ProveProgress& progress) { tell(progress); };
}

void ProveRun::tell(const ProveProgress& progress) {
  std::string note;
  if (progress.steps > 0) {
    note = fmt::format("{}: {} million steps of {}", progress.theorem, progress.steps / 1'000'000,
                       options_.limits.steps / 1'000'000);
  }
  line_.at(progress.done, progress.all, note);
}

void ProveRun::note(const std::string& line) {
  if (common_.json || common_.quiet) return;
  line_.make_way();
  print(line + '\n');
}

void ProveRun::write(const FileOutcome& file) const {
  if (file.kept) return;
  const std::filesystem::path certificate = certificate_of(file.statement);
  const ProofOutcome& outcome = file.outcome;
  write_file(certificate, outcome.proved() ? outcome.certificate : undecided_text(outcome.theorem, reasons(outcome)),
             inputs_, Targets::files);
}

void ProveRun::say(const FileOutcome& file) {
  std::string text = as_text(file, options_.limits.steps);
  text.pop_back();
  note(text);
}

void ProveRun::prove(const std::vector<std::filesystem::path>& statements) {
  for (const std::filesystem::path& statement : statements) inputs_.add(statement);
  for (const std::filesystem::path& statement : statements)
    OutputFile(certificate_of(statement), inputs_, Targets::files);
  // Results are written at once, but reported in the order of the files.
  std::vector<std::optional<FileOutcome>> waiting(statements.size());
  std::size_t next = 0;
  options_.finished = [&](std::size_t index, const FileOutcome& outcome) {
    write(outcome);
    waiting[index] = outcome;
    for (; next < waiting.size() && waiting[next]; ++next) say(*waiting[next]);
  };
  for (FileOutcome& outcome : prove_files(statements, options_)) outcomes_.push_back(std::move(outcome));
}

/// The result of `write` for a claim. If statements cannot be written or read, only this claim fails.
template <class Write>
std::vector<NamedStatement> ProveRun::sound(const Claim& claim, const Write& write) {
  std::vector<NamedStatement> statements;
  const std::string why = failure_of([&] {
    statements = write();
    for (const NamedStatement& s : statements) prove::Statement(s.name, s.text);
  });
  if (why.empty()) return statements;
  failed_.push_back({claim.id, why});
  return {};
}

std::vector<ProveRun::Stated> ProveRun::stated(const ClaimsFile& file) {
  std::vector<Stated> result;
  StatementNames names(file);
  for (const Claim& claim : file.claims) {
    for (const Reading reading : all_readings) {
      if (reading == Reading::repaired && !claim.repaired) continue;
      result.push_back({&claim, reading, sound(claim, [&] { return expected_statements(file, claim, reading); })});
      names.add(claim, result.back().statements);
    }
  }
  return result;
}

const ProofOutcome* ProveRun::outcome(const std::string& theorem) const {
  for (const FileOutcome& file : outcomes_) {
    if (file.outcome.theorem == theorem) return &file.outcome;
  }
  return nullptr;
}

/// Statements that show that the claim is false, after a first search: the refutation at a counterexample to one of its
/// statements; or, if some of these are undecided, a refutation by the statements of the other direction.
std::vector<NamedStatement> ProveRun::refutations(const ClaimsFile& file, const Stated& stated) {
  using Verdict = ProofOutcome::Verdict;
  bool open = false;
  for (const NamedStatement& statement : stated.statements) {
    const ProofOutcome* found = outcome(statement.name);
    if (found == nullptr) continue;
    if (statement.refutes && found->verdict == Verdict::refuted) return refutation_at(statement, found->counterexample);
    open = open || found->verdict == Verdict::undecided;
  }
  if (!open) return {};
  const bool expects_refutation = stated.claim->body(stated.reading).expect == Expectation::refuted;
  if (!expects_refutation) {
    auto others = claim_refutation(file, *stated.claim, stated.reading);
    const auto is_proved = [&](const NamedStatement& s) {
      return prove_statement(s.name, s.text, options_.limits).proved();
    };
    return std::all_of(others.begin(), others.end(), is_proved) ? others : std::vector<NamedStatement>{};
  }
  for (const NamedStatement& statement : claim_statements(file, *stated.claim, stated.reading)) {
    if (!statement.refutes) continue;
    const ProofOutcome found = prove_statement(statement.name, statement.text, options_.limits);
    if (found.verdict != Verdict::refuted) continue;
    for (const NamedStatement& s : stated.statements) settled_[s.name] = "refuted by " + statement.name + ".refuted";
    return refutation_at(statement, found.counterexample);
  }
  return {};
}

void ProveRun::prove_claims(const ClaimsFile& file, const PaperFolder& paper) {
  const std::filesystem::path generated = paper.generated();
  std::map<std::string, std::string> claims;  // by file
  std::set<std::filesystem::path> written;
  const auto write_statement = [&](const NamedStatement& statement, const Claim& claim) {
    const std::filesystem::path path = generated / (statement.name + ".statement");
    write_file(path, statement.text, inputs_, Targets::files);
    claims.emplace(path.string(), "claim " + claim.id + " (line " + std::to_string(claim.line) + ")");
    written.insert(path);
    return path;
  };
  try {
    const std::vector<Stated> all = stated(file);
    const std::string canonical = canonical_claims(file);
    if (!canonical.empty()) write_file(generated / canonical_name, canonical, inputs_, Targets::files);
    for (const Stated& one : all) {
      for (const NamedStatement& statement : one.statements) write_statement(statement, *one.claim);
    }
    // Other files in the folder of generated statements are from claims that have changed.
    std::vector<std::filesystem::path> statements = statements_in(paper.folder);
    std::erase_if(statements, [&](const auto& path) { return !paper.owns(path); });
    const auto is_outdated = [&](const std::filesystem::path& path) {
      return !written.contains(path) && path.lexically_relative(generated).begin()->string() != "..";
    };
    std::vector<std::filesystem::path> old;
    std::copy_if(statements.begin(), statements.end(), std::back_inserter(old), is_outdated);
    std::erase_if(statements, is_outdated);
    prove(statements);
    std::vector<std::filesystem::path> more;
    for (const Stated& one : all) {
      const auto found = sound(*one.claim, [&] { return refutations(file, one); });
      for (const NamedStatement& s : found) more.push_back(write_statement(s, *one.claim));
    }
    if (!more.empty()) prove(more);
    for (const auto& [theorem, why] : settled_) {
      for (const char* ending : {".statement", ".cert"}) std::filesystem::remove(generated / (theorem + ending));
      note("settled   " + theorem + ": the claim is " + why);
    }
    for (const std::filesystem::path& path : old) {
      if (!written.contains(path)) outdated_.push_back(path.stem().string());
    }
    unstated_ = unstated_claims(file);
    for (const UnstatedClaim& claim : unstated_) note("no statement of " + claim.id + ": " + claim.why);
    for (const UnstatedClaim& claim : failed_) note("failed    " + claim.id + ": " + claim.why);
    for (const std::string& name : outdated_)
      note("outdated  " + name + ": no claim says this; the file was not changed");
  } catch (const InputError& error) {
    throw naming_claims(error, claims);
  }
}

Exit ProveRun::conclude() {
  using Verdict = ProofOutcome::Verdict;
  const auto count = [&](Verdict verdict) {
    return std::count_if(outcomes_.begin(), outcomes_.end(), [&](const FileOutcome& file) {
      return file.outcome.verdict == verdict && !settled_.contains(file.outcome.theorem);
    });
  };
  const auto kept =
      std::count_if(outcomes_.begin(), outcomes_.end(), [](const FileOutcome& file) { return file.kept; });
  const auto proved = count(Verdict::proved), refuted = count(Verdict::refuted), left = count(Verdict::undecided);
  const Exit exit = refuted > 0                                         ? refuted_or_not_certified
                    : left > 0 || outcomes_.empty() || !failed_.empty() ? undecided
                                                                        : as_it_should_be;
  if (common_.json) {
    Json document, theorems = Json::array();
    for (const FileOutcome& file : outcomes_) {
      if (!settled_.contains(file.outcome.theorem)) theorems.push_back(as_json(file));
    }
    document["schema"] = "slipproof/prove/1";
    document["effort"] = options_.limits.steps;
    document["theorems"] = std::move(theorems);
    if (!outdated_.empty()) document["outdated"] = outdated_;
    for (const UnstatedClaim& claim : unstated_) {
      document["unstated"].push_back(Json{{"claim", claim.id}, {"why", claim.why}});
    }
    for (const UnstatedClaim& claim : failed_) {
      document["failed"].push_back(Json{{"claim", claim.id}, {"why", claim.why}});
    }
    print(dump(document));
    return exit;
  }
  const char* word = refuted > 0 ? "s REFUTED " : exit == undecided ? "s UNDECIDED " : "s PROVED ";
  print(word + std::to_string(proved) + " proved" + (kept > 0 ? " (" + std::to_string(kept) + " kept)" : "") +
        (refuted > 0 ? ", " + std::to_string(refuted) + " refuted" : "") + ", " + std::to_string(left) + " undecided" +
        (unstated_.empty() ? "" : ", " + counted(unstated_.size(), "claim") + " without a statement") +
        (failed_.empty() ? "" : ", " + counted(failed_.size(), "claim") + " failed") + "\n");
  return exit;
}

}  // namespace slipproof::cli
