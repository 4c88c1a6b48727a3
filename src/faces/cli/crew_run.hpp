// Commands whose work is shared by many ranks, or continues from a checkpoint.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/crew/crew.hpp"
#include "base/output/inputs.hpp"
#include "faces/cli/command.hpp"

namespace slipproof::cli {

/// --checkpoint, and the ranks there are.
struct CrewArguments {
  Transport* transport = nullptr;
  std::string checkpoint;

  bool many() const { return transport != nullptr && transport->ranks() > 1; }
  bool leads() const { return !many() || transport->rank() == 0; }
  std::function<bool(std::string_view, std::string_view)> still_counts = {};  ///< as CrewOptions have it
  /// Otherwise the work needs no crew.
  bool wanted() const { return many() || !checkpoint.empty(); }
};

/// The content of a file in few letters; of what is no file its name.
std::string digest_of(const std::filesystem::path& file);

/// --checkpoint, which is returned.
CLI::Option* add_crew_options(CLI::App& command, CrewArguments& arguments);

/// The crew of a command, while it runs: SIGTERM asks rank 0 to stop, and leaves the others to it.
class CrewRun {
 public:
  /// `work` says what the results depend on, as for Journal; `inputs` are not written over by the checkpoint. Throws as
  /// Journal does.
  CrewRun(const CrewArguments& arguments, unsigned threads, const std::function<std::string()>& work,
          const Inputs& inputs, Service service);

  /// On ranks that only answer: answers until rank 0 has all results. Elsewhere returns false at once.
  bool served();
  /// Null where none is wanted, as the crew.
  Journal* journal() { return journal_ ? &*journal_ : nullptr; }
  Crew* crew() { return crew_ ? &*crew_ : nullptr; }

 private:
  std::optional<Journal> journal_;
  std::optional<Crew> crew_;
};

}  // namespace slipproof::cli
