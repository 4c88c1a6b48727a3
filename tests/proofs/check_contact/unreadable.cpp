// What is no certificate is refused with its place, with what was found and what was expected.
#include <random>
#include <vector>

#include "proofs/check_contact/all_solutions_examples.hpp"
#include "proofs/check_contact/examples.hpp"

using namespace slipproof::check_contact;

namespace {

const std::vector<std::string> kAll{kEps,  kNoneWithin, kNoSolution,   kSlide,    kPlane, kComplementarity,
                                    kRod,  kStick,      kDominant,     kDefinite, kNamed, kRestsInBox,
                                    kBall, kParadox,    kSlidesInSpace};

struct Malformed {
  std::string from, to, expected;
};

void refuse_all(const std::string& certificate, const std::vector<Malformed>& table) {
  REQUIRE(verdict(certificate).starts_with("accepted: "));
  for (const Malformed& malformed : table) {
    INFO("'", malformed.from, "' -> '", malformed.to, "'");
    CHECK(verdict(replaced(certificate, malformed.from, malformed.to)) == "unreadable: " + malformed.expected);
  }
}

}  // namespace

TEST_CASE("a certificate that ends at any of its tokens, or within one, is refused") {
  for (const std::string& certificate : kAll) {
    REQUIRE(verdict(certificate).starts_with("accepted: "));
    for (std::size_t size = 0; size + 1 < certificate.size(); ++size) {
      const std::string found = verdict(certificate.substr(0, size));
      CAPTURE(certificate.substr(0, size));
      CHECK(found.starts_with("unreadable: line "));
      CHECK(found.find(": found ") != std::string::npos);
      CHECK(found.find(", expected ") != std::string::npos);
    }
    CHECK(verdict(certificate.substr(0, certificate.size() - 1)) == verdict(certificate));
  }
}

TEST_CASE("a token more or less anywhere is refused, or rejected") {
  for (const std::string& certificate : kAll) {
    const std::string good = verdict(certificate);
    for (std::size_t place = 1; place < certificate.size(); ++place) {
      if (certificate[place - 1] > ' ' || certificate[place] <= ' ') continue;
      const std::size_t end = certificate.find_first_of(" \n", place);
      const std::string before = certificate.substr(0, place), after = certificate.substr(end);
      CAPTURE(before);
      CHECK(!verdict(before + after).starts_with("accepted: "));
      CHECK(!verdict(before + "0 " + certificate.substr(place)).starts_with("accepted: "));
      CHECK(verdict(before + "nan" + after).starts_with("unreadable: line "));
      CHECK(verdict(before + " # a comment: end\n\t" + certificate.substr(place)) == good);
    }
  }
}

TEST_CASE("words and their order") {
  refuse_all(kSlide,
             {{"slipproof-contact", "slipproof", "line 1, column 1: found 'slipproof', expected 'slipproof-contact'"},
              {"contact 1", "contact 2", "line 1, column 19: found '2', expected '1'"},
              {"dimension 3", "dimension 4", "line 2, column 11: found '4', expected '3'"},
              {"dimension 3", "dimension 0", "line 2, column 11: found '0', expected '3'"},
              {"dimension 3", "dimension 03", "line 2, column 11: found '03', expected '3'"},
              {"dimension", "Dimension", "line 2, column 1: found 'Dimension', expected 'dimension'"},
              {"enclosure", "box", "line 8, column 1: found 'box', expected a claim"},
              {"answer 10 -3 -4\n", "", "line 7, column 1: found 'enclosure', expected 'answer'"},
              {"answer", "no-answer", "line 7, column 11: found '10', expected a claim"},
              {"center 10 -3 -4 2\nradius 2 2 2 2", "radius 2 2 2 2\ncenter 10 -3 -4 2",
               "line 10, column 1: found 'radius', expected 'center'"},
              {"pinned 0\ndropped 0", "dropped 0\npinned 0", "line 12, column 1: found 'dropped', expected 'pinned'"},
              {"end\n", "end\nend\n", "line 20, column 1: found 'end', expected nothing after 'end'"},
              {"end\n", "", "line 19, column 1: found the end of the file, expected a claim or 'end'"},
              {"end\n", "fin\n", "line 19, column 1: found 'fin', expected a claim or 'end'"}});
  refuse_all(kDominant,
             {{"dominant", "convex",
               "line 8, column 8: found 'convex', expected 'dominant', 'definite', 'bound' or 'determinants'"}});
}

TEST_CASE("modes that a contact cannot have") {
  const std::string first = ", expected a mode that contact 0 can have";
  refuse_all(kSlide, {{"modes slide", "modes slide+", "line 9, column 7: found 'slide+'" + first},
                      {"modes slide", "modes slip", "line 9, column 7: found 'slip'" + first},
                      {"modes slide", "modes", "line 10, column 1: found 'center'" + first},
                      {"modes slide", "modes slide open", "line 9, column 13: found 'open', expected 'center'"},
                      {"mu 1/2", "mu 0", "line 9, column 7: found 'slide'" + first}});
  refuse_all(kPlane, {{"modes slide+", "modes slide", "line 9, column 7: found 'slide'" + first},
                      {"mu 1/2", "mu 0", "line 9, column 7: found 'slide+'" + first}});
  refuse_all(kComplementarity, {{"modes stick", "modes slide+", "line 9, column 7: found 'slide+'" + first},
                                {"modes stick", "modes slide", "line 9, column 7: found 'slide'" + first}});
}

TEST_CASE("counts, indices, and what stands twice") {
  refuse_all(
      kRod,
      {{"free 1", "free 2", "line 7, column 1: found 'answer', expected an exact number"},
       {"free 1", "free -1",
        "line 2, column 18: found '-1', expected a count of at most 132, half the size of the file"},
       {"free 1", "free 1099511627776",
        "line 2, column 18: found '1099511627776', expected a count of at most 137, half the size of the file"},
       {"free 1", "free 18446744073709551617",
        "line 2, column 18: found '18446744073709551617', expected a count of at most 141, half the size of the file"},
       {"free 1", "free 132", "line 4, column 1: found 'matrix', expected a file that is long enough for 134 numbers"},
       {"matrix 5", "matrix 1099511627776",
        "line 4, column 8: found '1099511627776', expected a count of at most 137, half the size of the file"},
       {"matrix 5", "matrix 0x5",
        "line 4, column 8: found '0x5', expected a count of at most 132, half the size of the file"},
       {"matrix 5", "matrix 4", "line 5, column 31: found '2', expected 'constant'"},
       {"matrix 5", "matrix 6", "line 6, column 1: found 'constant', expected an index below 3"},
       {"2 0 1\nconstant", "3 0 1\nconstant", "line 5, column 31: found '3', expected an index below 3"},
       {"2 0 1\nconstant", "2 3 1\nconstant", "line 5, column 33: found '3', expected an index below 3"},
       {"2 0 1\nconstant", "2 -1 1\nconstant", "line 5, column 33: found '-1', expected an index below 3"},
       {"2 0 1\nconstant", "1 0 1\nconstant",
        "line 5, column 33: found '0', expected an index that does not stand here already"},
       {"2 0 1\nconstant", "2 99999999999999999999999 1\nconstant",
        "line 5, column 33: found '99999999999999999999999', expected an index below 3"},
       {"constant 2", "constant 2 7", "line 6, column 16: found '0', expected 'answer'"},
       {"pinned 1 2", "pinned 1 3", "line 12, column 10: found '3', expected an index below 3"},
       {"pinned 1 2", "pinned 2 2 2",
        "line 12, column 12: found '2', expected an index that does not stand here already"},
       {"dropped 1  2 1 1 1", "dropped 1  3 1 1 1", "line 13, column 12: found '3', expected an index below 3"},
       {"dropped 1  2 1 1 1", "dropped 2  2 1 1 1  2 1 1 1",
        "line 13, column 21: found '2', expected an index that does not stand here already"},
       {"dropped 1  2 1 1 1", "dropped 1  2 1 3 1", "line 13, column 16: found '3', expected an index below 3"},
       {"dropped 1  2 1 1 1", "dropped 1  2 2 1 1/2 1 1/2",
        "line 13, column 22: found '1', expected an index that does not stand here already"},
       {"0 1 1  1 0 -1  1 1 1", "0 1 1  1 0 -1  2 1 1", "line 15, column 16: found '2', expected an index below 2"},
       {"0 1 1  1 0 -1  1 1 1", "0 1 1  1 0 -1  1 2 1", "line 15, column 18: found '2', expected an index below 2"},
       {"0 1 1  1 0 -1  1 1 1", "0 1 1  1 0 -1  1 0 -1",
        "line 15, column 18: found '0', expected an index that does not stand here already"}});
}

TEST_CASE("numbers are integers, fractions or hexadecimal floats, and nothing else") {
  const auto with = [](const std::string& number) { return verdict(replaced(kComplementarity, "3/16", number)); };
  for (const std::string good : {"1", "007", "3/16", "6/32", "0x3p-4", "0x0.3p0", "0x1.8p-3", "0x1.80p-0003",
                                 "0x1.8p+0", "0x1p5000", "0xfffp+12"}) {
    CAPTURE(good);
    CHECK(with(good).starts_with("accepted: "));
    CHECK(with("-" + good) == "rejected: RHO is negative");
  }
  CHECK(with("-0x0p5000").starts_with("rejected: component"));
  CHECK(with("0x2.fffffffffffffp-4").starts_with("rejected: component"));
  CHECK(with("0x1p-5000").starts_with("rejected: component"));
  CHECK(with(std::string(5'000, '9')).starts_with("accepted: "));
  const std::string zeros(5'000, '0');
  for (const std::string& bad : {std::string("nan"),
                                 std::string("inf"),
                                 std::string("-"),
                                 std::string("--1"),
                                 std::string("+1"),
                                 std::string("1."),
                                 std::string("0.1875"),
                                 std::string("1e0"),
                                 std::string("1/0"),
                                 std::string("1/-2"),
                                 std::string("/2"),
                                 std::string("1/"),
                                 std::string("1/2/3"),
                                 std::string("0x"),
                                 std::string("0x1"),
                                 std::string("0x1.8"),
                                 std::string("0xp1"),
                                 std::string("0x.8p1"),
                                 std::string("0x1.p1"),
                                 std::string("0x1p"),
                                 std::string("0x1p+"),
                                 std::string("0x1p+-1"),
                                 std::string("0x1p--1"),
                                 std::string("0x1p1.5"),
                                 std::string("0x1p5001"),
                                 std::string("0x1p-5001"),
                                 std::string("0x1p99999999999999999999"),
                                 std::string("0X1p1"),
                                 std::string("0x1P1"),
                                 std::string("0xAp1"),
                                 std::string("0x1.8.0p1"),
                                 std::string("0x1p1p1"),
                                 std::string("0x-1p1"),
                                 std::string("0x1p1/2"),
                                 std::string("1/0x2p0"),
                                 std::string("abc"),
                                 std::string("1,5"),
                                 "1" + zeros}) {
    CAPTURE(bad);
    const std::string shown = bad.size() > 40 ? "'" + bad.substr(0, 40) + "'..." : "'" + bad + "'";
    CHECK(with(bad) == "unreadable: line 8, column 11: found " + shown + ", expected an exact number");
  }
}

TEST_CASE("what an editor does not show is refused, in comments as well") {
  for (const std::string& byte : {std::string("\r"), std::string("\x1B[2K"), std::string(1, '\0'), std::string("\x7F"),
                                  std::string("\v"), std::string("\xC3\xA9"), std::string("\xFF")}) {
    const std::string refused =
        "found a byte of value " + std::to_string(static_cast<unsigned char>(byte[0])) + ", expected printable ASCII";
    CAPTURE(refused);
    CHECK(verdict(byte + kRod) == "unreadable: line 1, column 1: " + refused);
    CHECK(verdict(replaced(kRod, "free", "fr" + byte)) == "unreadable: line 2, column 15: " + refused);
    CHECK(verdict(replaced(kRod, "mu", "# x" + byte + "\nmu")) == "unreadable: line 3, column 4: " + refused);
    CHECK(verdict(kRod + "#" + byte) == "unreadable: line 17, column 2: " + refused);
  }
}

TEST_CASE("bytes that change at random end in a verdict") {
  std::mt19937_64 random(1);
  constexpr std::string_view bytes = "0123456789 \n-/xp.#abcdefslide+openstick";
  int accepted = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string text = kAll[random() % kAll.size()];
    for (std::size_t changes = 1 + random() % 3; changes > 0; --changes) {
      const std::size_t place = random() % text.size();
      if (random() % 3 == 0) {
        text.erase(place, 1 + random() % 4);
      } else if (random() % 2 == 0) {
        text.insert(place, 1, bytes[random() % bytes.size()]);
      } else {
        text[place] = bytes[random() % bytes.size()];
      }
      if (text.empty()) text = " ";
    }
    if (verdict(text).starts_with("accepted: ")) ++accepted;
  }
  CHECK(accepted > 100);
  CHECK(accepted < 10'000);
}
