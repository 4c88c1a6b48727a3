#include "claims/verify/conclusion.hpp"

#include <utility>

#include "base/parallel/failure.hpp"
#include "claims/identity/vacuous.hpp"

namespace slipproof {

namespace {

void write_simplified(ByteWriter& bytes, const std::optional<Simplified>& found) {
  bytes.number(found && found->minimal ? 1 : 0).rationals(found ? found->values : std::vector<Rational>{});
}

std::optional<Simplified> read_simplified(ByteReader& bytes) {
  const bool minimal = bytes.number() != 0;
  std::vector<Rational> values = bytes.rationals();
  return values.empty() ? std::nullopt : std::optional(Simplified{std::move(values), minimal});
}

void add_counterexamples(const PaperTasks& tasks, const SimplestFailures& failures, ClaimResult& result) {
  const std::string why = failure_of([&] {
    auto found = counterexamples(tasks.file, tasks.compiled, result.claim, result.reading, failures);
    result.counterexample = std::move(found.shown);
    result.simplest = std::move(found.simpler);
  });
  if (result.failure.empty()) result.failure = why;
}

}  // namespace

std::string conclusion_bytes(const Conclusion& conclusion) {
  ByteWriter bytes;
  bytes.number(conclusion.vacuous ? 1 : 0);
  write_simplified(bytes, conclusion.failures ? std::optional(conclusion.failures->shown) : std::nullopt);
  write_simplified(bytes, conclusion.failures ? conclusion.failures->simpler : std::nullopt);
  bytes.text(conclusion.failure);
  return bytes.take();
}

Conclusion read_conclusion(std::string_view text) {
  ByteReader bytes(text);
  Conclusion conclusion{.vacuous = bytes.number() != 0, .failures = {}, .failure = {}};
  std::optional<Simplified> shown = read_simplified(bytes), simpler = read_simplified(bytes);
  if (shown) conclusion.failures = SimplestFailures{*std::move(shown), std::move(simpler)};
  conclusion.failure = bytes.text();
  bytes.end();
  return conclusion;
}

bool is_concluded(const PaperTasks& tasks, const ClaimTask& task, const Tally& tally) {
  if (tally.refuted > 0) return false;
  if (tally.held > 0) return true;
  return tasks.options.certificates && tasks.claim_of(task).kind().traits().seeks &&
         settled_by_certificates(tasks.file, task.claim, task.reading, *tasks.options.certificates);
}

Conclusion conclude(const PaperTasks& tasks, const ClaimTask& task, const Tally& tally) {
  Conclusion found;
  found.failure = failure_of([&] {
    if (tally.refuted > 0) {
      found.failures = simplest_failures(
          tasks.file, tasks.compiled, task.claim, task.reading, {tally.simplest.values, tally.realisable.values},
          tasks.options.simplify ? Showing::simplest : Showing::as_found, tasks.options.seed);
    } else if (tasks.claim_of(task).kind().traits().seeks) {
      found.vacuous = is_nowhere(tasks.file, task.claim, task.reading, tasks.book);
    } else {
      found.vacuous = tally.undecided == 0 && is_vacuous(tasks.file, task.claim, task.reading, tasks.book);
    }
  });
  return found;
}

ClaimResult result_of(const PaperTasks& tasks, const ClaimTask& task, const Tally& tally,
                      const Conclusion& conclusion) {
  ClaimResult result;
  result.claim = task.claim;
  result.reading = task.reading;
  result.tried = tally.tried;
  result.held = tally.held;
  result.refuted = tally.refuted;
  result.undecided = tally.undecided;
  result.unsure = tally.unsure;
  result.lines = tally.lines;
  result.cells = tally.cells;
  if (task.identity) {
    result.unless_zero = task.identity->unless_zero;
    result.unless_interval = !task.identity->has_interval_of_forces;
  }
  for (const std::string& why : {task.failure, tally.failure, conclusion.failure}) {
    if (result.failure.empty()) result.failure = why;
  }
  if (tally.refuted > 0) {
    result.verdict = Verdict::refuted;
    if (conclusion.failures) add_counterexamples(tasks, *conclusion.failures, result);
  } else if (tasks.claim_of(task).kind().traits().seeks) {
    result.verdict = tally.held > 0 ? Verdict::holds : Verdict::undecided;
    result.proved = tally.held > 0;
    if (conclusion.vacuous) result.verdict = Verdict::refuted;
  } else if (tally.undecided == 0 && tally.held > 0) {
    result.verdict = Verdict::holds;
    result.proved = task.identity && task.identity->proved();
  } else if (conclusion.vacuous) {
    result.verdict = Verdict::vacuous;
  }
  yield_to_failure(result);
  return result;
}

}  // namespace slipproof
