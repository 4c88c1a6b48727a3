// MatrixMarket: a matrix with its vectors beside it.
#include "contact/formats/matrix_market.hpp"

#include "support/files/small_files.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

SparseMatrix market(const std::string& text, std::size_t size) {
  return read_market_matrix(text, "FILE", size, size);
}

const std::string banner = "%%MatrixMarket matrix ";

}  // namespace

TEST_CASE("coordinates count from 1, arrays go column by column") {
  const Numbers expected = {4, 3, 0, 5};
  CHECK(dense(market(banner + "coordinate real general\n% words\n\n2 2 3\n1 1 4\n2 2 5\n1 2 3\n", 2)) == expected);
  CHECK(dense(market(banner + "array real general\n2 2\n4\n0\n3\n5\n", 2)) == expected);
  CHECK(dense(market("%%MatrixMarket MATRIX Array Integer GENERAL\n2 2\n4 0 3 5", 2)) == expected);
}

TEST_CASE("of symmetric and skew-symmetric matrices the other half is made") {
  CHECK(dense(market(banner + "coordinate real symmetric\n2 2 2\n1 1 4\n2 1 3\n", 2)) == Numbers{4, 3, 3, 0});
  CHECK(dense(market(banner + "array real symmetric\n2 2\n4\n3\n5\n", 2)) == Numbers{4, 3, 3, 5});
  CHECK(dense(market(banner + "coordinate real skew-symmetric\n2 2 1\n2 1 3\n", 2)) == Numbers{0, -3, 3, 0});
  CHECK(dense(market(banner + "array real skew-symmetric\n2 2\n3\n", 2)) == Numbers{0, -3, 3, 0});
}

TEST_CASE("the vectors beside a matrix make the problem") {
  const Folder folder;
  const std::string path = folder.write("p.mtx", banner + "array real general\n2 2\n4\n1\n3\n5\n");
  CHECK(problem_refusal(path).starts_with("FILE: found no "));
  folder.write("p_q.mtx", banner + "array real general\n2 1\n-1\n2\n");
  ReadProblem read = read_problem_file(path);
  CHECK(read.problem.form == ProblemForm::complementarity);
  CHECK(dense(read.problem.W) == Numbers{4, 3, 1, 5});
  CHECK(read.problem.q == Numbers{-1, 2});
  CHECK(read.answers.empty());
  folder.write("p_mu.mtx", banner + "array real general\n1 1\n0.5\n");
  folder.write("p_r.mtx", banner + "array real general\n1 2\n7\nnan\n");
  read = read_problem_file(path);
  CHECK(read.problem.form == ProblemForm::local);
  CHECK(read.problem.dimension == 2);
  REQUIRE(read.answers.size() == 1);
  CHECK(read.answers[0].r[0] == 7);
  CHECK(std::isnan(read.answers[0].r[1]));
  CHECK(read.problem.remarks.size() == 1);  // asymmetric
  CHECK(is_problem_file(path));
  folder.write("p_mu.mtx", banner + "array real general\n2 1\n0.5\n0.5\n");
  CHECK(problem_refusal(path) ==
        "FILE: mu: found 2 coefficients for 2 components, expected 2 or 3 components for each contact");
  folder.write("p_mu.mtx", banner + "array real general\n1 1\n-1\n");
  CHECK(problem_refusal(path) == "FILE: mu[1]: found -1, expected a coefficient of friction, which is not negative");
  folder.write("p_q.mtx", banner + "array real general\n2 1\n-1\ninf\n");
  folder.write("p_mu.mtx", banner + "array real general\n1 1\n1\n");
  CHECK(problem_refusal(path) == "FILE: q[2]: found an infinity, expected a finite number");
}

TEST_CASE("malformed MatrixMarket files are refused at their place") {
  const Folder folder;
  folder.write("p_q.mtx", banner + "array real general\n2 1\n-1\n2\n");
  const std::vector<Malformed> files = {
      {banner + "coordinate pattern general\n2 2 1\n1 1",
       "FILE:1:34: found 'pattern', expected real or integer or double"},
      {banner + "coordinate complex general\n2 2 1\n1 1 1 0", "FILE:1:34: found 'complex', expected real"},
      {banner + "coordinate real hermitian\n2 2 1\n1 1 1",
       "FILE:1:39: found 'hermitian', expected general or symmetric"},
      {banner + "elemental real general\n2 2 1\n1 1 1", "FILE:1:23: found 'elemental', expected coordinate or array"},
      {"%%MatrixMarket vector array real general\n2 1\n1\n1", "FILE:1:16: found 'vector', expected matrix"},
      {banner + "coordinate real general\n", "FILE:2:1: found the end of the file, expected the number of rows"},
      {banner + "coordinate real general\n2 2 2\n1 1 4\n", "FILE:4:1: found the end of the file, expected the row"},
      {banner + "coordinate real general\n2 2 1\n0 1 4\n",
       "FILE:3:1: found 0, expected the row of an entry, from 1 to 2"},
      {banner + "coordinate real general\n2 2 1\n1 3 4\n",
       "FILE:3:3: found 3, expected the column of an entry, from 1"},
      {banner + "coordinate real general\n2 2 1\n1 -1 4\n", "FILE:3:3: found '-1', expected the column of an entry"},
      {banner + "coordinate real general\n2 2 2\n1 1 4\n1 1 4\n",
       "FILE:2:1: found the entry in row 1 and column 1 twice"},
      {banner + "coordinate real general\n2 2 1\n1 1 NaN\n",
       "FILE:3:5: found 'NaN', expected an entry of the matrix, finite"},
      {banner + "coordinate integer general\n2 2 1\n1 1 1.5\n",
       "FILE:3:5: found '1.5', expected an entry of the matrix, a whole number, as the first line says integer"},
      {banner + "array integer general\n2 2\n1\n2\n3e0\n4\n",
       "FILE:5:1: found '3e0', expected an entry of the matrix, a"},
      {"%MatrixMarket matrix array real general\n2 2\n", "FILE:1:1: found '%MatrixMarket', expected '%%MatrixMarket'"},
      {banner + "coordinate real general\n2 2 1\n1 1 1/2\n", "FILE:3:5: found '1/2', expected an entry of the matrix"},
      {banner + "coordinate real general\n2 2 1\n1 1 4\n9\n", "FILE:4:1: found '9', expected the end of the file"},
      {banner + "coordinate real general\n3 3 0\n",
       "FILE:2:1: found 3 rows and 3 columns, expected 2 rows and 2 columns, the length"},
      {banner + "coordinate real general\n1099511627776 2 0\n",
       "FILE:2:1: found '1099511627776', expected the number of"},
      {banner + "coordinate real general\n2 2 1099511627776\n",
       "FILE:2:5: found '1099511627776', expected the number of"},
      {banner + "coordinate real symmetric\n2 2 1\n1 2 4\n",
       "FILE:3:1: found the row 1 and the column 2, expected what is"},
      {banner + "coordinate real skew-symmetric\n2 2 1\n1 1 4\n",
       "FILE:3:1: found the row 1 and the column 1, expected"},
      {banner + "array real general\n2 2\n4\n0\n3\n", "FILE:6:1: found the end of the file, expected an entry"},
  };
  for (const Malformed& file : files) {
    CAPTURE(file.content);
    const std::string said = problem_refusal(folder.write("p.mtx", file.content));
    CHECK_MESSAGE(said.starts_with(file.message), said);
  }
  CHECK(problem_refusal(folder.write("p.txt", banner + "array real general\n1 1\n1\n")) ==
        "FILE: found a matrix, expected a name that ends in .mtx, with q in the same folder");
  for (const char* vector : {"array real general\n2 2\n1 2 3 4", "coordinate real general\n2 1 0"}) {
    const std::string q = folder.write("p_q.mtx", banner + vector);
    CHECK(problem_refusal(folder.path("p.mtx"))
              .ends_with("found a matrix, expected a vector: a general array of one column"));
  }
}
