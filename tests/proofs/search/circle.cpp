// Statements about bodies at an angle, whose cosine and sine are on the circle: its equation shortens what contains
// them.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "claims/reading/read_claims_file.hpp"
#include "claims/statements/claim_statements.hpp"
#include "proofs/check/judge.hpp"
#include "proofs/search/prove.hpp"
#include "proofs/search/small_statement.hpp"
#include "support/run_program.hpp"

using namespace slipproof;

namespace {

/// Proved with few steps, and the checker accepts the proof.
void check_proved(const std::string& text, std::uint64_t steps) {
  CAPTURE(text);
  prove::Limits limits;
  limits.steps = steps;
  limits.sums_of_squares = false;
  const ProofOutcome outcome = prove_statement("small", text, limits);
  REQUIRE(outcome.proved());
  CHECK(check::judge(text, outcome.certificate).verdict == check::Verdict::accepted);
}

/// A bead on a rod that turns with a constant speed about its end; it rests on the rod at a distance r.
const std::string at_an_angle = R"(schema = "slipproof/mechanism/1"
name = "bead"
gravity = ["0", "-g"]
parameters = { m = "m > 0", r = "r > 0", w = "w > 0", mu = "mu >= 0", g = "g > 0" }
angles = { theta = { cos = "c", sin = "s" } }
[[body]]
name = "rod"
at = ["0", "0"]
angle = "theta"
acceleration = ["0", "0"]
turning = "0"
spin = "w"
[[body]]
name = "bead"
mass = "m"
at = ["r*c", "r*s"]
angle = "theta"
velocity = ["-w*r*s", "w*r*c"]
turning = "0"
spin = "w"
[[contact]]
name = "q"
of = "bead"
point = ["0", "0"]
on = "rod"
normal = ["0", "1"]
through = ["0", "0"]
friction = "mu"
)";

const std::string claims = R"(schema = "slipproof/claims/1"
paper = { title = "x", authors = ["x"], source = "x" }
[[setting]]
id = "x"
mechanism = "bead.toml"
motions = "strict"
[setting.parameters]
m = { domain = "m > 0", meaning = "x" }
r = { domain = "r > 0", meaning = "x" }
w = { domain = "w > 0", meaning = "x" }
mu = { domain = "mu >= 0", meaning = "x" }
g = { domain = "g > 0", meaning = "x" }
[setting.angles]
theta = { cos = "c", sin = "s" }
[[claim]]
id = "X"
line = 1
statement = "what is thrown outward does not slide inward"
kind = "impossible"
modes = ["slip-"]
region = "w^2*r > g*s"
)";

}  // namespace

TEST_CASE("circle: a bead on a turning rod at an angle does not slide inward") {
  const test::TemporaryFolder folder;
  folder.write("bead.toml", at_an_angle);
  const ClaimsFile file = parse_claims(claims, folder.path() / "claims.toml");
  const std::vector<NamedStatement> statements = claim_statements(file, file.claims.front(), Reading::printed);
  REQUIRE(statements.size() == 1);
  check_proved(statements.front().text, 1'000'000);
}

TEST_CASE("circle: terms that its equation shortens") {
  const std::string given = "real a b c s\nassume circle: c^2 + s^2 = 1\n";
  for (const char* rest :
       {"assume x: a*c^2 + a*s^2 > b\nshow a > b\n", "assume x: 3*a*c^2 + a*s^2 > 2*a*c^2 + b\nshow a > b\n",
        "assume x: a*c^4 + 2*a*c^2*s^2 + a*s^4 > b\nshow a > b\n", "assume x: s > 0\nshow c^2 < 1\n",
        "assume x: a > 0 and c != 0\nshow a*s^2 < a\n"}) {
    check_proved(test::statement(given + rest), 100'000);
  }
}

TEST_CASE("circle: of two angles, of another radius, and with a cosine that something else determines") {
  for (const char* text : {"real a b c s d t\nassume x: c^2 + s^2 = 1 and d^2 + t^2 = 1\n"
                           "assume y: a*c^2*d^2 + a*c^2*t^2 + a*s^2*d^2 + a*s^2*t^2 > b\nshow a > b\n",
                           "real a b c s\nassume x: 4 = c^2 + s^2\nassume y: a*c^2 + a*s^2 > b\nshow 4*a > b\n",
                           "real a b c s l h\nassume x: c^2 + s^2 = 1 and l > 0 and h > 0\nassume y: s*l = h\n"
                           "assume z: a*c^2 + a*s^2 > b\nshow a > b\n",
                           "real a b c s l h\nassume x: c^2 + s^2 = 1 and l > 0 and h > 0\nassume y: s*l = h\n"
                           "assume z: a > 0 and c != 0\nshow a*h^2 < a*l^2\n"}) {
    check_proved(test::statement(text), 200'000);
  }
}

TEST_CASE("circle: what is false on it is refuted or stays undecided") {
  const std::string given = "real a c s\nassume circle: c^2 + s^2 = 1\nassume x: a > 0\n";
  for (const char* shown : {"show a*c^2 > 0\n", "show a*c^2 + a*s^2 > a\n", "show c^2 - s^2 <= 1/2\n"}) {
    prove::Limits limits;
    limits.steps = 200'000;
    CHECK_FALSE(prove_statement("small", test::statement(given + shown), limits).proved());
  }
}
