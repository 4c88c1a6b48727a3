// Certifies answers to contact problems at real size: reads a file, gives a line of JSON for each answer and a summary
// in words.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/formats/problem_file.hpp"
#include "contact/judge/judge.hpp"

namespace slipproof {

struct ContactFileOptions {
  ContactJudgeOptions judge;
  std::optional<SolverAnswer> answer;  ///< from a separate file; replaces those in the problem's file
};

/// A judged answer to a problem.
struct JudgedAnswer {
  std::string origin;  ///< `/solution`, a file's name, `found here`
  ContactJudgement judgement;
};

/// A problem and everything that was found about it. It must not move, because enclosures point into it.
struct JudgedProblem {
  std::string file;
  ProblemFile problem;
  MixedProblem mixed;
  std::vector<JudgedAnswer> answers;

  JudgedProblem(std::string name, ReadProblem read, const ContactFileOptions& options);
  JudgedProblem(const JudgedProblem&) = delete;
  JudgedProblem& operator=(const JudgedProblem&) = delete;

  /// The first answer decides: it is what the file or the user calls the solution.
  const JudgedAnswer& first() const { return answers.front(); }
};

/// Judges the given answer, or all in the problem's file. If there is none and judge.refine is set, searches for one.
/// The result always has an answer: `undecided` if none is given or found.
JudgedProblem judge_problem_file(std::string file, ReadProblem read, const ContactFileOptions& options);

/// {"record":1,"problem":...} in one line, without a newline.
std::string contact_line(const JudgedProblem& problem, std::size_t answer);
/// The members after the record's number, `,"problem":...`, without the closing brace.
std::string contact_members(const JudgedProblem& problem, std::size_t answer);

/// The result in words: which contacts violate which law, by how much, and whether the cause is the answer, the
/// pyramid, or the problem.
std::string contact_words(const JudgedProblem& problem, std::size_t answer);

/// The sentence for the verdict.
std::string verdict_words(const ContactJudgement& judgement);
/// Further sentences, beyond verdict and backward error: why nothing stronger is proved, a pyramid for which the answer
/// is right, velocities that do not belong to the forces, undetermined forces.
std::vector<std::string> further_words(const ContactJudgement& judgement);

/// A nonnegative bound in three digits, `1.23e-12`: an upper bound is rounded up, a lower bound down.
std::string at_most(double bound);
std::string at_least(double bound);

/// The improved answer, {"r":[..],"u":[..],"v":[..],"lambda":[..],"radius":[..]}. Its digits are guaranteed: each
/// number is within its radius of an exact solution. Empty if no solution is enclosed.
std::string refined_answer(const JudgedProblem& problem, std::size_t answer);

}  // namespace slipproof
