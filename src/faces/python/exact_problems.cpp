#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include "base/number/binary64.hpp"
#include "base/number/parse.hpp"
#include "base/parallel/in_parallel.hpp"
#include "faces/python/arrays.hpp"
#include "faces/python/bind.hpp"
#include "faces/python/interruptible.hpp"
#include "records/certify/certify.hpp"
#include "records/problems/problem_judge.hpp"

namespace slipproof::python {

namespace {

namespace py = pybind11;

/// Numbers from Python: an array of binary64, or exact ones as a list of texts.
class Numbers {
 public:
  Numbers() = default;
  explicit Numbers(const py::object& given) {
    if (given.is_none()) return;
    if (py::isinstance<py::array>(given)) {
      doubles_ = copied(given.cast<Doubles>());
    } else {
      for (const py::handle text : given) exact_.push_back(parse_rational(text.cast<std::string>()));
    }
  }

  bool empty() const { return doubles_.empty() && exact_.empty(); }
  /// The `size` numbers of one problem, which may be common to all problems.
  std::vector<Rational> part(std::size_t problem, std::size_t size) const {
    const std::size_t begin = first(problem, size);
    std::vector<Rational> result;
    result.reserve(size);
    for (std::size_t i = begin; i < begin + size; ++i) {
      result.push_back(exact_.empty() ? to_rational(doubles_[i]) : exact_[i]);
    }
    return result;
  }
  /// What is wrong with these numbers of an answer before it is judged; empty if nothing is.
  std::string not_finite(std::size_t problem, std::size_t size, const char* name) const {
    for (std::size_t i = 0; i < size && !doubles_.empty(); ++i) {
      const double x = doubles_[first(problem, size) + i];
      if (!std::isfinite(x)) return fmt::format("{}[{}]: found {}, expected a finite number", name, i, x);
    }
    return {};
  }

 private:
  std::size_t first(std::size_t problem, std::size_t size) const {
    return std::max(doubles_.size(), exact_.size()) == size ? 0 : problem * size;
  }

  std::vector<double> doubles_;
  std::vector<Rational> exact_;
};

/// Problems of the same size with their numbers in common lists: W (count, size, size), q, z and optionally w (count,
/// size), mu (count, contacts). W and mu may be given once for all problems. Without contacts each is an LCP.
struct ExactBatch {
  std::size_t count = 0, size = 0, contacts = 0;
  Numbers W, q, z, w, mu;
  JudgeOptions options;
  unsigned threads = 0;
};

ContactProblem problem_of(const ExactBatch& batch, std::size_t k) {
  ContactProblem problem;
  const std::vector<Rational> W = batch.W.part(k, batch.size * batch.size);
  for (std::size_t i = 0; i < batch.size; ++i) {
    const auto row = W.begin() + static_cast<std::ptrdiff_t>(i * batch.size);
    problem.W.emplace_back(row, row + static_cast<std::ptrdiff_t>(batch.size));
  }
  problem.q = batch.q.part(k, batch.size);
  problem.mu = batch.mu.part(k, batch.contacts);
  return problem;
}

std::string exact_verdict(const ExactBatch& batch, std::size_t k) {
  std::string reason = batch.z.not_finite(k, batch.size, "z");
  if (reason.empty() && !batch.w.empty()) reason = batch.w.not_finite(k, batch.size, "w");
  RecordJudgement judgement;
  if (!reason.empty()) {
    judgement = invalid_judgement(reason);
  } else {
    ProblemAnswer answer{batch.z.part(k, batch.size), std::nullopt, std::nullopt};
    if (!batch.w.empty()) answer.w = batch.w.part(k, batch.size);
    judgement = judge_problem(problem_of(batch, k), answer, batch.options);
  }
  std::string line;
  append_line(line, k + 1, judgement);
  return line;
}

/// A line of JSON for each problem, as `slipproof certify` writes it. `shape`: (problems, components, contacts).
std::vector<std::string> certify_exact(const std::array<std::size_t, 3>& shape, const py::object& W,
                                       const py::object& q, const py::object& z, const py::object& w,
                                       const py::object& mu, double tolerance, Work effort, unsigned threads,
                                       const py::object& progress) {
  ExactBatch batch{shape[0],   shape[1],   shape[2],    Numbers(W), Numbers(q),
                   Numbers(z), Numbers(w), Numbers(mu), {},         threads};
  batch.options.tolerance = tolerance;
  batch.options.effort = effort;
  const auto work = [batch = std::move(batch)](Call& call) {
    std::vector<std::string> lines(batch.count);
    std::atomic<std::uint64_t> done = 0;
    on_threads(batch.threads, [&] {
      in_parallel(0, batch.count, [&](std::size_t k) {
        lines[k] = exact_verdict(batch, k);
        call.at(++done, batch.count);
      });
    });
    return lines;
  };
  return interruptible(work, progress);
}

}  // namespace

void bind_exact_problems(py::module_& module) {
  module.def("certify_exact", &certify_exact);
}

}  // namespace slipproof::python
