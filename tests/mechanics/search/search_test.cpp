#include "mechanics/search/search.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>

#include "base/input/diagnostic.hpp"
#include "mechanics/impact/impact.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/shipped.hpp"
#include "mechanics/scene/narrow.hpp"
#include "mechanics/search/points.hpp"
#include "support/replaced.hpp"

using namespace slipproof;

namespace {

SearchResult searched(const Mechanism& mechanism, std::uint64_t samples, unsigned threads = 0) {
  SearchOptions options;
  options.samples = samples;
  options.threads = threads;
  return search_motions(mechanism, options);
}

Mechanism within(const std::string& name, const std::string& condition) {
  return narrowed(open_mechanism(name), condition, "within");
}

/// A point mass on a belt or floor.
std::string mass(const std::string& friction, const std::string& more = "") {
  return "schema = \"slipproof/mechanism/1\"\nname = \"mass\"\n[parameters]\nm = \"m > 0\"\nmu = \"mu >= 0\"\n"
         "nu = \"nu >= mu\"\ng = \"g > 0\"\n" +
         more +
         "[load]\nsymbol = \"F\"\n[unknowns]\naccelerations = [\"ax\", \"ay\"]\n"
         "[motion]\nax = \"m*ax = F\"\nay = \"m*ay = -m*g\"\n"
         "[[contact]]\nname = \"floor\"\ngap = \"ay\"\nslip = \"ax\"\nfriction = " +
         friction + "\n";
}

/// The motions at a place, from the kernel for one load.
FoundMotions at_one_load(const Mechanism& mechanism, const SearchPlace& place) {
  const MotionsAtLoad at = motions_of(friction_problem(mechanism, place.values), place.load);
  FoundMotions found;
  for (MotionAtLoad motion : at.motions) {
    std::sort(motion.modes.begin(), motion.modes.end());
    if (motion.strict()) found.modes.push_back(motion.modes);
    if (!motion.strict()) ++found.on_boundary;
  }
  for (const ContinuumAtLoad& continuum : at.continua) found.continua.push_back(continuum.mode);
  std::sort(found.modes.begin(), found.modes.end());
  std::sort(found.continua.begin(), found.continua.end());
  return found;
}

void check_place(const Mechanism& mechanism, const SearchCell& cell, const SearchPlace& place) {
  const FoundMotions there = at_one_load(mechanism, place);
  CHECK(there.modes == cell.found.modes);
  CHECK(there.on_boundary == cell.found.on_boundary);
  CHECK(there.continua == cell.found.continua);
  const ProblemMaker maker(mechanism);
  CHECK(maker.broken(place.values).empty());
  if (place.load) CHECK(maker.load_domain(place.values).contains(*place.load));
}

/// What a rod's impact by Newton's law adds to its energy: the impulse times the mean velocity of the foot. The foot
/// sticks if its impulse is in the cone, and slides on or back if not.
Rational gain_of_rod(const MechanismValues& values) {
  const auto& p = values.parameters;
  const Rational m = p[0], v = p[2], a = p[3], e = p[5], mu = p[6];
  const Rational c = values.angles[0].cosine, s = values.angles[0].sine;
  const Rational nn = (1 + 3 * c * c) / m, nt = -3 * s * c / m, tt = (1 + 3 * s * s) / m, up = (1 + e) * v;
  Rational N = (tt * up + nt * a) / (nn * tt - nt * nt), S = (-nt * up - nn * a) / (nn * tt - nt * nt), sliding = 0;
  const bool sticks = abs(S) <= mu * N;
  for (const int direction : {-1, 1}) {
    const Rational carries = nn - direction * mu * nt;
    if (sticks || carries <= 0) continue;
    const Rational normal = up / carries, friction = -direction * mu * normal;
    const Rational after = a + nt * normal + tt * friction;
    if (after * direction >= 0) N = normal, S = friction, sliding = after;
  }
  return (N * (e * v - v) + S * (a + sliding)) / 2;
}

}  // namespace

TEST_CASE("the slender rod has several motions, or none, above 4/3 and not below") {
  const Mechanism below = within("painleve-rod", "3*I = m*l^2 and mu <= 4/3");
  const SearchResult calm = searched(below, 1'500);
  CHECK(calm.samples > 1'000);
  CHECK(calm.one_everywhere == calm.samples);
  const Mechanism above = within("painleve-rod", "3*I = m*l^2 and 4/3 < mu < 3/2");
  const SearchResult wild = searched(above, 1'500);
  CHECK(wild.count(MotionCount::none) > 0);
  CHECK(wild.count(MotionCount::several) > 0);
  CHECK(wild.one_everywhere < wild.samples);
}

TEST_CASE("the rod's motions at every place are those of its closed form") {
  const Mechanism rod = open_mechanism("painleve-rod");
  const SearchResult result = searched(rod, 600);
  for (const SearchCell& cell : result.cells) {
    const auto& v = cell.simplest.values.parameters;
    const Rational m = v[0], l = v[1], I = v[2], mu = v[3], w = v[4], g = v[5];
    const Rational c = cell.simplest.values.angles[0].cosine, s = cell.simplest.values.angles[0].sine;
    // gap = p N - q: in slip the gap is closed, open N is 0.
    const Rational p = 1 / m + l * l * c * (c - mu * s) / I, q = g - l * s * w * w;
    switch (cell.found.count) {
      case MotionCount::none:
        CHECK(p <= 0);
        CHECK(q > 0);
        break;
      case MotionCount::several:
        CHECK(p < 0);
        CHECK(q < 0);
        break;
      case MotionCount::continuum:
        CHECK(p == 0);
        CHECK(q == 0);
        break;
      default:
        CHECK((p > 0 || q == 0 || p == 0));
    }
  }
}

TEST_CASE("a block on a shaken floor always has one motion, in the modes that the ratio of its sides allows") {
  const SearchResult tall = searched(within("block-shaken", "mu*h > b"), 200);
  const SearchResult wide = searched(within("block-shaken", "mu*h < b"), 200);
  for (const SearchResult* result : {&tall, &wide}) {
    CHECK(result->samples > 100);
    CHECK(result->one_everywhere == result->samples);
  }
  const auto modes = [](const SearchResult& result) {
    std::set<std::string> names;
    for (const SearchCell& cell : result.cells) {
      for (const auto& motion : cell.found.modes) names.insert(name(motion.front()));
    }
    return names;
  };
  CHECK(modes(tall).contains("stick/lift"));
  CHECK_FALSE(modes(tall).contains("slip-/slip-"));
  CHECK(modes(wide).contains("slip-/slip-"));
  CHECK_FALSE(modes(wide).contains("stick/lift"));
}

TEST_CASE("loads at which a motion changes its mode are one motion on a boundary, not none") {
  const SearchResult result = searched(parse_mechanism(mass("\"mu\""), "x.toml"), 100);
  CHECK(result.one_everywhere == result.samples);
  const auto boundary = std::find_if(result.cells.begin(), result.cells.end(),
                                     [](const SearchCell& cell) { return cell.found.on_boundary == 1; });
  REQUIRE(boundary != result.cells.end());
  CHECK(boundary->found.count == MotionCount::one);
  CHECK(boundary->found.motions() == 1);
  CHECK(boundary->samples == result.samples);
}

TEST_CASE("hysteresis is left out, or asked for") {
  const Mechanism m = parse_mechanism(mass("{ static = \"nu\", kinetic = \"mu\" }"), "x.toml");
  const SearchResult without = searched(m, 200);
  CHECK(without.one_everywhere == without.samples);
  CHECK(without.count(MotionCount::hysteresis) > 20);
  CHECK(without.count(MotionCount::several) == 0);
  SearchOptions options;
  options.samples = 200;
  options.hysteresis = true;
  const SearchResult with = search_motions(m, options);
  CHECK(with.count(MotionCount::hysteresis) == 0);
  CHECK(with.count(MotionCount::several) == without.count(MotionCount::hysteresis));
  CHECK(with.one_everywhere == with.samples - with.count(MotionCount::several));
}

TEST_CASE("a continuum is found where an equation of the domain makes one") {
  const std::string text = test::replaced(mass("\"mu\"", "k = \"k >= 0\"\n"), "m*ax = F", "k*ax = 0");
  const Mechanism m = parse_mechanism(text, "x.toml");
  const SearchResult result = searched(m, 100);
  CHECK(result.count(MotionCount::continuum) > 0);
  for (const SearchCell& cell : result.cells) {
    if (cell.found.count != MotionCount::continuum) continue;
    CHECK(cell.simplest.values.parameters[4] == 0);
    CHECK(cell.simplest.values.parameters[1] == 0);
  }
}

TEST_CASE("at every place that is told are the motions that are told, and what could be built could be") {
  for (const ShippedMechanism& shipped : shipped_mechanisms()) {
    CAPTURE(std::string(shipped.name));
    const Mechanism mechanism = open_mechanism(std::string(shipped.name));
    const bool many_modes = mode_count(element_kinds(mechanism)) > 16;
    const SearchResult result = searched(mechanism, many_modes ? 3 : 15);
    CHECK(result.samples > 0);
    const ProblemMaker maker(mechanism);
    for (const SearchCell& cell : result.cells) {
      check_place(mechanism, cell, cell.simplest);
      if (!cell.realisable) continue;
      check_place(mechanism, cell, *cell.realisable);
      auto at = maker.at(cell.realisable->values);
      for (const Program& condition : maker.compiled().realisable) CHECK(at.truth(condition) == Truth::yes);
    }
  }
}

TEST_CASE("what is looked for alone ends the search at the first") {
  const Mechanism rod = open_mechanism("painleve-rod");
  SearchOptions options;
  options.wanted = SearchFor::none;
  options.threads = 1;
  const SearchResult result = search_motions(rod, options);
  REQUIRE(result.cells.size() == 1);
  CHECK(result.cells[0].found.count == MotionCount::none);
  CHECK(result.cells[0].samples == 1);
  CHECK(result.tried < 500);
  options.samples = result.tried - 1;
  CHECK(search_motions(rod, options).cells.empty());
  options.samples = result.tried;
  options.threads = 2;
  CHECK(search_motions(rod, options).cells.size() == 1);
}

TEST_CASE("without J a bicycle's wheels do not open, which is told apart from no motion") {
  const SearchResult result = searched(open_mechanism("bicycle"), 60);
  CHECK(result.count(MotionCount::none_modelled) > 0);
  for (const SearchCell& cell : result.cells) {
    CHECK((cell.found.not_modelled.size() == 2) == !cell.simplest.values.given[11]);
    if (cell.found.count == MotionCount::none) CHECK(cell.found.not_modelled.empty());
    if (cell.found.count == MotionCount::none_modelled) CHECK(cell.found.not_modelled.size() == 2);
  }
}

TEST_CASE("an impact is searched for gains of energy, which are those of a rod's closed form") {
  const Mechanism rod = with_approach(read_mechanism(SLIPPROOF_SOURCE_DIR "/proofs/impacts/rod.toml"));
  const SearchResult result = searched(rod, 300);
  REQUIRE(result.samples == 300);
  const ProblemMaker maker(rod);
  const PointSampler points(rod, maker, 1);
  std::uint64_t gains = 0;
  for (std::uint64_t i = 0; i < 300; ++i) gains += gain_of_rod(*points.at(i)) > 0;
  CHECK(gains > 10);
  CHECK(result.count(EnergyBalance::gained) == gains);
  CHECK(result.count(EnergyBalance::not_gained) == 300 - gains);
  for (const SearchCell& cell : result.cells) {
    CHECK((cell.found.energy == EnergyBalance::gained) == (gain_of_rod(cell.simplest.values) > 0));
  }
  SearchOptions options;
  options.wanted = SearchFor::gain;
  const SearchResult first = search_motions(rod, options);
  REQUIRE(first.cells.size() == 1);
  CHECK(gain_of_rod(first.cells[0].simplest.values) > 0);
  CHECK_THROWS_AS(search_motions(open_mechanism("painleve-rod"), options), InputError);
}

TEST_CASE("a condition narrows parameters, angles and the load") {
  const Mechanism m = within("ladder", "mu_f = 2*mu_w and c < s and 1 <= W < 3 and l > 1");
  const SearchResult result = searched(m, 60);
  CHECK(result.samples > 50);
  for (const SearchCell& cell : result.cells) {
    const auto& v = cell.simplest.values;
    CHECK(v.parameters[4] == Rational(2 * v.parameters[5]));
    CHECK(v.parameters[1] > 1);
    CHECK(v.angles[0].cosine < v.angles[0].sine);
    CHECK(*cell.simplest.load >= 1);
    CHECK(*cell.simplest.load < 3);
  }
}

TEST_CASE("narrow domains are sampled inside, whatever bounds them") {
  const std::vector<std::pair<std::string, std::string>> narrow{
      {"painleve-rod", "mu > 4/3 and mu < 1.3334"},          // no small fraction
      {"painleve-rod", "2 < mu^2 < 2.00001"},                // irrational bounds
      {"painleve-rod", "1 < 1/(mu - 3) < 1 + 1/10^6"},       // a quotient
      {"painleve-rod", "0.9999 < c < 1 and l < 1/10^9"},     // an angle
      {"ladder", "mu_f < mu_w and mu_w < 1/10^7"},           // the first is bounded by the second
      {"ladder", "10^7 < m*l < 10^7 + 1/100 and c = 3/5"}};  // a product
  for (const auto& [name, condition] : narrow) {
    CAPTURE(condition);
    const Mechanism m = within(name, condition);
    const SearchResult result = searched(m, 20);
    CHECK(result.samples == 20);
    const ProblemMaker maker(m);
    const PointSampler points(m, maker, 1);
    std::set<std::vector<Rational>> different;
    for (std::uint64_t i = 0; i < 20; ++i) {
      const auto values = points.at(i);
      REQUIRE(values);
      CHECK(maker.broken(*values).empty());
      different.insert(values->parameters);
    }
    CHECK(different.size() > 10);
  }
}

TEST_CASE("a condition that is none is refused with its column") {
  const Mechanism m = open_mechanism("ladder");
  const auto message = [&](const std::string& condition) -> std::string {
    try {
      narrowed(m, condition, "--within");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(message("mu_f < 1 and muw > 0") == "--within:1:14: condition: unknown symbol 'muw', did you mean 'mu_w'?");
  CHECK(message("mu_f + 1").starts_with("--within:1:"));
  CHECK(message("mu_f <").starts_with("--within:1:7: "));
  CHECK(message("").starts_with("--within:1:1: "));
  CHECK(message("ax > 0").find("found the acceleration ax, expected parameters, angles and definitions") !=
        std::string::npos);
  CHECK(message("W != 0").find("expected an interval of the load W") != std::string::npos);
  CHECK(message("W > nothing").find("unknown symbol 'nothing'") != std::string::npos);
  CHECK(message("c < s and W*d < 2").empty());
}

TEST_CASE("an empty domain has no samples, and too many modes to try have their motions by kinematics") {
  CHECK(searched(within("ladder", "mu_f < mu_w and mu_w < mu_f"), 10).samples == 0);
  std::string text = mass("\"mu\"");
  for (int i = 0; i < 8; ++i) {
    text += "[[contact]]\nname = \"c" + std::to_string(i) + "\"\ngap = \"ay\"\nslip = \"ax\"\nfriction = \"mu\"\n";
  }
  const SearchResult found = searched(parse_mechanism(text, "x.toml"), 5);
  CHECK(found.samples == 5);
  CHECK(found.one_everywhere == 5);
}
