#include "faces/cli/commands/papers/prove_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/number/format.hpp"
#include "base/parallel/stop.hpp"
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

Json as_json(const TheoremChanges& file) {
  return {{"file", file.file.string()},
          {"new", file.added},
          {"changed", file.changed},
          {"removed", file.removed},
          {"as_before", file.as_before}};
}

}  // namespace

ProveRun::ProveRun(const ProveOptions& options, const CommonOptions& common, Inputs inputs)
    : options_(options), common_(common), output_(std::move(inputs)), line_(!common.quiet) {
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

void ProveRun::write(const FileOutcome& file) {
  if (file.kept) return;
  const ProofOutcome& outcome = file.outcome;
  output_.put(file.statement,
              outcome.proved() ? outcome.certificate : undecided_text(outcome.theorem, reasons(outcome)));
}

void ProveRun::say(const FileOutcome& file) {
  std::string text = as_text(file, options_.limits.steps);
  text.pop_back();
  note(text);
}

void ProveRun::contain(const std::filesystem::path& file, TheoremFile contents) {
  output_.contain(file, std::move(contents));
}

void ProveRun::prove(const std::vector<StatementSource>& statements) {
  output_.prepare(statements);
  // Results are written at once, but reported in the order of the files.
  std::vector<std::optional<FileOutcome>> waiting(statements.size());
  std::size_t next = 0;
  options_.finished = [&](std::size_t index, const FileOutcome& outcome) {
    write(outcome);
    waiting[index] = outcome;
    for (; next < waiting.size() && waiting[next]; ++next) say(*waiting[next]);
  };
  try {
    for (FileOutcome& outcome : prove_files(statements, options_)) outcomes_.push_back(std::move(outcome));
  } catch (const Stopped&) {
    output_.save();
    throw;
  }
}

void ProveRun::save() {
  output_.save();
  changes_ = output_.changes();
  for (const TheoremChanges& file : changes_) {
    for (const std::string& name : file.removed) note("removed   " + name + ": no claim says this");
    note(fmt::format("wrote     {}: {} new, {} changed, {} removed, {} as before", file.file.string(), file.added,
                     file.changed, file.removed.size(), file.as_before));
  }
}

Exit ProveRun::conclude() {
  save();
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
                                                                        : success;
  if (common_.json) {
    Json document, theorems = Json::array();
    for (const FileOutcome& file : outcomes_) {
      if (!settled_.contains(file.outcome.theorem)) theorems.push_back(as_json(file));
    }
    document["schema"] = "slipproof/prove/1";
    document["effort"] = options_.limits.steps;
    document["theorems"] = std::move(theorems);
    for (const TheoremChanges& changes : changes_) document["files"].push_back(as_json(changes));
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
