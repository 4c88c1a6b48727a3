#include "records/certify/certify.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "base/number/binary64.hpp"
#include "base/parallel/in_parallel.hpp"
#include "contact/formats/problem_check.hpp"
#include "contact/problem/problem.hpp"
#include "faces/c_interface/call.hpp"
#include "faces/c_interface/options.hpp"
#include "records/problems/contact_file.hpp"
#include "records/problems/problem_judge.hpp"

/// A judgement and the texts that it refers to.
struct slipproof_verdict {
  std::string_view word;  ///< ends with a null character, and lives on
  std::string json;
  bool certified = false;
  double error = std::numeric_limits<double>::quiet_NaN();
  double backward_error = std::numeric_limits<double>::quiet_NaN();
};

namespace slipproof::c {

Options options_of(const slipproof_certify_options* given) {
  Options options;
  options.exact.tolerance = options.enclosure.judge.tolerance;
  if (given == nullptr) return options;
  const auto use = [](double from, const char* argument, double& to) {
    if (std::isnan(from)) return;
    if (!(from >= 0 && from <= 1)) throw BadArgument(argument, "expected a number from 0 to 1, or NaN");
    to = from;
  };
  use(given->tolerance, "tolerance", options.scene.tolerance);
  use(given->tolerance, "tolerance", options.exact.tolerance);
  use(given->tolerance, "tolerance", options.enclosure.judge.tolerance);
  use(given->backward_tolerance, "backward_tolerance", options.enclosure.judge.tolerance);
  if (given->effort != 0) {
    options.scene.effort = options.exact.effort = options.enclosure.judge.effort = given->effort;
  }
  options.enclosure.judge.refine = given->refine != 0;
  options.enclosure.judge.all = given->all != 0;
  return options;
}

namespace {

void check_shape(const slipproof_problem& p) {
  const auto refuse = [](const char* argument, std::size_t found, const std::string& expected) {
    throw BadArgument(argument, "found " + std::to_string(found) + ", expected " + expected);
  };
  if (p.dimension < 1 || p.dimension > 3) refuse("dimension", p.dimension, "1, 2 or 3");
  if (p.size == 0 || p.size % p.dimension != 0) {
    refuse("size", p.size, "a multiple of " + std::to_string(p.dimension) + " that is not 0");
  }
  if (p.size > std::numeric_limits<std::uint32_t>::max()) refuse("size", p.size, "less than 2^32");
  need(p.W, "W");
  need(p.q, "q");
  need(p.z, "z");
  if (p.dimension > 1) need(p.mu, "mu");
  if (p.dimension == 1 && p.mu != nullptr) throw BadArgument("mu", "found coefficients, expected NULL in dimension 1");
}

ReadProblem read(const slipproof_problem& p) {
  ReadProblem read;
  const auto vector = [](const double* from, std::size_t size) { return std::vector<double>(from, from + size); };
  read.problem.form = p.dimension == 1 ? ProblemForm::complementarity : ProblemForm::local;
  read.problem.dimension = p.dimension;
  read.problem.W = from_dense(p.size, p.size, {p.W, p.size * p.size});
  read.problem.q = vector(p.q, p.size);
  if (p.mu != nullptr) read.problem.mu = vector(p.mu, p.size / p.dimension);
  read.answers.push_back({.origin = "z", .r = vector(p.z, p.size), .u = {}, .v = {}, .lambda = {}});
  if (p.w != nullptr) read.answers.front().u = vector(p.w, p.size);
  Mistakes mistakes("problem");
  check_problem(read.problem, mistakes);
  try {
    mistakes.refuse_if_any();
  } catch (const InputError& error) {
    throw BadArgument("problem", error.diagnostics().front().message);
  }
  return read;
}

/// The first number of an answer that is not finite, worded as `certify` does for records.
std::string not_finite_in(const SolverAnswer& answer) {
  for (const auto& [values, symbol] : {std::pair(&answer.r, "z"), std::pair(&answer.u, "w")}) {
    for (std::size_t i = 0; i < values->size(); ++i) {
      const std::string place = std::string(symbol) + "[" + std::to_string(i + 1) + "]";
      if (const auto found = not_finite(place, (*values)[i], 0)) return found->reason;
    }
  }
  return {};
}

RecordJudgement judge_exactly(const ReadProblem& read, const JudgeOptions& options) {
  const SolverAnswer& given = read.answers.front();
  if (const std::string reason = not_finite_in(given); !reason.empty()) return invalid_judgement(reason);
  ContactProblem problem;
  const std::size_t n = read.problem.q.size();
  problem.W.assign(n, std::vector<Rational>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const auto columns = read.problem.W.columns_of(i);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      problem.W[i][columns[k]] = to_rational(read.problem.W.values_of(i)[k]);
    }
  }
  problem.q = to_rationals(read.problem.q);
  problem.mu = to_rationals(read.problem.mu);
  ProblemAnswer answer{to_rationals(given.r), {}, {}};
  if (!given.u.empty()) answer.w = to_rationals(given.u);
  return judge_problem(problem, answer, options);
}

std::unique_ptr<slipproof_verdict> verdict_of(const RecordJudgement& found) {
  auto verdict = std::make_unique<slipproof_verdict>();
  verdict->word = name(found.verdict);
  append_line(verdict->json, 1, found);
  verdict->certified = found.verdict == RecordVerdict::certified;
  if (!found.mode_names.empty()) verdict->error = found.max_error;
  return verdict;
}

std::unique_ptr<slipproof_verdict> verdict_of(const JudgedProblem& problem) {
  const ContactJudgement& found = problem.first().judgement;
  auto verdict = std::make_unique<slipproof_verdict>();
  verdict->word = name(found.verdict);
  verdict->json = contact_line(problem, 0) + '\n';
  verdict->certified = is_certified(found.verdict);
  if (found.has_solution()) verdict->error = found.rho;
  if (found.residual) verdict->backward_error = found.residual->backward_error();
  return verdict;
}

std::unique_ptr<slipproof_verdict> certify(const slipproof_problem& problem, const Options& options) {
  check_shape(problem);
  ReadProblem given = read(problem);
  if (problem.dimension < 3 && problem.size <= max_problem_size) return verdict_of(judge_exactly(given, options.exact));
  return verdict_of(judge_problem_file("problem", std::move(given), options.enclosure));
}

/// Names the problem in errors about its parts.
std::unique_ptr<slipproof_verdict> certify_at(const slipproof_problem* problems, std::size_t i,
                                              const Options& options) {
  try {
    return certify(problems[i], options);
  } catch (const BadArgument& error) {
    const Diagnostic& first = error.diagnostics().front();
    const std::string place = "problems[" + std::to_string(i + 1) + "]";
    throw BadArgument(first.file == "problem" ? place : place + "." + first.file, first.message);
  }
}

std::vector<slipproof_result> certify_many(std::span<const slipproof_problem> problems, const Options& options,
                                           unsigned threads) {
  std::vector<slipproof_result> results(problems.size());
  on_threads(threads, [&] {
    in_parallel(0, problems.size(), [&](std::size_t i) {
      const auto found = certify_at(problems.data(), i, options);
      results[i] = {found->word.data(), found->certified, found->error, found->backward_error};
    });
  });
  return results;
}

}  // namespace

}  // namespace slipproof::c

slipproof_status slipproof_certify(const slipproof_problem* problem, const slipproof_certify_options* options,
                                   slipproof_verdict** verdict, slipproof_error** error) {
  return slipproof::c::call(error, [&] {
    slipproof::c::need(problem, "problem");
    slipproof::c::need(verdict, "verdict");
    *verdict = slipproof::c::certify(*problem, slipproof::c::options_of(options)).release();
  });
}

slipproof_status slipproof_certify_many(const slipproof_problem* problems, size_t count,
                                        const slipproof_certify_options* options, slipproof_result* results,
                                        unsigned threads, slipproof_error** error) {
  return slipproof::c::call(error, [&] {
    if (count == 0) return;
    slipproof::c::need(problems, "problems");
    slipproof::c::need(results, "results");
    std::ranges::copy(slipproof::c::certify_many({problems, count}, slipproof::c::options_of(options), threads),
                      results);
  });
}

slipproof_judgement slipproof_verdict_judgement(const slipproof_verdict* v) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  if (v == nullptr) return {"", 0, nothing, nothing, ""};
  return {v->word.data(), v->certified, v->error, v->backward_error, v->json.c_str()};
}

void slipproof_verdict_free(slipproof_verdict* verdict) {
  delete verdict;
}
