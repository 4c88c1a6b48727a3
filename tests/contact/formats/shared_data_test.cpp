// Problems of real simulations, read twice: by the reader, and by what a few lines of C make of the same file. They are
// no part of this repository: SLIPPROOF_SHARED, or shared/data beside it, says where they are.
#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "support/files/hdf5_writer.hpp"
#include "support/files/small_files.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

std::filesystem::path shared_data() {
  const char* set = std::getenv("SLIPPROOF_SHARED");
  return set != nullptr ? std::filesystem::path(set) : std::filesystem::path(SLIPPROOF_SOURCE_DIR) / "../shared/data";
}

std::vector<std::filesystem::path> files_in(const char* folder) {
  std::vector<std::filesystem::path> result;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(shared_data() / folder, none)) {
    if (entry.path().extension() != ".json") result.push_back(entry.path());  // answers
  }
  if (result.empty()) MESSAGE("skipped: there is no " << (shared_data() / folder).string());
  return result;
}

/// Reads on, believing everything.
struct NaiveMatrix {
  std::size_t rows = 0, columns = 0;
  Entries entries;
};

void put(NaiveMatrix& m, std::size_t i, std::size_t j, double x) {
  if (x != 0) m.entries[{i, j}] = x;
}

void read_blocks(std::istream& in, NaiveMatrix& m) {
  std::size_t blocks = 0, down = 0, across = 0, filled = 0, again = 0, index = 0;
  double x = 0;
  in >> blocks >> down >> across;
  std::vector<std::size_t> row_end(down), column_end(across);
  for (auto& end : row_end) in >> end;
  for (auto& end : column_end) in >> end;
  in >> filled >> again;
  std::vector<std::size_t> start(filled), column(again);
  for (auto& s : start) in >> s;
  for (auto& c : column) in >> c;
  for (std::size_t b = 0, row = 0; b < blocks; ++b) {
    while (start[row + 1] <= b) ++row;
    const std::size_t top = row == 0 ? 0 : row_end[row - 1], left = column[b] == 0 ? 0 : column_end[column[b] - 1];
    in >> index;
    for (std::size_t j = left; j < column_end[column[b]]; ++j) {
      for (std::size_t i = top; i < row_end[row]; ++i) in >> x, put(m, i, j, x);
    }
  }
}

void read_print(std::istream& in, NaiveMatrix& m) {
  std::string line;
  int origin = 0;
  in >> origin;
  std::getline(in, line);
  std::getline(in, line);
  std::getline(in, line);
  if (line.starts_with("triplet")) {
    unsigned long number = 0, i = 0, j = 0;
    double x = 0;
    std::sscanf(line.c_str() + line.find("nnz:"), "nnz: %lu", &number);
    for (; number > 0; --number) {
      std::getline(in, line);
      std::sscanf(line.c_str(), "%lu %lu : %lf", &i, &j, &x);
      put(m, i, j, x);
    }
    return;
  }
  for (std::size_t j = 0; j < m.columns; ++j) {
    long from = 0, to = 0;
    unsigned long i = 0;
    double x = 0;
    std::getline(in, line);
    std::sscanf(line.c_str() + line.find("locations"), "locations %ld to %ld", &from, &to);
    for (; from <= to; ++from) {
      std::getline(in, line);
      std::sscanf(line.c_str(), "%lu : %lf", &i, &x);
      put(m, i, j, x);
    }
  }
}

NaiveMatrix naive_matrix(std::istream& in) {
  NaiveMatrix m;
  int storage = 0;
  in >> storage >> m.rows >> m.columns;
  if (storage == 0) {
    double x = 0;
    in >> m.rows >> m.columns;
    for (std::size_t j = 0; j < m.columns; ++j) {
      for (std::size_t i = 0; i < m.rows; ++i) in >> x, put(m, i, j, x);
    }
  }
  if (storage == 1) read_blocks(in, m);
  if (storage == 2) read_print(in, m);
  return m;
}

Numbers naive_vector(std::istream& in, std::size_t size) {
  Numbers result(size);
  for (double& x : result) in >> x;
  return result;
}

void check_same(const SparseMatrix& read, const NaiveMatrix& naive) {
  CHECK(read.rows == naive.rows);
  CHECK(read.columns == naive.columns);
  CHECK(entries_of(read) == naive.entries);
}

void check_siconos(const std::filesystem::path& path, bool friction) {
  CAPTURE(path);
  CHECK(is_problem_file(path));
  const ReadProblem read = read_problem_file(path);
  const ProblemFile& p = read.problem;
  CHECK(read.answers.empty());
  std::ifstream in(path);
  const std::string name = path.filename();
  const bool global =
      (name.starts_with("GFC") || name.starts_with("gfc")) && name.find("condensed") == std::string::npos;
  std::size_t size = 0, dimension = 1;
  if (friction) in >> dimension;
  in >> size;
  CHECK(p.dimension == dimension);
  CHECK(p.contacts() == size);
  const NaiveMatrix first = naive_matrix(in);
  if (!global) {
    CHECK(p.form == (friction ? ProblemForm::local : ProblemForm::complementarity));
    check_same(p.W, first);
    CHECK(p.q == naive_vector(in, first.rows));
  } else {
    CHECK(p.form == ProblemForm::global);
    check_same(p.M, first);
    const NaiveMatrix H = naive_matrix(in);
    check_same(p.H, H);
    CHECK(p.f == naive_vector(in, first.rows));
    CHECK(p.w == naive_vector(in, H.columns));
  }
  if (friction) CHECK(p.mu == naive_vector(in, size));
  CHECK_FALSE(in.fail());
  std::string rest;
  const bool more = static_cast<bool>(in >> rest);
  const bool told =
      std::ranges::any_of(p.remarks, [](const std::string& r) { return r.starts_with("after the data"); });
  CHECK(more == told);
}

}  // namespace

TEST_CASE("friction problems of Siconos") {
  for (const auto& path : files_in("siconos")) check_siconos(path, true);
}

TEST_CASE("complementarity problems of Siconos") {
  for (const auto& path : files_in("lcp")) check_siconos(path, false);
}

#ifdef SLIPPROOF_HDF5

namespace {

template <class Number>
std::vector<Number> stored(hid_t file, const std::string& path, hid_t memory) {
  const hid_t set = H5Dopen2(file, path.c_str(), H5P_DEFAULT), space = H5Dget_space(set);
  std::vector<Number> result(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  REQUIRE(H5Dread(set, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.data()) >= 0);
  H5Sclose(space);
  H5Dclose(set);
  return result;
}

Numbers stored_reals(hid_t file, const std::string& path) {
  return stored<double>(file, path, H5T_NATIVE_DOUBLE);
}

NaiveMatrix stored_matrix(hid_t file, const std::string& path) {
  const auto whole = [&](const char* name) { return stored<int>(file, path + name, H5T_NATIVE_INT); };
  const std::vector<int> i = whole("/i"), p = whole("/p");
  const Numbers x = stored_reals(file, path + "/x");
  const int nz = whole("/nz")[0];
  NaiveMatrix m{static_cast<std::size_t>(whole("/m")[0]), static_cast<std::size_t>(whole("/n")[0]), {}};
  const auto at = [](const std::vector<int>& v, std::size_t k) { return static_cast<std::size_t>(v[k]); };
  if (nz >= 0) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(nz); ++k) put(m, at(i, k), at(p, k), x[k]);
    return m;
  }
  for (std::size_t list = 0; list + 1 < p.size(); ++list) {
    for (std::size_t k = at(p, list); k < at(p, list + 1); ++k) {
      nz == -1 ? put(m, at(i, k), list, x[k]) : put(m, list, at(i, k), x[k]);
    }
  }
  return m;
}

}  // namespace

TEST_CASE("problems of FCLIB, whose solutions were never written") {
  for (const auto& path : files_in("fclib")) {
    CAPTURE(path);
    CHECK(is_problem_file(path));
    const ReadProblem read = read_problem_file(path);
    const ProblemFile& p = read.problem;
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    REQUIRE(file >= 0);
    const std::string group = p.form == ProblemForm::global ? "/fclib_global" : "/fclib_local";
    CHECK(p.mu == stored_reals(file, group + "/vectors/mu"));
    CHECK(p.dimension == 3);
    if (p.form == ProblemForm::global) {
      check_same(p.M, stored_matrix(file, group + "/M"));
      check_same(p.H, stored_matrix(file, group + "/H"));
      CHECK(p.f == stored_reals(file, group + "/vectors/f"));
      CHECK(p.w == stored_reals(file, group + "/vectors/w"));
    } else {
      check_same(p.W, stored_matrix(file, group + "/W"));
      CHECK(p.q == stored_reals(file, group + "/vectors/q"));
    }
    const bool solved = H5Lexists(file, "/solution", H5P_DEFAULT) > 0;
    const std::string unwritten = "/solution/r was never written, and is left out";
    CHECK((std::ranges::count(p.remarks, unwritten) == 1) == solved);
    REQUIRE(read.answers.size() == (solved ? 1 : 0));
    if (solved) {
      CHECK(read.answers[0].r == stored_reals(file, "/guesses/1/r"));
      CHECK_THROWS_WITH_AS(read_answer_file(path), doctest::Contains("never written"), InputError);
    }
    H5Fclose(file);
  }
}

#endif
