// Records of solvers from CSV, from .npy and from memory: the same ones, 26 columns, judged on one core.
#include "records/certify/certify.hpp"

#include <benchmark/benchmark.h>

#include <filesystem>
#include <fstream>

#include "records/certify/columns.hpp"
#include "records/certify/table_records.hpp"
#include "records/record/bicycle_records.hpp"
#include "support/files/npy_file.hpp"
#include "support/scenes/solver_records.hpp"

namespace {

using namespace slipproof;

/// Records that repeat after a while, as CSV and as a structured array, in files.
class RecordFiles {
 public:
  explicit RecordFiles(std::size_t count)
      : csv_(std::filesystem::temp_directory_path() / ("slipproof-bench-" + std::to_string(count) + ".csv")),
        npy_(csv_ + ".npy") {
    constexpr std::size_t different = 2048;
    test::SolverRecords records(17, false);
    std::vector<test::Cells> cells;
    while (cells.size() < different) {
      cells.push_back(records.next());
      if (cells.back()[test::j_cell].empty()) cells.pop_back();  // a column has J for all or for none
    }
    std::string text = test::header(), rows;
    for (std::size_t i = 0; i < count; ++i) text += test::joined(cells[i % different]);
    for (std::size_t i = 0; i < count; ++i) rows += test::npy_row(cells[i % different]);
    std::ofstream(csv_, std::ios::binary) << text;
    std::ofstream(npy_, std::ios::binary) << test::npy_file(test::npy_record_fields(), rows, count);
  }
  ~RecordFiles() {
    std::filesystem::remove(csv_);
    std::filesystem::remove(npy_);
  }
  const std::string& csv() const { return csv_; }
  const std::string& npy() const { return npy_; }

 private:
  std::string csv_, npy_;
};

template <class Certify>
void measure(benchmark::State& state, const Certify& certify_all) {
  const RecordFiles files(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    std::size_t bytes = 0;
    CertifyOptions options;
    options.threads = 1;
    const CertifySummary summary = certify_all(files, options, [&](std::string_view lines) { bytes += lines.size(); });
    if (!summary.all_certified()) state.SkipWithError("not certified");
    benchmark::DoNotOptimize(bytes);
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void certify_csv(benchmark::State& state) {
  measure(state, [](const RecordFiles& files, const CertifyOptions& options, const LineSink& sink) {
    return certify(open_bytes(files.csv()), sink, options);
  });
}
void certify_npy(benchmark::State& state) {
  measure(state, [](const RecordFiles& files, const CertifyOptions& options, const LineSink& sink) {
    return certify(open_table(files.npy()), sink, options);
  });
}
/// The rows of the file in memory, and answers in arrays: no text at all.
void certify_columns(benchmark::State& state) {
  measure(state, [](const RecordFiles& files, const CertifyOptions& options, const LineSink&) {
    const RecordJudge judge(bicycle_records(), options.judge);
    Table table = open_table(files.npy());
    TableBlock block;
    CertifySummary summary;
    while (table.next(block)) {
      RecordColumns columns(judge.fields(), block.rows);
      for (const TableColumn& column : table.columns) {
        if (const auto field = judge.fields().find(column.name)) {
          columns.numbers[*field] = {Table::cells(block, column), static_cast<std::ptrdiff_t>(table.stride(column))};
        }
      }
      const auto* const kinds = Table::cells(block, table.columns[test::kind_cell]);
      const std::size_t stride = table.stride(table.columns[test::kind_cell]);
      std::vector<double> external(block.rows);
      for (std::size_t i = 0; i < block.rows; ++i) external[i] = kinds[i * stride];
      columns.numbers[judge.fields().word_field()] = std::span<const double>(external);
      summary.add(certify(columns, judge, 1).summary);
    }
    return summary;
  });
}
BENCHMARK(certify_csv)->Arg(4096)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(certify_npy)->Arg(4096)->Arg(1000000)->Unit(benchmark::kMillisecond);
BENCHMARK(certify_columns)->Arg(4096)->Arg(1000000)->Unit(benchmark::kMillisecond);

}  // namespace
