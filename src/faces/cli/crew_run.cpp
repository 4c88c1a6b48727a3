#include "faces/cli/crew_run.hpp"

#include <csignal>
#include <utility>

#include "base/input/text_file.hpp"
#include "base/os/sha256.hpp"

namespace slipproof::cli {

namespace {

volatile std::sig_atomic_t asked_to_stop = 0;

}  // namespace

std::string digest_of(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::is_regular_file(file, error) ? sha256(read_text_file(file)) : file.string();
}

CLI::Option* add_crew_options(CLI::App& command, CrewArguments& arguments) {
  return command.add_option("--checkpoint", arguments.checkpoint,
                            "Keep results in this file as they come: if the run is interrupted, the same command\n"
                            "continues from there, with any number of threads and ranks");
}

CrewRun::CrewRun(const CrewArguments& arguments, unsigned threads, const std::function<std::string()>& work,
                 const Inputs& inputs, Service service) {
  if (!arguments.wanted()) return;
  if (arguments.leads() && !arguments.checkpoint.empty()) try {
      inputs.refuse(arguments.checkpoint);
      journal_.emplace(arguments.checkpoint, "slipproof " SLIPPROOF_VERSION "\n" + work());
    } catch (...) {
      dismiss_others(*arguments.transport);
      throw;
    }
  std::signal(SIGTERM, [](int) { asked_to_stop = 1; });
  crew_.emplace(*arguments.transport,
                CrewOptions{.threads = threads,
                            .journal = journal_ ? &*journal_ : nullptr,
                            .still_counts = arguments.still_counts,
                            .stop_asked = [] { return asked_to_stop != 0; }},
                std::move(service));
}

bool CrewRun::served() {
  if (!crew_ || crew_->leads()) return false;
  crew_->serve();
  return true;
}

}  // namespace slipproof::cli
