#include "floating/trade/trade.hpp"

#include <fmt/format.h>

#include <memory>

#include "faces/cli/command.hpp"
#include "faces/cli/crew_run.hpp"
#include "faces/cli/interrupt.hpp"
#include "faces/cli/progress.hpp"
#include "report/scenes/trade_report.hpp"

namespace slipproof::cli {

namespace {

struct TradeArguments {
  CommonOptions common;
  TradeOptions trade;
  CrewArguments crew;
  bool quick = false;
};

int run_trade(TradeArguments& options) {
  options.trade.seed = options.common.seed;
  options.trade.threads = options.common.threads;
  if (options.quick) {
    options.trade.scenes = 25;
    options.trade.seconds = 0.002;
  }
  const auto crew = crew_of(
      options.crew, options.common.threads,
      [&] { return fmt::format("trade scenes {} seed {}\n", options.trade.scenes, options.trade.seed); }, {},
      [&](std::string_view request) { return trade_answer(options.trade, request); });
  if (crew && crew->serve()) return success;
  ProgressLine line(!options.common.quiet);
  const auto progress = [&](std::size_t done, std::size_t all) { line.at(done, all); };
  const Trade trade = measure_trade(options.trade, progress, crew.get());
  print_report(
      options.common, [&] { return trade_json(trade); }, [&] { return trade_document(trade); });
  return trade.sound() ? success : refuted_or_not_certified;
}

}  // namespace

void add_trade(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<TradeArguments>();
  CLI::App& command = *app.add_subcommand("trade", "Measure speed and accuracy of the number types");
  auto* quick = command.add_flag("--quick", options->quick, "25 scenes of each workload, rough timings: seconds");
  command.add_option("--scenes", options->trade.scenes, "Scenes of each workload")
      ->check(whole_number(1, 1'000'000))
      ->excludes(quick)
      ->capture_default_str();
  command.add_option("--seconds", options->trade.seconds, "Least CPU time for each measurement of speed")
      ->check(number_in(0, 60))
      ->excludes(quick)
      ->capture_default_str();
  add_crew_options(command, options->crew);
  add_report_options(command, options->common);
  add_examples(command, {"--quick"});
  command.callback([options, &exit_code] {
    exit_code = stoppable([&] { return run_trade(*options); }, [&] { return by_checkpoint(options->crew); });
  });
}

}  // namespace slipproof::cli
