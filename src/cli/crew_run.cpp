#include "cli/crew_run.hpp"

#include <csignal>
#include <utility>

namespace slipproof::cli {

namespace {

volatile std::sig_atomic_t asked_to_stop = 0;

}  // namespace

void add_crew_options(CLI::App& command, CrewArguments& arguments) {
  command.add_option("--checkpoint", arguments.checkpoint,
                     "Keep results in this file as they come: whatever ends the run, the same command\n"
                     "goes on from there, by any number of threads and ranks");
}

CrewRun::CrewRun(const CrewArguments& arguments, unsigned threads, const std::string& work, const Inputs& inputs,
                 Service service) {
  if (arguments.leads() && !arguments.checkpoint.empty()) {
    inputs.refuse(arguments.checkpoint);
    journal_.emplace(arguments.checkpoint, "slipproof " SLIPPROOF_VERSION "\n" + work);
  }
  std::signal(SIGTERM, [](int) { asked_to_stop = 1; });
  crew_.emplace(*arguments.transport,
                CrewOptions{.threads = threads,
                            .journal = journal_ ? &*journal_ : nullptr,
                            .stop_asked = [] { return asked_to_stop != 0; }},
                std::move(service));
}

}  // namespace slipproof::cli
