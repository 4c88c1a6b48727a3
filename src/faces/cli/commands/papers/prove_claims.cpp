// The claims of a file: their statements, a search for each, refutations after it, and what the theorem file holds
// then.
#include <algorithm>

#include "base/parallel/failure.hpp"
#include "claims/canonical/canonical_claims.hpp"
#include "claims/statements/claim_statements.hpp"
#include "faces/cli/commands/papers/prove_run.hpp"
#include "proofs/statement/statement.hpp"

namespace slipproof::cli {

namespace {

/// Whether a theorem's name begins with that of the claim.
bool is_about(const std::string& theorem, const std::string& claim) {
  return theorem == claim || theorem.starts_with(claim + ".");
}

/// What an earlier run has made of the claims: a theorem file, or a folder.
TheoremFile earlier(const std::filesystem::path& found) {
  if (!std::filesystem::exists(found)) return {};
  if (is_theorem_file(found)) return read_theorems(found);
  TheoremFile result;
  for (const StatementSource& old : read_statements(statements_in(found))) {
    result.theorems.push_back({old.path.stem().string(), old.text, old.certificate.value_or("")});
  }
  return result;
}

void append(std::vector<StatementSource>& all, const std::vector<StatementSource>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// Adds the theorems of `found` that are wanted and not there.
template <class Wanted>
void add_missing(TheoremFile& file, const TheoremFile& found, const Wanted& wanted) {
  for (const Theorem& theorem : found.theorems) {
    if (file.find(theorem.name) == nullptr && wanted(theorem.name)) file.theorems.push_back(theorem);
  }
}

}  // namespace

/// The statements of a claim in a reading, as `expect` requires.
struct ProveRun::Stated {
  const Claim* claim;
  Reading reading;
  std::vector<NamedStatement> statements;
  std::vector<NamedStatement> others{};  ///< those that were found necessary, or proved earlier
};

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

/// The statements in the order of the claims, each with the certificate that it has in `found`.
TheoremFile ProveRun::arranged(const ClaimsFile& file, const std::vector<Stated>& all, const TheoremFile& found) const {
  TheoremFile result{.claims = canonical_claims(file), .theorems = {}};
  for (const Stated& one : all) {
    for (const auto* statements : {&one.statements, &one.others}) {
      for (const auto& [name, text, refutes] : *statements) {
        if (settled_.contains(name) || result.find(name) != nullptr) continue;
        const Theorem* const known = found.find(name);
        result.theorems.push_back({name, text, known == nullptr ? "" : known->certificate});
      }
    }
  }
  return result;
}

/// The statements of both directions that have a certificate from an earlier run, whatever `expect` says now.
void ProveRun::keep_proved(const ClaimsFile& file, std::vector<Stated>& all, const TheoremFile& found) const {
  if (arranged(file, all, found).theorems.size() == found.theorems.size()) return;
  for (Stated& one : all) {
    failure_of([&] {  // what fails here was told of its statements
      for (const auto& stated : {claim_statements, claim_refutation}) {
        for (NamedStatement& statement : stated(file, *one.claim, one.reading)) {
          const Theorem* const known = found.find(statement.name);
          const bool same = known != nullptr && known->statement == statement.text;
          if (same && known->certificate.starts_with("slipproof-certificate "))
            one.others.push_back(std::move(statement));
        }
      }
    });
  }
}

std::vector<StatementSource> ProveRun::sources(const std::vector<NamedStatement>& statements,
                                               const std::filesystem::path& theorems) {
  std::vector<StatementSource> result;
  for (const NamedStatement& statement : statements) {
    const Theorem* const known = output_.contents(theorems).find(statement.name);
    result.push_back({theorems / (statement.name + ".statement"), statement.text});
    if (known != nullptr && !known->certificate.empty()) result.back().certificate = known->certificate;
  }
  return result;
}

void ProveRun::prove_claims(const ClaimsFile& file, const PaperFolder& paper,
                            const std::vector<StatementSource>& by_hand) {
  const std::filesystem::path theorems = paper.theorems(), before = paper.generated();
  std::vector<Stated> all = stated(file);
  // Until all is done, the file also has what it had: a later step may ask for it.
  const auto contain = [&](const TheoremFile& found, const auto& wanted) {
    TheoremFile contents = arranged(file, all, found);
    add_missing(contents, found, wanted);
    output_.contain(theorems, std::move(contents));
  };
  const auto everything = [](const std::string&) { return true; };
  contain(earlier(before), everything);
  std::vector<StatementSource> first = by_hand, more;
  for (const Stated& one : all) append(first, sources(one.statements, theorems));
  prove(first);
  for (Stated& one : all) one.others = sound(*one.claim, [&] { return refutations(file, one); });
  contain(TheoremFile(output_.contents(theorems)), everything);
  for (const Stated& one : all) append(more, sources(one.others, theorems));
  if (!more.empty()) prove(more);
  keep_proved(file, all, output_.contents(theorems));
  contain(TheoremFile(output_.contents(theorems)), [&](const std::string& theorem) {
    return std::any_of(failed_.begin(), failed_.end(), [&](const auto& claim) { return is_about(theorem, claim.id); });
  });
  for (const auto& [theorem, why] : settled_) note("settled   " + theorem + ": the claim is " + why);
  unstated_ = unstated_claims(file);
  for (const UnstatedClaim& claim : unstated_) note("no statement of " + claim.id + ": " + claim.why);
  for (const UnstatedClaim& claim : failed_) note("failed    " + claim.id + ": " + claim.why);
  if (before != theorems)
    note("left      " + before.lexically_normal().string() + ": " + theorems.filename().string() + " replaces it");
}

}  // namespace slipproof::cli
