#include "faces/cli/crew_run.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <utility>

#include "base/input/text_file.hpp"
#include "base/os/sha256.hpp"

namespace slipproof::cli {

Rank launched() {
  // SLURM_NTASKS is set in a whole job; SLURM_STEP_NUM_TASKS only in what srun starts.
  constexpr std::array<std::array<const char*, 2>, 4> launchers{{{"SLIPPROOF_RANK", "SLIPPROOF_RANKS"},
                                                                 {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                                                 {"PMI_RANK", "PMI_SIZE"},
                                                                 {"SLURM_PROCID", "SLURM_STEP_NUM_TASKS"}}};
  for (const auto& [rank, ranks] : launchers) {
    const char *const r = std::getenv(rank), *const n = std::getenv(ranks);
    if (r == nullptr || n == nullptr) continue;
    Rank place;
    const bool read = CLI::detail::lexical_cast(r, place.rank) && CLI::detail::lexical_cast(n, place.ranks);
    if (read && 0 <= place.rank && place.rank < place.ranks) return place;
    throw CLI::ValidationError(
        rank, "found rank " + std::string(r) + " of " + n + ", expected 0 or more, and less than " + n);
  }
  return {};
}

void be_silent() {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

void add_crew_options(CLI::App& command, CrewArguments& arguments) {
  command.add_option("--checkpoint", arguments.checkpoint,
                     "Keep results in this file as they come: if the run is interrupted, the same command "
                     "continues from there, with any number of threads and ranks");
}

std::string digest_of(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::is_regular_file(file, error) ? sha256(read_text_file(file)) : file.string();
}

std::unique_ptr<Crew> crew_of(const CrewArguments& arguments, unsigned threads,
                              const std::function<std::string()>& work, const Inputs& inputs, Service service) {
  if (!arguments.wanted()) return nullptr;
  const auto [rank, ranks] = launched();
  if (arguments.checkpoint.empty()) {
    throw CLI::ValidationError("--checkpoint", "found " + std::to_string(ranks) +
                                                   " ranks without it, expected a file, on a file system of all of "
                                                   "them, beside which they keep their results");
  }
  if (rank == 0) inputs.refuse(arguments.checkpoint);
  const CrewOptions options{arguments.checkpoint, "slipproof " SLIPPROOF_VERSION "\n" + work(), rank, ranks, threads};
  return std::make_unique<Crew>(options, std::move(service));
}

}  // namespace slipproof::cli
