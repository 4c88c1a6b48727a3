// The checker accepts a certificate of each claim and rejects every forgery: for each side condition of FORMAT.md a
// certificate that differs from a valid one only there.
#include "proofs/check_contact/examples.hpp"

using namespace slipproof::check_contact;

TEST_CASE("what is established is told in words, with bounds rounded up") {
  CHECK(verdict(kEps) ==
        "accepted: a solution of a problem whose constant differs by at most 2.5e-1, within 1.3e-1 of the answer, 1 "
        "contacts "
        "in dimension 3 and 1 free unknowns");
  CHECK(verdict(kNoneWithin) ==
        "accepted: no solution within 1.3e-1 of the answer, by contact 0, 1 contacts in dimension 3");
  CHECK(verdict(kNoSolution) == "accepted: no solution, 1 contacts in dimension 3 and 1 free unknowns");
  CHECK(verdict(kSlide) == "accepted: a solution within 2.0e0 of the answer, 1 contacts in dimension 3");
  CHECK(verdict(replaced(kPlane, "enclosure 1/2", "enclosure 0x1.f4p+6")) ==
        "accepted: a solution within 1.3e2 of the answer, 3 contacts in dimension 2");
  CHECK(verdict(kDominant) ==
        "accepted: one solution, whatever the constant, by a dominant matrix, 2 contacts in dimension 1");
  CHECK(verdict(kDefinite) ==
        "accepted: one solution, whatever the constant, by a definite matrix, 2 contacts in dimension 1");
  CHECK(verdict(kDeterminants) ==
        "accepted: one solution, whatever the constant, by the mode determinants, 1 contacts in dimension 2");
  CHECK(verdict(kBound) ==
        "accepted: one solution, whatever the constant, by a bound on mu, 1 contacts in dimension 2");
}

TEST_CASE("eps: law, bound and distance") {
  reject_all(kEps, {{"mu 1/2", "mu -1/2", "contact 0: mu is negative"},
                    {"eps 1/4", "eps -1/4", "BOUND is negative"},
                    {"1/4 1/8", "1/4 -1/8", "MOVED is negative"},
                    {"eps 1/4", "eps 63/256", "row 3: w^ is farther than BOUND from A x^ + c"},
                    {"1/4 1/8", "1/4 31/256", "component 3: x^ is farther than MOVED from the answer"},
                    {"answer 3", "answer 4", "component 0: x^ is farther than MOVED from the answer"},
                    {"answer 3  10 -3 -33/8", "no-answer", "the claim speaks of the answer, and there is no-answer"},
                    {"motion 0", "motion 1/4", "row 0: w^ is not 0"},
                    {"constant -6", "constant -7", "row 0: w^ is farther than BOUND from A x^ + c"},
                    {"motion 0  0", "motion 0  -1/8", "contact 0: u_N is negative"},
                    {"motion 0  0", "motion 0  1/8", "contact 0: neither u_N nor r_N is 0"},
                    {"point 3  10 -3 -4", "point 3  -10 -3 -4", "contact 0: r_N is negative"},
                    {"point 3  10 -3 -4", "point 3  10 -3 -5", "contact 0: the force is outside of the friction cone"},
                    {"point 3  10 -3 -4", "point 3  0 -3 -4", "contact 0: the force is outside of the friction cone"},
                    {"point 3  10 -3 -4", "point 3  10 -3 -3",
                     "contact 0: it slides with a force inside of the friction cone"},
                    {"point 3  10 -3 -4", "point 3  10 3 4", "contact 0: friction drives the sliding"},
                    {"point 3  10 -3 -4", "point 3  10 -4 -3", "contact 0: friction is not parallel to the sliding"},
                    {"point 3  10 -3 -4", "point 3  10 -5 0", "contact 0: friction is not parallel to the sliding"}});
  const std::string planar =
      "slipproof-contact 1 dimension 2 free 0 contacts 1 mu 1/2 matrix 0 constant 0 3 answer 4 -2 eps 0 0 point 4 -2 "
      "motion 0 3 end";
  reject_all(planar, {{"point 4 -2", "point 4 2", "contact 0: friction drives the sliding"},
                      {"point 4 -2", "point 4 -1", "contact 0: it slides with a force inside of the friction cone"}});
  const std::string without_friction = replaced(planar, "mu 1/2", "mu 0");
  reject_all(replaced(replaced(without_friction, "4 -2", "4 0"), "point 4 -2", "point 4 0"),
             {{"point 4 0", "point 4 1", "contact 0: the force is outside of the friction cone"}});
}

TEST_CASE("none-within: the law or a row fails in the whole box") {
  const std::string may = "every row and every contact may hold within RHO";
  reject_all(kNoneWithin, {{"within 1/8", "within 1/2", may},
                           {"within 1/8", "within -1/8", "RHO is negative"},
                           {"mu 1/2", "mu -1/2", "contact 0: mu is negative"},
                           {"answer 1 0 0", "no-answer", "the claim speaks of the answer, and there is no-answer"},
                           {"constant -1 1 0", "constant -1 1/8 0", may},
                           {"mu 1/2", "mu 1/5", may}});
  const std::string row =
      "slipproof-contact 1 dimension 1 free 1 contacts 0 mu matrix 1 0 0 -4 constant 1 answer 0 none-within 1/5 end";
  reject_all(row, {{"1/5", "1/4", may}, {"constant 1", "constant 1/2", may}});
}

TEST_CASE("none-within: each mode is excluded by each of its conditions, and at its edge by none") {
  struct Case {
    std::string mu, force, motion;
    std::string least;  ///< RHO at which the law may hold
  };
  // w = u exactly, as the matrix is 0.
  const std::vector<Case> table = {
      {"1/2", "1 0 0", "1 0 0", "1"},    // open at r_N = 0
      {"1/2", "0 3 4", "2 7 7", "4"},    // open at r_T = 0
      {"1/2", "2 4 0", "0 0 0", "2"},    // sticks at the edge, 4 - rho = 1/2 (2 + rho)
      {"1/2", "-2 0 0", "0 0 0", "2"},   // sticks at r_N = 0
      {"1/2", "-2 0 0", "0 1 0", "2"},   // slides at r_N = 0
      {"1/2", "4 2 0", "0 1 0", "2"},    // slides at r_T . u_T = 0
      {"1/2", "4 0 2", "0 0 1", "2"},    // the same
      {"1/2", "4 0 -2", "0 1 0", "2"},   // slides at r_T x u_T = 0
      {"0", "4 1 0", "0 1 0", "1"},      // slides without friction
      {"1/2", "13 -1 0", "0 1 0", "3"},  // slides at the edge, (1 + rho)^2 + rho^2 = 1/4 (13 - rho)^2
      {"1/2", "2 4 0", "0 -1 0", "2"},   // slides at the edge, 4 - rho = 1/2 (2 + rho)
  };
  for (const auto& [mu, force, motion, least] : table) {
    const auto found = [&, mu = mu, force = force, motion = motion](const std::string& rho) {
      return verdict("slipproof-contact 1 dimension 3 free 0 contacts 1 mu " + mu + " matrix 0 constant " + motion +
                     " answer " + force + " none-within " + rho + " end");
    };
    INFO(mu, " ", force, " ", motion);
    CHECK(found(least).starts_with("rejected: every row"));
    CHECK(found(least + "0000/10001").starts_with("accepted: "));
  }
  for (const char* law : {"constant 1 5 5 answer 0 0 0", "constant 0 0 0 answer 2 1 0", "constant 0 0 0 answer 0 0 0",
                          "constant 0 6 8 answer 10 -3 -4", "constant 0 5 5 answer 0 0 0"}) {
    CHECK(verdict(std::string("slipproof-contact 1 dimension 3 free 0 contacts 1 mu 1/2 matrix 0 ") + law +
                  " none-within 0 end")
              .starts_with("rejected: every row"));
  }
  CHECK(verdict("slipproof-contact 1 dimension 3 free 0 contacts 1 mu 1/2 matrix 0 constant -1 0 0 answer 0 0 0 "
                "none-within 100 end")
            .starts_with("accepted: "));
}

TEST_CASE("no-solution: multipliers and what they add up to") {
  reject_all(kNoSolution,
             {{"multipliers 1 1 0 0", "multipliers -1 -1 0 0", "row 1: the multiplier of a normal row is negative"},
              {"1 1 0 0", "1 1 1 0", "row 2: the multiplier of a tangential row is not 0"},
              {"1 1 0 0", "1 1 0 -1", "row 3: the multiplier of a tangential row is not 0"},
              {"1 1 0 0", "2 1 0 0", "column 0: g is not 0"},
              {"1 1 0 0", "0 1 0 0", "column 0: g is not 0"},
              {"1 1 0 0", "0 0 0 0", "c . y is not negative"},
              {"constant -1", "constant 0", "c . y is not negative"},
              {"1 1 -1", "1 1 1", "contact 0: g_N is positive"},
              {"1 1 -1", "1 1 -3/4", "contact 0: m |g_T| exceeds |g_N|"},
              {"mu 1/2", "mu 3/4", "contact 0: m |g_T| exceeds |g_N|"},
              {"mu 1/2", "mu -1/2", "contact 0: mu is negative"}});
}

TEST_CASE("unique: classes of matrices") {
  const std::string dominates = "the diagonal does not dominate", free = "the problem has free unknowns";
  const std::string dimension = "the class is not one of this dimension";
  reject_all(kDominant, {{"dominant 2 1", "dominant 1 1", "row 0: " + dominates},
                         {"dominant 2 1", "dominant 3 2", "row 0: " + dominates},  // as much as the others
                         {"dominant 2 1", "dominant 2 0", "row 1: d is not positive"},
                         {"dominant 2 1", "dominant -2 1", "row 0: d is not positive"},
                         {"1 1 1\n", "1 1 -1\n", "row 1: " + dominates},
                         {"1 1 1\n", "1 0 1\n", "row 1: " + dominates},
                         {"mu 0 0", "mu 1 0", "contact 0: mu is not 0 in dimension 1"},
                         {"free 0 contacts 2\nmu 0 0", "free 1 contacts 1\nmu 0", free},
                         {"dimension 1 free 0 contacts 2\nmu 0 0", "dimension 2 free 0 contacts 1\nmu 0", dimension}});
  reject_all(kDefinite, {{"1 1 1\nend", "1 1 6/5\nend", "row 1: " + dominates},
                         {"3  0 0 1", "3  0 0 7/5", "row 0: " + dominates},
                         {"0 1 3", "0 1 7/2", "row 0: " + dominates},
                         {"3  0 0 1  1 0 1/2", "3  0 0 1  0 1 1/2", "row 0: an entry stands above the diagonal"},
                         {"free 0 contacts 2\nmu 0 0", "free 2 contacts 0\nmu", free}});
}

TEST_CASE("unique with planar friction: determinants of all modes") {
  const std::string dominates = "the diagonal does not dominate";
  const auto mode = [](const char* contact) {
    return std::string("contact ") + contact + ": the determinant of a mode in which it is the last is not positive";
  };
  reject_all(kDeterminants, {{"mu 3/2", "mu 2", mode("0")},  // slide+ has 1 - 2/2
                             {"0 1 1/2", "0 1 -2/3", mode("0")},
                             {"mu 3/2", "mu -3/2", "contact 0: mu is negative"},
                             {"0 0 1  0 1", "0 0 5/8  0 1", mode("0")},
                             {"1 1 1\n", "1 1 2\n", "row 1: " + dominates},
                             {"1  1 1 1", "1  0 1 1", "row 0: an entry stands above the diagonal"},
                             {"dimension 2 free 0 contacts 1\nmu 3/2", "dimension 1 free 0 contacts 2\nmu 0 0",
                              "the class is not one of this dimension"},
                             {"free 0 contacts 1\nmu 3/2", "free 2 contacts 0\nmu", "the problem has free unknowns"}});
  // The force at contact 0 sticks to reach N_1 and T_1: with it slide- of contact 1 has 21/25 - 4/25 mu.
  const std::string two =
      "slipproof-contact 1 dimension 2 free 0 contacts 2 mu 1 5 matrix 8 0 0 1 1 1 1 2 2 1 3 3 1 1 2 2/5 2 1 2/5 1 3 "
      "2/5 "
      "3 1 2/5 constant 0 0 0 0 no-answer unique determinants 0 end";
  reject_all(two, {{"mu 1 5", "mu 1 21/4", mode("1")}, {"mu 1 5", "mu 1 6", mode("1")}});
  CHECK(verdict(replaced(two, "mu 1 5", "mu 0 6")).starts_with("accepted: "));  // nothing sticks at contact 0
  // Contact 1 slides with 1 - mu/4 where contact 0 is open, and with more where it is not.
  reject_all(
      "slipproof-contact 1 dimension 2 free 0 contacts 2 mu 0 39/10 matrix 10 0 0 1 1 1 1 2 2 1 3 3 1 0 2 1/4 2 0 1/4 "
      "0 3 1/4 3 0 1/4 2 3 1/4 3 2 1/4 constant 0 0 0 0 no-answer unique determinants 0 end",
      {{"mu 0 39/10", "mu 0 4", mode("1")}});
  // As many contacts as the limit allows, and one more.
  const auto many = [](int contacts) {
    std::string mu, matrix, constant;
    for (int i = 0; i < 2 * contacts; ++i) {
      if (i % 2 == 0) mu += " 1";
      matrix += " " + std::to_string(i) + " " + std::to_string(i) + " 1";
      constant += " 0";
    }
    return verdict("slipproof-contact 1 dimension 2 free 0 contacts " + std::to_string(contacts) + " mu" + mu +
                   " matrix " + std::to_string(2 * contacts) + matrix + " constant" + constant +
                   " no-answer unique determinants 0 end");
  };
  CHECK(many(0) ==
        "accepted: one solution, whatever the constant, by the mode determinants, 0 contacts in dimension 2");
  CHECK(many(5).starts_with("accepted: "));
  CHECK(many(9) == "rejected: there are more than 8 contacts");
}

TEST_CASE("unique with planar friction: the bound on mu, with all that it takes from the diagonal") {
  const std::string dominates = "the diagonal does not dominate";
  reject_all(kBound, {{"mu 1/2", "mu 3/5", "row 0: " + dominates},
                      {"mu 1/2", "mu -1/2", "contact 0: mu is negative"},
                      {"0 0 1/2", "0 0 3/4", "row 0: " + dominates},
                      {"0 1 1/2", "0 1 3/4", "row 0: " + dominates},
                      {"dimension 2 free 0 contacts 1\nmu 1/2", "dimension 1 free 0 contacts 2\nmu 0 0",
                       "the class is not one of this dimension"},
                      {"free 0 contacts 1\nmu 1/2", "free 2 contacts 0\nmu", "the problem has free unknowns"}});
  // N_0 gives up 1 for its own tangent, 1/4 for that of contact 1, and 1/4 because row 2 has 1/2 in column 1 that
  // column 2 does not have in row 1; N_1 gives up 1/4 for that, too.
  const std::string two =
      "slipproof-contact 1 dimension 2 free 0 contacts 2 mu 1 0 matrix 7 0 0 2 1 1 1 2 2 1 3 3 1 2 1 1/2 1 3 1/4 3 1 "
      "1/4 "
      "constant 0 0 0 0 no-answer unique bound 0 end";
  reject_all(two, {{"0 0 2", "0 0 3/2", "row 0: " + dominates},
                   {"2 2 1 ", "2 2 1/2 ", "row 2: " + dominates},
                   {"mu 1 0", "mu 6/5 0", "row 0: " + dominates}});
  CHECK(verdict(replaced(two, "0 0 2", "0 0 1501/1000")).starts_with("accepted: "));
  CHECK(verdict(replaced(two, "2 2 1 ", "2 2 501/1000 ")).starts_with("accepted: "));
}

TEST_CASE("a denominator that grows beyond its limit is rejected") {
  std::string mu, entries, constant;
  for (int i = 0; i < 40; ++i) {
    entries += "0 " + std::to_string(i) + " 1/" + std::string(4'000, '1') + std::to_string(2 * i + 1) + " ";
    mu += " 0";
    constant += " 1";
  }
  CHECK(verdict("slipproof-contact 1 dimension 1 free 0 contacts 40 mu" + mu + " matrix 40 " + entries + "constant" +
                constant + " no-answer unique dominant" + constant + " end") ==
        "rejected: a denominator exceeds 100000 bits");
}
