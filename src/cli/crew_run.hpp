// Commands whose work is shared by many ranks, or goes on from a checkpoint.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "cli/command.hpp"
#include "output/inputs.hpp"
#include "scatter/crew.hpp"

namespace slipproof::cli {

/// --checkpoint, and the ranks there are.
struct CrewArguments {
  Transport* transport = nullptr;
  std::string checkpoint;

  bool many() const { return transport->ranks() > 1; }
  bool leads() const { return transport->rank() == 0; }
  /// Otherwise the work needs no crew.
  bool wanted() const { return many() || !checkpoint.empty(); }
};

void add_crew_options(CLI::App& command, CrewArguments& arguments);

/// The crew of a command, while it runs: SIGTERM asks rank 0 to stop, and leaves the others to it.
class CrewRun {
 public:
  /// `work` says what the results depend on, as for Journal; `inputs` are not written over by the checkpoint. Throws as
  /// Journal does.
  CrewRun(const CrewArguments& arguments, unsigned threads, const std::string& work, const Inputs& inputs,
          Service service);

  Crew& crew() { return *crew_; }

 private:
  std::optional<Journal> journal_;
  std::optional<Crew> crew_;
};

}  // namespace slipproof::cli
