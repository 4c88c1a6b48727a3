#include "contact/formats/fclib.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/files/hdf5_file.hpp"
#include "base/files/words.hpp"
#include "contact/formats/entries.hpp"
#include "contact/formats/problem_check.hpp"

namespace slipproof {

namespace {

/// One matrix: m rows and n columns; nz is the number of triplets, or how else i and p are to be read.
class FclibMatrix {
 public:
  FclibMatrix(const Hdf5File& file, std::string path) : file_(file), path_(std::move(path)) {}

  /// Reads a matrix of this size, which the vectors give.
  SparseMatrix read(std::size_t rows, std::size_t columns) {
    size("m", rows);
    size("n", columns);
    const std::int64_t nz = file_.integer(path_ + "/nz");
    if (nz < -2) {
      file_.refuse(path_ + "/nz", "found " + std::to_string(nz) + ", expected a number of triplets, -1 or -2");
    }
    i_ = file_.integers(path_ + "/i");
    p_ = file_.integers(path_ + "/p");
    x_ = file_.reals(path_ + "/x");
    if (nz >= 0) read_triplets(nz, rows, columns);
    if (nz == -1) read_lists(columns, rows, false);
    if (nz == -2) read_lists(rows, columns, true);
    return matrix_of(rows, columns, std::move(entries_), [&](const std::string& twice) { file_.refuse(path_, twice); });
  }

 private:
  void size(const char* name, std::size_t expected) const {
    const std::string path = path_ + "/" + name;
    const std::int64_t found = file_.integer(path);
    if (std::cmp_equal(found, expected)) return;
    file_.refuse(path, "found " + std::to_string(found) + ", expected " + std::to_string(expected) +
                           ", the length of the vectors");
  }

  /// Lists may be as long as nzmax, with entries that are not used at their end.
  void enough(const char* name, std::size_t found, std::size_t used) const {
    if (found >= used) return;
    file_.refuse(path_ + "/" + name, "found " + std::to_string(found) + " numbers, expected " + std::to_string(used));
  }

  std::uint32_t index(const char* name, std::int64_t found, std::size_t bound) const {
    if (found >= 0 && std::cmp_less(found, bound)) return static_cast<std::uint32_t>(found);
    file_.refuse(path_ + "/" + name, "found the index " + std::to_string(found) + ", expected one from 0 to " +
                                         std::to_string(bound) + " - 1");
  }

  void read_triplets(std::int64_t nz, std::size_t rows, std::size_t columns) {
    // Larger ones have been refused: no list is as long.
    const std::size_t number = std::cmp_less(nz, x_.size()) ? static_cast<std::size_t>(nz) : x_.size();
    if (std::cmp_greater(nz, x_.size())) {
      file_.refuse(path_ + "/nz", "found " + std::to_string(nz) + ", expected at most " + std::to_string(x_.size()) +
                                      ", the length of x");
    }
    enough("i", i_.size(), number);
    enough("p", p_.size(), number);
    for (std::size_t k = 0; k < number; ++k) {
      entries_.push_back({index("i", i_[k], rows), index("p", p_[k], columns), x_[k]});
    }
  }

  void read_lists(std::size_t lists, std::size_t bound, bool by_rows) {
    if (p_.size() != lists + 1) {
      file_.refuse(path_ + "/p", "found " + std::to_string(p_.size()) + " numbers, expected " +
                                     std::to_string(lists + 1) + ", where each " + (by_rows ? "row" : "column") +
                                     " starts and where the last one ends");
    }
    const bool increase = p_[0] == 0 && std::ranges::is_sorted(p_);
    if (!increase || std::cmp_greater(p_.back(), x_.size())) {
      file_.refuse(path_ + "/p", "found starts that do not increase from 0 to at most " + std::to_string(x_.size()));
    }
    enough("i", i_.size(), static_cast<std::size_t>(p_.back()));
    for (std::size_t list = 0; list < lists; ++list) {
      for (auto k = static_cast<std::size_t>(p_[list]); std::cmp_less(k, p_[list + 1]); ++k) {
        const auto other = index("i", i_[k], bound), here = static_cast<std::uint32_t>(list);
        entries_.push_back(by_rows ? MatrixEntry{here, other, x_[k]} : MatrixEntry{other, here, x_[k]});
      }
    }
  }

  const Hdf5File& file_;
  const std::string path_;
  std::vector<std::int64_t> i_, p_;
  std::vector<double> x_;
  std::vector<MatrixEntry> entries_;
};

class FclibFile {
 public:
  FclibFile(const std::string& bytes, const std::string& name) : file_(bytes, name), name_(name) {}

  ReadProblem read() {
    const bool global = file_.has("/fclib_global"), local = file_.has("/fclib_local");
    if (!global && !local) {
      refuse(name_, file_.has("/fclib_global_rolling")
                        ? "/fclib_global_rolling: found rolling friction, which is not judged, expected /fclib_local "
                          "or /fclib_global"
                        : "found neither /fclib_local nor /fclib_global, expected one of them. Records are read "
                          "from CSV, JSON Lines and .npy; Python makes an array of a table in HDF5: "
                          "numpy.save(\"a.npy\", h5py.File(\"a.h5\")[\"table\"][:])");
    }
    global ? read_global("/fclib_global") : read_local("/fclib_local");
    if (global && local) read_.problem.remarks.emplace_back("/fclib_local is not read, since /fclib_global is there");
    if (file_.has("/solution")) add_answer("/solution");
    read_guesses();
    return std::move(read_);
  }

  /// Nothing where its forces were created and never written, which the library reads as zeros.
  std::optional<SolverAnswer> answer(const std::string& path, const AnswerSizes& sizes) {
    SolverAnswer result;
    result.origin = path;
    if (!file_.has(path)) file_.refuse(path, "found nothing, expected a solver's answer");
    bool forces = true;
    const auto part = [&](const char* name, std::optional<std::size_t> most) {
      bool written = true;
      std::vector<double> numbers;
      if (file_.has(path + name)) numbers = file_.reals(path + name, written, most);
      if (written) return numbers;
      read_.problem.remarks.push_back(path + name + " was never written, and is left out");
      forces = forces && name != std::string_view("/r");
      return std::vector<double>();
    };
    result.r = part("/r", sizes.r);
    result.u = part("/u", sizes.u);
    result.v = part("/v", sizes.v);
    result.lambda = part("/l", sizes.lambda);
    if (!forces) return std::nullopt;
    if (result.r.empty() && result.u.empty()) file_.refuse(path, "found neither r nor u, expected a solver's answer");
    return result;
  }

  SolverAnswer answer_alone(const AnswerSizes& sizes) {
    if (auto found = answer("/solution", sizes)) return *std::move(found);
    file_.refuse("/solution/r", "found a data set that was never written, expected a solver's forces");
  }

 private:
  void read_common(const std::string& group) {
    ProblemFile& p = read_.problem;
    const std::int64_t dimension = file_.integer(group + "/spacedim");
    if (dimension != 2 && dimension != 3) {
      file_.refuse(group + "/spacedim", "found " + std::to_string(dimension) + ", expected 2 or 3");
    }
    p.dimension = static_cast<std::size_t>(dimension);
    p.mu = file_.reals(group + "/vectors/mu");
    p.title = file_.has(group + "/info/title") ? file_.text(group + "/info/title").value_or("") : "";
  }

  SparseMatrix matrix(const std::string& path, std::size_t rows, std::size_t columns) const {
    return FclibMatrix(file_, path).read(rows, columns);
  }

  void read_local(const std::string& group) {
    ProblemFile& p = read_.problem;
    p.form = ProblemForm::local;
    read_common(group);
    p.q = file_.reals(group + "/vectors/q");
    p.W = matrix(group + "/W", p.q.size(), p.q.size());
    if (!file_.has(group + "/V") && !file_.has(group + "/R")) return;
    p.s = file_.reals(group + "/vectors/s");
    p.V = matrix(group + "/V", p.q.size(), p.s.size());
    p.R = matrix(group + "/R", p.s.size(), p.s.size());
  }

  void read_global(const std::string& group) {
    ProblemFile& p = read_.problem;
    p.form = ProblemForm::global;
    read_common(group);
    p.f = file_.reals(group + "/vectors/f");
    p.w = file_.reals(group + "/vectors/w");
    p.M = matrix(group + "/M", p.f.size(), p.f.size());
    p.H = matrix(group + "/H", p.f.size(), p.w.size());
    if (!file_.has(group + "/G")) return;
    p.b = file_.reals(group + "/vectors/b");
    p.G = matrix(group + "/G", p.f.size(), p.b.size());
  }

  void read_guesses() {
    if (!file_.has("/guesses")) return;
    const std::string count = "/guesses/number_of_guesses";
    const std::int64_t number = file_.integer(count);
    const std::size_t objects = file_.size_of_group("/guesses");
    if (number < 0 || std::cmp_greater(number, objects)) {
      file_.refuse(count, "found " + std::to_string(number) + ", expected at most " + std::to_string(objects) +
                              ", as there are objects in /guesses");
    }
    for (std::int64_t k = 1; k <= number; ++k) {
      add_answer("/guesses/" + std::to_string(k));
    }
  }

  void add_answer(const std::string& path) {
    if (auto found = answer(path, answer_sizes(read_.problem))) read_.answers.push_back(*std::move(found));
  }

  Hdf5File file_;
  std::string name_;
  ReadProblem read_;
};

}  // namespace

ReadProblem read_fclib(const std::string& bytes, const std::string& file) {
  return FclibFile(bytes, file).read();
}

SolverAnswer read_fclib_answer(const std::string& bytes, const std::string& file, const AnswerSizes& sizes) {
  return FclibFile(bytes, file).answer_alone(sizes);
}

}  // namespace slipproof
