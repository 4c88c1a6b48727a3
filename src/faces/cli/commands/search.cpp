#include "mechanics/search/search.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>

#include "contact/impact/solve_impact.hpp"
#include "contact/space/search_space.hpp"
#include "faces/cli/command.hpp"
#include "faces/cli/crew_run.hpp"
#include "faces/cli/interrupt.hpp"
#include "faces/cli/load_option.hpp"
#include "faces/cli/progress.hpp"
#include "faces/cli/warnings.hpp"
#include "mechanics/reading/shipped.hpp"
#include "mechanics/scene/narrow.hpp"
#include "report/uniqueness/search_report.hpp"

namespace slipproof::cli {

namespace {

struct SearchArguments {
  CommonOptions common;
  SearchOptions search;
  CrewArguments crew;
  std::string mechanism, law, within, wanted;
  bool narrows = false;
};

/// Everything that a result may depend on.
std::string searched_work(const SearchArguments& arguments, const Mechanism& mechanism) {
  const SearchOptions& options = arguments.search;
  return fmt::format("search {} law {} within {} for {} hysteresis {} samples {} seed {}\n", digest_of(mechanism.file),
                     arguments.law, arguments.within, arguments.wanted, options.hysteresis,
                     options.samples.value_or(default_samples(mechanism)), options.seed);
}

Exit run_search(SearchArguments& arguments) {
  SearchOptions& options = arguments.search;
  options.seed = arguments.common.seed;
  options.threads = arguments.common.threads;
  options.progress = progress_bar(!arguments.common.quiet);
  options.wanted = parse_search_for(arguments.wanted);
  MechanismRequest request = Dimensions::any;
  if (const auto law = parse_impact_law(arguments.law)) request.impact = ImpactRequest{law};
  Mechanism mechanism = open_mechanism(arguments.mechanism, {}, request);
  print_warnings(mechanism, arguments.common);
  mechanism = mechanism_to_search(std::move(mechanism), options);
  if (arguments.narrows) mechanism = narrowed(mechanism, arguments.within, "--within");
  MotionSearch search(mechanism, options);
  const auto crew = crew_of(
      arguments.crew, options.threads, [&] { return searched_work(arguments, mechanism); }, Inputs{mechanism.file},
      [&](std::string_view request) { return search.answer(request); });
  if (crew && crew->serve()) return success;
  const SearchReport report = searched(mechanism, options, arguments.within, search, solve_impact, crew.get());
  print_report(
      arguments.common, [&] { return search_json(report); }, [&] { return search_document(report); });
  switch (verdict(report)) {
    case SearchVerdict::unique:
    case SearchVerdict::none_found:
      return success;
    case SearchVerdict::found:
      return refuted_or_not_certified;
    case SearchVerdict::undecided:
      break;
  }
  return undecided;
}

}  // namespace

void add_search(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SearchArguments>();
  CLI::App& command =
      *app.add_subcommand("search",
                          "Search for points where a mechanism has no motion, several, or a continuum, or an impact "
                          "gains energy");
  command.add_option("MECHANISM", options->mechanism, "Mechanism file (TOML), or the name of a shipped one")
      ->required();
  auto* within =
      command.add_option("--within", options->within, "Search only where this holds, such as \"b < h and mu < 1\"");
  command
      .add_option("--for", options->wanted,
                  "Look only for this, and stop at the first; gain: an impact after which there is more energy")
      ->check(CLI::IsMember(std::vector<std::string>(search_words.begin(), search_words.end())));
  add_law_option(command, options->law, "as the file says; without one, no impact");
  command.add_flag("--hysteresis", options->search.hysteresis,
                   "Also report several motions that become one if static coefficients equal the kinetic ones");
  command
      .add_option(
          "--samples", options->search.samples,
          "Points of the domain, each for every load, in space for one; default: 30 to 2000, fewer for more modes")
      ->check(whole_number(1, 1'000'000'000));
  add_crew_options(command, options->crew);
  add_report_options(command, options->common);
  add_examples(command, {"painleve-rod --within \"mu < 1\" --samples 20", "proofs/impacts/rod.toml --for gain"});
  command.callback([options, within, &exit_code] {
    options->narrows = within->count() > 0;
    exit_code = stoppable([&] { return run_search(*options); }, [&] { return by_checkpoint(options->crew); });
  });
}

}  // namespace slipproof::cli
