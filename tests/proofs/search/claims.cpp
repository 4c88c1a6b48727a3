// Claims and their proofs: the statements say what the claims file and the model say, and the certificates prove them.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/expression/parser.hpp"
#include "base/input/diagnostic.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "claims/statements/claim_statements.hpp"
#include "claims/statements/formulas.hpp"
#include "proofs/check/files.hpp"
#include "proofs/search/prove.hpp"
#include "proofs/statement/statement.hpp"
#include "proofs/statement/statement_text.hpp"
#include "support/bicycle/motions.hpp"
#include "support/papers/shipped.hpp"
#include "support/run_program.hpp"

namespace {

using namespace slipproof;
using test::shipped_certificates;
using test::shipped_folder;

struct ClaimProof {
  bool proved = false;  ///< all statements, by shipped certificates
  std::vector<std::string> names, problems;
};

/// Of the shipped statements and certificates; with `trust`, whatever the certificates say.
ClaimProof find_claim_proof(const ClaimsFile& claims, const Claim& claim, Reading reading, bool trust = false) {
  ClaimProof result;
  for (const NamedStatement& statement : claim_statements(claims, claim, reading)) {
    const std::string name = (shipped_certificates / statement.name).string();
    result.names.push_back(statement.name);
    const std::string objection = trust ? "" : check::check_file(name + ".cert").message;
    if (!objection.empty()) result.problems.push_back(objection);
    if (test::read_file(name + ".statement") != statement.text) result.problems.push_back(name + " differs");
  }
  result.proved = !result.names.empty() && result.problems.empty();
  return result;
}

bool holds(const prove::Formula& formula) {
  using Kind = prove::Formula::Kind;
  if (formula.kind == Kind::atom) {
    const Rational value = formula.polynomial.front().constant();
    return formula.sign == prove::Sign::zero       ? value == 0
           : formula.sign == prove::Sign::positive ? value > 0
                                                   : value >= 0;
  }
  for (const prove::Formula& part : formula.parts) {
    if (holds(part) != (formula.kind == Kind::conjunction)) return formula.kind != Kind::conjunction;
  }
  return formula.kind == Kind::conjunction;
}

/// The statement with numbers for its parameters.
std::string with_numbers(std::string text, const std::map<std::string, Rational>& values) {
  const std::size_t begin = text.find("real ");
  const std::size_t end = text.find('\n', begin) + 1;
  std::string lets;
  for (const auto& [name, value] : values) lets += "let " + name + " = " + value.str() + "\n";
  return text.replace(begin, end - begin, lets);
}

}  // namespace

TEST_CASE("Assertions 1 to 4 are proved in the reading in which they are true") {
  const ClaimsFile claims = read_claims(shipped_folder / "claims.toml");
  for (const char* id : {"A1.1", "A1.1a", "A1.2",  "A1.2a", "A2.1", "A2.1a", "A2.2", "A2.2a", "A2.3", "A2.3a",
                         "A2.4", "A3.1",  "A3.1a", "A3.2",  "A4.1", "A4.1a", "A4.2", "A4.2a", "A4.3", "A5.1"}) {
    const Claim* claim = claims.find(id);
    REQUIRE_MESSAGE(claim != nullptr, id);
    const ClaimProof proof = find_claim_proof(claims, *claim, Reading::repaired);
    INFO(id, ": ", proof.problems.empty() ? "" : proof.problems.front());
    CHECK(proof.proved);
  }
}

TEST_CASE("uniqueness is proved cell by cell, and that the motions exist with it") {
  const ClaimsFile claims = read_claims(shipped_folder / "claims.toml");
  const Claim& claim = *claims.find("A5.2");
  const ClaimProof proof = find_claim_proof(claims, claim, Reading::repaired);
  INFO(claim.id, ": ", proof.problems.empty() ? "" : proof.problems.front());
  CHECK(proof.proved);
  const std::set<std::string> names(proof.names.begin(), proof.names.end());
  for (const char* id : {"A1.1", "A1.2", "A2.1", "A2.2", "A2.3", "A3.1", "A4.1", "A4.2"}) {
    INFO(id);
    for (const char* part : {"", ".one", ".exists"}) {  // no other mode, no other motion in it, and one
      CHECK(names.contains(std::string("A5.2.repaired.") + id + part));
    }
  }
  for (const char* cell : {"1", "2", "3", "4"}) {  // b1, b11, b0 are between them
    CHECK(names.contains(std::string("A5.2.repaired.rest.") + cell));
    CHECK(names.contains(std::string("A5.2.repaired.rest.exists.") + cell));
  }
  CHECK(names.contains("A5.2.repaired.rest.cells"));
  for (const char* pair : {"1-1", "1-2", "1-3", "1-4", "2-2", "2-3", "2-4", "3-3", "3-4", "4-4"}) {
    CHECK(names.contains(std::string("A5.2.repaired.rest.one.") + pair));
  }
  CHECK(names.contains("A5.2.repaired.defined.A1.1"));  // xi1 divides by what is not plainly positive
}

TEST_CASE("uniqueness is not proved of other claims than those whose motions it speaks of") {
  const auto proved = [](const ClaimsFile& claims) {
    return find_claim_proof(claims, *claims.find("A5.2"), Reading::repaired, true).proved;
  };
  const ClaimsFile shipped = read_claims(shipped_folder / "claims.toml");
  REQUIRE(proved(shipped));
  CHECK(!find_claim_proof(shipped, *shipped.find("A5.2"), Reading::printed).proved);
  const auto tampered = [&](auto change) {
    ClaimsFile claims = shipped;
    for (Claim& claim : claims.claims) {
      if (claim.id == "A5.2") change(*claim.repaired);
    }
    return proved(claims);
  };
  CHECK(tampered([](ClaimBody&) {}));
  CHECK(!tampered([](ClaimBody& claim) { claim.except.clear(); }));
  CHECK(!tampered([](ClaimBody& claim) { claim.claims.pop_back(); }));
  CHECK(!tampered([](ClaimBody& claim) { claim.modes.pop_back(); }));
}

TEST_CASE("where a motion is left out of those that are stated, uniqueness is not found") {
  ClaimsFile claims = read_claims(shipped_folder / "claims.toml");
  const auto stick_stick = static_cast<std::size_t>(claims.find("A1.1") - claims.claims.data());
  for (Claim& claim : claims.claims) {
    if (claim.id == "A5.2") std::erase(claim.repaired->claims, stick_stick);
  }
  prove::Limits limits;
  limits.split_depth = 1;
  limits.products = 0;
  limits.steps = 1'000'000;
  bool found = false;
  for (const NamedStatement& statement : claim_statements(claims, *claims.find("A5.2"), Reading::repaired)) {
    if (statement.name != "A5.2.repaired.rest.4") continue;
    found = true;
    CHECK(!prove_statement(statement.name, statement.text, limits).proved());
  }
  CHECK(found);
}

TEST_CASE("a limit is proved from a value on, and only if that value is defined and large enough") {
  ClaimsFile claims = read_claims(shipped_folder / "claims.toml");
  const auto proved = [&](const std::string& from) {
    Claim claim = *claims.find("R3.3.1");  // as f grows, b < b11 and b < b0
    claim.printed.own.erase("from");
    if (!from.empty()) claim.printed.own["from"] = parse_expression(from, Sort::number);
    const auto statements = claim_statements(claims, claim, Reading::printed);
    return !statements.empty() && std::all_of(statements.begin(), statements.end(), [](const NamedStatement& s) {
      return prove_statement(s.name, s.text, {.split_depth = 1, .products = 0, .steps = 100'000}).proved();
    });
  };
  CHECK(proved("b/(h + R)"));
  CHECK(proved("2*b/(h + R)"));
  CHECK(!proved("b/(2*(h + R))"));      // too small
  CHECK(!proved("b/(h + R) + 1/h"));    // not defined for h = 0
  CHECK(!proved("b/(h + R - h - R)"));  // nowhere defined: all beyond it would hold
  CHECK(!proved(""));
  for (const auto& [id, reading] : {std::pair("R3.3.1", Reading::printed), std::pair("R3.3.2", Reading::repaired)}) {
    CHECK(find_claim_proof(claims, *claims.find(id), reading).proved);
  }
  CHECK(!find_claim_proof(claims, *claims.find("R3.3.2"), Reading::printed).proved);
}

TEST_CASE("what is false in print has no proof") {
  const ClaimsFile claims = read_claims(shipped_folder / "claims.toml");
  for (const char* id : {"A2.1", "A2.cover", "A3.cover", "A4.cover", "A5.1"}) {
    const Claim* claim = claims.find(id);
    REQUIRE_MESSAGE(claim != nullptr, id);
    const ClaimProof proof = find_claim_proof(claims, *claim, Reading::printed);
    CHECK(!proof.proved);
    CHECK(!proof.problems.empty());
  }
}

TEST_CASE("every claim has a proof or a refutation, as far as statements can say it") {
  for (const char* paper : {"rozenblat-yashin", "rear-drive"}) {
    const std::filesystem::path file = shipped_folder.parent_path() / paper / "claims.toml";
    const std::filesystem::path theorems = file.parent_path() / "claims.theorems";
    const ClaimsFile claims = read_claims(file);
    std::vector<NamedStatement> statements;
    for (const Claim& claim : claims.claims) {
      for (const Reading reading : all_readings) {
        if (reading == Reading::repaired && !claim.repaired) continue;
        for (NamedStatement& s : expected_statements(claims, claim, reading)) statements.push_back(std::move(s));
      }
    }
    CHECK(statements.size() > 30);
    for (const NamedStatement& statement : statements) {
      INFO(statement.name);
      CHECK(test::read_file(theorems / (statement.name + ".statement")) == statement.text);
      CHECK(test::read_file(theorems / (statement.name + ".cert")) != "");
    }
  }
}

TEST_CASE("whatever the paper's file is called, its statements are printable ASCII") {
  ClaimsFile claims = read_claims(shipped_folder / "claims.toml");
  claims.paper.source = "\xD0\x9E \xD1\x82\xD1\x80.tex\nshow false\r";
  const auto statements = claim_statements(claims, *claims.find("A2.4"), Reading::printed);
  REQUIRE(!statements.empty());
  const std::string& text = statements.front().text;
  CHECK(text.find("\n# A2.4 of ? ??.tex?show false?, printed reading\n") != std::string::npos);
  CHECK_NOTHROW(prove::Statement("s", text));
}

TEST_CASE("truth values find their words") {
  const auto text = [](const char* source) { return formula_text(formula_of(parse_expression(source, Sort::truth))); };
  CHECK(text("not 0 < x <= 1") == "0 >= x or x > 1");
  CHECK(text("x > max(y, z) and x < max(y, z)") == "x > y and x > z and {x < y or x < z}");
  CHECK(text("min(y, z) >= x or min(y, z) < x") == "{y >= x and z >= x} or {y < x or z < x}");
  CHECK(text("not (x = 1 or y != 2)") == "x != 1 and y = 2");
  CHECK(text("abs(x) > 1") == "{x >= 0 and x > 1} or {x < 0 and -x > 1}");
  CHECK(text("0.5 < x^-2") == "1 / 2 < 1 / x^2");
  CHECK(text("x^0 = 1 and (1/x)^0 = 1") == "1 = 1 and 0 * (1 / x) + 1 = 1");
  // Where an operand has no value, neither has a maximum: it is not enough that the other one is large.
  CHECK(text("max(1, 1/x) > 0") == "{1 >= 1 / x and 1 > 0} or {1 < 1 / x and 1 / x > 0}");
}

TEST_CASE("a false claim is refuted by a theorem, and a true one is not") {
  const ClaimsFile claims = read_claims(shipped_folder / "claims.toml");
  for (const char* id : {"A2.1", "A3.cover", "A5.1", "E4.1.2", "T4.7"}) {
    const auto statements = claim_refutation(claims, *claims.find(id), Reading::printed);
    REQUIRE(statements.size() == 1);
    INFO(id);
    CHECK(statements[0].name == std::string(id) + ".refuted");
    CHECK(prove_statement(id, statements[0].text).proved());
  }
  prove::Limits limits;
  limits.instances = 50;
  const auto statements = claim_refutation(claims, *claims.find("A1.1"), Reading::printed);
  REQUIRE(statements.size() == 1);
  CHECK(!prove_statement("A1.1", statements[0].text, limits).proved());
}

TEST_CASE("a claim that changes loses its proof") {
  ClaimsFile claims = read_claims(shipped_folder / "claims.toml");
  const Claim* claim = claims.find("A1.1");
  REQUIRE(find_claim_proof(claims, *claim, Reading::printed).proved);
  for (Setting& setting : claims.settings) {
    for (Definition& definition : setting.definitions) {
      if (definition.symbol == "b0") definition.printed = make_symbol("R");
    }
  }
  CHECK(!find_claim_proof(claims, *claim, Reading::printed).proved);
}

TEST_CASE("the statements' mechanics accept the motions of the mode solver, and nothing beside them") {
  const ClaimsFile claims = read_claims(shipped_folder / "claims.toml");
  struct Sample {
    const char* id;
    Rational b, F;
    ContactMode mode;
  };
  using enum WheelState;
  // f = g = R = sigma = 1, h = 1/2, M2 = M3 = J = 1: b1 = 1/8, b11 = 5/2, b0 = 7/2.
  const std::vector<Sample> samples = {{"A1.1", 4, Rational(1, 2), {stick, stick}},
                                       {"A2.2", 1, Rational(3, 5), {stick, slip_forward}},
                                       {"A3.1", 8, 2, {slip_backward, stick}},
                                       {"A4.2", 4, 2, {slip_backward, slip_forward}}};
  for (const Sample& sample : samples) {
    const Rational half(1, 2);
    Bicycle<Rational> bicycle{1, 1, half, sample.b, sample.b, half, half, 1, 1, 1, 1, Rational(1)};
    const ModeTable table(bicycle, {1, 1}, ForceKind::internal);
    const MotionsAtForce motions = motions_at(table, sample.F);
    INFO(sample.id);
    REQUIRE(motions.motions.size() == 1);
    REQUIRE(motions.motions[0].modes.size() == 1);
    REQUIRE(motions.motions[0].modes[0] == sample.mode);
    const Motion<Rational>& motion = motions.motions[0].values;
    const std::string text = claim_statements(claims, *claims.find(sample.id), Reading::repaired)[1].text;
    const std::map<std::string, Rational> numbers = {{"R", 1},  {"h", half},    {"b", sample.b}, {"M2", 1},
                                                     {"M3", 1}, {"f", 1},       {"g", 1},        {"sigma", 1},
                                                     {"J", 1},  {"F", sample.F}};
    const prove::Statement statement("sample", with_numbers(text, numbers));
    // eps1 = eps2 and T = I1 eps1 - F L, which the mode solver does not list: mu = 1, r1 = 1.
    const Rational eps2 = motion[Quantity::eps2];
    std::vector<Rational> values = {motion[Quantity::a],
                                    motion[Quantity::a_y],
                                    motion[Quantity::phi],
                                    eps2,
                                    eps2,
                                    motion[Quantity::eps3],
                                    half * eps2 - sample.F,
                                    motion[Quantity::N2],
                                    motion[Quantity::S2],
                                    motion[Quantity::N3],
                                    motion[Quantity::S3]};
    const auto texts = [&] {
      std::vector<std::string> result;
      for (const Rational& value : values) result.push_back(value.str());
      return result;
    };
    for (const auto& [name, assumption] : statement.assumptions()) CHECK(holds(assumption));
    CHECK(holds(statement.shown(texts())));
    for (Rational& value : values) {
      value += Rational(1, 1000);
      CHECK(!holds(statement.shown(texts())));
      value -= Rational(1, 1000);
    }
  }
}
