// The filter against the exact solver on many scenes: filter_soak RANDOM ADVERSARIAL [FIRST_CHUNK]. Each chunk has its
// own seed, which is its number, so that a run can go on where another stopped. Exit 1 at the first difference.
#include <cstdio>
#include <cstdlib>

#include "support/filter_scenes.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

constexpr std::size_t forces = 250, bicycles = 400;  // a chunk: 100,000 scenes

/// The tame populations come oftener: extremes cost more and are undecided anyway.
Population population(std::uint64_t i, bool adversarial) {
  constexpr std::array<Population, 5> tame{Population::bicycles, Population::wide, Population::bicycles,
                                           Population::wide, Population::fractions};
  return adversarial ? static_cast<Population>(i % population_count) : tame[i % tame.size()];
}

}  // namespace

int main(int argc, char** argv) {
  const double wanted[2] = {argc > 1 ? std::atof(argv[1]) : 1e5, argc > 2 ? std::atof(argv[2]) : 1e5};
  std::uint64_t chunk = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  Comparison found[2];
  while (true) {
    const bool adversarial =
        static_cast<double>(found[1].scenes) * wanted[0] < static_cast<double>(found[0].scenes) * wanted[1];
    Comparison& c = found[adversarial ? 1 : 0];
    if (static_cast<double>(c.scenes) >= wanted[adversarial ? 1 : 0]) break;
    FilterScenes random(chunk);
    for (std::size_t i = 0; i < bicycles; ++i) compare(random, population(i, adversarial), forces, adversarial, c);
    if (c.differences != 0) {
      std::printf("%llu differences in chunk %llu (%s)\n", static_cast<unsigned long long>(c.differences),
                  static_cast<unsigned long long>(chunk), adversarial ? "adversarial" : "random");
      return 1;
    }
    ++chunk;
    if (chunk % 50 == 0) {
      for (const auto& x : found)
        std::printf("%.3g scenes, %.3g undecided, %.3g twice; ", double(x.scenes), double(x.undecided),
                    double(x.undecided_twice));
      std::printf("next chunk %llu\n", static_cast<unsigned long long>(chunk));
      std::fflush(stdout);
    }
  }
  for (const auto& x : found) {
    std::printf("%s: %llu scenes, 0 differences, undecided by binary64 %llu, by double-double %llu\n",
                &x == found ? "random" : "adversarial", static_cast<unsigned long long>(x.scenes),
                static_cast<unsigned long long>(x.undecided), static_cast<unsigned long long>(x.undecided_twice));
  }
  return 0;
}
