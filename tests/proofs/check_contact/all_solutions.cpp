// The checker accepts certificates of all solutions and rejects every forgery: see forgeries.cpp.
#include "proofs/check_contact/all_solutions_examples.hpp"
#include "proofs/check_contact/examples.hpp"

using namespace slipproof::check_contact;

namespace {

const std::string kVelocities = "contact 0: v . u may be negative", kForces = "contact 0: g . r may be negative";
const std::string kNotEmpty = "y . q is not positive, and not 0 where more than that is proved";
const std::string kLess = "y . q is less than the bound", kArc = "it is not counterclockwise and below half a turn";
const std::string kOutside = "the box is not mapped into its radius";

std::string node(int index, const std::string& reason) {
  return "node " + std::to_string(index) + ": " + reason;
}

/// Of what is established, without the problem.
std::string established(const std::string& certificate) {
  const std::string found = verdict(certificate);
  return found.substr(0, found.find(','));
}

}  // namespace

TEST_CASE("all solutions: how many motions there are is told in words") {
  CHECK(verdict(kRests) == "accepted: one motion and no other, 1 contacts in dimension 1");
  CHECK(verdict(kRestsInBox) == "accepted: one motion and no other, 1 contacts in dimension 1 and 1 free unknowns");
  CHECK(established(kRestsOrLifts) == "accepted: 2 motions and no others");
  CHECK(established(kTouches) == "accepted: one motion and no other");
  CHECK(established(kSlides) == "accepted: one motion and no other");
  CHECK(established(kSlidesInBox) == "accepted: one motion and no other");
  CHECK(established(kParadox) == "accepted: 3 motions and no others");
  CHECK(established(kSticks) == "accepted: one motion and no other");
  CHECK(established(kSlidesInSpace) == "accepted: one motion and no other");
  CHECK(established(kThreeContacts) == "accepted: one motion and no other");
  CHECK(established(kNoMotion) == "accepted: no motion at all");
}

TEST_CASE("all solutions: motions that may be one are not counted twice") {
  const std::string two = "at least one motion and at most 2";
  const std::string twice =
      replaced(kRests, "all-solutions 1\nmotion exact 1", "all-solutions 2\nmotion exact 1\nmotion exact 1");
  CHECK(established(twice) == "accepted: " + two);
  CHECK(established(replaced(replaced(twice, "known 0", "known 1"), "motion exact 1\n",
                             "motion box modes closed center 1 radius 1/4 alone 0 inverse 1 0 0 1\n")) ==
        "accepted: " + two);
  // What slides has u = (0, 7) within 3 and 7 times the radius, what lifts (1, 10).
  CHECK(established(replaced(kParadox, "radius 1/8", "radius 3/8")) == "accepted: 3 motions and no others");
  CHECK(established(replaced(kParadox, "radius 1/8", "radius 1/2")) == "accepted: at least one motion and at most 3");
  CHECK(established(
            replaced(replaced(kRestsOrLifts, "exact 1", "box modes closed center 1 radius 1 alone 0 inverse 1 0 0 -1"),
                     "known 1", "empty 1")) == "rejected: node 2: contact 0: g . r may be negative");
}

TEST_CASE("all solutions: a tree covers everything") {
  reject_all(kRests, {{"  empty -1\n  known 0", "  known 0 1 -1\n  known 0", node(1, kLess)},
                      {"  empty -1\n  known 0", "  empty -1\n  empty -1", node(2, kForces)},
                      {"  empty -1\n  known 0", "  empty -1\n  empty 1", node(2, kNotEmpty)},
                      {"  empty -1\n  known 0", "  empty -1\n  decide 0 empty -1 known 0",
                       node(2, "contact 0: it is decided already")},
                      {"  empty -1\n  known 0", "  empty -1\n  slips 0 known 0 known 0 known 0",
                       node(2, "contact 0: it has no friction")}});
  reject_all(kSlides, {{"decide 0\n  empty -1 0\n  slips", "slips",
                        node(0, "contact 0: it is not closed, or it sticks or slips already")},
                       {"    empty 1 1", "    slips 0 empty 1 1 empty 1 1 empty 1 1",
                        node(3, "contact 0: it is not closed, or it sticks or slips already")},
                       {"    empty 1 1", "    arcs 0 0 empty 1 1", node(3, "contact 0: it does not slip")},
                       {"    empty 0 1", "    arcs 0 0 empty 0 1", node(5, "contact 0: it slips in one direction")}});
  // A child that is missing: what follows is not a node.
  CHECK(verdict(replaced(kRests, "  known 0\n", "")) ==
        "unreadable: line 11, column 1: found 'end', expected 'decide', 'slips', 'arcs', 'empty' or 'known'");
  CHECK(verdict(replaced(kSlides, "    empty 0 1\n", "")) ==
        "unreadable: line 14, column 1: found 'end', expected 'decide', 'slips', 'arcs', 'empty' or 'known'");
  CHECK(verdict(replaced(kRests, "  known 0\n", "  known 0 known 0\n")) ==
        "unreadable: line 11, column 11: found 'known', expected a claim or 'end'");
}

TEST_CASE("all solutions: arcs go round, without a gap") {
  const std::string round = "4  1 0  0 1  -1 0  0 -1", last = "    empty 0 0 1\n";
  reject_all(kSlidesInSpace,
             {{round, "4  1 0  0 -1  -1 0  0 1", node(2, "arc 0: " + kArc)},
              {round, "4  1 0  0 1  0 1  0 -1", node(2, "arc 1: " + kArc)},  // of no width
              {round, "4  1 0  0 1  -1 0  1 0", node(2, "arc 2: " + kArc)},  // of half a turn
              {round, "4  1 0  0 1  -1 0  0 1", node(2, "arc 2: " + kArc)},
              {round, "4  1 0  0 1  -1 0  0 -2", node(2, "a direction has not length 1")},
              {round, "4  1 0  0 1  -1 0  1/2 -1/2", node(2, "a direction has not length 1")},
              {"2  21/29 20/29  8/17 15/17", "2  8/17 15/17  21/29 20/29", node(4, "arc 1: " + kArc)},
              {"2  21/29 20/29  8/17 15/17", "2  21/29 20/29  -15/17 8/17", node(4, "arc 2: " + kArc)},
              {"2  21/29 20/29  8/17 15/17", "2  21/29 -20/29  8/17 15/17", node(4, "arc 0: " + kArc)},
              {"2  21/29 20/29  8/17 15/17", "2  21/29 20/29  8/17 14/17", node(4, "a direction has not length 1")}});
  // An arc is missing, with its case.
  const auto without_last = [&](const std::string& directions) {
    return verdict(replaced(replaced(kSlidesInSpace, round, directions), last, ""));
  };
  CHECK(without_last("3  1 0  0 1  -1 0") == "rejected: " + node(2, "arc 2: " + kArc));
  CHECK(without_last("3  1 0  0 1  -3/5 -4/5").starts_with("rejected: node 9: "));  // all three are wide, and one fails
  CHECK(verdict(replaced(replaced(kSlidesInSpace, "2  21/29 20/29  8/17 15/17", "1  8/17 15/17"),
                         "      empty 0 -20 21\n", ""))
            .starts_with("rejected: node 5: "));
  CHECK(verdict("slipproof-contact 1 dimension 3 free 0 contacts 1 mu 1/2 matrix 0 constant -1 1 0 no-answer "
                "all-solutions 0 decide 0 empty -1 0 0 slips 0 0 empty 1 4 0 end") ==
        "rejected: " + node(2, "the arcs do not go round: there are fewer than 3"));
  CHECK(verdict("slipproof-contact 1 dimension 3 free 0 contacts 1 mu 1/2 matrix 0 constant -1 1 0 no-answer "
                "all-solutions 0 decide 0 empty -1 0 0 slips 0 2 1 0 0 1 empty 1 4 0 empty 1 4 0 empty 1 4 0 end") ==
        "rejected: " + node(2, "the arcs do not go round: there are fewer than 3"));
}

TEST_CASE("all solutions: multipliers, in each state") {
  reject_all(kRests, {{"empty -1", "empty 1", node(1, kVelocities)}, {"empty -1", "empty 0", node(1, kNotEmpty)}});
  reject_all(kTouches, {{"empty 1", "empty -1", node(2, kForces)},
                        {"empty 1", "empty 0", node(2, kNotEmpty)},  // not more than 0
                        {"known 0  0  -1", "known 0  2  -1", node(1, kVelocities)},
                        {"constant 0", "constant -1", "motion 0: contact 0: u_N is negative"}});
  reject_all(kSlides, {{"  empty -1 0", "  empty -1 1", node(1, kVelocities)},
                       {"    empty 1 1", "    empty 1 3", node(3, kForces)},
                       {"    empty 1 1", "    empty 3 1", node(3, kNotEmpty)},
                       {"    empty 1 1", "    empty -1 1", node(3, kForces)},
                       {"known 0  1/2 1", "known 0  1/2 9/8", node(4, kVelocities)},
                       {"known 0  1/2 1", "known 0  3/8 1", node(4, kForces)},
                       {"known 0  1/2 1", "known 0  5/8 1", node(4, kLess)},
                       {"-1/2 -1", "-3/8 -1", node(4, kLess)},
                       {"-1/2 -1", "-1/2 -9/8", node(4, kLess)},
                       {"-1/2 -1", "-1/2 -7/8", node(4, kVelocities)},
                       {"    empty 0 1", "    empty 0 -1", node(5, kVelocities)},
                       {"    empty 0 1", "    empty -1 1", node(5, kForces)},
                       {"    empty 0 1", "    empty 3 1", node(5, kNotEmpty)}});
  reject_all(kSlidesInSpace, {{"empty 5/2 3 4", "empty 19/8 3 4", node(3, kForces)},
                              {"empty 0 -20 21", "empty 0 -19 21", node(5, kVelocities)},
                              {"empty 0 -20 21", "empty -1 -20 21", node(5, kForces)},
                              {"empty 0 15 -8", "empty 0 15 -7", node(7, kVelocities)},
                              {"1 589/493", "13/10 589/493", node(6, kLess)},
                              {"1 589/493", "63/64 589/493", node(6, kForces)},  // inside of the arc's cone
                              {"-961/986", "0", node(6, kLess)},
                              {"-961/986", "-962/986", node(6, kForces)}});
  reject_all(kNoMotion, {{"empty -1 0 0", "empty -1 1 0", node(0, kVelocities)},
                         {"empty -1 0 0", "empty 1 0 0", node(0, kVelocities)},
                         {"mu 1/2", "mu 3/4", node(0, kForces)},
                         {"constant -1", "constant 1", node(0, kNotEmpty)}});
  // What is more than 0 at the edges of the states is 0 at them: one forgery each takes it away.
  const auto edge = [](const std::string& mu, const std::string& constant, const std::string& y) {
    return verdict("slipproof-contact 1 dimension 2 free 0 contacts 1 mu " + mu + " matrix 2 0 0 1 1 1 1 constant " +
                   constant + " no-answer all-solutions 0 decide 0 empty -1 0 slips 0 empty " + y +
                   " empty 0 -1 empty 1 1 end");
  };
  CHECK(edge("1", "-1 1", "1 1") == "rejected: " + node(3, kNotEmpty));  // it sticks at the edge of the cone
  CHECK(edge("1/2", "-1 1", "1 1").starts_with("rejected: node 4: "));   // here it does not, but it slips
}

TEST_CASE("all solutions: more than 0 is proved by velocities") {
  // No force moves it, and nothing else does: u = 0.
  const std::string stands =
      "slipproof-contact 1 dimension 3 free 0 contacts 1 mu 1/2 matrix 0 constant 0 0 0 no-answer all-solutions 1 "
      "motion exact 0 0 0 decide 0 known 0 1 0 0 -1 0 0 0 1 0 0 -1 0 0 0 1 0 0 -1 "
      "slips 0 4 1 0 0 1 -1 0 0 -1 known 0 empty 0 -1 -1 empty 0 1 -2 empty 0 2 1 empty 0 -1 3 end";
  reject_all(stands, {{"empty 0 -1 -1", "empty 0 -1 0", node(4, kNotEmpty)},  // 0 at an end of the arc
                      {"empty 0 -1 -1", "empty 0 0 -1", node(4, kNotEmpty)},
                      {"empty 0 2 1", "empty 0 2 -1", node(6, kVelocities)},
                      {"motion exact 0 0 0", "motion exact 1 1 0",
                       "motion 0: contact 0: the force is outside of the "
                       "friction cone"}});
}

TEST_CASE("all solutions: motions exist") {
  reject_all(kRests, {{"exact 1", "exact 2", "motion 0: contact 0: neither u_N nor r_N is 0"},
                      {"exact 1", "exact -1", "motion 0: contact 0: u_N is negative"}});
  reject_all(kSlides, {{"exact 1 -1/2", "exact 1 1/2", "motion 0: contact 0: friction drives the sliding"},
                       {"exact 1 -1/2", "exact 1 -1/4",
                        "motion 0: contact 0: it slides with a force inside of the friction cone"}});
  const std::string spread = "motion 0: unknown 0: |I - R J| p is not less than its radius";
  reject_all(kRestsInBox, {{"center 1", "center 4/3", "motion 0: unknown 0: " + kOutside},
                           {"0 0 1\ndecide", "0 0 2\ndecide", spread},
                           {"inverse 1  0 0 1", "inverse 0", spread},
                           {"radius 1/4", "radius 0", spread},
                           {"radius 1/4", "radius 5/4", "motion 0: unknown 0: alone is less than its radius"},
                           {"alone 1", "alone 1/8", "motion 0: unknown 0: alone is less than its radius"},
                           {"alone 1", "alone -1", "motion 0: alone is neither positive nor 0 everywhere"},
                           {"alone 1", "alone 0", node(2, "the motion is not claimed to be alone")},
                           {"eliminated 1  0 0 1/2", "eliminated 1  0 0 1", "row 0: B A_FF is not I"},
                           {"eliminated 1  0 0 1/2", "eliminated 0", "row 0: B A_FF is not I"}});
  reject_all(kSlidesInBox, {{"slide+", "slide-", "motion 0: contact 0: u_T may have the other sign"},
                            {"constant -1 2", "constant -1 1/2", "motion 0: contact 0: u_T may have the other sign"},
                            {"radius 1/4 alone 1", "radius 2 alone 2", "motion 0: contact 0: r_N may be negative"}});
  reject_all(kSticks, {{"radius 1/4 1/4 1/4 alone 1 1 1", "radius 8 1/4 1/4 alone 8 1 1",
                        "motion 0: contact 0: the force may leave the friction cone"},
                       {"radius 1/4 1/4 1/4 alone 1 1 1", "radius 1 3 1 alone 3 3 3",
                        "motion 0: contact 0: the force may leave the friction cone"},
                       {"mu 1/2", "mu 1/4", "motion 0: contact 0: the force may leave the friction cone"}});
  reject_all(
      kSlidesInSpace,
      {{"center 10 3/5 4/5 10", "center 10 4/5 3/5 10", "motion 0: unknown 1: " + kOutside},
       {"center 10 3/5 4/5 10", "center 10 -3/5 -4/5 -20",
        "motion 0: unknown 1: |I - R J| p is not less than its radius"},
       {"radius 1/8 1/64", "radius 1/8 1/4", "motion 0: unknown 1: alone is less than its radius"},
       {"radius 1/8 1/64 1/64 1/8", "radius 1/8 1/64 1/64 1/256", "motion 0: unknown 3: " + kOutside},
       {"alone 1/2 9/64 9/64 5/4", "alone 1/2 1/4 1/4 5/4", "motion 0: unknown 3: there may be two zeros within alone"},
       {"alone 1/2 9/64 9/64 5/4", "alone 1/2 9/64 9/64 1", "motion 0: unknown 3: there may be two zeros within alone"},
       {"alone 1/2 9/64 9/64 5/4", "alone 1/2 9/64 0 5/4", "motion 0: alone is neither positive nor 0 everywhere"}});
  // Friction that drives it: r_T = (3, 4), u_T = (12, 16) = -20 d.
  const std::size_t at = kSlidesInSpace.find("inverse"), end = kSlidesInSpace.find("decide");
  reject_all(kSlidesInSpace,
             {{kSlidesInSpace.substr(kSlidesInSpace.find("center"), end - kSlidesInSpace.find("center")),
               "center 10 -3/5 -4/5 -20 radius 1/8 1/64 1/64 1/2 alone 0 0 0 0 inverse 11 0 0 1 1 1 16/375 1 2 -4/125 "
               "1 3 -3/10 2 1 -4/125 2 2 3/125 2 3 -2/5 3 0 -1/2 3 1 3/5 3 2 4/5 3 3 15/2 ",
               "motion 0: contact 0: v may be negative"},
              {kSlidesInSpace.substr(at, end - at), "inverse 0\n",
               "motion 0: unknown 0: |I - R J| p is not less than its radius"}});
  // What lifts is pushed by the contact that slides: u_N = r_N - 1.
  reject_all(kThreeContacts, {{"9  0 0 1  1 1 1  2 2 1  3 3 1  4 0 1  4 3 1  4 4 1  5 3 1  5 5 1\nconstant 5",
                               "9  0 4 1  1 1 1  2 2 1  3 3 1  4 0 1  4 3 1  4 4 1  5 3 1  5 5 1\nconstant -1",
                               "motion 0: contact 0: u_N may be negative"}});
  const std::string open =
      replaced(replaced(kRestsOrLifts, "motion exact 0", "motion box modes open center radius alone inverse 0"),
               "known 0  1  -1", "known 0");
  reject_all(open, {{"constant 1", "constant -1", "motion 0: contact 0: u_N may be negative"}});
}

TEST_CASE("all solutions: motions that exist just so") {
  const std::string one = "accepted: one motion and no other";
  CHECK(established(replaced(kRestsInBox, "center 1", "center 5/4")) == one);  // |R f| = 1/4
  const std::string touches = replaced(kTouches, "exact 0", "box modes open center radius alone inverse 0");
  CHECK(established(replaced(touches, "known 0  0  -1", "known 0")) == one);  // u_N = 0
  const std::string slowly = replaced(kSlidesInBox, "constant -1 2", "constant -1 5/8");
  CHECK(established(replaced(slowly, "empty 1 1", "empty 1/2 1")) == one);  // u_T >= 0
  const std::size_t box = kSlidesInSpace.find("motion"), tree = kSlidesInSpace.find("decide");
  const std::string motion = kSlidesInSpace.substr(box, tree - box);
  std::string wide = replaced(replaced(motion, "1/64 1/8", "1/64 10"), "alone 1/2 9/64 9/64 5/4", "alone 0 0 0 0");
  wide = replaced(kSlidesInSpace, "all-solutions 1\n", "all-solutions 2\n" + wide);
  reject_all(replaced(wide, "known 0", "known 1"), {{"1/64 10", "1/64 11", "motion 0: contact 0: v may be negative"}});
  // As far as |I - R J| P + 2 |R| q(P) = P, and less.
  reject_all(replaced(kSlidesInSpace, "9/64 5/4", "9/64 7084/6208"),
             {{"9/64 7084/6208", "9/64 7083/6208", "motion 0: unknown 3: there may be two zeros within alone"}});
}

TEST_CASE("all solutions: what is known of a pattern is the motion of its mode, alone there") {
  const std::string mode = "contact 0: the motion has another mode", arc = "the arc is not where the motion is alone";
  reject_all(kParadox,
             {{"    known 2  1 0  -1 0\n    empty 1 0", "    empty 1 0\n    known 2  1 0  -1 0", node(4, kForces)},
              {"    known 1\n    known 2  1 0  -1 0", "    known 2 1 0 -1 0\n    known 1 -3 1 3 -1", node(3, mode)},
              {"  known 0  1 0  -1 0  0 1  0 -1", "  known 2  1 0  -1 0", node(1, mode)},
              {"known 1\n", "known 0\n", node(3, "row 0: u of the motion is not 0")},
              {"known 0  1 0", "known 1  1 0", node(1, kLess)}});
  reject_all(kSlidesInBox,
             {{"known 0  -1 0  1 0\n    empty 0 1", "empty 0 1\n    known 0  -1 0  1 0", node(4, kVelocities)},
              {"known 0  -1 0  1 0", "known 0  -1 0  3 0", node(4, kLess)},
              {"alone 1", "alone 0", node(4, "the motion is not claimed to be alone")}});
  reject_all(
      kSlidesInSpace,
      {{"alone 1/2 9/64 9/64", "alone 1/2 1/8 9/64", node(6, arc)},
       {"alone 1/2 9/64 9/64", "alone 1/2 9/64 7/64", node(6, arc)},

       {"    empty 5/2 3 4", "    known 0 -1 0 0 1 0 0 -961/986 -589/493 -775/493 1 589/493 775/493", node(3, mode)}});
  // The arc reaches the edge of where the motion is alone: 3/5 - 11/85 = 8/17, 4/5 - 16/145 = 20/29.
  CHECK(established(replaced(kSlidesInSpace, "alone 1/2 9/64 9/64", "alone 1/2 11/85 16/145")) ==
        "accepted: one motion and no other");
}

TEST_CASE("all solutions: of Coulomb's law, and by its numbers") {
  reject_all(kSlides, {{"no-answer", "law box no-answer", "the claim is not one of this law"},
                       {"constant -1 2", "constant -1 1/2", node(3, kNotEmpty)},
                       {"0 0 1  1 1 1", "0 0 1  1 1 2", node(4, kForces)}});
  reject_all(kRests, {{"mu 0", "mu 1", "contact 0: mu is not 0 in dimension 1"},
                      {"mu 0", "mu -1", "contact 0: mu is negative"}});
}

TEST_CASE("all solutions: what is no certificate is refused with its place") {
  const auto refused = [](const std::string& certificate, const std::string& from, const std::string& to) {
    return verdict(replaced(certificate, from, to)).substr(0, 200);
  };
  CHECK(refused(kRests, "motion exact", "motion nearly") ==
        "unreadable: line 8, column 8: found 'nearly', expected 'exact' or 'box'");
  CHECK(refused(kRests, "motion exact 1", "eliminated 0 motion exact 1") ==
        "unreadable: line 8, column 1: found 'eliminated', expected 'motion'");
  CHECK(refused(kRestsInBox, "eliminated 1  0 0 1/2\n", "") ==
        "unreadable: line 8, column 1: found 'motion', expected 'eliminated'");
  CHECK(refused(kRests, "known 0", "known 1") == "unreadable: line 11, column 9: found '1', expected an index below 1");
  CHECK(refused(kRests, "decide 0", "decide 1") ==
        "unreadable: line 9, column 8: found '1', expected an index below 1");
  for (const char* mode : {"stick", "slide", "slide+", "slide-", "any"}) {
    CHECK(refused(kRestsInBox, "modes closed", std::string("modes ") + mode) ==
          std::string("unreadable: line 9, column 18: found '") + mode + "', expected a mode that contact 0 can have");
  }
  for (const char* mode : {"closed", "slide", "slip+"}) {
    CHECK(refused(kSlidesInBox, "modes slide+", std::string("modes ") + mode).starts_with("unreadable: line 8"));
  }
  for (const char* mode : {"closed", "slide+"}) {
    CHECK(refused(kSlidesInSpace, "modes slide", std::string("modes ") + mode).starts_with("unreadable: line 8"));
  }
}

TEST_CASE("all solutions: a tree that is deep ends in a verdict") {
  std::string tree, leaves;
  for (int i = 0; i < 200'000; ++i) tree += "decide 0\n", leaves += "empty 0\n";
  CHECK(verdict(replaced(kRests, "  known 0\n", tree + leaves + "empty 0\n")) ==
        "rejected: node 2: contact 0: it is decided already");
}
