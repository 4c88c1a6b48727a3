#include "records/problems/contact_record.hpp"

#include "contact/formats/read_files.hpp"
#include "records/judging/judge.hpp"
#include "records/problems/contact_file.hpp"
#include "records/problems/problem_judge.hpp"

namespace slipproof {

RecordJudgement judge_contact_line(const JsonProblem& json, const CertifyOptions& options) {
  if (options.decimal_exact) {
    throw BrokenRecord{0, "found a problem whose decimals mean the nearest binary64, expected one of W, q and z alone"};
  }
  ReadProblem given = of_line([&] { return read_problem_line(json); });
  return judged_or_undecided([&] {
    const JudgedProblem problem =
        judge_problem_file(options.file, std::move(given), {options.contact, std::nullopt, options.law});
    return as_record(problem, 0);
  });
}

RecordJudgement as_record(const JudgedProblem& problem, std::size_t answer) {
  RecordJudgement result;
  const ContactJudgement& judgement = problem.answers[answer].judgement;
  result.verdict = record_verdict(judgement.verdict);
  result.others_excluded = !is_certified(judgement.verdict) || judgement.others_excluded();
  result.eps_solution = judgement.verdict == ContactVerdict::eps_solution;
  if (judgement.enclosure || judgement.every) result.tier = Tier::filter;  // with proved bounds on rounding
  result.rho = judgement.rho;
  result.members = contact_members(problem, answer);
  return result;
}

}  // namespace slipproof
