#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/number/binary64.hpp"
#include "base/number/parse.hpp"
#include "base/parallel/in_parallel.hpp"
#include "contact/formats/problem_check.hpp"
#include "contact/formats/read_files.hpp"
#include "contact/judge/certificate.hpp"
#include "faces/python/bind.hpp"
#include "faces/python/interruptible.hpp"
#include "faces/python/numbers.hpp"
#include "records/certify/certify.hpp"
#include "records/problems/contact_file.hpp"
#include "records/problems/problem_judge.hpp"
#include "report/html/contact_report.hpp"
#include "report/scenes/contact_words.hpp"

namespace slipproof::python {

namespace {

namespace py = pybind11;
using Doubles = py::array_t<double, py::array::c_style>;
using Indices = py::array_t<std::int64_t, py::array::c_style>;

std::vector<double> copied(const Doubles& values) {
  return {values.data(), values.data() + values.size()};
}

// Small problems, in exact numbers: finds every solution.

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

// Problems of any size.

/// Verdicts about one problem; details are computed at the first request.
class Judged {
 public:
  explicit Judged(std::shared_ptr<const JudgedProblem> problem) : problem_(std::move(problem)) {}
  std::size_t size() const { return problem_->answers.size(); }
  std::string line(std::size_t answer) const { return contact_line(*problem_, checked(answer)); }
  std::string words(std::size_t answer) const { return contact_words(*problem_, checked(answer)); }
  std::string refined(std::size_t answer) const { return refined_answer(*problem_, checked(answer)); }
  std::string certificate(std::size_t answer) const {
    return contact_certificate(problem_->mixed, problem_->answers[checked(answer)].judgement);
  }
  std::string report(const std::string& command) const { return contact_report(*problem_, command, SLIPPROOF_VERSION); }

 private:
  std::size_t checked(std::size_t answer) const {
    if (answer < size()) return answer;
    throw py::index_error();
  }

  std::shared_ptr<const JudgedProblem> problem_;
};

ContactFileOptions options_of(double tolerance, std::optional<double> within, bool refine, bool all,
                              const std::optional<std::string>& law, std::optional<Work> effort) {
  ContactFileOptions options;
  options.judge.tolerance = tolerance;
  options.judge.within = within;
  options.judge.refine = refine;
  options.judge.all = all;
  if (law) options.law = law_called(*law);
  if (effort) options.judge.effort = *effort;
  return options;
}

/// A file or arrays, and an answer from another file.
struct Source {
  std::string name;
  std::optional<ReadProblem> read;
  std::optional<std::string> answer;
};

std::shared_ptr<const JudgedProblem> judge(const Source& source, ContactFileOptions options) {
  ReadProblem read = source.read ? *source.read : read_problem_file(source.name);
  if (source.answer) {
    options.answer = read_answer_file(*source.answer, answer_sizes(read.problem));
    Mistakes mistakes(*source.answer);
    check_answer(read.problem, *options.answer, "the answer's ", mistakes);
    mistakes.refuse_if_any();
  }
  return std::make_shared<const JudgedProblem>(source.name, std::move(read), options);
}

Judged judged(const Source& source, const ContactFileOptions& options) {
  return Judged(interruptible([source, options](Call&) { return judge(source, options); }));
}

/// What a law needs, and what a solver adds to u: see certify() in Python.
struct SolverLaw {
  std::optional<Doubles> bounds, compliance, bias;
  std::optional<double> slip_speed;
  std::string function;

  void put(ProblemFile& problem) const {
    if (bounds) problem.law.bounds = copied(*bounds);
    if (compliance) problem.compliance = copied(*compliance);
    if (bias) problem.bias = copied(*bias);
    if (slip_speed) problem.law.slip_speed = *slip_speed;
    if (const auto known = regularisation_called(function)) problem.law.function = *known;
  }
};

/// A problem from arrays whose sizes fit each other.
ReadProblem problem_of(SparseMatrix W, const Doubles& q, const std::optional<Doubles>& mu, std::size_t dimension,
                       const std::optional<Doubles>& z, const std::optional<Doubles>& w, const SolverLaw& law) {
  ReadProblem read;
  read.problem.form = dimension == 1 ? ProblemForm::complementarity : ProblemForm::local;
  read.problem.dimension = dimension;
  read.problem.W = std::move(W);
  read.problem.q = copied(q);
  if (mu) read.problem.mu = copied(*mu);
  law.put(read.problem);
  if (z) read.answers.push_back({"z", copied(*z), w ? copied(*w) : std::vector<double>(), {}, {}});
  Mistakes mistakes("arguments");
  check_problem(read.problem, mistakes);
  mistakes.refuse_if_any();
  return read;
}

SparseMatrix from_csr(std::size_t size, const Indices& starts, const Indices& columns, const Doubles& values) {
  std::vector<MatrixEntry> entries, twice;
  entries.reserve(static_cast<std::size_t>(values.size()));
  for (std::size_t row = 0; row < size; ++row) {
    for (std::int64_t i = starts.data()[row]; i < starts.data()[row + 1]; ++i) {
      entries.push_back(
          {static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(columns.data()[i]), values.data()[i]});
    }
  }
  return sparse_matrix(size, size, std::move(entries), twice);
}

/// The matrix, from a dense array or from the arrays (indptr, indices, data) by rows.
SparseMatrix matrix_of(const py::tuple& parts, std::size_t size) {
  if (parts.size() == 1) return from_dense(size, size, {parts[0].cast<Doubles>().data(), size * size});
  return from_csr(size, parts[0].cast<Indices>(), parts[1].cast<Indices>(), parts[2].cast<Doubles>());
}

void bind_problems(py::module_& module) {
  py::class_<Judged>(module, "Judged")
      .def("__len__", &Judged::size)
      .def("line", &Judged::line)
      .def("words", &Judged::words)
      .def("refined", &Judged::refined)
      .def("certificate", &Judged::certificate)
      .def("report", &Judged::report);
  module.def("certify_exact", &certify_exact);
  py::class_<ContactFileOptions>(module, "ContactOptions").def(py::init(&options_of));
  module.def(
      "certify_problem",
      [](const py::tuple& matrix, const Doubles& q, const std::optional<Doubles>& mu, std::size_t dimension,
         const std::optional<Doubles>& z, const std::optional<Doubles>& w, const std::optional<Doubles>& bounds,
         const std::optional<Doubles>& compliance, const std::optional<Doubles>& bias, std::optional<double> slip_speed,
         const std::string& function, const ContactFileOptions& options) {
        SparseMatrix W = matrix_of(matrix, static_cast<std::size_t>(q.size()));
        const SolverLaw law{bounds, compliance, bias, slip_speed, function};
        return judged({"arguments", problem_of(std::move(W), q, mu, dimension, z, w, law), std::nullopt}, options);
      });
  module.def("exact", [](const std::string& text) { return to_python(parse_rational(text)); });
  module.def("law_words", &law_words);
  module.def("certify_problem_file",
             [](const std::string& path, const std::optional<std::string>& answer, const ContactFileOptions& options) {
               return judged({path, std::nullopt, answer}, options);
             });
  module.def("is_problem_file", &is_problem_file);
  module.def("dimension_by_sizes", [](std::size_t components, std::optional<std::size_t> coefficients) {
    const DimensionBySizes found = dimension_by_sizes(components, coefficients);
    if (!found.mistake.empty()) throw py::value_error(found.key + ": " + found.mistake);
    return found.dimension;
  });
}

}  // namespace

void bind_contacts(py::module_& module) {
  bind_problems(module);
}

}  // namespace slipproof::python
