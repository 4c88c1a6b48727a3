#include "report/uniqueness/search_report.hpp"

#include <doctest/doctest.h>

#include <string>

#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/shipped.hpp"
#include "mechanics/scene/narrow.hpp"
#include "support/crew_ranks.hpp"

using namespace slipproof;

TEST_CASE("the same bytes at any number of threads and ranks, and other samples for another seed") {
  const std::string impact = SLIPPROOF_SOURCE_DIR "/proofs/impacts/rod.toml";
  std::string name;
  SUBCASE("motions") {
    name = "ladder";
  }
  SUBCASE("impacts") {
    name = impact;
  }
  const Mechanism mechanism = open_mechanism(name);
  const auto json = [&](unsigned threads, std::uint64_t seed) {
    SearchOptions options;
    options.samples = 150;
    options.threads = threads;
    options.seed = seed;
    return search_json({mechanism, options, "", search_motions(mechanism, options)});
  };
  const std::string one = json(1, 1);
  CHECK(json(2, 1) == one);
  SearchOptions options;
  options.samples = 150;
  MotionSearch search(mechanism, options);
  test::by_crew(
      3, [&](std::string_view request) { return search.answer(request); },
      [&](Crew& crew) {
        CHECK(search_json({mechanism, options, "", search.result(&crew)}) == one);
      });
  CHECK(json(1, 2) != one);
}

TEST_CASE("an empty domain is undecided") {
  const Mechanism ladder = narrowed(open_mechanism("ladder"), "mu_f < mu_w and mu_w < mu_f", "within");
  SearchOptions options;
  options.samples = 10;
  CHECK(verdict({ladder, options, "", search_motions(ladder, options)}) == SearchVerdict::undecided);
}

TEST_CASE("of an impact that a prescribed body drives energy is not judged") {
  const std::string wall =
      "schema = \"slipproof/mechanism/1\"\nname = \"wall\"\ngravity = \"none\"\n[impact]\nlaw = \"moreau\"\n"
      "[[body]]\nname = \"wall\"\nvelocity = [\"2\", \"0\"]\nacceleration = [\"0\", \"0\"]\n"
      "[[body]]\nname = \"ball\"\nmass = \"1\"\nturning = \"0\"\nat = [\"1\", \"0\"]\n"
      "[[contact]]\nname = \"face\"\nof = \"ball\"\npoint = [\"-1\", \"0\"]\non = \"wall\"\n"
      "normal = [\"1\", \"0\"]\nrestitution = \"1/2\"\n";
  const Mechanism mechanism = parse_mechanism(wall, "wall.toml");
  SearchOptions options;
  options.samples = 3;
  const SearchResult result = search_motions(mechanism, options);
  CHECK(result.count(EnergyBalance::not_judged) == 3);
  CHECK(verdict({mechanism, options, "", result}) == SearchVerdict::none_found);
}
