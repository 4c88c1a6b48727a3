#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>

#include "base/input/text_file.hpp"
#include "faces/python/bind.hpp"
#include "faces/python/interruptible.hpp"
#include "mechanics/reading/shipped.hpp"
#include "records/certify/certify.hpp"
#include "records/certify/columns.hpp"
#include "records/record/bicycle_records.hpp"

namespace slipproof::python {

namespace {

namespace py = pybind11;

struct RecordLines {
  std::string lines, summary;
};

RecordLines certify_lines(const std::string& path, const CertifyOptions& options, Call& call) {
  RecordLines result;
  const ByteSource input = open_bytes(path);
  const CertifySummary summary = certify(
      input, [&](std::string_view lines) { result.lines += lines; }, options,
      [&](std::uint64_t records) { call.at(records, records); });
  result.summary = to_json(summary);
  return result;
}

CertifyOptions record_options(const std::string& path, const std::optional<std::string>& scene,
                              const std::optional<std::string>& mechanism) {
  CertifyOptions options;
  options.file = path;
  if (mechanism) options.mechanism.emplace(open_mechanism(*mechanism, {}, Dimensions::any));
  if (scene) options.mechanism = records_of_scene(read_text_file(*scene), *scene);
  return options;
}

py::tuple certify_records(const std::string& path, const std::optional<std::string>& scene,
                          const std::optional<std::string>& mechanism, std::optional<double> tolerance,
                          std::optional<Work> effort, bool ignore_unknown, unsigned threads,
                          const py::object& progress) {
  const RecordLines found = interruptible(
      [=](Call& call) {
        CertifyOptions options = record_options(path, scene, mechanism);
        if (tolerance) options.judge.tolerance = options.contact.tolerance = *tolerance;
        if (effort) options.judge.effort = options.contact.effort = *effort;
        options.ignore_unknown = ignore_unknown;
        options.threads = threads;
        return certify_lines(path, options, call);
      },
      progress);
  return py::make_tuple(py::bytes(found.lines), found.summary);
}

// Records in memory.

/// A view of a column anywhere in memory; a single number is the same for all records.
template <class T>
StridedColumn<T> view(const py::array& column) {
  return {column.data(), column.ndim() == 0 || column.shape(0) == 1 ? 0 : column.strides(0)};
}

RecordColumns columns_of(const py::dict& given, const RecordFields& fields, std::size_t records) {
  RecordColumns columns(fields, records);
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    const auto column = py::reinterpret_borrow<py::array>(value);
    if (name == "mode") {
      columns.modes = view<std::uint16_t>(column);
    } else {
      columns.number(name == "kind" ? fields.word()->parameter : name) = view<double>(column);
    }
  }
  return columns;
}

JudgeOptions judge_options(double tolerance, std::optional<Work> effort) {
  JudgeOptions options;
  options.tolerance = tolerance;
  if (effort) options.effort = *effort;
  return options;
}

/// The records, their judge, and the arrays that both refer to.
class RecordsInMemory {
 public:
  RecordsInMemory(py::dict arrays, std::size_t records, const std::optional<std::string>& scene, double tolerance,
                  std::optional<Work> effort)
      : arrays_(std::move(arrays)),
        record_judge_(scene ? bicycle_records(parse_scene(*scene, "scene")) : bicycle_records(),
                      judge_options(tolerance, effort)),
        columns_(columns_of(arrays_, record_judge_.fields(), records)),
        judge_(columns_, record_judge_) {}

  py::tuple certify_all(unsigned threads, const py::object& progress) {
    const auto size = static_cast<py::ssize_t>(columns_.records);
    py::array_t<std::uint8_t> verdicts(size), tiers(size);
    py::array_t<std::uint64_t> modes(size);
    py::array_t<double> errors(size);
    const JudgementSpans answers{{reinterpret_cast<RecordVerdict*>(verdicts.mutable_data()), columns_.records},
                                 {modes.mutable_data(), columns_.records},
                                 {errors.mutable_data(), columns_.records},
                                 {reinterpret_cast<Tier*>(tiers.mutable_data()), columns_.records}};
    const CertifySummary summary = interruptible(
        [this, answers, threads](Call& call) {
          return certify(columns_, record_judge_, answers, threads,
                         [&](std::uint64_t records) { call.at(records, columns_.records); });
        },
        progress, Uses::arrays);
    return py::make_tuple(std::move(verdicts), std::move(modes), std::move(errors), std::move(tiers), to_json(summary));
  }

  /// The line that `slipproof certify` writes for one record.
  std::string line(std::size_t record) const {
    if (record >= columns_.records) throw py::index_error();
    std::string text;
    append_line(text, record + 1, judge_(record));
    return text;
  }

 private:
  py::dict arrays_;
  RecordJudge record_judge_;
  RecordColumns columns_;
  ColumnsJudge judge_;
};

}  // namespace

void bind_records(py::module_& module) {
  module.def("certify_records", &certify_records);
  py::class_<RecordsInMemory>(module, "RecordsInMemory")
      .def(py::init<py::dict, std::size_t, const std::optional<std::string>&, double, std::optional<Work>>())
      .def("certify", &RecordsInMemory::certify_all)
      .def("line", &RecordsInMemory::line);
  py::list names, verdicts;
  const RecordFields fields(bicycle_records());
  for (std::size_t i = 0; i < fields.size(); ++i) names.append(fields.name(i));
  for (std::size_t i = 0; i < record_verdict_count; ++i) verdicts.append(name(static_cast<RecordVerdict>(i)));
  module.attr("record_fields") = py::tuple(names);
  module.attr("record_verdicts") = py::tuple(verdicts);
}

}  // namespace slipproof::python
