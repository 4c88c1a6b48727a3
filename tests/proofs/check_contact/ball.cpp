// Balls, with an order and with a factor, and problems of which half is written: accepted, and every forgery rejected.
#include "proofs/check_contact/examples.hpp"

using namespace slipproof::check_contact;

TEST_CASE("ball: by an order of the unknowns, and by a factor as earlier versions wrote it") {
  const std::string factor = replaced(kBall, "order 8 1 0", "factor 3  0 0 33/256  1 0 31/128  1 1 1/8");
  const std::string row = ": the diagonal is less than the others", bends = "the equations bend more";
  const std::string defect = "the center is farther from the equations than the defect";
  const std::vector<Forgery> alike{
      {"ball 1/8", "ball 1/16", "component 0: the solution may be farther than RHO from the answer"},
      {"least 3/64", "least 0", "the least singular value is not positive"},
      {"least 3/64", "least 1/32", "the ball is not mapped into itself"},
      {"defect 9/256", "defect -9/256", "the defect or the bend is negative"},
      {"defect 9/256", "defect 1/32", defect},
      {"bend 0", "bend -1/256", "the defect or the bend is negative"},
      {"center 65/64", "center 33/32", defect},
      {"constant -3", "constant -4", defect},
      {"rows 1 1", "rows 2 1", defect}};
  reject_all(kBall, alike);
  reject_all(factor, alike);
  reject_all(kBall, {{"least 3/64", "least 1/8", "row 1" + row},
                     {"order 8", "order 2", "row 0" + row},
                     {"1 1 2", "1 1 1/2", defect}});
  reject_all(factor, {{"least 3/64", "least 1/8", "row 0" + row},
                      {"31/128", "-31/128", "row 0" + row},
                      {"1 1 1/8", "1 1 1/2", "row 1" + row}});
  CHECK(verdict(replaced(kBall, "order 8 1 0", "order 8 0 1")) == verdict(kBall));
  CHECK(verdict(factor) == verdict(kBall));
  // A singular matrix has no least singular value, on any grid.
  const std::string singular = replaced(replaced(kBall, "2 0 1 1 2", "2 0 2 1 2"), "order 8", "order 200");
  CHECK(verdict(singular) == "rejected: " + defect);
  CHECK(verdict(replaced(replaced(singular, "defect 9/256", "defect 10"), "least 3/64", "least 10")) ==
        "rejected: row 0" + row);
}

TEST_CASE("ball: an order has each unknown once") {
  const std::string place = "unreadable: line 19, column ";
  CHECK(verdict(replaced(kBall, "order 8 1 0", "order 8 1 1")) ==
        place + "11: found '1', expected an index that does not stand here already");
  CHECK(verdict(replaced(kBall, "order 8 1 0", "order 8 1 2")) == place + "11: found '2', expected an index below 2");
  CHECK(verdict(replaced(kBall, "order 8 1 0", "order 5000 1 0")) ==
        place + "7: found '5000', expected an index below 5000");
  CHECK(verdict(replaced(kBall, "order 8 1 0", "order 8 1")) ==
        "unreadable: line 20, column 1: found 'end', expected an index below 2");
}

TEST_CASE("a problem of which half is written is the same problem") {
  const std::string rod = "matrix 5\n0 0 1  0 1 -1  0 2 -1  1 0 1  2 0 1\n";
  const std::string half = "mirrored 1\n1 0 1\n1 0 1\n1 0 1\n";
  CHECK(checked_on_record(replaced(kRod, rod, half)).message == checked_on_record(kRod).message);
  CHECK(verdict(replaced(kNamed, "matrix 3\n0 0 1  1 1 1  2 2 1", "mirrored 0\n1 0 1  1 1 1  1 2 1")) ==
        verdict(kNamed));
  reject_all(replaced(kRod, rod, half),
             {{"mirrored 1", "mirrored 0", "unknown 1: |I - R J| p is not less than its radius"}});
  const std::string place = "unreadable: line 4, column ";
  CHECK(verdict(replaced(kRod, rod, "mirrored 4\n1 0 1\n1 0 1\n1 0 1\n")) ==
        place + "10: found '4', expected an index below 4");
  CHECK(verdict(replaced(kRod, rod, "mirrored 1\n1 1 1\n1 0 1\n1 0 1\n")) ==
        "unreadable: line 5, column 3: found '1', expected an index below 1");
  CHECK(verdict(replaced(kRod, rod, "mirrored 1\n1 0 1\n2 0 1 0 1\n1 0 1\n")) ==
        "unreadable: line 6, column 7: found '0', expected an index that does not stand here already");
}
