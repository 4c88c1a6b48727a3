#include "records/problems/problem_batch.hpp"

#include <fmt/format.h>

#include <atomic>
#include <limits>

#include "base/parallel/in_parallel.hpp"
#include "contact/formats/problem_check.hpp"

namespace slipproof {

namespace {

/// Those of problem k among the numbers of all.
std::vector<double> part(std::span<const double> numbers, std::size_t k, std::size_t size) {
  if (numbers.empty()) return {};
  const auto own = numbers.subspan(k * size, size);
  return {own.begin(), own.end()};
}

ReadProblem problem_at(const ProblemBatch& batch, std::size_t k, const std::string& name) {
  ReadProblem read{batch.common, {}};
  ProblemFile& problem = read.problem;
  const std::size_t size = batch.q.size() / batch.count;
  if (!batch.W.empty()) problem.W = from_dense(size, size, batch.W.subspan(k * size * size, size * size));
  problem.q = part(batch.q, k, size);
  if (!batch.mu.empty()) problem.mu = part(batch.mu, k, problem.contacts());
  if (!batch.z.empty()) read.answers.push_back({"z", part(batch.z, k, size), part(batch.w, k, size), {}, {}});
  Mistakes mistakes(name);
  check_problem(problem, mistakes);
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
