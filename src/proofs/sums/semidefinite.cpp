#include "proofs/sums/semidefinite.hpp"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

#include "base/os/program_run.hpp"

namespace slipproof::prove::sums {

namespace {

/// Removed at its end with all that is in it.
class SolverFolder {
 public:
  SolverFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "slipproof-squares-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::system_error(errno, std::generic_category(), pattern);
    path_ = pattern;
  }
  SolverFolder(const SolverFolder&) = delete;
  SolverFolder& operator=(const SolverFolder&) = delete;
  ~SolverFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// Where CSDP has the entries: blocks of one row are one diagonal block, which comes last and ends in u = 1 - margin.
class Layout {
 public:
  explicit Layout(const std::vector<std::size_t>& sizes) {
    for (const std::size_t size : sizes) {
      if (size > 1) wide_.push_back(size);
    }
    std::size_t wide = 0;
    for (const std::size_t size : sizes) {
      if (size > 1) {
        places_.emplace_back(++wide, 0);
      } else {
        places_.emplace_back(wide_.size() + 1, diagonal_++);
      }
    }
  }

  std::string sizes() const {
    std::string result = fmt::format("{}\n", wide_.size() + 1);
    for (const std::size_t size : wide_) result += fmt::format("{} ", size);
    return result + fmt::format("-{}\n", diagonal_ + 1);
  }
  std::string place(const MatrixPlace& at) const {
    const auto& [block, offset] = places_[at.block];
    return fmt::format("{} {} {}", block, at.row + offset + 1, at.column + offset + 1);
  }
  std::string place_of_u() const { return fmt::format("{0} {1} {1}", wide_.size() + 1, diagonal_ + 1); }

  /// The entry that CSDP calls so, with the margin for u.
  void read(std::size_t block, std::size_t row, std::size_t column, double value, MatrixPoint& point) const {
    if (block == wide_.size() + 1 && row == diagonal_ + 1) {
      point.margin = 1 - value;
      return;
    }
    for (std::size_t b = 0; b < places_.size(); ++b) {
      const auto& [number, offset] = places_[b];
      const bool wide = number <= wide_.size();
      if (number != block || (!wide && row != offset + 1)) continue;
      const std::size_t size = wide ? wide_[number - 1] : 1, i = row - 1 - offset, j = column - 1 - offset;
      point.blocks[b][i * size + j] = point.blocks[b][j * size + i] = value;
    }
  }

 private:
  std::vector<std::size_t> wide_;
  std::vector<std::pair<std::size_t, std::size_t>> places_;  ///< number of the block there, and the entry's offset
  std::size_t diagonal_ = 0;
};

/// X = X' + (1 - u) 1 with X' semidefinite and u >= 0 least. In SDPA's format, each equation divided by its largest
/// factor.
std::string in_sdpa_format(const MatrixEquations& problem, const Layout& layout) {
  std::string sums, entries = fmt::format("0 {} -1\n", layout.place_of_u());
  for (std::size_t k = 0; k < problem.equations.size(); ++k) {
    const MatrixEquation& equation = problem.equations[k];
    double largest = 0, trace = 0;
    for (const auto& [place, factor] : equation.terms) {
      largest = std::max(largest, std::fabs(factor));
      if (place.row == place.column) trace += factor;
    }
    sums += fmt::format("{:.17g} ", (equation.sum - trace) / largest);
    for (const auto& [place, factor] : equation.terms) {
      entries += fmt::format("{} {} {:.17g}\n", k + 1, layout.place(place), factor / largest);
    }
    if (trace != 0) entries += fmt::format("{} {} {:.17g}\n", k + 1, layout.place_of_u(), -trace / largest);
  }
  return fmt::format("{}\n", problem.equations.size()) + layout.sizes() + sums + "\n" + entries;
}

std::optional<MatrixPoint> read_point(const std::string& file, const MatrixEquations& problem, const Layout& layout) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line)) return std::nullopt;  // the multipliers of the equations
  MatrixPoint point;
  point.margin = 1;  // entries that are 0 are left out
  for (const std::size_t size : problem.sizes) point.blocks.emplace_back(size * size);
  constexpr int of_primal = 2;
  int which = 0;
  std::size_t block = 0, row = 0, column = 0;
  for (double value = 0; in >> which >> block >> row >> column >> value;) {
    if (!std::isfinite(value)) return std::nullopt;
    if (which == of_primal) layout.read(block, row, column, value, point);
  }
  for (std::size_t b = 0; b < point.blocks.size(); ++b) {
    for (std::size_t i = 0; i < problem.sizes[b]; ++i) point.blocks[b][i * (problem.sizes[b] + 1)] += point.margin;
  }
  return point;
}

}  // namespace

bool has_semidefinite_solver() {
  static const bool has = [] {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
      std::error_code ignored;
      if (std::filesystem::is_regular_file(std::filesystem::path(folder) / "csdp", ignored)) return true;
    }
    return false;
  }();
  return has;
}

std::optional<MatrixPoint> widest_point(const MatrixEquations& problem) {
  const Layout layout(problem.sizes);
  const SolverFolder folder;
  const std::string question = folder.file("question.dat-s"), answer = folder.file("answer");
  std::ofstream(question) << in_sdpa_format(problem, layout);
  try {
    const ProgramRun run = run_program(
        {"env", "OMP_NUM_THREADS=1", "OPENBLAS_NUM_THREADS=1", "OPENBLAS_CORETYPE=Prescott", "csdp", question, answer});
    constexpr int no_solution = 2;  // 1 and 2 say that there is none; from 3 on it may be less exact
    if (run.exit_code > 0 && run.exit_code <= no_solution) return std::nullopt;
  } catch (const std::system_error&) {
    return std::nullopt;
  }
  return read_point(answer, problem, layout);
}

}  // namespace slipproof::prove::sums
