// Commands whose work many ranks share, or that continue from a checkpoint.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "base/crew/crew.hpp"
#include "base/output/inputs.hpp"
#include "faces/cli/command.hpp"

namespace slipproof::cli {

/// The option --checkpoint, and the ranks of the run.
struct CrewArguments {
  Transport* transport = nullptr;
  std::string checkpoint;

  bool many() const { return transport != nullptr && transport->ranks() > 1; }
  bool leads() const { return !many() || transport->rank() == 0; }
  std::function<bool(std::string_view, std::string_view)> still_counts = {};  ///< as in CrewOptions
  /// If false, the work needs no crew.
  bool wanted() const { return many() || !checkpoint.empty(); }
};

/// A short digest of a file's content; if it is not a file, its name.
std::string digest_of(const std::filesystem::path& file);

/// Adds --checkpoint, and returns it.
CLI::Option* add_crew_options(CLI::App& command, CrewArguments& arguments);

/// The crew of a running command. SIGTERM asks rank 0 to stop; it then stops the others.
class CrewRun {
 public:
  /// `work` says what the results depend on, as for Journal. The checkpoint must not overwrite `inputs`. Throws as
  /// Journal does.
  CrewRun(const CrewArguments& arguments, unsigned threads, const std::function<std::string()>& work,
          const Inputs& inputs, Service service);

  /// On a rank that only answers: answers until rank 0 has all results, then returns true. On other ranks returns false
  /// at once.
  bool served();
  /// Null if no journal is wanted; the same holds for the crew.
  Journal* journal() { return journal_ ? &*journal_ : nullptr; }
  Crew* crew() { return crew_ ? &*crew_ : nullptr; }

 private:
  std::optional<Journal> journal_;
  std::optional<Crew> crew_;
};

}  // namespace slipproof::cli
