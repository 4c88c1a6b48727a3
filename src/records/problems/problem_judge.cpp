#include "records/problems/problem_judge.hpp"

#include "base/number/binary64.hpp"
#include "base/number/format.hpp"
#include "base/output/json.hpp"
#include "contact/judge/small_json.hpp"
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
    result_.verdict = record_verdict(found.verdict);
    if (found.near()) {
      result_.mode_names = inner_json_text(modes_json(problem_, found.meant->modes));
      result_.max_error = enclose(found.meant->distance.relative).upper;
    }
    if (found.unique_by) details_["unique_by"] = name(*found.unique_by);
    if (found.all) {
      tell_all(found);
    } else if (found.near()) {
      tell_its_mode(found);
    } else {
      result_.counted = false;
      add_own_mode(problem_, answer_, found, details_);
      if (found.verdict == ContactVerdict::undecided) details_["unexamined"] = others_unexamined(found);
    }
  }

  /// All solutions are known.
  void tell_all(const SmallJudgement& found) {
    result_.motions = found.all->solutions.size();
    result_.continuum = !found.all->continua.empty();
    if (found.own) add_own_mode(problem_, answer_, found, details_);
    if (result_.verdict == RecordVerdict::certified) return;
    add_solutions(problem_, found, details_);
  }

  /// The answer is the solution of its mode, or one of them; the other modes were not tried.
  void tell_its_mode(const SmallJudgement& found) {
    result_.continuum = found.own->continuum.has_value();
    result_.motions = result_.continuum ? 0 : 1;
    if (found.unique_by) return;
    details_["reason"] =
        result_.continuum ? "in a mode with a continuum of solutions" : "near the solution of its mode";
    details_["unexamined"] = others_unexamined(found);
  }

  void tell_every_q() {
    Effort again(options_.effort);
    const EveryLoad found = for_every_load(problem_, again);
    details_["every_q"] = slipproof::to_json(found, found.mode ? name(problem_, *found.mode) : "");
  }

  std::string others_unexamined(const SmallJudgement& found) const {
    return "the other modes: " + too_much_work(found.needed, options_.effort);
  }

  const ContactProblem& problem_;
  const ProblemAnswer& answer_;
  const JudgeOptions& options_;
  RecordJudgement result_;
  Json details_ = Json::object();
};

}  // namespace

RecordVerdict record_verdict(ContactVerdict verdict) {
  switch (verdict) {
    case ContactVerdict::unique:
    case ContactVerdict::solution_within_rho:
    case ContactVerdict::velocities_within_rho:
    case ContactVerdict::velocities_of_a_solution:
      return RecordVerdict::certified;
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
