// Answers in files of their own, in whatever a solver writes.
#include <bit>
#include <cstdint>
#include <limits>

#include "support/files/npy_file.hpp"
#include "support/files/small_files.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

SolverAnswer answer(const std::string& content, const std::string& name = "a") {
  const Folder folder;
  return read_answer_file(folder.write(name, content));
}

std::string npy(const std::string& header, const std::string& data, char version = 1) {
  return npy_with(header, data, version);
}

std::string header(const std::string& type, const std::string& order, const std::string& shape) {
  return "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }   \n";
}

/// The numbers in 8 or 4 bytes.
std::string raw(const Numbers& numbers, std::size_t width = 8, bool big = false) {
  std::string result;
  for (const double x : numbers) {
    std::string bytes = width == 8 ? little(std::bit_cast<std::uint64_t>(x), 8)
                                   : little(std::bit_cast<std::uint32_t>(static_cast<float>(x)), 4);
    result += big ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
  }
  return result;
}

const std::string three = npy(header("<f8", "False", "(3,)"), raw({1, -2.5, 1e300}));

}  // namespace

TEST_CASE("plain numbers are r") {
  const SolverAnswer a = answer("1 -2.5\n\t1e300\r\n0.1");
  CHECK(a.r == Numbers{1, -2.5, 1e300, 0.1});
  CHECK(a.u.empty());
  const SolverAnswer odd = answer("nan inf -inf +1 NaN 1e999");
  CHECK(std::isnan(odd.r[0]));
  CHECK(odd.r[1] == std::numeric_limits<double>::infinity());
  CHECK(odd.r[2] == -std::numeric_limits<double>::infinity());
  CHECK(odd.r[3] == 1);
  CHECK(std::isnan(odd.r[4]));
  CHECK(odd.r[5] == std::numeric_limits<double>::infinity());
}

TEST_CASE("a vector of MatrixMarket is r") {
  CHECK(answer("%%MatrixMarket matrix array real general\n% by a solver\n3 1\n1\n2\nnan\n").r.size() == 3);
}

TEST_CASE("JSON has the parts under their names") {
  const SolverAnswer a =
      answer(R"({"z": [1, 2], "w": [NaN, 4], "iterations": 17, "solver": "x", "times": {"a": [null, true]}})");
  CHECK(a.r == Numbers{1, 2});
  CHECK(a.u[1] == 4);
  const SolverAnswer b = answer(R"({"r": ["0.5"], "velocity": [2], "v": [3, 4], "lambda": [5]})");
  CHECK(b.r == Numbers{0.5});
  CHECK(b.u == Numbers{2});
  CHECK(b.v == Numbers{3, 4});
  CHECK(b.lambda == Numbers{5});
}

TEST_CASE("NumPy's arrays of either byte order, width and order of dimensions") {
  CHECK(answer(three).r == Numbers{1, -2.5, 1e300});
  CHECK(answer(npy(header(">f8", "False", "(3, 1)"), raw({1, -2.5, 1e300}, 8, true))).r == Numbers{1, -2.5, 1e300});
  CHECK(answer(npy(header("<f4", "True", "(2,)"), raw({1, 0.1}, 4))).r == Numbers{1, static_cast<double>(0.1F)});
  CHECK(answer(npy(header(">f4", "False", "(1, 2)"), raw({1, 0.5}, 4, true), 2)).r == Numbers{1, 0.5});
  // Rows of contacts.
  CHECK(answer(npy(header("<f8", "False", "(2, 3)"), raw({1, 2, 3, 4, 5, 6}))).r == Numbers{1, 2, 3, 4, 5, 6});
  CHECK(answer(npy(header("<f8", "True", "(2, 3)"), raw({1, 4, 2, 5, 3, 6}))).r == Numbers{1, 2, 3, 4, 5, 6});
}

TEST_CASE("NumPy's whole numbers are numbers") {
  CHECK(answer(npy(header("<i8", "False", "(2,)"), little(5, 8) + little(~std::uint64_t{0}, 8))).r == Numbers{5, -1});
  CHECK(answer(npy(header("|u1", "False", "(2,)"), "\x05\xff")).r == Numbers{5, 255});
}

TEST_CASE("more numbers than the problem has are refused in every format") {
  const Folder folder;
  const auto said = [&](const std::string& content) {
    const std::string path = folder.write("a", content);
    return refusal([&] { read_answer_file(path, {.r = 2, .u = 2, .v = 0, .lambda = 0}); }, path);
  };
  CHECK(said(three) == "FILE: found 3 numbers, expected 2");
  CHECK(said("1 2\n3 x") == "FILE:2:1: found '3', expected the end of the 2 numbers of the answer");
  CHECK(said("%%MatrixMarket matrix array real general\n3 1\n1\n") == "FILE:2:1: found 3 numbers, expected 2");
  CHECK(said(R"({"r": [1, 2], "u": [1, 2, 3]})") == "FILE: u: found 3 numbers, expected 2");
  CHECK(said(npy(header("<f8", "False", "(2,)"), raw({1, 2}))).empty());
}

TEST_CASE("malformed answers are refused") {
  const std::string numbers = raw({1, 2});
  check_refusals(
      {
          {"", "FILE: found neither r nor u, expected an answer"},
          {"1 2\n3 x", "FILE:2:3: found 'x', expected a number of the answer"},
          {"1,2", "FILE:1:1: found '1,2', expected a number of the answer"},
          {"{\"iterations\": 3}", "FILE: found neither r nor u"},
          {R"({"r": [1], "z": [2]})", "FILE: z: found the same part under two names"},
          {R"({"r": 1})", "FILE: r: found no list, expected a list of numbers"},
          {R"({"r": [[1]]})", "FILE: r[1]: found no number, expected one"},
          {"%%MatrixMarket matrix array real general\n2 1\n1\n",
           "FILE:4:1: found the end of the file, expected a component"},
          {"%%MatrixMarket matrix array real general\n1099511627776 1\n1\n", "FILE:2:1: found '1099511627776'"},
          {"\x93NUMPY", "FILE: found no .npy array"},
          {npy(header("<f8", "False", "(3,)"), numbers), "FILE: found 16 bytes of data, expected 3 items of 8"},
          {npy(header("<f8", "False", "(2,)"), numbers + "x"), "FILE: found 17 bytes of data, expected 2 items"},
          {npy(header("<f8", "False", "(1099511627776,)"), numbers), "FILE: found 16 bytes of data"},
          {npy(header("<f8", "False", "(99999999999999999999999,)"), numbers), "FILE: found the shape"},
          {npy(header("<f8", "False", "(1, 2, 1)"), numbers), "FILE: found 3 dimensions, expected one or two"},
          {npy(header("<f8", "False", "()"), numbers.substr(8)), "FILE: found 0 dimensions"},
          {npy(header("<c16", "False", "(1,)"), numbers),
           "FILE: found the type '<c16', expected f8 or f4, or integers"},
          {npy(header("|O", "False", "(2,)"), numbers),
           "FILE: found Python objects ('|O'), which only Python could read"},
          {npy(header("<f8", "Maybe", "(2,)"), numbers),
           "FILE: found the fortran_order 'Maybe', expected True or False"},
          {npy("{'descr': '<f8'}", numbers), "FILE: found no 'fortran_order' in the header of an array"},
          {std::string("\x93NUMPY\x01\x00\xff\xff{'descr'", 18), "FILE: found a header that is cut off"},
          {"PK\x03\x04 and more",
           "FILE: found an archive of NumPy (.npz), expected one array (.npy) with r, or JSON with r, u, v and lambda"},
      },
      "a", answer_refusal);
  const Folder folder;
  CHECK(answer_refusal(folder.path("")).ends_with("found a directory, expected a file"));
  CHECK(answer_refusal(folder.path("none")).starts_with("FILE: cannot be opened: "));
}
