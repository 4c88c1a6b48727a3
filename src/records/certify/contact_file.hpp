// Certifying answers to contact problems at real size: a file in, a line of JSON for each answer, and a summary in
// words.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/formats/problem_file.hpp"
#include "contact/judge/judge.hpp"

namespace slipproof {

struct ContactFileOptions {
  ContactJudgeOptions judge;
  std::optional<SolverAnswer> answer;  ///< from a file of its own, instead of those in the problem's
};

/// One answer to a problem, judged.
struct JudgedAnswer {
  std::string origin;  ///< `/solution`, a file's name, `found here`
  ContactJudgement judgement;
};

/// A problem with everything that was found about it; enclosures point into it, so it stays where it is.
struct JudgedProblem {
  std::string file;
  ProblemFile problem;
  MixedProblem mixed;
  std::vector<JudgedAnswer> answers;

  JudgedProblem(std::string name, ReadProblem read, const ContactFileOptions& options);
  JudgedProblem(const JudgedProblem&) = delete;
  JudgedProblem& operator=(const JudgedProblem&) = delete;

  /// The first answer counts: it is what the file, or the user, calls the solution.
  const JudgedAnswer& first() const { return answers.front(); }
};

/// Judges the answer that is given, or all that stand in the problem's file; without any, and with judge.refine, one is
/// looked for. There is always one answer: `undecided` where none is given or found.
JudgedProblem judge_problem_file(std::string file, ReadProblem read, const ContactFileOptions& options);

/// {"record":1,"problem":...} in one line, without a newline.
std::string contact_line(const JudgedProblem& problem, std::size_t answer);
/// What follows the number of the record in it: `,"problem":...`, without the brace at its end.
std::string contact_members(const JudgedProblem& problem, std::size_t answer);

/// In words: which contacts, which law, by how much, and whether the cause is the answer, the pyramid, or the problem.
std::string contact_words(const JudgedProblem& problem, std::size_t answer);

/// The sentence for the verdict.
std::string verdict_words(const ContactJudgement& judgement);
/// What there is to say beyond the verdict and the backward error, in sentences: why nothing stronger is proved, a
/// pyramid that the answer is right for, velocities that are not those of the forces, undetermined forces.
std::vector<std::string> further_words(const ContactJudgement& judgement);

/// A bound that is not negative in three digits, `1.23e-12`: an upper one rounded up, a lower one rounded down.
std::string at_most(double bound);
std::string at_least(double bound);

/// The improved answer, {"r":[..],"u":[..],"v":[..],"lambda":[..],"radius":[..]}, with guaranteed digits: each number
/// is within its radius of an exact solution. Empty if nothing is enclosed.
std::string refined_answer(const JudgedProblem& problem, std::size_t answer);

}  // namespace slipproof
