// FCLIB's files, and what is in them.
#include "contact/formats/fclib.hpp"

#include <random>
#include <thread>

#include "base/files/hdf5_file.hpp"
#include "contact/formats/fclib_writer.hpp"

using namespace slipproof;
using namespace slipproof::test;

TEST_CASE("without HDF5 a file in it is refused in words") {
  const Folder folder;
  const std::string path = folder.write("p.hdf5", std::string(hdf5_signature) + "rest");
  CHECK(is_problem_file(path));
  if (has_hdf5()) {
    CHECK(problem_refusal(path) == "FILE: found no whole HDF5 file: it is cut off or damaged");
  } else {
    CHECK(problem_refusal(path) == std::string("FILE: ") + without_hdf5);
  }
}

#ifdef SLIPPROOF_HDF5

namespace {

void write_global(const Hdf5Writer& out) {
  out.group("/fclib_global");
  out.integers("/fclib_global/spacedim", {2});
  out.matrix("/fclib_global/M", 3, 3, 3, {2, 1, 0}, {2, 1, 0}, {3, 2, 1});
  out.matrix("/fclib_global/H", 3, 2, -1, {0, 2, 1}, {0, 2, 3}, {5, 6, 7});
  out.group("/fclib_global/vectors");
  out.reals("/fclib_global/vectors/f", {1, 2, 3});
  out.reals("/fclib_global/vectors/w", {4, 5});
  out.reals("/fclib_global/vectors/mu", {0.25});
}

}  // namespace

TEST_CASE("a local problem by rows, by columns and as triplets with the row in i") {
  const Folder folder;
  const ReadProblem read = read_problem_file(written(folder, write_local));
  const ProblemFile& p = read.problem;
  CHECK(p.form == ProblemForm::local);
  CHECK(p.dimension == 2);
  CHECK(p.contacts() == 1);
  CHECK(dense(p.W) == Numbers{4, 3, 0, 5});
  CHECK(p.q == Numbers{-1, 2});
  CHECK(p.mu == Numbers{0.5});
  CHECK(p.remarks.size() == 1);  // asymmetric
  const auto other = [&](long long nz, const std::vector<long long>& i, const std::vector<long long>& j,
                         const Numbers& x) {
    return read_problem_file(written(folder, write_local,
                                     [&](const Hdf5Writer& out) {
                                       out.remove("/fclib_local/W");
                                       out.matrix("/fclib_local/W", 2, 2, nz, i, j, x);
                                     }))
        .problem.W;
  };
  CHECK(other(-1, {0, 0, 1}, {0, 1, 3}, {4, 3, 5}) == p.W);
  CHECK(other(3, {1, 0, 0}, {1, 1, 0}, {5, 3, 4}) == p.W);
  // Lists may be longer than what is used of them.
  CHECK(other(3, {1, 0, 0, 77}, {1, 1, 0, -5}, {5, 3, 4, 99}) == p.W);
}

TEST_CASE("a global problem with bilateral rows, and a local one") {
  const Folder folder;
  const ProblemFile p = read_problem_file(written(folder, write_global, [](const Hdf5Writer& out) {
                          out.matrix("/fclib_global/G", 3, 1, -2, {0}, {0, 0, 1, 1}, {8});
                          out.reals("/fclib_global/vectors/b", {9});
                          out.group("/fclib_global/info");
                          out.text("/fclib_global/info/title", "a heap");
                        })).problem;
  CHECK(p.form == ProblemForm::global);
  CHECK(dense(p.M) == Numbers{1, 0, 0, 0, 2, 0, 0, 0, 3});
  CHECK(dense(p.H) == Numbers{5, 0, 0, 7, 6, 0});
  CHECK(dense(p.G) == Numbers{0, 8, 0});
  CHECK(p.f == Numbers{1, 2, 3});
  CHECK(p.w == Numbers{4, 5});
  CHECK(p.b == Numbers{9});
  CHECK(p.title == "a heap");
  const ProblemFile l = read_problem_file(written(folder, write_local, [](const Hdf5Writer& out) {
                          out.matrix("/fclib_local/V", 2, 1, 1, {1}, {0}, {6});
                          out.matrix("/fclib_local/R", 1, 1, 1, {0}, {0}, {7});
                          out.reals("/fclib_local/vectors/s", {8});
                        })).problem;
  CHECK(dense(l.V) == Numbers{0, 6});
  CHECK(dense(l.R) == Numbers{7});
  CHECK(l.s == Numbers{8});
}

TEST_CASE("where both forms stand, the global one is read") {
  const Folder folder;
  const ProblemFile p = read_problem_file(written(folder, write_global, write_local)).problem;
  CHECK(p.form == ProblemForm::global);
  CHECK(p.remarks == std::vector<std::string>{"/fclib_local is not read, since /fclib_global is there"});
}

TEST_CASE("numbers of any plain type are read") {
  const Folder folder;
  const ProblemFile p = read_problem_file(written(folder, write_local, [](const Hdf5Writer& out) {
                          const hid_t compact = H5Pcreate(H5P_DATASET_CREATE);
                          H5Pset_layout(compact, H5D_COMPACT);
                          out.reals("/fclib_local/W/x", {4, 3, 5}, H5T_IEEE_F64BE, compact);
                          H5Pclose(compact);
                          out.reals("/fclib_local/vectors/q", {-1, 0.1}, H5T_IEEE_F32BE);
                          out.integers("/fclib_local/vectors/mu", {1});
                          out.integers("/fclib_local/W/m", {2}, H5T_STD_U64BE);
                          out.integers("/fclib_local/spacedim", {2}, H5T_STD_I8LE);
                        })).problem;
  CHECK(dense(p.W) == Numbers{4, 3, 0, 5});
  CHECK(p.q == Numbers{-1, static_cast<double>(0.1F)});
  CHECK(p.mu == Numbers{1});
}

TEST_CASE("a solution and guesses are answers; a solution with r = 0 and another u is remarked upon") {
  const Folder folder;
  const auto read = [&](const Numbers& r, const Numbers& u) {
    return read_problem_file(written(folder, write_local, [&](const Hdf5Writer& out) {
      write_solution(out, r, u);
      out.group("/guesses");
      out.integers("/guesses/number_of_guesses", {2});
      for (const char* name : {"/guesses/1", "/guesses/2"}) {
        out.group(name);
        out.reals(std::string(name) + "/r", {std::nan(""), 1});
        out.reals(std::string(name) + "/u", {2, HUGE_VAL});
      }
    }));
  };
  const ReadProblem wrong = read({0, 0}, {-1, 2.5});
  REQUIRE(wrong.answers.size() == 3);
  CHECK(wrong.answers[0].origin == "/solution");
  CHECK(wrong.answers[0].u == Numbers{-1, 2.5});
  CHECK(wrong.answers[2].origin == "/guesses/2");
  CHECK(std::isnan(wrong.answers[2].r[0]));
  CHECK(wrong.answers[2].u[1] == HUGE_VAL);
  CHECK(wrong.problem.remarks.back() ==
        "the stored /solution is no solution: r is 0, and u differs from W r + q by up to 0.5");
  CHECK(read({0, 0}, {-1, 2}).problem.remarks.size() == 1);
  CHECK(read({0, 1}, {-1, 7}).problem.remarks.size() == 1);
  const SolverAnswer alone = read_answer_file(folder.path("p.hdf5"));
  CHECK(alone.r == Numbers{0, 1});
  CHECK(alone.origin == folder.path("p.hdf5"));
}

TEST_CASE("what was created and never written is left out, and without forces there is no answer") {
  const Folder folder;
  const auto with_unwritten = [&](const char* part) {
    return written(folder, write_global, [=](const Hdf5Writer& out) {
      write_solution(out, {1, 1}, {4, 5});
      const hsize_t size = std::string(part) == "/solution/v" ? 3 : 2;
      out.set(part, H5T_IEEE_F64LE, {size}, H5T_NATIVE_DOUBLE, nullptr);
    });
  };
  const ReadProblem forces = read_problem_file(with_unwritten("/solution/r"));
  CHECK(forces.answers.empty());
  CHECK(forces.problem.remarks == std::vector<std::string>{"/solution/r was never written, and is left out"});
  CHECK_THROWS_WITH_AS(read_answer_file(with_unwritten("/solution/r")),
                       doctest::Contains("/solution/r: found a data set that was never written"), InputError);
  const ReadProblem velocities = read_problem_file(with_unwritten("/solution/v"));
  REQUIRE(velocities.answers.size() == 1);
  CHECK(velocities.answers[0].r == Numbers{1, 1});
  CHECK(velocities.answers[0].v.empty());
}

TEST_CASE("an answer may stand alone in its file") {
  const Folder folder;
  const std::string path = written(folder, [](const Hdf5Writer& out) { write_solution(out, {1, 2}, {3, 4}); });
  CHECK(read_answer_file(path).u == Numbers{3, 4});
  CHECK(problem_refusal(path).starts_with(
      "FILE: found neither /fclib_local nor /fclib_global, expected one of them. Records"));
}

TEST_CASE("readers of several threads wait for each other") {
  const Folder folder;
  const std::string path = written(folder, write_local);
  std::vector<std::thread> threads;
  std::vector<int> good(4);
  for (int& mine : good) {
    threads.emplace_back([&mine, path] {
      for (int k = 0; k < 20; ++k) mine += read_problem_file(path).problem.W.entries() == 3 ? 1 : 0;
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(good == std::vector<int>(4, 20));
}

#endif
