// Certifies answers to contact problems at real size: judges those of a file, with a line of JSON for each.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/formats/problem_file.hpp"
#include "contact/impact/step_energy.hpp"
#include "contact/judge/judge.hpp"

namespace slipproof {

struct ContactFileOptions {
  ContactJudgeOptions judge;
  std::optional<SolverAnswer> answer;  ///< answer from a separate file; replaces those in the problem's file
  std::optional<FrictionLaw> law;      ///< replaces the law that the problem names
};

/// A judged answer to a problem.
struct JudgedAnswer {
  std::string origin;  ///< `/solution`, a file's name, `found here`
  ContactJudgement judgement = {};
  std::optional<ContactJudgement> coulomb =
      {};                                 ///< the same forces under Coulomb's law for rigid bodies, if that differs
  std::optional<StepEnergy> energy = {};  ///< of an answer in finite numbers to a problem with an impact
};

/// A problem and everything that was found about it. It must not move, because enclosures point into it.
struct JudgedProblem {
  std::string file;
  double tolerance = 0;
  ProblemFile problem;
  MixedProblem mixed;                 ///< the problem with the solver's law, compliance and bias
  std::optional<MixedProblem> rigid;  ///< the problem with Coulomb's law, without compliance and bias, if that differs
  std::vector<JudgedAnswer> answers;

  JudgedProblem(std::string name, ReadProblem read, const ContactFileOptions& options);
  JudgedProblem(const JudgedProblem&) = delete;
  JudgedProblem& operator=(const JudgedProblem&) = delete;

  /// The first answer decides: it is what the file or the user calls the solution.
  const JudgedAnswer& first() const { return answers.front(); }
};

/// Judges the given answer, or all in the problem's file. If there is none but wrong guesses and judge.refine is set,
/// searches for one, which is then the first.
/// The result always has an answer: `undecided` if none is given or found.
JudgedProblem judge_problem_file(std::string file, ReadProblem read, const ContactFileOptions& options);

/// {"record":1,"problem":...} in one line, without a newline.
std::string contact_line(const JudgedProblem& problem, std::size_t answer);
/// The members after the record's number, `,"problem":...`, without the closing brace.
std::string contact_members(const JudgedProblem& problem, std::size_t answer);

/// The improved answer, {"r":[..],"u":[..],"v":[..],"lambda":[..],"radius":[..]}. Its digits are guaranteed: each
/// number is within its radius of an exact solution. Empty if no solution is enclosed.
std::string refined_answer(const JudgedProblem& problem, std::size_t answer);

}  // namespace slipproof
