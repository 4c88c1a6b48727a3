// The checker accepts certificates of enclosures and rejects every forgery: see forgeries.cpp.
#include "proofs/check_contact/examples.hpp"

using namespace slipproof::check_contact;

namespace {

const std::string kSpread = "|I - R J| p is not less than its radius",
                  kMapped = "the box is not mapped into its radius";
const std::string kFar = "the solution may be farther than RHO from the answer";

}  // namespace

TEST_CASE("enclosure: a contact that slides in space") {
  const std::string box = "center 10 -3 -4 2\nradius 2 2 2 2";
  reject_all(kSlide, {{"enclosure 2", "enclosure 3/2", "component 0: " + kFar},
                      {"enclosure 2", "enclosure -2", "RHO is negative"},
                      {"mu 1/2", "mu -1/2", "contact 0: mu is negative"},
                      {"answer 10 -3 -4", "answer 10 -3 -5", "component 2: " + kFar},
                      {"answer 10 -3 -4", "no-answer", "the claim speaks of the answer, and there is no-answer"},
                      {"radius 2 2 2 2", "radius 2 2 2 0", "unknown 3: its radius is not positive"},
                      {"radius 2 2 2 2", "radius -2 2 2 2", "unknown 0: its radius is not positive"},
                      {"radius 2 2 2 2", "radius 3 3 3 3", "unknown 1: " + kMapped},
                      {"radius 2 2 2 2", "radius 2 2 2 3", "unknown 1: " + kMapped},  // p_s p_T
                      {"radius 2 2 2 2", "radius 2 2 4 2", "unknown 1: " + kMapped},  // p_T1^2 + p_T2^2
                      {"radius 2 2 2 2", "radius 9 2 2 2", "unknown 1: " + kMapped},  // m^2 p_N^2
                      {"constant -10 9 12", "constant -10 15 12", "unknown 1: " + kMapped},
                      {"0 0 1\n1 0", "0 0 3\n1 0", "unknown 0: " + kSpread},
                      {"0 0 1\n1 0", "0 0 2\n1 0", "unknown 0: " + kSpread},  // as large as the radius
                      {"inverse 13\n0 0 1\n", "inverse 12\n", "unknown 0: " + kSpread},
                      {"3 3 -3/50", "3 3 3/50", "unknown 3: " + kSpread},
                      {"mu 1/2", "mu 3/5", "unknown 1: " + kMapped},
                      {"radius 2 2 2 2", "radius 5/2 2 2 2", "component 0: " + kFar},
                      {box, "center 10 -3 -4 15/8\nradius 2 1 1 2", "contact 0: s may be negative"}});
}

TEST_CASE("enclosure: the radius of a slip is not compared with RHO") {
  CHECK(
      verdict(replaced(replaced(kSlide, "radius 2 2 2 2", "radius 1/64 1/64 1/64 1"), "enclosure 2", "enclosure 1/32"))
          .starts_with("accepted: "));
}

TEST_CASE("enclosure: contacts that slide in the plane, and open ones") {
  reject_all(kPlane, {{"enclosure 1/2", "enclosure 1/8", "component 0: " + kFar},
                      {"mu 1/2 1/2 1", "mu 1/2 1/2 -1", "contact 2: mu is negative"},
                      {"-3 7", "-31/8 7", "contact 2: u_N may be negative"},
                      {"constant -4 5", "constant -4 2", "contact 0: u_T may have the other sign"},
                      {"-4 -5", "-4 -2", "contact 1: u_T may have the other sign"},
                      {"slide+ slide-", "slide- slide-", "unknown 1: " + kSpread},
                      {"slide+ slide-", "slide+ slide+", "unknown 3: " + kSpread},
                      {"4 2  0 0", "4 2  1 0", "component 4: " + kFar},
                      {"4 2  0 0", "4 2  0 -1", "component 5: " + kFar},
                      {"radius 0x1p-2", "radius 9/2", "contact 0: r_N may be negative"}});
  CHECK(verdict(replaced(kPlane, "-3 7", "-15/4 7")).starts_with("accepted: "));  // u_N >= 0, just so
  CHECK(verdict(replaced(kPlane, "-4 5", "-4 9/4")).starts_with("accepted: "));   // u_T >= 0
  CHECK(verdict(replaced(replaced(kRod, "radius 1/4 1/4", "radius 1/4 1"), "enclosure 1/2", "enclosure 5/4"))
            .starts_with("accepted: "));  // r_N >= 0
}

TEST_CASE("enclosure: linear complementarity") {
  reject_all(kComplementarity, {{"enclosure 3/16", "enclosure 1/8", "component 0: " + kFar},
                                {"center 17/16", "center 9/8", "unknown 0: " + kMapped},
                                {"mu 0 0", "mu 0 1", "contact 1: mu is not 0 in dimension 1"},
                                {"radius 1/8 1/8", "radius 2 2", "contact 0: r_N may be negative"},
                                {"0 0 1/2", "0 0 1", "unknown 0: " + kSpread},
                                {"0 1 1 ", "0 1 2 ", "unknown 0: " + kSpread}});
}

TEST_CASE("enclosure: contacts that stick, with and without friction") {
  const std::string cone = "contact 0: the force may leave the friction cone";
  reject_all(kStick, {{"mu 1/2", "mu 9/20", cone},
                      {"mu 1/2", "mu -1/2", "contact 0: mu is negative"},
                      {"radius 1/4 1/4 1/4", "radius 1/4 1/2 1/2", cone},
                      {"radius 1/4 1/4", "radius 1 1/4", cone},
                      {"constant -10", "constant -11", "unknown 0: " + kMapped},
                      {"1/4 1/4 1/4 1/4", "1/4 1/4 1/4 2", "contact 1: r_N may be negative"},
                      {"1 0 0\nenclosure", "1 1 0\nenclosure", "component 4: " + kFar},
                      {"1 0 0\nenclosure", "1 0 -1\nenclosure", "component 5: " + kFar}});
  const std::string other_way = replaced(replaced(kStick, "-10 -3", "-10 3"), "answer 10 3", "answer 10 -3");
  reject_all(replaced(other_way, "center 10 3", "center 10 -3"), {{"mu 1/2", "mu 9/20", cone}});
}

TEST_CASE("enclosure: pinned unknowns and dropped equations") {
  const std::string by = "dropped 1  2 1 1 1", column = "dropped equation 2: it is not the combination, in a column";
  const std::string many = "as many unknowns as equations must be left";
  reject_all(kRod,
             {{by, "dropped 1  2 1 1 2", column},
              {by, "dropped 1  2 0", column},
              {by, "dropped 1  2 1 0 1", column},
              {by, "dropped 1  2 2 0 1 1 1", column},
              {by, "dropped 1  2 1 2 1", "dropped equation 2: it is combined of one that is dropped"},
              {"constant 2 0 0", "constant 2 0 1", "dropped equation 2: it is not the combination, at the center"},
              {"pinned 1 2", "pinned 0", many},
              {by, "dropped 0", many},
              {"pinned 1 2", "pinned 1 0", "unknown 1: " + kSpread},
              {"answer 0 5/4 3/4", "answer 0 5/4 1/4", "component 2: " + kFar},
              {"center 0 1 1", "center 0 3 -1", "contact 1: r_N may be negative"},
              {"radius 1/4 1/4 1/4", "radius 1/4 1/4 0", "unknown 2: its radius is not positive"},
              {"pinned 1 2\ndropped 1  2 1 1 1\ninverse 3\n0 1 1  1 0 -1  1 1 1",
               "pinned 2 1 2\ndropped 2  1 1 2 1  2 1 1 1\ninverse 1\n0 0 1",
               "dropped equation 1: it is combined of one that is dropped"}});
  CHECK(verdict(replaced(kRod, "center 0", "center 1/16")).starts_with("accepted: "));  // both are off by as much
  // What is pinned has no radius, and stays at its center, so that it may stand in a dropped equation only.
  CHECK(verdict(replaced(kRod, "radius 1/4 1/4 1/4", "radius 1/4 1/4 9")).starts_with("accepted: "));
  CHECK(verdict(replaced(replaced(kRod, "matrix 5", "matrix 6 2 2 1"), "constant 2 0 0", "constant 2 0 -1"))
            .starts_with("accepted: "));
}

TEST_CASE("enclosure: equations that are not linear are neither dropped nor combined") {
  const std::size_t place = kSlide.find("pinned 0");
  const auto with = [&](const std::string& rest) { return verdict(kSlide.substr(0, place) + rest + " inverse 0 end"); };
  CHECK(with("pinned 1 0 dropped 1 1 0") == "rejected: dropped equation 1: it is not linear");
  CHECK(with("pinned 1 0 dropped 1 2 0") == "rejected: dropped equation 2: it is not linear");
  CHECK(with("pinned 1 0 dropped 1 3 0") == "rejected: dropped equation 3: it is not linear");
  for (const char* other : {"1", "2", "3"}) {
    CHECK(with(std::string("pinned 1 0 dropped 1 0 1 ") + other + " 0") ==
          "rejected: dropped equation 0: it is combined of one that is not linear");
  }
}

TEST_CASE("enclosure: where nothing is left, the box is a point or empty forces") {
  const std::string open =
      "slipproof-contact 1 dimension 3 free 0 contacts 1 mu 1/2 matrix 0 constant 0 5 6 answer 1/4 0 0 enclosure 1/4 "
      "modes open center radius pinned 0 dropped 0 inverse 0 end";
  reject_all(open, {{"constant 0", "constant -1/1000", "contact 0: u_N may be negative"},
                    {"enclosure 1/4", "enclosure 1/5", "component 0: " + kFar}});
  const std::string pinned =
      "slipproof-contact 1 dimension 1 free 0 contacts 1 mu 0 matrix 0 constant 0 answer 7 enclosure 1 modes stick "
      "center 7 radius 1 pinned 1 0 dropped 1 0 0 inverse 0 end";
  reject_all(pinned, {{"constant 0", "constant 1", "dropped equation 0: it is not the combination, at the center"},
                      {"matrix 0", "matrix 1 0 0 1", "dropped equation 0: it is not the combination, at the center"},
                      {"center 7", "center -7", "contact 0: r_N may be negative"}});
  CHECK(
      verdict("slipproof-contact 1 dimension 2 free 0 contacts 0 mu matrix 0 constant answer enclosure 0 modes center "
              "radius pinned 0 dropped 0 inverse 0 end")
          .starts_with("accepted: "));
}
