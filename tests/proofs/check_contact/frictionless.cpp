// A node for a motion that needs no friction: accepted where it is the only one, and every forgery rejected.
#include <map>

#include "proofs/check_contact/all_solutions_examples.hpp"
#include "proofs/check_contact/examples.hpp"
#include "proofs/check_contact/frictionless_examples.hpp"
#include "proofs/check_contact/known_problems.hpp"

using namespace slipproof::check_contact;

namespace {

const std::string kOne = "accepted: one motion and no other";
const std::string kNotTheSum = "W is not the sum of the squares", kSlips = "u_T of the motion is not 0, with friction";
const std::string kTangential = "r_T of the motion is not 0";

std::string at_root(const std::string& reason) {
  return "node 0: " + reason;
}

/// Of what is established, without the problem.
std::string all_told(const std::string& certificate) {
  const std::string found = verdict(certificate);
  return found.substr(0, found.rfind(','));
}

/// W = sum of d l l^T by elimination, for two rows. Where the first pivot is 0 the rest of its column is left out.
std::string squares(const Small& problem) {
  const auto& A = problem.A;
  const mpq_class share = A[0][0] == 0 ? mpq_class(0) : mpq_class(A[0][1] / A[0][0]);
  return " 2" + listed({A[0][0], 1, share}) + listed({A[1][1] - share * A[0][1], 0, 1});
}

}  // namespace

TEST_CASE("a motion without friction is the only one") {
  CHECK(all_told(kBlockRests) == kOne);
  CHECK(all_told(kLiftsOff) == kOne);
  CHECK(all_told(kOnIce) == kOne);
  CHECK(all_told(kGuided).starts_with("accepted: at least one motion, and every motion is within "));
  CHECK(all_told(replaced(kBlockRests, "1/2 0  1/2 0", "1/2 0  1/2 0 within 0 0 0 1")) ==
        "accepted: at least one motion, and every motion is within 1.0e0 of one of 1");
  const std::string normal = "slipproof-contact 1 dimension 1 free 0 contacts 1 mu 0 ";
  CHECK(all_told(normal + "matrix 0 constant 0 no-answer all-solutions 1 motion exact 7 frictionless 0 0 end") == kOne);
  // u = r - 1, where a free unknown is eliminated
  const std::string box = "box modes stick center 1 radius 1/4 pinned 0 dropped 0 inverse 1  0 0 1 alone 4";
  const std::string tree = "decide 0\n  empty -1\n  known 0  -1  1\n", whole = "frictionless 0 1  1/4 2\n";
  CHECK(all_told(replaced(replaced(kRestsInBox, box, "exact 1"), tree, whole)) == kOne);
  CHECK(all_told(replaced(kRests, "known 0", "frictionless 0 2  1/2 1  1/2 1")) == kOne);  // in a case
}

TEST_CASE("a motion with friction is not shown to be the only one") {
  // Contacts that are pressed together are at rest with friction.
  reject_all(kBlockRests, {{"1/2 0  1/2 0", "1/2 1/8  1/2 -1/8", at_root("row 1: " + kTangential)}});
  reject_all(kGuided, {{"frictionless 0", "frictionless 1", at_root("row 1: " + kTangential)},
                       {"frictionless 0", "frictionless 2", at_root("the motion is in a box")},
                       {"  1 0 0", "  -1 0 0", at_root("square 1: its factor is negative")}});
  reject_all(kLiftsOff, {{"constant 3 0 0", "constant 3 1 0", at_root("row 1: " + kSlips)},
                         {"constant 3 0 0", "constant 3 0 -1", at_root("row 2: " + kSlips)}});
  CHECK(verdict(replaced(replaced(kOnIce, "-1 2  -1 0", "-1 2  1 2"), "exact 1 0  1 0", "exact 1 0  0 0")) ==
        "rejected: " + at_root("row 3: " + kSlips));
  reject_all(kOnIce,
             {{"mu 0 1/2", "mu 1/2 0", "motion 0: contact 0: it slides with a force inside of the friction cone"}});
  CHECK(verdict(kThrownSideways) == "rejected: " + at_root("row 1: " + kSlips));  // and it may slide
  CHECK(verdict(replaced(kThrownSideways, "exact 0 0", "exact 1 -4")) ==
        "rejected: " + at_root("row 1: " + kTangential));
  CHECK(all_told(replaced(kThrownSideways, "mu 4", "mu 0")) == kOne);
}

TEST_CASE("W is a sum of squares for a motion without friction") {
  const std::string last = "  1 -1 1 1 1";
  reject_all(kBlockRests, {{"0 3 -1", "0 3 -2", at_root("row 0: " + kNotTheSum)},  // not symmetric
                           {"3 1 2", "3 1 3", at_root("row 3: " + kNotTheSum)},
                           {"1 1 2", "1 1 3", at_root("row 1: " + kNotTheSum)},
                           {"2 3 1", "2 3 0", at_root("row 2: " + kNotTheSum)},
                           {last, "  -1 -1 1 1 1", at_root("square 2: its factor is negative")},
                           {last, "  2 -1 1 1 1", at_root("row 0: " + kNotTheSum)},
                           {last, "  1 -1 1 1 7/8", at_root("row 0: " + kNotTheSum)},
                           {last, "  1 0 1 1 1", at_root("row 0: " + kNotTheSum)},
                           {"0 3  1 0 1 0 1", "0 2 ", at_root("row 1: " + kNotTheSum)}});
  CHECK(all_told(replaced(kBlockRests, "0 3  1", "0 4  0 5 6 7 8  1")) == kOne);
  reject_all(kLiftsOff, {{"matrix 3", "matrix 4  1 2 1/8", at_root("row 1: " + kNotTheSum)}});
  // u = 1 - r lifts, or rests.
  const std::string lifts =
      "slipproof-contact 1 dimension 1 free 0 contacts 1 mu 0 matrix 1 0 0 -1 constant 1 no-answer "
      "all-solutions 1 motion exact 0 frictionless 0 ";
  CHECK(verdict(lifts + "1 -1 1 end") == "rejected: " + at_root("square 0: its factor is negative"));
  CHECK(verdict(lifts + "1 1 1 end") == "rejected: " + at_root("row 0: " + kNotTheSum));
  CHECK(verdict(lifts + "0 end") == "rejected: " + at_root("row 0: " + kNotTheSum));
}

TEST_CASE("a motion without friction that cannot be read is refused with its place") {
  const auto refused = [](const std::string& from, const std::string& to) {
    return verdict(replaced(kLiftsOff, from, to));
  };
  CHECK(refused("less 0", "less 1") == "unreadable: line 9, column 14: found '1', expected an index below 1");
  CHECK(refused("1/2 0 0 1", "1/2 0 0") == "unreadable: line 10, column 1: found 'end', expected an exact number");
  CHECK(refused("0 3  2", "0 4  2") == "unreadable: line 10, column 1: found 'end', expected an exact number");
  CHECK(refused("0 3  2", "0 2  2") == "unreadable: line 9, column 37: found '1/2', expected a claim or 'end'");
  CHECK(refused("0 3  2", "0 -3  2").starts_with("unreadable: line 9, column 16: found '-3', expected a count"));
  CHECK(refused("0 3  2", "0 100000000  2").starts_with("unreadable: line 9, column 16: found '100000000', expected"));
  CHECK(refused("all-solutions 1\nmotion exact 0 0 0", "all-solutions 0") ==
        "unreadable: line 8, column 14: found '0', expected an index below 0");
}

TEST_CASE("small problems with a motion without friction that is accepted have no other") {
  std::map<std::string, int> found;
  for (int i = 0; i < 40'000; ++i) {
    Small problem{below(2) == 0, {{from_to(-3, 3), from_to(-3, 3)}}, {from_to(-4, 4), from_to(-4, 4)}};
    problem.A.push_back({problem.A[0][1] + (below(4) == 0 ? from_to(-1, 1) : 0), from_to(-3, 6)});
    bool complete = false;
    const auto solutions = problem.solutions(complete);
    if (!complete || solutions.empty()) continue;
    const Numbers& x = solutions[static_cast<std::size_t>(below(static_cast<int>(solutions.size())))];
    const std::string text = std::string("slipproof-contact 1 dimension ") +
                             (problem.planar ? "2 free 0 contacts 1 mu 1" : "1 free 0 contacts 2 mu 0 0") + " matrix " +
                             listed(problem.A) + " constant" + listed(problem.c) +
                             " no-answer all-solutions 1 motion exact" + listed(x) + " frictionless 0" +
                             squares(problem) + " end";
    CAPTURE(text);
    const std::string told = all_told(text), kind = problem.planar ? "planar " : "normal ";
    const bool only = std::all_of(solutions.begin(), solutions.end(),
                                  [&](const Numbers& other) { return problem.motion(other) == problem.motion(x); });
    if (told.starts_with("accepted")) CHECK(only);
    ++found[kind + told.substr(0, 8) + (only ? "" : " of several")];
  }
  CHECK(found.size() == 6);
  for (const auto& [kind, count] : found) CHECK_MESSAGE(count > 100, kind);
}
