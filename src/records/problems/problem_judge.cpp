#include "records/problems/problem_judge.hpp"

#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "base/output/json.hpp"
#include "contact/judge/all_solutions_json.hpp"
#include "contact/problem/every_load_json.hpp"

namespace slipproof {

namespace {

/// What was found, in the words of a record.
class ProblemRecordWriter {
 public:
  ProblemRecordWriter(const ContactProblem& problem, const ProblemAnswer& answer, const JudgeOptions& options)
      : problem_(problem), answer_(answer), options_(options) {}

  RecordJudgement write() {
    try {
      Effort effort(options_.effort);
      tell(judge_small(problem_, answer_, options_.tolerance, effort));
      if (options_.every_q) tell_every_q();
    } catch (const TooMuchWork&) {
      result_ = RecordJudgement();
      result_.verdict = RecordVerdict::undecided;
      details_ = Json{{"reason", too_much_work(unlimited, options_.effort)}};
    }
    if (!details_.empty()) result_.details = "," + inner_json_text(details_);
    return std::move(result_);
  }

 private:
  void tell(const SmallJudgement& found) {
    const FoundSolution* meant = found.meant();
    const bool all = found.all.complete();
    result_.verdict = record_verdict(found.verdict);
    result_.counted = all || meant != nullptr;
    if (meant != nullptr) {
      result_.mode_names = inner_json_text(meant->modes);
      result_.max_error = enclose(found.distance.relative).upper;
    }
    if (result_.counted) {
      result_.motions = found.all.singles();
      result_.continuum = found.all.families() > 0;
    }
    if (found.unique_by) details_["unique_by"] = name(*found.unique_by);
    if (found.own) add_own_mode(*found.own, details_);
    if (all && (result_.verdict != RecordVerdict::certified || !found.all.one())) add_solutions(found.all, details_);
    if (all || found.unique_by || (found.own && found.own->claimed)) return;
    if (meant != nullptr) {
      details_["reason"] =
          result_.continuum ? "in a mode with a continuum of solutions" : "near the solution of its mode";
    }
    details_["unexamined"] = "the other modes: " + too_much_work(found.needed, options_.effort);
  }

  void tell_every_q() {
    Effort again(options_.effort);
    const EveryLoad found = for_every_load(problem_, again);
    details_["every_q"] = slipproof::to_json(found, found.mode ? name(problem_, *found.mode) : "");
  }

  const ContactProblem& problem_;
  const ProblemAnswer& answer_;
  const JudgeOptions& options_;
  RecordJudgement result_;
  Json details_ = Json::object();
};

}  // namespace

RecordVerdict record_verdict(ContactVerdict verdict) {
  if (is_certified(verdict)) return RecordVerdict::certified;
  switch (verdict) {
    case ContactVerdict::ambiguous:
      return RecordVerdict::ambiguous;
    case ContactVerdict::inaccurate:
    case ContactVerdict::not_converged:
    case ContactVerdict::eps_solution:
      return RecordVerdict::inaccurate;
    case ContactVerdict::invalid:
      return RecordVerdict::invalid;
    case ContactVerdict::undecided:
      return RecordVerdict::undecided;
    default:
      return RecordVerdict::wrong;
  }
}

RecordJudgement judge_problem(const ContactProblem& problem, const ProblemAnswer& answer, const JudgeOptions& options) {
  RecordJudgement result = judged_or_undecided([&] { return ProblemRecordWriter(problem, answer, options).write(); });
  result.contact_problem = true;
  return result;
}

}  // namespace slipproof
