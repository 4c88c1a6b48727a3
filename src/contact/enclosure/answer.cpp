#include "contact/enclosure/answer.hpp"

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

namespace slipproof {

bool complete_free_unknowns(const MixedProblem& problem, std::vector<double>& x) {
  if (problem.free == 0) return true;
  using Matrix = Eigen::SparseMatrix<double>;
  const auto n = static_cast<Eigen::Index>(problem.free);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right(n);
  for (std::size_t i = 0; i < problem.free; ++i) {
    double sum = problem.c[i];
    const auto columns = problem.A.columns_of(i);
    for (std::size_t e = 0; e < columns.size(); ++e) {
      const double a = problem.A.values_of(i)[e];
      if (columns[e] < problem.free) {
        entries.emplace_back(static_cast<int>(i), static_cast<int>(columns[e]), a);
      } else {
        sum += a * x[columns[e]];
      }
    }
    right[static_cast<Eigen::Index>(i)] = -sum;
  }
  Matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Matrix> lu(matrix);
  if (lu.info() != Eigen::Success) return false;
  const Eigen::VectorXd found = lu.solve(right);
  if (lu.info() != Eigen::Success || !found.allFinite()) return false;
  std::copy(found.data(), found.data() + n, x.begin());
  return true;
}

std::vector<double> answer_vector(const ProblemFile& file, const MixedProblem& problem, const SolverAnswer& answer,
                                  std::string& reason) {
  const std::size_t bodies = file.form == ProblemForm::global ? file.M.rows : 0, bilateral = problem.free - bodies;
  const auto sized = [&](const std::vector<double>& part, std::size_t size, const char* what, bool needed) {
    if (part.size() == size || (part.empty() && !needed)) return;
    if (!reason.empty()) return;
    reason = "found " + std::to_string(part.size()) + " numbers in " + what + ", expected " + std::to_string(size);
  };
  const std::size_t components = problem.size() - problem.free;
  sized(answer.r, components, "r", true);
  sized(answer.u, components, "u", false);
  sized(answer.v, bodies, "v", false);
  sized(answer.lambda, bilateral, "lambda", false);
  if (!reason.empty()) return {};
  std::vector<double> x(problem.free, 0);
  x.insert(x.end(), answer.r.begin(), answer.r.end());
  const bool has_v = answer.v.size() == bodies, has_lambda = answer.lambda.size() == bilateral;
  if (has_v && has_lambda) {
    std::copy(answer.v.begin(), answer.v.end(), x.begin());
    std::copy(answer.lambda.begin(), answer.lambda.end(), x.begin() + static_cast<std::ptrdiff_t>(bodies));
  } else if (std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); }) &&
             !complete_free_unknowns(problem, x)) {
    reason = "the answer has no v or lambda, and the rows for them have no one solution";
  }
  return x;
}

}  // namespace slipproof
