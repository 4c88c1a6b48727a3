// A crew whose ranks are threads of this process.
#pragma once

#include <functional>
#include <thread>
#include <vector>

#include "base/crew/crew.hpp"
#include "support/run_program.hpp"

namespace slipproof::test {

/// lead(crew) on rank 0 of so many ranks, which answer with the same service and keep their results in the folder.
inline void by_crew(int ranks, const Service& service, const std::function<void(Crew&)>& lead,
                    const std::filesystem::path& folder) {
  const auto options = [&](int rank) {
    return CrewOptions{.checkpoint = folder / "checkpoint", .work = "work", .rank = rank, .ranks = ranks, .threads = 1};
  };
  std::vector<std::jthread> others;  // which end after rank 0
  Crew crew(options(0), service);
  for (int rank = 1; rank < ranks; ++rank) {
    others.emplace_back([&, rank] { Crew(options(rank), service).serve(); });
    // One that comes when rank 0 is gone would wait for it.
    while (!Journal::is_written(folder / ("checkpoint." + std::to_string(rank)))) std::this_thread::yield();
  }
  lead(crew);
}
inline void by_crew(int ranks, const Service& service, const std::function<void(Crew&)>& lead) {
  by_crew(ranks, service, lead, TemporaryFolder().path());
}

}  // namespace slipproof::test
