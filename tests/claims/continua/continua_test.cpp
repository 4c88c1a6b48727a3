// Bodies with continua of motions: walls, wedges, redundant contacts, no mass. Every mode that brute force finds is
// told by `solve`, in the cells over the loads, by `search` and in claims.
#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "claims/continua/brute_force.hpp"
#include "claims/judge/judge.hpp"
#include "claims/reading/read_claims_file.hpp"
#include "mechanics/family/solved_sample.hpp"
#include "mechanics/scene/solve_mechanism.hpp"
#include "mechanics/search/found_motions.hpp"
#include "report/scenes/mechanism_report.hpp"
#include "support/how_many.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

using Names = std::set<std::string>;

Names names_of(const std::vector<MechanismMode>& modes) {
  Names names;
  for (const MechanismMode& mode : modes) names.insert(name(mode));
  return names;
}

/// The values of a body's parameters, in the order of the mechanism's file.
std::vector<Rational> parameters_of(const Body& body) {
  std::vector<Rational> values{body.mass[0], body.mass[2]};
  values.insert(values.end(), body.force.begin(), body.force.end());
  values.insert(values.end(), body.load.begin(), body.load.end());
  for (const BodyContact& contact : body.contacts) {
    values.insert(values.end(), contact.gap.begin(), contact.gap.end());
    values.insert(values.end(), contact.slip.begin(), contact.slip.end());
    values.insert(values.end(), {contact.static_friction, contact.kinetic_friction});
  }
  return values;
}

/// Claims about a body on contacts at the load c, in a strict and in a closed setting.
class BodyClaims {
 public:
  explicit BodyClaims(std::size_t contacts)
      : file_(parse_claims(text(contacts), SLIPPROOF_SOURCE_DIR "/tests/claims/continua/claims.toml")),
        compiled_(file_),
        all_(modes_of(file_.settings[0].kinds())) {}

  const Mechanism& mechanism() const { return *file_.settings[0].mechanism; }
  const std::vector<MechanismMode>& all() const { return all_; }

  /// The sample of a body; its last parameter is the load that the claims are about.
  std::unique_ptr<SolvedSample> sample(const Body& body, const Rational& load, bool strict) const {
    std::vector<Rational> values = parameters_of(body);
    values.push_back(load);
    return SolvedSample::make(compiled_.settings[strict ? 0 : 1], std::move(values));
  }

  /// The outcome of `kind` about some modes. `unique` names the interval of the first.
  Outcome judged(const std::string& kind, Modes modes, bool strict, SolvedSample& sample) {
    const std::string id = (strict ? "strict." : "closed.") + kind;
    const std::size_t claim = index(id);
    ClaimBody& body =
        kind == "unique" ? file_.claims[file_.claims[claim].printed.claims[0]].printed : file_.claims[claim].printed;
    body.modes = std::move(modes);
    return judge(file_, compiled_, claim, Reading::printed, sample).outcome;
  }

 private:
  std::size_t index(const std::string& id) const {
    const auto found = std::ranges::find(file_.claims, id, &Claim::id);
    REQUIRE(found != file_.claims.end());
    return static_cast<std::size_t>(found - file_.claims.begin());
  }

  static std::string text(std::size_t contacts) {
    std::string mode = "lift", file = contacts == 2 ? "two-contacts.toml" : "three-contacts.toml";
    for (std::size_t k = 1; k < contacts; ++k) mode += "/lift";
    std::string parameters;
    const auto add = [&](const std::string& symbol) {
      parameters += symbol + " = { domain = \"true\", meaning = \"x\" }\n";
    };
    for (const char* symbol : {"m", "J", "fx", "fy", "fa", "lx", "ly", "la"}) add(symbol);
    for (std::size_t k = 1; k <= contacts; ++k) {
      for (const char* symbol : {"gx", "gy", "ga", "tx", "ty", "ta", "s", "k"}) add(symbol + std::to_string(k));
    }
    add("c");
    std::string all = "schema = \"slipproof/claims/1\"\npaper = { title = \"x\", authors = [\"x\"], source = \"x\" }\n";
    for (const std::string setting : {"strict", "closed"}) {
      all += "[[setting]]\nid = \"" + setting + "\"\nmechanism = \"" + file + "\"\nmotions = \"" + setting +
             "\"\n[setting.parameters]\n" + parameters;
    }
    for (const std::string setting : {"strict", "closed"}) {
      const auto claim = [&](const std::string& kind, const std::string& says) {
        all += "[[claim]]\nid = \"" + setting + "." + kind + "\"\nsetting = \"" + setting +
               "\"\nline = 1\nstatement = \"x\"\nforces = \"F = c\"\nkind = \"" + kind + "\"\n" + says + "\n";
      };
      claim("motions", "modes = [\"" + mode + "\"]");
      claim("exists", "modes = [\"" + mode + "\"]");
      claim("impossible", "modes = [\"" + mode + "\"]");
      claim("interval", "mode = \"" + mode + "\"");
      claim("unique", "claims = [\"" + setting + ".interval\"]");
    }
    return all;
  }

  ClaimsFile file_;
  const CompiledClaims compiled_;
  const std::vector<MechanismMode> all_;
};

/// What was met, so that a test knows that it tested something.
struct Counts {
  int continua = 0, inside = 0, strict_inside = 0, several = 0, right = 0, right_beside_continuum = 0;
};

void check_solve(const MotionsAtLoad& found, const BruteMotions& there, Counts& counts) {
  CHECK(found.motions.size() == there.motions.size());
  for (const MotionAtLoad& motion : found.motions) {
    const auto same = there.motions.find(Accelerations(motion.accelerations.begin(), motion.accelerations.begin() + 3));
    REQUIRE(same != there.motions.end());
    CHECK(names_of(motion.modes) == same->second.modes);
    CHECK(names_of(motion.boundary_modes) == same->second.boundary_modes);
    CHECK(names_of(motion.continua) == same->second.continua);
    counts.inside += motion.continua.empty() ? 0 : 1;
    counts.strict_inside += motion.strict() && !motion.continua.empty() ? 1 : 0;
  }
  CHECK(found.continua.size() == there.continua.size());
  for (const ContinuumAtLoad& continuum : found.continua) {
    const auto same = there.continua.find(name(continuum.mode));
    REQUIRE(same != there.continua.end());
    CHECK(continuum.strict == same->second);
  }
  const Names consistent = there.consistent(false);
  CHECK(found.rejected.size() + consistent.size() == there.modes);
  for (const RejectedMode& rejected : found.rejected) CHECK(consistent.count(name(rejected.mode)) == 0);
  counts.several += there.motions.size() > 1 ? 1 : 0;
  counts.continua += there.continua.empty() ? 0 : 1;
}

void check_cell(const LoadCell& cell, const Rational& load, const BruteMotions& there) {
  CHECK(cell.motions.size() == there.motions.size());
  for (const MotionOverLoads& motion : cell.motions) {
    Accelerations at;
    for (std::size_t i = 0; i < 3; ++i) at.push_back(motion.accelerations[i].at(load));
    const auto same = there.motions.find(at);
    REQUIRE(same != there.motions.end());
    CHECK(names_of(motion.modes) == same->second.modes);
    CHECK(names_of(motion.boundary_modes) == same->second.boundary_modes);
    CHECK(names_of(motion.continua) == same->second.continua);
  }
  Names continua;
  for (const auto& [mode, strict] : there.continua) continua.insert(mode);
  CHECK(names_of(cell.continua) == continua);
}

void check_search(const FrictionProblem& problem, const Rational& load, const BruteMotions& there) {
  for (const FoundOverLoads& found : found_over_loads(problem, {}, false)) {
    if (!found.loads.contains(load)) continue;
    Names strict;
    for (const auto& motion : found.found.modes) strict.merge(names_of(motion));
    for (const MechanismMode& mode : found.found.continua) strict.insert(name(mode));
    Names expected = there.consistent(true);
    for (const auto& [mode, is_strict] : there.continua) expected.insert(mode);
    CHECK(strict == expected);
    CHECK(found.found.motions() == there.motions.size());
  }
}

/// Each kind of claim about modes, where it is right and where it is wrong.
void check_claims(BodyClaims& claims, const Body& body, const Rational& load, const BruteMotions& there, bool strict,
                  Counts& counts) {
  const auto sample = claims.sample(body, load, strict);
  REQUIRE(sample);
  const auto outcome = [&](const char* kind, Modes modes) {
    return claims.judged(kind, std::move(modes), strict, *sample);
  };
  const Names having = there.consistent(strict);
  for (const MechanismMode& mode : claims.all()) {
    const bool has = having.count(name(mode)) > 0;
    CHECK((outcome("exists", {mode}) == Outcome::holds) == has);
    CHECK(outcome("impossible", {mode}) == (has ? Outcome::refuted : Outcome::holds));
  }
  const auto mode_named = [&](const std::string& wanted) {
    return *std::ranges::find_if(claims.all(), [&](const MechanismMode& mode) { return name(mode) == wanted; });
  };
  // One mode of each motion that counts, and whether a continuum counts.
  Modes one_of_each;
  for (const auto& [accelerations, motion] : there.motions) {
    const Names& modes = !strict && motion.modes.empty() ? motion.boundary_modes : motion.modes;
    if (!modes.empty()) one_of_each.push_back(mode_named(*modes.rbegin()));
  }
  const bool continuum = std::ranges::any_of(there.continua, [&](const auto& mode) { return mode.second || !strict; });
  const bool right = !continuum && !one_of_each.empty();
  if (!one_of_each.empty()) CHECK(outcome("motions", one_of_each) == (right ? Outcome::holds : Outcome::refuted));
  counts.right += right ? 1 : 0;
  counts.right_beside_continuum += right && !there.continua.empty() ? 1 : 0;
  for (const MechanismMode& mode : claims.all()) {
    if (having.count(name(mode)) > 0) continue;
    Modes with_another = one_of_each;
    with_another.push_back(mode);
    CHECK(outcome("motions", with_another) == Outcome::refuted);
    break;
  }
  if (one_of_each.size() > 1) {
    one_of_each.pop_back();
    CHECK(outcome("motions", one_of_each) == Outcome::refuted);
  }
  // Uniqueness counts boundary motions and continua in any setting.
  const bool one = there.motions.size() == 1 && there.continua.empty();
  const MechanismMode its = there.motions.empty() ? claims.all().front() : [&] {
    const auto& motion = there.motions.begin()->second;
    return mode_named(*(motion.modes.empty() ? motion.boundary_modes : motion.modes).begin());
  }();
  CHECK(outcome("unique", {its}) == (one ? Outcome::holds : Outcome::refuted));
}

/// A body's scene at a load.
MechanismScene scene_of(const Mechanism& mechanism, const Body& body, const Rational& load) {
  MechanismScene scene;
  scene.mechanism = mechanism;
  scene.values = default_values(mechanism);
  scene.values.parameters = parameters_of(body);
  scene.values.given.assign(scene.values.parameters.size(), true);
  scene.load = load;
  return scene;
}

/// The document of `solve` has each mode once: with a motion, as a continuum, or rejected.
void check_document(const Mechanism& mechanism, const Body& body, const Rational& load, const BruteMotions& there) {
  const SolvedMechanism solved = solve_mechanism(scene_of(mechanism, body, load));
  const std::string json = solve_json(solved, std::nullopt), text = text_of(solve_document(solved, std::nullopt, 6));
  std::size_t strict = 0;
  for (const auto& [accelerations, motion] : there.motions) strict += motion.modes.empty() ? 0 : 1;
  CHECK(text.find("s SOLVED motions " + std::to_string(there.motions.size()) + " strict " + std::to_string(strict) +
                  " continua " + std::to_string(there.continua.size()) + " rejected " +
                  std::to_string(there.modes - there.consistent(false).size()) + "\n") != std::string::npos);
  CHECK((text.find("0 motions") != std::string::npos) == (there.motions.empty() && there.continua.empty()));
  for (const std::string& mode : there.consistent(false)) CHECK(json.find('"' + mode + '"') != std::string::npos);
  CHECK(json.find("\"complete\": true") != std::string::npos);
}

void compare(BodyClaims& claims, const Body& body, const Rational& load, bool all, Counts& counts) {
  const BruteMotions there = brute_force(body, load);
  const auto sample = claims.sample(body, load, true);
  REQUIRE(sample);
  const FrictionProblem problem = without_equations(sample->problem());
  check_solve(motions_of(problem, load), there, counts);
  const std::vector<LoadCell> cells = motions_over_loads(problem)->cells();
  const auto here = std::ranges::find_if(cells, [&](const LoadCell& cell) { return cell.loads.contains(load); });
  REQUIRE(here != cells.end());
  check_cell(*here, load, there);
  for (const bool strict : {true, false}) check_claims(claims, body, load, there, strict, counts);
  if (!all) return;
  for (const LoadCell& cell : cells) {
    const Rational other = cell.loads.sample();
    check_cell(cell, other, brute_force(body, other));
  }
  check_search(problem, load, there);
  check_document(claims.mechanism(), body, load, there);
}

}  // namespace

TEST_CASE("every mode of a body with continua is told by solve, in cells, by search and in claims") {
  const int bodies = how_many("SLIPPROOF_BODIES_WITH_CONTINUA", 300);
  RandomBodies random(61);
  BodyClaims two(2), three(3);
  Counts counts;
  for (int i = 0; i < bodies; ++i) {
    CAPTURE(i);
    const bool larger = i % 10 == 9;
    const Body body = random.body(larger ? 3 : 2);
    compare(larger ? three : two, body, random.integer(-3, 3), i % 5 == 0, counts);
  }
  CHECK(counts.continua > bodies / 10);
  CHECK(counts.inside > bodies / 10);
  CHECK(counts.strict_inside > bodies / 20);
  CHECK(counts.several > bodies / 10);
  CHECK(counts.right > bodies / 10);
  CHECK(counts.right_beside_continuum > bodies / 300);
  MESSAGE(bodies << " bodies, " << counts.continua << " with continua, " << counts.inside << " motions in them, "
                 << counts.strict_inside << " of these strict");
}

TEST_CASE("a body held between two walls: each of its 16 modes gets an answer, and stick/stick is strict") {
  // Walls on both sides, gravity down along y, mu = 1/2.
  Body body;
  body.mass = {1, 1, 1};
  body.force = {0, -1, 0};
  const BodyContact left{{1, 0, 0}, {0, 1, 0}, Rational(1, 2), Rational(1, 2)},
      right{{-1, 0, 0}, {0, 1, 0}, Rational(1, 2), Rational(1, 2)};
  body.contacts = {left, right};
  BodyClaims claims(2);
  Counts counts;
  compare(claims, body, 0, true, counts);
  const MotionsAtLoad found = motions_of(claims.sample(body, 0, true)->problem(), Rational(0));
  REQUIRE(found.motions.size() == 2);
  REQUIRE(found.continua.size() == 1);
  CHECK(name(found.continua[0].mode) == "slip-/slip-");
  const auto rests =
      std::ranges::find_if(found.motions, [](const auto& motion) { return motion.accelerations[1] == 0; });
  REQUIRE(rests != found.motions.end());
  CHECK(names_of(rests->modes) == Names{"stick/stick"});
  CHECK(rests->continua.size() == 1);
  CHECK(found.rejected.size() + 1 + found.motions[0].all_modes().size() + found.motions[1].all_modes().size() == 16);
}
