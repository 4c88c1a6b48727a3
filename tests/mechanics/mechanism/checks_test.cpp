#include "mechanics/checks/checks.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <functional>
#include <string>
#include <thread>

#include "base/input/text_file.hpp"
#include "mechanics/mechanism/forms.hpp"
#include "mechanics/mechanism/units.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/shipped.hpp"

using namespace slipproof;

namespace {

std::string changed(std::string text, const std::string& what, const std::string& by) {
  const std::size_t position = text.find(what);
  REQUIRE_MESSAGE(position != text.npos, what);
  return text.replace(position, what.size(), by);
}

/// The warnings of a mechanism, a line each, and what was not checkable if asked for.
std::string findings(const Mechanism& m, bool all = false) {
  std::string text;
  for (const MechanismFinding& finding : check_mechanism(m)) {
    if (all || finding.checkable) text += to_string(m, finding) + "\n";
  }
  return text;
}

/// What the checks say of a shipped mechanism with a change.
std::string said(const std::string& name, const std::string& what, const std::string& by) {
  return findings(parse_mechanism(changed(std::string(find_shipped(name)->text), what, by), "x.toml"), true);
}

/// Every tree with the sign of one term turned round: + and - exchanged, a negation dropped, a first term negated.
void sign_errors(const Expression& e, const std::function<void(Expression)>& found) {
  const bool sum = e->operation == Operation::add || e->operation == Operation::subtract;
  if (e->operation == Operation::negate) {
    found(e->operands[0]);
  } else if (!sum && e->operation != Operation::number) {
    found(make(Operation::negate, {e}));
  }
  if (sum) {
    const bool minus = e->operation == Operation::subtract;
    found(make(minus ? Operation::add : Operation::subtract, e->operands));
    sign_errors(e->operands[0], [&](Expression x) { found(make(e->operation, {std::move(x), e->operands[1]})); });
  }
  const Expression& inner = sum ? e->operands[1] : e;
  if (inner->operation != Operation::multiply && inner->operation != Operation::divide) return;
  for (std::size_t i = 0; i < 2; ++i) {  // sums in brackets
    const Operation factor = inner->operands[i]->operation;
    if (factor != Operation::add && factor != Operation::subtract) continue;
    sign_errors(inner->operands[i], [&](Expression x) {
      std::vector<Expression> operands = inner->operands;
      operands[i] = std::move(x);
      const Expression whole = make(inner->operation, std::move(operands));
      found(sum ? make(e->operation, {e->operands[0], whole}) : whole);
    });
  }
}

/// The mechanism with its equations written out, contact forces included.
Mechanism written_out(Mechanism m) {
  for (MechanismEquation& equation : m.equations) equation.right.expression = equation.whole_right();
  m.by_virtual_work = false;
  Mistakes none(m.file);
  derive_forms(m, none);
  REQUIRE(none.empty());
  return m;
}

struct Count {
  std::size_t made = 0, found = 0;
};

/// Makes each sign error in one expression of the mechanism once.
void count_errors(Mechanism& m, Expression& place, Count& count) {
  const Expression original = place;
  sign_errors(original, [&](Expression wrong) {
    place = std::move(wrong);
    Mistakes mistakes(m.file);
    derive_forms(m, mistakes);
    ++count.made;
    if (!mistakes.empty() || !findings(m).empty()) ++count.found;
  });
  place = original;
  Mistakes none(m.file);
  derive_forms(m, none);
}

}  // namespace

TEST_CASE("the checks find most single sign errors in written-out equations") {
  Count all;
  for (const ShippedMechanism& shipped : shipped_mechanisms()) {
    Mechanism m = written_out(open_mechanism(std::string(shipped.name)));
    CHECK(findings(m) == "");
    Count count;
    for (MechanismEquation& equation : m.equations) {
      count_errors(m, equation.left.expression, count);
      count_errors(m, equation.right.expression, count);
    }
    for (MechanismContact& contact : m.contacts) {
      count_errors(m, contact.gap.expression, count);
      count_errors(m, contact.slip.expression, count);
    }
    for (MechanismFriction& friction : m.friction) count_errors(m, friction.slip.expression, count);
    for (MechanismLink& link : m.links) count_errors(m, link.zero.expression, count);
    MESSAGE(std::string(shipped.name), ": ", count.found, " of ", count.made, " sign errors are found");
    all.made += count.made;
    all.found += count.found;
  }
  MESSAGE("in all ", all.found, " of ", all.made, ", ", 100 * all.found / all.made, " %");
  CHECK(all.made > 400);
  CHECK(10 * all.found > 7 * all.made);
}

TEST_CASE("a matrix that is not symmetric is told at the place of a motion") {
  const std::string wrong = said("bicycle", "eps1 + I2*eps2 + I3*eps3 = b2*N2", "eps1 + I2*eps2 + I3*eps3 = -b2*N2");
  CHECK(wrong.find("x.toml:73:8: warning: forces and accelerations are not reciprocal") != std::string::npos);
  const std::string on_purpose = changed(std::string(find_shipped("bicycle")->text), "= b2*N2", "= -b2*N2");
  const Mechanism m =
      parse_mechanism(changed(on_purpose, "name = \"bicycle\"", "name = \"bicycle\"\nreciprocal = false"), "x.toml");
  CHECK(findings(m).find("reciprocal") == std::string::npos);
}

TEST_CASE("a force that works against itself is told") {
  const std::string one =
      "schema = \"slipproof/mechanism/1\"\nname = \"x\"\n[parameters]\nm = \"m > 0\"\n[unknowns]\naccelerations = "
      "[\"y\"]\n"
      "[equations]\ny = \"m*y = -m*10 - N\"\n[[contact]]\nname = \"floor\"\ngap = \"y\"\nnormal = \"N\"\n";
  const Mechanism m = parse_mechanism(one, "x.toml");
  CHECK(findings(m).starts_with("x.toml:11:8: warning: the force N accelerates gap_floor against itself"));
}

TEST_CASE("no mechanism that is shipped has a warning") {
  std::size_t count = 0;
  for (const char* folder : {"/cases", "/proofs"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(SLIPPROOF_SOURCE_DIR + std::string(folder))) {
      if (entry.path().extension() != ".toml") continue;
      const std::string text = read_text_file(entry.path());
      if (text.find("\"slipproof/mechanism/1\"") == std::string::npos) continue;
      CHECK(findings(parse_mechanism(text, entry.path().string())) == "");
      ++count;
    }
  }
  CHECK(count >= 36);
}

TEST_CASE("a factor of all rows is no mistake, and one of a single row is one by the energy") {
  std::string text(find_shipped("block-shaken")->text);
  for (const char* row : {"m*ax = 0", "m*ay = -m*g", "I*phi = 0"}) {
    const std::string equation(row);
    const std::size_t equals = equation.find(" = ");
    const std::string divided = "(" + equation.substr(0, equals) + ")/m = (" + equation.substr(equals + 3) + ")/m";
    text = changed(text, equation, divided);
  }
  CHECK(findings(parse_mechanism(text, "x.toml")) == "");
  const std::string trailer(find_shipped("trailer")->text);
  REQUIRE(trailer.find("energy = ") != std::string::npos);
  for (const char* row : {"m1*x1 = F", "m1*y1 = -m1*g", "J1*phi1 = 0", "m2*x2 = 0", "m2*y2 = -m2*g", "J2*phi2 = 0"}) {
    const std::string equation(row);
    const std::string name = equation.substr(equation.find('*') + 1, equation.find(" =") - equation.find('*') - 1);
    const std::string scaled =
        "2*" + equation.substr(0, equation.find(" = ")) + " = 2*(" + equation.substr(equation.find(" = ") + 3) + ")";
    const std::string said = findings(parse_mechanism(changed(trailer, equation, scaled), "x.toml"));
    CHECK(said.find("warning: scale of row " + name + ": ") != std::string::npos);
  }
}

TEST_CASE("a picture may be turned, mirrored and shifted as a whole, and scaled at a contact") {
  const std::string block(find_shipped("block-shaken")->text);
  const auto drawn = [&](const std::string& left, const std::string& right, const std::string& direction) {
    const std::string plain = "\ndirection = [\"0\", \"1\"]";
    std::string text = changed(block, "at = [\"b\", \"-h\"]" + plain, "at = " + right + "\n" + direction);
    text = changed(text, "at = [\"-b\", \"-h\"]" + plain, "at = " + left + "\n" + direction);
    return findings(parse_mechanism(text, "x.toml"));
  };
  CHECK(drawn("[\"5 - b\", \"7\"]", "[\"5 + b\", \"7\"]", "direction = [\"0\", \"2\"]") == "");
  CHECK(drawn("[\"h\", \"-b\"]", "[\"h\", \"b\"]", "direction = [\"-1\", \"0\"]") == "");
  CHECK(drawn("[\"b\", \"-h\"]", "[\"-b\", \"-h\"]", "direction = [\"0\", \"1\"]\nslip_direction = [\"-1\", \"0\"]") ==
        "");
  CHECK(drawn("[\"(-3*b + 4*h)/5\", \"(-4*b - 3*h)/5\"]", "[\"(3*b + 4*h)/5\", \"(4*b - 3*h)/5\"]",
              "direction = [\"-4/5\", \"3/5\"]") == "");
  CHECK(drawn("[\"-b\", \"-h\"]", "[\"2*b\", \"-h\"]", "direction = [\"0\", \"1\"]") != "");
  CHECK(drawn("[\"-b\", \"-h\"]", "[\"b\", \"h\"]", "direction = [\"0\", \"1\"]") != "");
  const std::string scaled = changed(block, "gap = \"ay - b*phi\"\nslip = \"ax + h*phi - A*g\"",
                                     "gap = \"3*ay - 3*b*phi\"\nslip = \"3*ax + 3*h*phi - 3*A*g\"");
  CHECK(findings(parse_mechanism(scaled, "x.toml")) == "");
}

TEST_CASE("gravity is judged where nothing pushes, and named with the values that matter") {
  const std::string pushed = changed(std::string(find_shipped("block-shaken")->text), "[load]",
                                     "P = { unit = \"N\" }\nQ = { domain = \"Q > 0\", unit = \"N\" }\n[load]");
  CHECK(findings(parse_mechanism(changed(pushed, "m*ay = -m*g", "m*ay = P - Q - m*g"), "x.toml")) == "");
  const std::string lifted = findings(parse_mechanism(changed(pushed, "m*ay = -m*g", "m*ay = P + Q - m*g"), "x.toml"));
  CHECK(lifted.find("the contact left opens: gap_left = ") != std::string::npos);  // Q cannot be 0
  CHECK(lifted.find(", at m = ") != std::string::npos);
  CHECK(lifted.find("P = 0, Q = ") != std::string::npos);
  for (const char* other : {"b = ", "h = ", "I = ", "mu = "}) CHECK(lifted.find(other) == std::string::npos);
}

TEST_CASE("gravity that lifts, and gravity that nobody wrote down, are told") {
  CHECK(
      said("block-shaken", "-m*g", "m*g").find("without contact forces and load the contact left opens: gap_left = ") !=
      std::string::npos);
  CHECK(said("block-shaken", "-m*g", "0").find("there is gravity, but without contact forces and load nothing moves") !=
        std::string::npos);
  CHECK(said("gripper", "-m*g", "m*g").find("warning") == std::string::npos);  // nobody can know where down is
}

TEST_CASE("each contact that gravity opens is named") {
  const std::string lifted = said("block-shaken", "-m*g", "m*g");
  for (const char* name : {"left", "right"}) {
    CHECK(lifted.find("the contact " + std::string(name) + " opens: gap_" + name + " = ") != std::string::npos);
  }
}

TEST_CASE("a literal 0 for friction is told to make the contact smooth") {
  const std::string smooth =
      "schema = \"slipproof/mechanism/1\"\nname = \"x\"\n[unknowns]\naccelerations = [\"x\", \"y\"]\n[motion]\nx = "
      "\"x = 0\"\ny = \"y = -10\"\n[[contact]]\nname = \"floor\"\ngap = \"y\"\nslip = \"x\"\n";
  CHECK(findings(parse_mechanism(smooth, "x.toml")) == "");
  CHECK(findings(parse_mechanism(smooth + "friction = \"0\"\n", "x.toml"))
            .find("x.toml:12:13: warning: floor: found friction = \"0\", which makes the contact smooth") == 0);
}

TEST_CASE("a smooth contact may have a slip, of which no force speaks") {
  CHECK(findings(parse_mechanism(R"(schema = "slipproof/mechanism/1"
name = "smooth"
[parameters]
m = "m > 0"
[unknowns]
accelerations = ["x", "y"]
[motion]
x = "m*x = 0"
y = "m*y = -1"
[[contact]]
name = "floor"
gap = "y"
slip = "x"
at = ["0", "0"]
direction = ["0", "1"]
)",
                                 "x.toml"))
            .empty());
}

TEST_CASE("what cannot be checked says why") {
  const std::string massless =
      "schema = \"slipproof/mechanism/1\"\nname = \"x\"\n[unknowns]\naccelerations = [\"x\", \"y\"]\n[equations]\nx = "
      "\"0 "
      "= 0\"\n"
      "y = \"y = N_floor - 10\"\n[[contact]]\nname = \"floor\"\ngap = \"y + x\"\n";
  CHECK(findings(parse_mechanism(massless, "x.toml"), true) ==
        "x.toml: not checkable: reciprocity: the equations do not determine the accelerations for given contact "
        "forces\n"
        "x.toml: not checkable: gravity: the equations do not determine a motion without contact forces\n");
  CHECK(said("block-shaken", "h = { domain = \"h > 0\"", "h = { domain = \"h > 0 and h*h < 0\"") ==
        "x.toml: not checkable: too few points of the domain were found to try equations and contacts at\n");
  const std::string two_bodies = said("stacked-blocks", "y1 = \"m1*y1 = -m1*g\"", "y1 = \"m1*y1 = -m1*g \"");
  CHECK(two_bodies ==
        "x.toml: not checkable: geometry of the contacts floor, between: their gaps and slips do not use the "
        "accelerations "
        "of one body, two translations and a rotation\n");
}

TEST_CASE("sums of different units are told at their place") {
  CHECK(said("block-shaken", "gap = \"ay - b*phi\"", "gap = \"ay - b*b*phi\"")
            .find("x.toml:34:11: warning: 'ay - b * b * phi' adds or compares m.s-2 and m2.s-2") != std::string::npos);
  CHECK(said("block-shaken", "ay = \"m*ay = -m*g\"", "ay = \"m*ay = -g\"")
            .find("warning: the equation ay has m.kg.s-2 and m.s-2") != std::string::npos);
  CHECK(said("block-shaken", "unit = \"kg\", meaning = \"mass\"", "unit = \"kgg\", meaning = \"mass\"")
            .find("not checkable: units: 'kgg' of m is not a known unit") != std::string::npos);
  CHECK(said("block-shaken", "domain = \"b > 0\"", "domain = \"b > 1\"").find("'b > 1' adds or compares m and 1") !=
        std::string::npos);
  CHECK(said("block-shaken", "unit = \"1\", meaning = \"coefficient", "unit = \"m\", meaning = \"coefficient")
            .find("the coefficient of friction 'mu' is in m, expected a number") != std::string::npos);
}

TEST_CASE("units are the same by dimension and size") {
  const auto unit = [](const char* text) { return parse_unit(text).value(); };
  CHECK(unit("N") == unit("kg m/s^2"));
  CHECK(unit("N m") == unit("kg m^2 s^-2"));
  CHECK_FALSE(unit("N") == unit("kN"));
  CHECK_FALSE(unit("m/s") == unit("s/m"));
  CHECK(unit("rad/s") == unit("s^-1"));
  CHECK(unit("kg") * unit("m") / unit("s").power(2).value() == unit("N"));
  CHECK(unit("1") == Unit());
  for (const char* text :
       {"parrot", "kg kg kg parrot", "m^99999999999", "1e999999 m", "@", "seconds since 1970-01-01", "((((", "\xff"}) {
    CAPTURE(text);
    CHECK_NOTHROW(parse_unit(text));
  }
  CHECK_FALSE(parse_unit("parrot"));
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int k = 0; k < 300; ++k) CHECK(unit("kg m/s^2") == unit("N"));
    });
  }
  for (std::thread& thread : threads) thread.join();
}
