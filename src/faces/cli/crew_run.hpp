// Commands whose work many ranks share, or that continue from a checkpoint.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/crew/crew.hpp"
#include "base/output/inputs.hpp"
#include "faces/cli/command.hpp"

namespace slipproof::cli {

/// The number of this process among those of its run, as its launcher says: mpirun of Open MPI or MPICH, srun, or who
/// sets SLIPPROOF_RANK and SLIPPROOF_RANKS. Without one, the only rank.
struct Rank {
  int rank = 0, ranks = 1;
};
/// Throws CLI::ValidationError for a rank that is none of the ranks.
Rank launched();
/// Ranks other than 0 print nothing.
void be_silent();

/// The option --checkpoint.
struct CrewArguments {
  std::string checkpoint;

  /// If false, the work needs no crew.
  bool wanted() const { return !checkpoint.empty() || launched().ranks > 1; }
};
void add_crew_options(CLI::App& command, CrewArguments& arguments);

/// A short digest of a file's content; if it is not a file, its name.
std::string digest_of(const std::filesystem::path& file);

/// The crew of a running command; null if none is wanted. `work` says what the results depend on, as for Journal. The
/// checkpoint must not overwrite `inputs`. Throws as Journal does, and CLI::ValidationError for many ranks without a
/// checkpoint.
std::unique_ptr<Crew> crew_of(const CrewArguments& arguments, unsigned threads,
                              const std::function<std::string()>& work, const Inputs& inputs, Service service);

}  // namespace slipproof::cli
