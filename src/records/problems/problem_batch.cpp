#include "records/problems/problem_batch.hpp"

#include <fmt/format.h>

#include <atomic>
#include <limits>

#include "base/parallel/in_parallel.hpp"
#include "contact/formats/problem_check.hpp"

namespace slipproof {

namespace {

/// The numbers of problem k among those of all.
std::span<const double> part(std::span<const double> numbers, std::size_t k, std::size_t count) {
  const std::size_t size = numbers.size() / count;
  return numbers.subspan(k * size, size);
}

ReadProblem problem_at(const ProblemBatch& batch, std::size_t k, const std::string& name) {
  ReadProblem read{batch.common, {}};
  ProblemFile& p = read.problem;
  const auto vector = [&](std::span<const double> numbers, std::vector<double>& to) {
    const auto own = part(numbers, k, batch.count);
    if (!own.empty()) to.assign(own.begin(), own.end());
  };
  const auto matrix = [&](std::span<const double> numbers, std::size_t rows, SparseMatrix& to) {
    const auto own = part(numbers, k, batch.count);
    if (!own.empty()) to = from_dense(rows, own.size() / rows, own);
  };
  vector(batch.q, p.q), vector(batch.f, p.f), vector(batch.w, p.w), vector(batch.mu, p.mu);
  if (p.impact) vector(batch.before, p.impact->before);
  matrix(batch.W, p.q.size(), p.W), matrix(batch.M, p.f.size(), p.M), matrix(batch.H, p.f.size(), p.H);
  if (!batch.r.empty()) {
    SolverAnswer answer{p.form == ProblemForm::global ? "r" : "z", {}, {}, {}, {}};
    vector(batch.r, answer.r), vector(batch.u, answer.u), vector(batch.v, answer.v);
    read.answers.push_back(std::move(answer));
  }
  Mistakes mistakes(name);
  check_problem(p, mistakes);
  mistakes.refuse_if_any();
  return read;
}

}  // namespace

BatchVerdicts judge_batch(const ProblemBatch& batch, const ContactFileOptions& options,
                          const std::function<void(std::uint64_t)>& progress) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  BatchVerdicts result{std::vector<ContactVerdict>(batch.count), std::vector<double>(batch.count, unknown),
                       std::vector<double>(batch.count, unknown), std::vector<std::string>(batch.count)};
  std::atomic<std::uint64_t> done = 0;
  in_parallel(0, batch.count, [&](std::size_t k) {
    const std::string name = fmt::format("problem {}", k + 1);
    const JudgedProblem judged(name, problem_at(batch, k, name), options);
    const ContactJudgement& found = judged.first().judgement;
    result.verdicts[k] = found.verdict;
    if (found.has_solution()) result.rho[k] = found.rho;
    if (found.residual) result.backward_error[k] = found.residual->backward_error();
    result.lines[k] = fmt::format("{{\"record\":{}{}}}", k + 1, contact_members(judged, 0));
    if (progress) progress(++done);
  });
  return result;
}

}  // namespace slipproof
