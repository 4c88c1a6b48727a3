// The text files of Siconos: all storages, told apart by their content.
#include "contact/formats/siconos.hpp"

#include "support/files/small_files.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

ProblemFile siconos(const std::string& text) {
  return read_siconos(text, "FILE");
}

const std::string one_contact = "2\n1\n0\n2\n2\n2\t2\n 4 1 \n 3 5 \n -1 2\n 0.5\n";

/// The matrix ((4, 3), (1, 5)), of which `dense` holds the columns.
const std::string block_contact = "2 1\n1 2 2\n1 1 1\n2\n2\n2 1\n0 1\n0\n0\n 4\n 1\n 3\n 5\n-1 2\n.5\n";

}  // namespace

TEST_CASE("dense numbers are columns one after the other") {
  const ProblemFile p = siconos(one_contact);
  CHECK(p.form == ProblemForm::local);
  CHECK(p.dimension == 2);
  CHECK(p.contacts() == 1);
  CHECK(dense(p.W) == Numbers{4, 3, 1, 5});
  CHECK(p.q == Numbers{-1, 2});
  CHECK(p.mu == Numbers{0.5});
  CHECK(p.remarks.empty());
}

TEST_CASE("blocks, columns and triplets hold what the dense storage holds") {
  const SparseMatrix W = siconos(one_contact).W;
  CHECK(siconos(block_contact).W == W);
  const std::string csparse = "CSparse Version 3.1.9, May 4, 2016.  Copyright (c)\n", rest = "-1 2\n0.5\n";
  const ProblemFile columns = siconos("2\n1\n2\n2\n2\n2\n" + csparse +
                                      "2-by-2, nzmax: 4 nnz: 4, 1-norm: 8\n    col 0 : locations 0 to 1\n      0 : 4\n"
                                      "      1 : 1\n    col 1 : locations 2 to 3\n      0 : 3\n      1 : 5\n" +
                                      rest);
  CHECK(columns.W == W);
  CHECK(columns.remarks == std::vector<std::string>{"W is printed with six digits, which are taken as printed"});
  const ProblemFile rows =
      siconos("2\n1\n2\n2\n2\n3\n" + csparse +
              "csr: 2-by-2, nzmax: 4 nnz: 4, 1-norm: nan\n    row 0 : locations 0 to 1\n"
              "      0 : 4\n      1 : 3\n    row 1 : locations 2 to 3\n      0 : 1\n      1 : 5\n" +
              rest);
  CHECK(rows.W == W);
  const ProblemFile triplets = siconos("2\n1\n2\n2\n2\n1\n" + csparse +
                                       "triplet: 2-by-2, nzmax: 9 nnz: 4\n    1 1 : 5\n    0 1 : 3\n    1 0 : 1\n"
                                       "    0 0 : 4\n" +
                                       rest);
  CHECK(triplets.W == W);
  // A column without entries ends before it starts.
  const ProblemFile empty = siconos("2\n1\n2\n2\n2\n2\n" + csparse +
                                    "2-by-2, nzmax: 1 nnz: 1, 1-norm: 8\n    col 0 : locations 0 to -1\n"
                                    "    col 1 : locations 0 to 0\n      1 : 5\n" +
                                    rest);
  CHECK(dense(empty.W) == Numbers{0, 0, 0, 5});
}

TEST_CASE("blocks of several sizes stand where their row and column say") {
  // Rows of blocks: 1 and 2 high; columns: 2 and 1 wide; the blocks (0, 1), (1, 0).
  const ProblemFile p = siconos("3\n1\n3\n3\n2\n2\n2\n1 3\n2 3\n3\n2\n0 1 2\n1 0\n0\n 7\n1\n 1\n 2\n 3\n 4\n 8 9 10");
  CHECK(p.form == ProblemForm::complementarity);
  CHECK(p.dimension == 1);
  CHECK(dense(p.W) == Numbers{0, 0, 7, 1, 3, 0, 2, 4, 0});
  CHECK(p.q == Numbers{8, 9, 10});
}

TEST_CASE("global problems: q of the file is f, b of the file is w, H has a column for each component") {
  const ProblemFile p =
      siconos("2\n1\n0\n3\n3\n3 3\n1 0 0\n0 2 0\n0 0 4\n0\n3\n2\n3\t2\n1 2 3\n4 5 6\n7 8 9\n10 11\n.25\n1\n");
  CHECK(p.form == ProblemForm::global);
  CHECK(dense(p.M) == Numbers{1, 0, 0, 0, 2, 0, 0, 0, 4});
  CHECK(dense(p.H) == Numbers{1, 4, 2, 5, 3, 6});
  CHECK(p.f == Numbers{7, 8, 9});
  CHECK(p.w == Numbers{10, 11});
  CHECK(p.mu == Numbers{.25});
  CHECK(p.b.empty());
  CHECK(p.remarks == std::vector<std::string>{"after the data there is '1', which is not read"});
}

TEST_CASE("a global problem without contacts is one") {
  const std::string csparse = "CSparse Version 3.1.9, May 4, 2016.  Copyright (c)\n";
  const ProblemFile p =
      siconos("3 0 2 2 2 1\n" + csparse + "triplet: 2-by-2, nzmax: 2 nnz: 2\n0 0 : 1\n1 1 : 1\n2 2 0 2\n" + csparse +
              "2-by-0, nzmax: 1 nnz: 0, 1-norm: 0\n 5 6\n");
  CHECK(p.form == ProblemForm::global);
  CHECK(p.contacts() == 0);
  CHECK(p.H.rows == 2);
  CHECK(p.f == Numbers{5, 6});
}

TEST_CASE("complementarity problems, with words about them") {
  const ProblemFile p = siconos("2\n0\n2\n2\n2\t2\n1 3\n2 4\n-1 -1\n\nRemark 4.1.14 of a book\nset of solutions\n");
  CHECK(p.form == ProblemForm::complementarity);
  CHECK(dense(p.W) == Numbers{1, 2, 3, 4});
  CHECK(p.q == Numbers{-1, -1});
  CHECK(p.mu.empty());
  CHECK(p.remarks == std::vector<std::string>{"after the data there is 'Remark 4.1.14 of a book', which is not read"});
}

TEST_CASE("the grammar that reads a file to its end is taken before one that leaves words") {
  // Read as a local problem, q would be 2 3 3, mu 2, and the rest words.
  const ProblemFile p = siconos(
      "3 1\n0 3 3 3 3 1 0 0 0 1 0 0 0 1\n2 3 3 2\nCSparse Version 3\n3-by-3, nzmax: 1 nnz: 1, 1-norm: 1\n"
      "col 0 : locations 0 to -1\ncol 1 : locations 0 to -1\ncol 2 : locations 0 to 0\n0 : 1\n1 2 3\n4 5 6\n.5\n");
  CHECK(p.form == ProblemForm::global);
  CHECK(p.w == Numbers{4, 5, 6});
}

TEST_CASE("numbers printed by %e are told, those written by hand are not") {
  const auto remarks = [](const std::string& entry) {
    return siconos("1\n1\n1\n1\n1\n1\n1\n1\n1\n2\n1\n0 1\n0\n0\n" + entry + "\n-1").remarks.size();
  };
  CHECK(remarks("5.220412e-05") == 1);
  CHECK(remarks("1.065000e+02") == 0);
  CHECK(remarks("0.5") == 0);
  CHECK(remarks("5.220412345678901234e-05") == 0);
}

TEST_CASE("decimals are the nearest binary64, also beyond its range below") {
  const ProblemFile p = siconos("4 0 4 4 4 4 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\n0.1 1e-400 +3 9007199254740993");
  CHECK(p.q == Numbers{0.1, 0, 3, 9007199254740992});
}

TEST_CASE("malformed texts of Siconos are refused at their place") {
  check_refusals(
      {
          {"",
           "FILE:1:1: found the end of the file, expected a contact problem: FCLIB HDF5, Siconos text, MatrixMarket, "
           "JSON"},
          {" \n\n", "FILE:3:1: found the end of the file"},
          {"x y z", "FILE:1:1: found 'x', expected a contact problem"},
          {"2",
           "FILE:1:2: read as a local friction problem: found the end of the file, expected the number of contacts"},
          {"2\n1\n0\n2\n2\n2\t2\n 4 1 \n 3 5 \n -1 2\n",
           "FILE:10:1: read as a local friction problem: found the end of the file, expected a coefficient of "
           "friction"},
          {"2\n1\n0\n2\n2\n2\t2\n 4 1 \n 3 x \n -1 2\n .5",
           "FILE:8:4: read as a local friction problem: found 'x', expected an entry of W"},
          {"2\n1\n0\n2\n2\n2\t2\n 4 1 \n 3 nan \n -1 2\n .5",
           "FILE:8:4: read as a local friction problem: found 'nan', expected an entry of W, finite and within"},
          {"2\n1\n0\n2\n2\n2\t2\n 4 1 \n 3 5 \n -1 inf\n .5",
           "FILE:9:5: read as a local friction problem: found 'inf', expected one of the 2 components of q, finite"},
          {"2\n1\n0\n2\n2\n2\t2\n 4 1 \n 3 1e999999999 \n -1 2\n .5",
           "FILE:8:4: read as a local friction problem: found '1e999999999', expected an entry of W, finite"},
          {"2\n1\n0\n2\n2\n2\t2\n 4 1 \n 3 5 \n -1 2\n -0.5",
           "FILE:10:2: read as a local friction problem: found '-0.5', expected a coefficient of friction, which is "
           "not"},
          {one_contact + "3 4", "FILE:11:1: read as a local friction problem: found more numbers, expected the end"},
          {one_contact + "0.5", "FILE:11:1: read as a local friction problem: found more numbers, expected the end"},
          {one_contact + "1 word", "FILE:11:1: read as a local friction problem: found more numbers"},
          {"2\n1\n0\n2\n3\n2\t3\n 4 1 0 3 5 0\n 1 2 3\n.5",
           "FILE:5:1: read as a local friction problem: found '3', expected 2, the number of columns of W"},
          {"2\n2\n0\n2\n2\n2\t2\n 4 1 3 5\n 1 2 3\n.5",
           "FILE:8:6: read as a global friction problem: found '3', expected 4, the number of columns of H"},
          {"2\n1\n0\n2\n2\n2\t3\n 4 1 \n",
           "FILE:6:3: read as a local friction problem: found '3', expected 2, the number"},
          {"2\n1\n7\n2\n2\n",
           "FILE:3:1: read as a local friction problem: found '7', expected the storage of W: 0 (dense)"},
          {"5\n1\n0\n2\n2\n",
           "FILE:3:1: read as a complementarity problem: found '0', expected 5, the number of rows of W"},
          {"2\n1\n0\n-2\n2\n",
           "FILE:4:1: read as a local friction problem: found '-2', expected 2, the number of rows of W"},
          {"2\n1\n0\n2.0\n2\n",
           "FILE:4:1: read as a local friction problem: found '2.0', expected 2, the number of rows"},
          {"2\n1099511627776\n0\n2\n2\n",
           "FILE:2:1: read as a local friction problem: found '1099511627776', expected the number of contacts, of "
           "which a "
           "file of 22 bytes cannot have more"},
          {"2\n1\n0\n1099511627776\n1099511627776\n",
           "FILE:4:1: read as a local friction problem: found '1099511627776', expected 2, the number of "
           "rows of W"},
          {"2 1\n0\n99999999999999999999999999 2\n", "FILE:3:1: read as a local friction problem: found '9999"},
          {"2 1\n1 2 2\n9 9 9\n", "FILE:4:1: read as a local friction problem: found the end"},
          {"2 1\n1 2 2\n1 1 1\n3\n2\n2 1\n0 1\n0\n0\n 4 1 3 5 -1 2 .5",
           "FILE:4:1: read as a local friction problem: found 3, expected the end of a block of rows of W, which "
           "increase"},
          {"2 1\n1 2 2\n1 2 1\n2 2\n2\n2 1\n0 1\n0\n0\n 4 1 3 5 -1 2 .5",
           "FILE:4:1: read as a local friction problem: found 2, expected the end of a block of rows of W"},
          {"2 1\n1 2 2\n1 1 1\n2\n2\n3 1\n0 1\n0\n0\n 4 1 3 5 -1 2 .5",
           "FILE:6:1: read as a local friction problem: found 3, expected at most 2 starts of rows of blocks of W"},
          {"2 1\n1 2 2\n1 1 1\n2\n2\n2 2\n0 1\n0\n0\n 4 1 3 5 -1 2 .5",
           "FILE:6:3: read as a local friction problem: found '2', expected 1, the number of blocks of W again"},
          {"2 1\n1 2 2\n1 1 1\n2\n2\n2 1\n0 2\n0\n0\n 4 1 3 5 -1 2 .5",
           "FILE:7:3: read as a local friction problem: found 2, expected the start of a row of blocks of W, from 0"},
          {"2 1\n1 2 2\n1 1 1\n2\n2\n2 1\n1 1\n0\n0\n 4 1 3 5 -1 2 .5",
           "FILE:7:1: read as a local friction problem: found 1, expected the start of a row of blocks of W, from 0"},
          {"2 1\n1 2 2\n1 1 1\n2\n2\n2 1\n0 1\n1\n0\n 4 1 3 5 -1 2 .5",
           "FILE:8:1: read as a local friction problem: found 1, expected the column of a block of W, below 1"},
          {"2 1\n1 2 2\n1 1 1\n2\n2\n2 1\n0 1\n0\n1\n 4 1 3 5 -1 2 .5",
           "FILE:9:1: read as a local friction problem: found '1', expected 0, the index before a block of W"},
          {"2 1\n1 2 2\n2 1 1\n2\n2\n2 2\n0 2\n0 0\n0\n 4 1 3 5 1 4 1 3 5 -1 2 .5",
           "FILE:2:1: read as a local friction problem: W: found the entry in row 1 and column 1 twice, expected it "
           "once"},
          {"2 1 2 2 2 2\n(null)\n", "FILE:2:1: read as a local friction problem: found '(null)', expected 'CSparse'"},
          {"3 1 2 3 3 4\nCSparse\n",
           "FILE:1:11: read as a local friction problem: found '4', expected the origin of W: 1"},
          {"2 1 2 2 2 1\nCSparse 3\n2-by-2, nzmax: 1 nnz: 0, 1-norm: 0",
           "FILE:3:1: read as a local friction problem: found '2-by-2,', expected a matrix of the origin 1 for W"},
          {"2 1 2 2 2 2\nCSparse 3\n2-by-3, nzmax: 1 nnz: 0, 1-norm: 0",
           "FILE:3:1: read as a local friction problem: found '2-by-3,', expected '2-by-2,'"},
          {"2 1 2 2 2 1\nCSparse 3\ntriplet: 2-by-2, nzmax: 1 nnz: 1\n0 2 : 5",
           "FILE:4:3: read as a local friction problem: found 2, expected the column of an entry of W, below 2"},
          {"2 1 2 2 2 1\nCSparse 3\ntriplet: 2-by-2, nzmax: 1 nnz: 2\n0 1 : 5\n0 1 : 6\n1 1 1",
           "FILE:1:5: read as a local friction problem: W: found the entry in row 1 and column 2 twice, expected it "
           "once"},
          {"2 1 2 2 2 1\nCSparse 3\ntriplet: 2-by-2, nzmax: 1 nnz: 1099511627776\n0 1 : 5\n",
           "FILE:5:1: read as a local friction problem: found the end of the file, expected the row of an entry"},
          {"2 1 2 2 2 2\nCSparse 3\n2-by-2, nzmax: 4 nnz: 1, 1-norm: 8\ncol 1 : locations 0 to 0\n",
           "FILE:4:5: read as a local friction problem: found '1', expected 0, the next column"},
          {"2 1 2 2 2 2\nCSparse 3\n2-by-2, nzmax: 4 nnz: 1, 1-norm: 8\ncol 0 : locations 1 to 1\n",
           "FILE:4:19: read as a local friction problem: found '1', expected 0, the number of entries before"},
          {"2 1 2 2 2 2\nCSparse 3\n2-by-2, nzmax: 4 nnz: 1, 1-norm: 8\ncol 0 : locations 0 to 1\n",
           "FILE:4:24: read as a local friction problem: found the location 2 - 1, expected one from 0 - 1 to 1 - 1"},
          {"2 1 2 2 2 2\nCSparse 3\n2-by-2, nzmax: 4 nnz: 1, 1-norm: 8\ncol 0 : locations 0 to 0\n  ...\n",
           "FILE:5:3: read as a local friction problem: found '...', expected the row of an entry"},
          {"2 1 2 2 2 2\nCSparse 3\n2-by-2, nzmax: 4 nnz: 9, 1-norm: 8\ncol 0 : locations 0 to -1\ncol 1 : locations 0 "
           "to -1\n1 1 1",
           "FILE:6:1: read as a local friction problem: found '1', expected 9 entries of W altogether"},
          {std::string("2 1 0 2 2 2 2 \0\xff\xfe\x01", 19),
           "FILE:1:15: read as a local friction problem: found '\\x00"},
          {"5\n1\n0\n5\n5\n5 5\n1 0 0 0 0\n0 1 0 0 0\n0 0 1 0 0\n0 0 0 1 0\n0 0 0 0 1\n-1 0 0 0 0\n 0.3\n 0.1",
           "FILE: found rolling friction: five components a contact, or three in the plane, and two coefficients"},
          {"3\n1\n0\n3\n3\n3 3\n1 0 0\n0 1 0\n0 0 1\n-1 0 0\n 0.3\n 0.1", "FILE: found rolling friction"},
          {"5\n1\n0\n5\n5\n5 5\n1 0 0 0 0\n0 1 0 0 0\n0 0 1 0 0\n0 0 0 1 0\n0 0 0 0 1\n-1 0 0 0 0\n 0.3",
           "FILE:3:1: read as a complementarity problem"},
          {std::string("\0\0\xff\xfe\x01", 5), "FILE: found bytes that are not text, expected a contact problem"},
          {"\xff\xfe"
           "2",
           "FILE: found bytes that are not text, expected a contact problem"},
      },
      "p.dat", problem_refusal);
}

TEST_CASE("what begins with a number is no header of records, whatever follows") {
  const Folder folder;
  const auto is_problem = [&](const std::string& text) { return is_problem_file(folder.write("p.dat", text)); };
  for (const char* text : {"3", "3\n31\n", "3.0 1 0", "-3 1 0", "3 1x 0", "\n 2 1"}) CHECK(is_problem(text));
  for (const char* text : {"", "R,h\n1,2\n", "3,1,0", "inf 1 2", "mode\n"}) CHECK_FALSE(is_problem(text));
}

TEST_CASE("a text that is cut off anywhere is refused or ends with whole data") {
  for (const std::string& text : {one_contact, block_contact}) {
    for (std::size_t size = 0; size < text.size(); ++size) {
      CAPTURE(size);
      // What is cut off within the last number, or behind it, is still a number.
      if (size + 3 < text.size()) CHECK_THROWS_AS(siconos(text.substr(0, size)), InputError);
    }
  }
}
