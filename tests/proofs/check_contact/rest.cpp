// The claims `rest` and `no-rest`: forces that hold, or a virtual motion that gains power.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "proofs/check_contact/record.hpp"
#include "support/replaced.hpp"

using namespace slipproof;
using Kind = check_contact::ContactVerdict::Kind;

namespace {

/// A particle on a slope: v along the normal and the slope, weights 4 and 3 against them, friction 3/4; a link with the
/// force lambda holds along the slope as well.
const std::string on_slope =
    "slipproof-contact 1\n"
    "dimension 2 free 3 contacts 1\n"
    "mu 3/4\n"
    "matrix 8\n"
    "0 0 2  0 3 -1  1 1 2  1 2 -1  1 4 -1  2 1 1  3 0 1  4 1 1\n"
    "constant 4 3 0  0 0\n"
    "no-answer\n";
const std::string held = on_slope + "rest 2\nforces 1  4 2\nend\n";
const std::string in_space =
    "slipproof-contact 1\n"
    "dimension 3 free 3 contacts 1\n"
    "mu 3/4\n"
    "matrix 9\n"
    "0 0 1  0 3 -1  1 1 1  1 4 -1  2 2 1  2 5 -1  3 0 1  4 1 1  5 2 1\n"
    "constant 4 9/5 13/5  0 0 0\n"
    "no-answer\n";
/// At 4 along the normal friction holds 3, and (9/5, 13/5) is longer.
const std::string falls = in_space + "no-rest 3\nmultipliers 3 -12/5 -16/5\nend\n";

std::string told(const std::string& certificate) {
  const auto found = check_contact::checked_on_record(certificate);
  return (found.kind == Kind::accepted   ? "accepted: "
          : found.kind == Kind::rejected ? "rejected: "
                                         : "unreadable: ") +
         found.message.substr(0, found.message.find(", "));
}

}  // namespace

TEST_CASE("rest: forces in the cones that balance") {
  CHECK(told(held) == "accepted: it can rest");
  CHECK(told(test::replaced(held, "forces 1  4 2", "forces 0  4 3")) == "accepted: it can rest");
  const std::vector<std::vector<std::string>> forgeries{
      {"forces 1  4 2", "forces 1  4 3", "row 1: it does not vanish at rest"},
      {"forces 1  4 2", "forces 1  5 2", "row 0: it does not vanish at rest"},
      {"forces 1  4 2", "forces -1  4 4", "contact 0: |r_T| exceeds m r_N"},
      {"constant 4", "constant -4", "row 0: it does not vanish at rest"},
      {"constant 4 3 0  0 0", "constant 4 3 1  0 0", "row 2: it does not vanish at rest"},
      {"constant 4 3 0  0 0", "constant 4 3 0  0 1", "row 4: it does not vanish at rest"},
      {"mu 3/4", "mu 1/4", "contact 0: |r_T| exceeds m r_N"},
      {"mu 3/4", "mu -3/4", "contact 0: mu is negative"}};
  for (const auto& forgery : forgeries) {
    CHECK(told(test::replaced(held, forgery[0], forgery[1])) == "rejected: " + forgery[2]);
  }
  const std::string pulls =
      test::replaced(test::replaced(held, "constant 4 3", "constant -4 3"), "forces 1  4 2", "forces 1  -4 2");
  CHECK(told(pulls) == "rejected: contact 0: r_N is negative");
  CHECK(told(test::replaced(held, "rest 2", "rest 4")).starts_with("unreadable: "));
  CHECK(told(test::replaced(held, "rest 2", "rest 3")).starts_with("unreadable: "));
}

TEST_CASE("no-rest: a virtual motion that no contact resists, and that gains power") {
  CHECK(told(falls) == "accepted: it cannot rest");
  const std::vector<std::vector<std::string>> forgeries{
      {"multipliers 3", "multipliers -3", "contact 0: g_N is positive"},
      {"multipliers 3", "multipliers 29/10", "contact 0: m |g_T| exceeds |g_N|"},
      {"-12/5 -16/5", "-14/5 -16/5", "contact 0: m |g_T| exceeds |g_N|"},
      {"-12/5 -16/5", "-12/5 -10/5", "c . y is not negative"},
      {"-12/5 -16/5", "-12/5 -18/5", "contact 0: m |g_T| exceeds |g_N|"},
      {"constant 4", "constant 5", "c . y is not negative"},
      {"9/5 13/5", "9/5 12/5", "c . y is not negative"},
      {"mu 3/4", "mu 4/5", "contact 0: m |g_T| exceeds |g_N|"},
      {"0 0 1  0 3 -1", "0 0 1  0 3 1", "contact 0: g_N is positive"}};
  for (const auto& forgery : forgeries) {
    CHECK(told(test::replaced(falls, forgery[0], forgery[1])) == "rejected: " + forgery[2]);
  }
  // A link resists: y along it is not 0.
  CHECK(told(on_slope + "no-rest 2\nmultipliers -3 -4\nend\n") == "rejected: column 2: g is not 0");
}
