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
  CHECK(established(kNearASlide) == "accepted: at least one motion");
  CHECK(established(kSharedWeight) == "accepted: at least one motion");
  CHECK(established(kNoMotion) == "accepted: no motion at all");
}

TEST_CASE("all solutions: motions that may be one are not counted twice") {
  const std::string two = "at least one motion and at most 2";
  const std::string twice =
      replaced(kRests, "all-solutions 1\nmotion exact 1", "all-solutions 2\nmotion exact 1\nmotion exact 1");
  CHECK(established(twice) == "accepted: " + two);
  CHECK(established(
            replaced(replaced(twice, "known 0", "known 1"), "motion exact 1\n",
                     "motion box modes stick center 1 radius 1/4 pinned 0 dropped 0 inverse 1 0 0 1 alone 1\n")) ==
        "accepted: " + two);
  // What slides has u = (0, 7) within 3 and 7 times the radius, what lifts (1, 10).
  CHECK(established(replaced(kParadox, "radius 1/8 1/8", "radius 3/8 3/8")) == "accepted: 3 motions and no others");
  CHECK(established(replaced(kParadox, "radius 1/8 1/8", "radius 1/2 1/2")) ==
        "accepted: at least one motion and at most 3");
}

TEST_CASE("all solutions: how far from the list motions may be") {
  const auto far = [](const std::string& certificate) {
    const std::string found = verdict(certificate);
    return found.substr(0, found.rfind(','));
  };
  const std::string one = "accepted: at least one motion, and every motion is within ", two = "accepted: at least 2 ";
  CHECK(far(kNearASlide) == one + "4.7e-1 of one of 1");  // h + e - l: 3/16 + 9/32
  CHECK(far(kSharedWeight) == one + "1.0e0 of one of 1");
  const std::string within = replaced(kRestsOrLifts, "exact 0", "exact 0 within 1");
  CHECK(far(within) == two + "motions, and every motion is within 1.0e0 of one of 2");
  // What rests has u = 0 within the radius, what lifts 1.
  const std::string box =
      replaced(kRestsOrLifts, "exact 1", "box modes stick center 1 radius 1/2 pinned 0 dropped 0 inverse 1 0 0 -1");
  CHECK(far(box) == two + "motions, and every motion is within 1.0e0 of one of 2");
  CHECK(far(replaced(box, "radius 1/2", "radius 1")) == one + "2.0e0 of one of 2");
  // One stands for all where it is, or may be, as they are.
  reject_all(replaced(within, "known 1", "known 0"),
             {{"within 1", "within 7/8", node(2, "row 0: u of the motion is not 0")},
              {"within 1", "within -1", "motion 0: a number of within is negative"},
              {" within 1", "", node(2, "row 0: u of the motion is not 0")}});
  reject_all(kNearASlide, {{"9/32 3/16", "8/32 3/16", node(6, kLess)},
                           {"9/32 3/16", "9/32 2/16", node(6, kLess)},
                           {"within 0 9/32 3/16", "", node(6, kLess)},
                           {"9/32 3/16", "9/32 -3/16", "motion 0: a number of within is negative"},
                           {"24/73 1 0", "23/73 1 0", node(6, kForces)},
                           {"24/73 1 0", "24/73 9/8 0", node(6, kVelocities)},
                           {"-55/146 0 -1", "-54/146 0 -1", node(6, kLess)}});
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
        "unreadable: line 11, column 1: found 'end', expected 'decide', 'slips', 'arcs', 'empty', 'known' or "
        "'frictionless'");
  CHECK(verdict(replaced(kSlides, "    empty 0 1\n", "")) ==
        "unreadable: line 14, column 1: found 'end', expected 'decide', 'slips', 'arcs', 'empty', 'known' or "
        "'frictionless'");
  CHECK(verdict(replaced(kRests, "  known 0\n", "  known 0 known 0\n")) ==
        "unreadable: line 11, column 11: found 'known', expected a claim or 'end'");
}

TEST_CASE("all solutions: arcs go round, without a gap") {
  const std::string round = "4  1 0  0 1  -1 0  0 -1", last = "    empty 0 0 1\n";
  const std::string arc = "48/73 55/73  28/53 45/53";
  reject_all(kSlidesInSpace, {{round, "4  1 0  0 -1  -1 0  0 1", node(2, "arc 0: " + kArc)},
                              {round, "4  1 0  0 1  0 1  0 -1", node(2, "arc 1: " + kArc)},  // of no width
                              {round, "4  1 0  0 1  -1 0  1 0", node(2, "arc 2: " + kArc)},  // of half a turn
                              {round, "4  1 0  0 1  -1 0  0 1", node(2, "arc 2: " + kArc)},
                              {round, "4  1 0  0 1  -1 0  0 -2", node(2, "a direction has not length 1")},
                              {round, "4  1 0  0 1  -1 0  1/2 -1/2", node(2, "a direction has not length 1")},
                              {arc, "28/53 45/53  48/73 55/73", node(4, "arc 1: " + kArc)},
                              {arc, "48/73 55/73  -45/53 28/53", node(4, "arc 2: " + kArc)},
                              {arc, "48/73 -55/73  28/53 45/53", node(4, "arc 0: " + kArc)},
                              {arc, "48/73 55/73  28/53 44/53", node(4, "a direction has not length 1")}});
  // An arc is missing, with its case.
  const auto without_last = [&](const std::string& directions) {
    return verdict(replaced(replaced(kSlidesInSpace, round, directions), last, ""));
  };
  CHECK(without_last("3  1 0  0 1  -1 0") == "rejected: " + node(2, "arc 2: " + kArc));
  CHECK(without_last("3  1 0  0 1  -3/5 -4/5").starts_with("rejected: node 9: "));  // all three are wide, and one fails
  CHECK(verdict(replaced(replaced(kSlidesInSpace, "2  " + arc, "1  28/53 45/53"), "      empty 0 -55 48\n", ""))
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
  reject_all(kTouches, {{"empty -1", "empty 1", node(1, kVelocities)},
                        {"empty -1", "empty 0", node(1, kNotEmpty)},  // not more than 0
                        {"known 0", "empty 1", node(2, kNotEmpty)},   // nor here: r may be 0
                        {"known 0", "empty -1", node(2, kForces)},
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
                              {"empty 0 -55 48", "empty 0 -54 48", node(5, kVelocities)},
                              {"empty 0 -55 48", "empty -1 -55 48", node(5, kForces)},
                              {"empty 0 45 -28", "empty 0 45 -27", node(7, kVelocities)},
                              {"24/73 0 0", "23/73 0 0", node(6, kForces)},
                              {"-14/53 0 0", "-13/53 0 0", node(6, kLess)},
                              {"45/106 0 0", "46/106 0 0", node(6, kLess)},
                              {"-55/146 0 0", "-54/146 0 0", node(6, kLess)},
                              {"-3 -4588/3869", "-29/10 -4588/3869", node(6, kLess)},
                              {"-3 -4588/3869", "-4 -4588/3869", node(6, kForces)},
                              {"-3 -4588/3869", "-3 -4587/3869", node(6, kVelocities)},
                              {"29/10 4588/3869", "3 4588/3869", node(6, kLess)},
                              {"29/10 4588/3869", "358/125 4588/3869", node(6, kForces)}});  // inside of the arc's cone
  reject_all(kNoMotion, {{"empty -1 0 0", "empty -1 1 0", node(0, kVelocities)},
                         {"empty -1 0 0", "empty 1 0 0", node(0, kVelocities)},
                         {"mu 1/2", "mu 3/4", node(0, kForces)},
                         {"constant -1", "constant 1", node(0, kNotEmpty)},
                         {"constant -1", "constant 0", node(0, kNotEmpty)}});  // u_N may be 0 where nothing is decided
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
  const std::string alone = "motion 0: alone is less than 1, or an unknown is pinned";
  const std::string second = "motion 0: unknown 3: there may be two zeros where it is alone";
  reject_all(kRestsInBox, {{"center 1", "center 4/3", "motion 0: unknown 0: " + kOutside},
                           {"0 0 1 alone", "0 0 2 alone", spread},
                           {"inverse 1  0 0 1", "inverse 0", spread},
                           {"radius 1/4", "radius 0", "motion 0: unknown 0: its radius is not positive"},
                           {"alone 4", "alone 0", alone},
                           {"alone 4", "alone 7/8", alone},
                           {"alone 4", "alone -4", alone},
                           {"eliminated 1  0 0 1/2", "eliminated 1  0 0 1", "row 0: B A_FF is not I"},
                           {"eliminated 1  0 0 1/2", "eliminated 0", "row 0: B A_FF is not I"}});
  const std::string slides = "slide+ center 1 -1/2 radius 1/4 1/4 pinned 0 dropped 0\ninverse 3  0 0 1  1 0 -1/2";
  const std::string sign = "motion 0: contact 0: u_T may have the other sign";
  reject_all(kSlidesInBox,
             {{slides, replaced(replaced(slides, "slide+ center 1 -", "slide- center 1 "), "-1/2", "1/2"), sign},
              {"constant -1 2", "constant -1 1/2", sign},
              {"center 1 -1/2", "center 1 1/2", "motion 0: unknown 1: " + kOutside},
              {"radius 1/4 1/4", "radius 2 1/4", "motion 0: contact 0: r_N may be negative"}});
  const std::string cone = "motion 0: contact 0: the force may leave the friction cone";
  reject_all(kSticks, {{"radius 1/4 1/4 1/4", "radius 8 1/4 1/4", cone},
                       {"radius 1/4 1/4 1/4", "radius 1 3 1", cone},
                       {"mu 1/2", "mu 1/4", cone}});
  reject_all(kSlidesInSpace, {{"center 10 -3 -4 2", "center 10 -4 -3 2", "motion 0: unknown 1: " + kOutside},
                              {"1/16 1/32", "1/16 1/2048", "motion 0: unknown 3: " + kOutside},
                              {"alone 4", "alone 6", second},
                              {"alone 4", "alone 3", node(6, kLess)}});
  // Friction that drives it: r_T = (3, 4), u_T = (12, 16).
  const std::size_t at = kSlidesInSpace.find("center"), end = kSlidesInSpace.find("alone");
  reject_all(kSlidesInSpace, {{kSlidesInSpace.substr(at, end - at),
                               "center 10 3 4 -4 radius 1/8 3/32 1/16 1/32 pinned 0 dropped 0 inverse 13 0 0 1 "
                               "1 0 3/10 1 1 -16/75 1 2 4/25 1 3 3/50 2 0 2/5 2 1 4/25 2 2 -3/25 2 3 2/25 "
                               "3 0 3/10 3 1 3/25 3 2 4/25 3 3 3/50\n",
                               "motion 0: contact 0: s may be negative"}});
  // What lifts is pushed by the contact that slides: u_N = r_N - 1.
  reject_all(kThreeContacts, {{"9  0 0 1  1 1 1  2 2 1  3 3 1  4 0 1  4 3 1  4 4 1  5 3 1  5 5 1\nconstant 5",
                               "9  0 4 1  1 1 1  2 2 1  3 3 1  4 0 1  4 3 1  4 4 1  5 3 1  5 5 1\nconstant -1",
                               "motion 0: contact 0: u_N may be negative"}});
  const std::string nothing = "box modes open center radius pinned 0 dropped 0 inverse 0 alone 1";
  const std::string open = replaced(replaced(kRestsOrLifts, "exact 0", nothing), "known 0  1  -1", "known 0");
  CHECK(established(open) == "accepted: 2 motions and no others");
  reject_all(open, {{"constant 1", "constant -1", "motion 0: contact 0: u_N may be negative"}});
}

TEST_CASE("all solutions: what touches has no force, and forces that nothing determines are pinned") {
  const std::string column = "motion 0: dropped equation 1: it is not the combination, in a column";
  const std::string force = "it touches with a force";
  reject_all(kSharedWeight, {{"1 1 0 1 inverse", "1 1 0 2 inverse", column},
                             {"1 1 0 1 inverse", "1 0 inverse", column},
                             {"constant -1 0  -1 2", "constant -1 0  -2 2",
                              "motion 0: dropped equation 1: it is not the combination, at the center"},
                             {"1 1 0 1 inverse", "1 1 1 1 inverse",
                              "motion 0: dropped equation 1: it is combined of one that is dropped"},
                             {"dropped 1  1 1 0 1 inverse 1  0 0 1", "dropped 0 inverse 2  0 0 1  0 1 0",
                              "motion 0: as many unknowns as equations must be left"},
                             {"pinned 1 1", "pinned 1 0", "motion 0: contact 1: " + force},
                             {"center 1 0", "center 1/2 1/2", "motion 0: contact 1: " + force},
                             {"within 0 0 0 1", "within 0 0 0 7/8", node(8, kLess)},
                             {"empty -1 0 1 0", "empty 0 0 0 0", node(3, kNotEmpty)},
                             {"empty 1 0 -1 0", "empty 2 0 -1 0", node(5, kNotEmpty)}});
  const std::string touches =
      replaced(kTouches, "exact 0", "box modes touch center 0 radius 1 pinned 1 0 dropped 1 0 0 inverse 0");
  CHECK(established(touches) == "accepted: one motion and no other");
  const std::string rest = "inverse 0\ndecide 0\n  empty -1\n  known 0";
  reject_all(touches, {{rest, replaced(rest, "inverse 0", "inverse 0 alone 1") + " 0 0",
                        "motion 0: alone is less than 1, or an unknown is pinned"},
                       {"1 pinned 1 0 dropped 1 0 0 inverse 0", "1 pinned 0 dropped 0 inverse 1 0 0 1",
                        "motion 0: contact 0: " + force}});
}

TEST_CASE("all solutions: motions that exist just so") {
  const std::string one = "accepted: one motion and no other";
  CHECK(established(replaced(kRestsInBox, "center 1", "center 5/4")) == one);  // |R f| = 1/4
  CHECK(established(replaced(kRestsInBox, "alone 4", "alone 1")) == one);
  const std::string nothing = "box modes open center radius pinned 0 dropped 0 inverse 0";
  CHECK(established(replaced(kTouches, "exact 0", nothing)) == one);  // u_N = 0
  const std::string slowly = replaced(kSlidesInBox, "constant -1 2", "constant -1 3/4");
  CHECK(established(replaced(slowly, "empty 1 1", "empty 1/2 1")) == one);  // u_T >= 0
  reject_all(replaced(kNearASlide, "1/16 1/32", "1/16 2"),
             {{"1/16 2", "1/16 65/32", "motion 0: contact 0: s may be negative"}});
  // As far as |I - R J| p + 4 L |R| q = p, and less.
  reject_all(replaced(kSlidesInSpace, "alone 4", "alone 399/73"),
             {{"alone 399/73", "alone 400/73", "motion 0: unknown 3: there may be two zeros where it is alone"}});
}

TEST_CASE("all solutions: what is known of a pattern is the motion of its mode, alone there") {
  const std::string mode = "contact 0: the motion has another mode", bounds = "  1 0  -1 0  -1 0  1 0";
  reject_all(kParadox,
             {{"    known 2" + bounds + "\n    empty 1 0", "    empty 1 0\n    known 2" + bounds, node(4, kForces)},
              {"    known 1\n    known 2" + bounds, "    known 2" + bounds + "\n    known 1 -3 1 3 -1", node(3, mode)},
              {"  known 0  1 0  -1 0  0 1  0 -1", "  known 2" + bounds, node(1, mode)},
              {"known 1\n", "known 0\n", node(3, "row 0: u of the motion is not 0")},
              {"known 0  1 0", "known 1  1 0", node(1, kLess)}});
  const std::string known = "known 0  -1 0  1 0  1/2 0  -1/2 0";
  reject_all(kSlidesInBox, {{known + "\n    empty 0 1", "empty 0 1\n    " + known, node(4, kVelocities)},
                            {"empty 0 1", known, node(5, mode)},
                            {"known 0  -1 0  1 0", "known 0  -1 0  3 0", node(4, kLess)},
                            {"1/2 0  -1/2 0", "3/8 0  -1/2 0", node(4, kForces)},
                            {"1/2 0  -1/2 0", "9/8 0  -1/2 0", node(4, kLess)},
                            {"1/2 0  -1/2 0", "1/2 0  1/8 0", node(4, kLess)}});
  std::string zeros = "known 0";
  for (int i = 0; i < 24; ++i) zeros += " 0";
  reject_all(kSlidesInSpace, {{"empty 5/2 3 4", zeros, node(3, mode)}, {"empty 0 -55 48", zeros, node(5, kLess)}});
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
  for (const char* mode : {"closed", "slide", "slide+", "slide-", "any"}) {
    CHECK(refused(kRestsInBox, "modes stick", std::string("modes ") + mode) ==
          std::string("unreadable: line 9, column 18: found '") + mode + "', expected a mode that contact 0 can have");
  }
  const std::string within = refused(kRestsInBox, "alone 4", "alone 4 within 0");
  CHECK(within ==
        "unreadable: line 9, column 88: found 'within', expected 'decide', 'slips', 'arcs', 'empty', 'known' or "
        "'frictionless'");
  CHECK(refused(kRestsInBox, "alone 4", "alone").starts_with("unreadable: line 10, column 1: "));
  CHECK(refused(kNearASlide, "within 0 9/32", "within 0").starts_with("unreadable: "));
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
