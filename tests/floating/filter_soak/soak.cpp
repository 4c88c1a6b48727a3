// The filter against the exact solver on many scenes, one by one and in batches; and how often typical scenes need more
// than its first tier.
//   filter_soak RANDOM ADVERSARIAL [FIRST_CHUNK]
//   filter_soak typical SCENES
//   filter_soak registers SCENES    batches in each kind of registers that there is, against scenes one by one
// Each chunk has its own seed, which is its number, so that a run can go on where another stopped. Exit 1 at the first
// difference.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "support/filter_scenes.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

using Count = unsigned long long;

/// The tame populations come oftener: extremes cost more and are undecided anyway.
Population population(std::uint64_t i, bool adversarial) {
  constexpr std::array<Population, 5> tame{Population::bicycles, Population::wide, Population::bicycles,
                                           Population::wide, Population::fractions};
  return adversarial ? static_cast<Population>(i % population_count) : tame[i % tame.size()];
}

/// 100,000 scenes of few bicycles, or as many bicycles as that costs with a force or two each.
void run_chunk(std::uint64_t chunk, bool adversarial, Comparison& found) {
  FilterScenes random(chunk);
  BatchComparison batch;
  const bool few = chunk % 2 == 0;
  const std::size_t bicycles = few ? 400 : 2000, forces = few ? 250 : 1 + chunk / 2 % 2;
  for (std::size_t i = 0; i < bicycles; ++i) {
    compare(random, population(i, adversarial), forces, adversarial, found, batch);
  }
  batch.run(chunk % 3 == 0 ? 2 : 1, found);
}

void print(const char* name, const Comparison& x) {
  std::printf(
      "%s: %llu scenes of %llu bicycles, %llu of them in batches, %llu differences, undecided by binary64 %llu, "
      "by double-double %llu\n",
      name, Count{x.scenes}, Count{x.bicycles}, Count{x.in_batches}, Count{x.differences}, Count{x.undecided},
      Count{x.undecided_twice});
}

using Groups = std::array<SceneColumns, 4>;

SceneColumns& group_of(Groups& groups, const ForcedScene<double>& s) {
  return groups[(s.bicycle.J ? 2U : 0U) + (s.force_kind == ForceKind::external ? 1U : 0U)];
}

/// Every scene another bicycle, on another road, at another force.
void count_tiers(double wanted) {
  FilterScenes random(7);
  TierCounts counts{};
  for (double done = 0; done < wanted;) {
    Groups groups;
    for (int i = 0; i < 100000; ++i) {
      const ForcedScene<double> s = random.typical();
      group_of(groups, s).add(s);
    }
    for (const SceneColumns& group : groups) {
      std::vector<ConsistentModes> answers(group.size());
      consistent_modes(group.scenes(), answers, counts);
      done += static_cast<double>(answers.size());
    }
  }
  for (std::size_t i = 0; i < tier_count; ++i) {
    std::printf("%s %llu\n", std::string(name(static_cast<Tier>(i))).c_str(), Count{counts[i]});
  }
}

/// 99 typical scenes to one over six decades. False at a difference.
bool compare_registers(double wanted) {
  FilterScenes random(8);
  std::array<Count, 3> compared{};
  for (double done = 0; done < wanted; done += 100000) {
    Groups groups;
    std::array<std::vector<ConsistentModes>, 4> answers;
    for (int i = 0; i < 100000; ++i) {
      ForcedScene<double> s = random.typical();
      if (i % 100 == 0) s = nearest_binary64(random.scene(Population::wide));
      SceneColumns& group = group_of(groups, s);
      group.add(s);
      answers[static_cast<std::size_t>(&group - groups.data())].push_back(consistent_modes(s));
    }
    for (const Registers registers : {Registers::two, Registers::four, Registers::eight}) {
      if (!available(registers)) continue;
      for (std::size_t g = 0; g < groups.size(); ++g) {
        std::vector<ConsistentModes> found(groups[g].size());
        TierCounts counts{};
        consistent_modes(groups[g].scenes(), found, counts, 1, registers);
        if (found != answers[g]) return false;
        compared[static_cast<std::size_t>(registers)] += found.size();
      }
    }
  }
  std::printf("the same one by one and in registers of 2, 4, 8 numbers: %llu, %llu, %llu scenes\n", compared[0],
              compared[1], compared[2]);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::string_view(argv[1]) == "typical") {
    count_tiers(std::atof(argv[2]));
    return 0;
  }
  if (argc == 3 && std::string_view(argv[1]) == "registers") return compare_registers(std::atof(argv[2])) ? 0 : 1;
  const double wanted[2] = {argc > 1 ? std::atof(argv[1]) : 1e5, argc > 2 ? std::atof(argv[2]) : 1e5};
  std::uint64_t chunk = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  Comparison found[2];
  const auto print_all = [&] {
    print("random", found[0]);
    print("adversarial", found[1]);
  };
  while (true) {
    const bool adversarial =
        static_cast<double>(found[1].scenes) * wanted[0] < static_cast<double>(found[0].scenes) * wanted[1];
    Comparison& c = found[adversarial ? 1 : 0];
    if (static_cast<double>(c.scenes) >= wanted[adversarial ? 1 : 0]) break;
    run_chunk(chunk, adversarial, c);
    if (c.differences != 0) {
      std::printf("a difference in chunk %llu (%s)\n", Count{chunk}, adversarial ? "adversarial" : "random");
      print_all();
      return 1;
    }
    if (++chunk % 50 == 0) {
      print_all();
      std::printf("next chunk %llu\n", Count{chunk});
      std::fflush(stdout);
    }
  }
  print_all();
  return 0;
}
