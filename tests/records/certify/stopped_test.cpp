// Searches and certification that take long end when they are asked to. Each of these would go on for minutes.
#include "support/stopped.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "floating/batch/bicycle_batch.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/search/search.hpp"
#include "records/certify/certify.hpp"

using namespace slipproof;
using test::is_stopped;

namespace {

const std::filesystem::path source = SLIPPROOF_SOURCE_DIR;

/// A CSV without end.
ByteSource endless_records() {
  const std::string header = "R,h,b2,b3,I1,I2,I3,r1,r2,L,M,J,f,g,F,a,S2,S3,N2,N3\n";
  const std::string record = "0.34,1,0.5,0.5,0.01,0.1,0.1,0.1,0.05,0.17,85,12,0.8,9.81,100,1,1,1,400,430\n";
  return [=, at_head = true](char* to, std::size_t size) mutable -> std::size_t {
    const std::string& text = at_head ? header : record;
    at_head = false;
    REQUIRE(size >= text.size());
    std::copy(text.begin(), text.end(), to);
    return text.size();
  };
}

}  // namespace

TEST_CASE("searching a mechanism ends when it is asked to") {
  const Mechanism mechanism = read_mechanism(source / "cases/mechanisms/three-axles.toml");
  SearchOptions options;
  options.samples = 100'000'000;
  CHECK(is_stopped([&] { search_motions(mechanism, options); }));
}

TEST_CASE("certifying and deciding modes end when they are asked to") {
  for (const unsigned threads : {1U, 0U}) {
    CertifyOptions options;
    options.threads = threads;
    CHECK(is_stopped([&] {
      certify(
          endless_records(), [](std::string_view) {}, options);
    }));
    const std::vector<double> forces(100'000, 300);
    BicycleColumns bicycles{.numbers = {85, 0.34, 1, 0.5, 0.5, 0.01, 0.1, 0.1, 0.1, 0.05, 0.17, 12, 0.8, 9.81},
                            .F = forces};
    CHECK(is_stopped([&] {
      for (;;) consistent_modes(bicycles, threads);
    }));
  }
}
