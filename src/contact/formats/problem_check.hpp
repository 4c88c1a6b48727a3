// The conditions that every problem must satisfy, in any format, and the remarks about it.
#pragma once

#include <optional>
#include <string>

#include "base/input/diagnostic.hpp"
#include "contact/formats/problem_file.hpp"

namespace slipproof {

/// Sizes fit each other, all numbers are finite, coefficients of friction are not negative. Reports every size that
/// does not fit, and of each matrix and vector the first number that does not. Rows and columns count from 1. Linear.
void check_problem(const ProblemFile& problem, Mistakes& mistakes);

/// The dimension of contacts with friction, if a file does not give it: 2 or 3 components for each coefficient, or for
/// each contact if one number is the coefficient of all (`coefficients` is nothing). If the sizes leave it open, or fit
/// neither, returns a mistake that begins with the key.
struct DimensionBySizes {
  std::size_t dimension = 0;
  std::string key, mistake;  ///< empty where the dimension is known
};
DimensionBySizes dimension_by_sizes(std::size_t components, std::optional<std::size_t> coefficients);

AnswerSizes answer_sizes(const ProblemFile& problem);

/// The parts that an answer gives have the sizes of the problem's. NaN and infinities are no mistake here. `where` is
/// how messages call the answer.
void check_answer(const ProblemFile& problem, const SolverAnswer& answer, const std::string& where, Mistakes& mistakes);

/// The largest difference of two opposite entries, and the largest entry.
struct Asymmetry {
  double difference = 0, largest = 0;
  std::size_t row = 0, column = 0;  ///< counted from 0: the first entry that differs most from its opposite
};
/// The asymmetry of a square matrix, rounded to binary64.
Asymmetry asymmetry(const SparseMatrix& matrix);

/// Why an answer with r = 0 is not a solution: a sentence without a full stop. Nothing if r is not 0 or not given, or
/// nothing contradicts it by more than rounding. Files of the field store such answers with problems that nobody
/// solved.
std::optional<std::string> contradiction(const ProblemFile& problem, const SolverAnswer& answer);

/// Adds to the remarks that a matrix is asymmetric (of a complementarity problem it may be), that there is no contact,
/// and what contradicts an answer called /solution. The problem must have passed `check_problem`.
void add_remarks(ReadProblem& read);

}  // namespace slipproof
