#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "base/number/parse.hpp"
#include "base/parallel/in_parallel.hpp"
#include "contact/formats/problem_check.hpp"
#include "contact/formats/read_files.hpp"
#include "contact/judge/certificate.hpp"
#include "faces/python/arrays.hpp"
#include "faces/python/bind.hpp"
#include "faces/python/interruptible.hpp"
#include "faces/python/numbers.hpp"
#include "mechanics/mechanism/mechanism.hpp"
#include "records/problems/contact_file.hpp"
#include "records/problems/problem_batch.hpp"
#include "report/html/contact_report.hpp"
#include "report/scenes/contact_words.hpp"

namespace slipproof::python {

namespace {

namespace py = pybind11;
using Indices = py::array_t<std::int64_t, py::array::c_style>;

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

/// Law, restitution, tangential restitution, velocities before: see Impact in Python.
using Impact = std::optional<std::tuple<std::string, Doubles, std::optional<Doubles>, Doubles>>;

/// Without the velocities before.
std::optional<StepImpact> step_impact(const Impact& given) {
  if (!given) return std::nullopt;
  const auto& [law, restitution, tangential, before] = *given;
  StepImpact impact{*parse_impact_law(law), copied(restitution), {}, {}};
  if (tangential) impact.tangential_restitution = copied(*tangential);
  return impact;
}

/// What a law needs, and what a solver adds to u: see certify() in Python.
struct SolverLaw {
  std::optional<Doubles> bounds, compliance, bias;
  std::optional<double> slip_speed;
  std::string function;
  Impact impact;

  void put(ProblemFile& problem) const {
    if (bounds) problem.law.bounds = copied(*bounds);
    if (compliance) problem.compliance = copied(*compliance);
    if (bias) problem.bias = copied(*bias);
    if (slip_speed) problem.law.slip_speed = *slip_speed;
    if (const auto known = regularisation_called(function)) problem.law.function = *known;
    problem.impact = step_impact(impact);
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
  if (law.impact) read.problem.impact->before = copied(std::get<3>(*law.impact));
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

using Given = std::optional<Doubles>;

std::span<const double> values_of(const Doubles& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}
std::span<const double> numbers_of(const Given& values) {
  return values ? values_of(*values) : std::span<const double>();
}

/// A matrix of each problem, if there is one of each.
void put_matrix(const Doubles& given, std::span<const double>& each, SparseMatrix& common) {
  if (given.ndim() == 3) {
    each = numbers_of(given);
  } else {
    const auto rows = static_cast<std::size_t>(given.shape(0)), columns = static_cast<std::size_t>(given.shape(1));
    common = from_dense(rows, columns, {given.data(), rows * columns});
  }
}

void put_friction(const Given& mu, ProblemBatch& batch) {
  if (mu && mu->ndim() == 2) {
    batch.mu = numbers_of(mu);
  } else if (mu) {
    batch.common.mu = copied(*mu);
  }
}

/// (index of each verdict in contact_verdicts, rho, backward error, lines).
py::tuple judged_batch(const ProblemBatch& batch, const ContactFileOptions& options, unsigned threads,
                       const py::object& progress) {
  BatchVerdicts found = interruptible(
      [&](Call& call) {
        return on_threads(threads, [&] {
          return judge_batch(batch, options, [&](std::uint64_t done) { call.at(done, batch.count); });
        });
      },
      progress, Uses::arrays);
  py::array_t<std::uint8_t> codes(static_cast<py::ssize_t>(batch.count));
  std::ranges::transform(found.verdicts, codes.mutable_data(),
                         [](ContactVerdict verdict) { return static_cast<std::uint8_t>(verdict); });
  const auto array = [](const std::vector<double>& values) {
    return Doubles(static_cast<py::ssize_t>(values.size()), values.data());
  };
  return py::make_tuple(codes, array(found.rho), array(found.backward_error), std::move(found.lines));
}

/// q, z and w have a row for each problem; W and mu may be the same for all of them.
py::tuple certify_problems(const py::tuple& matrix, const Doubles& q, const Given& mu, std::size_t dimension,
                           const Given& z, const Given& w, const SolverLaw& law, const ContactFileOptions& options,
                           unsigned threads, const py::object& progress) {
  ProblemBatch batch;
  batch.count = static_cast<std::size_t>(q.shape(0));
  batch.common.form = dimension == 1 ? ProblemForm::complementarity : ProblemForm::local;
  batch.common.dimension = dimension;
  const Given dense = matrix.size() == 1 ? Given(matrix[0].cast<Doubles>()) : Given();
  if (dense) {
    put_matrix(*dense, batch.W, batch.common.W);
  } else {
    batch.common.W = matrix_of(matrix, static_cast<std::size_t>(q.shape(1)));
  }
  batch.q = numbers_of(q), batch.r = numbers_of(z), batch.u = numbers_of(w);
  put_friction(mu, batch);
  law.put(batch.common);
  if (law.impact) batch.before = values_of(std::get<3>(*law.impact));
  return judged_batch(batch, options, threads, progress);
}

/// f, w and the parts of answers have a row for each problem; M, H and mu may be the same for all of them.
py::tuple certify_bodies(const Doubles& M, const Doubles& H, const Doubles& f, const Doubles& w, const Doubles& mu,
                         std::size_t dimension, const std::array<Given, 3>& answers, const Impact& impact,
                         const ContactFileOptions& options, unsigned threads, const py::object& progress) {
  ProblemBatch batch;
  batch.count = static_cast<std::size_t>(f.shape(0));
  batch.common.form = ProblemForm::global;
  batch.common.dimension = dimension;
  put_matrix(M, batch.M, batch.common.M);
  put_matrix(H, batch.H, batch.common.H);
  put_friction(mu, batch);
  batch.f = numbers_of(f), batch.w = numbers_of(w);
  batch.r = numbers_of(answers[0]), batch.u = numbers_of(answers[1]), batch.v = numbers_of(answers[2]);
  batch.common.impact = step_impact(impact);
  if (impact) batch.before = values_of(std::get<3>(*impact));
  return judged_batch(batch, options, threads, progress);
}

py::tuple contact_verdicts() {
  py::list names;
  for (auto i = 0; i <= static_cast<int>(ContactVerdict::undecided); ++i) {
    names.append(std::string(name(static_cast<ContactVerdict>(i))));
  }
  return py::tuple(names);
}

void bind_problems(py::module_& module) {
  py::class_<Judged>(module, "Judged")
      .def("__len__", &Judged::size)
      .def("line", &Judged::line)
      .def("words", &Judged::words)
      .def("refined", &Judged::refined)
      .def("certificate", &Judged::certificate)
      .def("report", &Judged::report);
  py::class_<ContactFileOptions>(module, "ContactOptions").def(py::init(&options_of));
  module.def(
      "certify_problem",
      [](const py::tuple& matrix, const Doubles& q, const std::optional<Doubles>& mu, std::size_t dimension,
         const std::optional<Doubles>& z, const std::optional<Doubles>& w, const std::optional<Doubles>& bounds,
         const std::optional<Doubles>& compliance, const std::optional<Doubles>& bias, std::optional<double> slip_speed,
         const std::string& function, const Impact& impact, const ContactFileOptions& options) {
        SparseMatrix W = matrix_of(matrix, static_cast<std::size_t>(q.size()));
        const SolverLaw law{bounds, compliance, bias, slip_speed, function, impact};
        return judged({"arguments", problem_of(std::move(W), q, mu, dimension, z, w, law), std::nullopt}, options);
      });
  module.def("certify_problems",
             [](const py::tuple& matrix, const Doubles& q, const std::optional<Doubles>& mu, std::size_t dimension,
                const std::optional<Doubles>& z, const std::optional<Doubles>& w, const std::optional<Doubles>& bounds,
                const std::optional<Doubles>& compliance, const std::optional<Doubles>& bias,
                std::optional<double> slip_speed, const std::string& function, const Impact& impact,
                const ContactFileOptions& options, unsigned threads, const py::object& progress) {
               const SolverLaw law{bounds, compliance, bias, slip_speed, function, impact};
               return certify_problems(matrix, q, mu, dimension, z, w, law, options, threads, progress);
             });
  module.def("certify_bodies", &certify_bodies);
  module.attr("contact_verdicts") = contact_verdicts();
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
