#include "report/uniqueness/search_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "mechanics/points/sampling.hpp"
#include "report/scenes/impact_report.hpp"
#include "report/values/number_text.hpp"

namespace slipproof {

namespace {

bool finds_something(const SearchReport& report) {
  const SearchResult& result = report.result;
  return report.options.wanted ? !result.cells.empty()
                               : result.one_everywhere + result.count(MotionCount::undecided) < result.samples ||
                                     result.count(EnergyBalance::gained) > 0;
}

}  // namespace

SearchReport searched(const Mechanism& mechanism, const SearchOptions& options, std::string within,
                      MotionSearch& search, const SolveImpact& solve, Crew* crew) {
  SearchReport report{mechanism, options, std::move(within), search.result(crew)};
  if (report.result.samples > 0 && !finds_something(report) && mechanism.dimension == 2)
    report.proof = unique_everywhere(mechanism, !options.hysteresis);
  for (std::size_t i = 0; i < report.result.cells.size(); ++i) {
    const auto& [found, samples, simplest, realisable] = report.result.cells[i];
    if (found.energy != EnergyBalance::gained) continue;
    report.impacts.emplace(i, solve({mechanism.name, mechanism, simplest.values, simplest.load, {}}));
  }
  return report;
}

SearchVerdict verdict(const SearchReport& report) {
  if (report.result.samples == 0) return SearchVerdict::undecided;
  if (finds_something(report)) return SearchVerdict::found;
  const SearchResult& result = report.result;
  if (result.count(MotionCount::undecided) + result.count(EnergyBalance::undecided) > 0)
    return SearchVerdict::undecided;
  return report.proof ? SearchVerdict::unique : SearchVerdict::none_found;
}

std::string_view name(SearchVerdict verdict) {
  constexpr std::array<std::string_view, 4> names{"unique", "none found", "found", "undecided"};
  return names[static_cast<std::size_t>(verdict)];
}

namespace {

const char* title(MotionCount count) {
  switch (count) {
    case MotionCount::none:
      return "No motion";
    case MotionCount::none_modelled:
      return "No motion of those that are modelled";
    case MotionCount::several:
      return "Several motions";
    case MotionCount::continuum:
      return "A continuum of motions";
    case MotionCount::undecided:
      return "Undecided whether there are other motions";
    default:
      return "One motion";
  }
}

std::string in_words(const UniqueEverywhere& proof) {
  return fmt::format(
      "one motion in the whole domain, whatever pushes, by theorem 1 of proofs/two-wheeler: the determinants of all {} "
      "modes are positive, by {} checked certificates (--json has them)",
      proof.modes, proof.statements.size());
}

std::string motions_text(const FoundMotions& found) {
  std::vector<std::string> words;
  for (const auto& motion : found.modes) words.push_back(equal_modes(motion));
  for (const MechanismMode& mode : found.continua) words.push_back("a continuum in " + name(mode));
  words.insert(words.end(), found.in_space.begin(), found.in_space.end());
  if (found.on_boundary > 0) {
    const char* more = words.empty() ? "" : " more";
    words.push_back(fmt::format("{}{} on a boundary of modes", found.on_boundary, more));
  }
  if (words.empty()) words.emplace_back("none");
  return listed(words, "; ");
}

std::string energy_text(const Range& energy) {
  return energy.is_point() ? exact_text(*energy.lower) : "within " + range_text(energy, 6);
}

void write_energies(Document& document, const SolvedImpact& solved) {
  for (const ImpactOutcome& outcome : solved.outcomes) {
    document.paragraph(fmt::format("{} {}: {} before, {} after", outcome.modes.front(), energy_words(solved, outcome),
                                   exact_text(solved.energy), energy_text(outcome.energy)));
  }
}

std::string place_text(const Mechanism& mechanism, const SearchPlace& place) {
  std::string text = values_text(mechanism, place.values);
  if (place.load) text += ", " + mechanism.load->symbol + " = " + exact_text(*place.load);
  return text;
}

/// How often an impact gains energy.
void write_balance(Document& document, const SearchResult& result) {
  document.paragraph(fmt::format("energy is gained at {} of them", result.count(EnergyBalance::gained)));
  if (const auto count = result.count(EnergyBalance::undecided); count > 0) {
    document.paragraph("undecided whether energy is gained at " + counted(count, "sample"));
  }
  if (const auto count = result.count(EnergyBalance::not_judged); count > 0) {
    document.paragraph("energy is not judged at " + counted(count, "sample") +
                       ": bodies that move as prescribed may put energy in");
  }
}

void write_head(Document& document, const SearchReport& report) {
  const Mechanism& mechanism = report.mechanism;
  const SearchResult& result = report.result;
  document.title(mechanism.dimension == 3
                     ? mechanism.name + ": " + counted(mechanism.contacts.size(), "contact") + " in space"
                     : fmt::format("{}: {:.0f} modes", mechanism.name, mode_count(element_kinds(mechanism))));
  if (!report.within.empty()) document.paragraph("within " + report.within);
  if (result.samples == 0) {
    document.paragraph("no point of the domain was found in " + counted(result.tried, "try") +
                       ": nothing is known, more --samples or another --seed may find some");
  } else {
    document.paragraph(counted(result.samples, "sample") + " of the domain" +
                       (mechanism.load ? ", each for every load " + mechanism.load->symbol : "") +
                       (report.proof ? "" : ": a search, no proof"));
  }
  if (report.proof) document.paragraph("proved: " + in_words(*report.proof));
  if (result.without_value > 0) {
    document.paragraph("at " + counted(result.without_value, "more point") + " something divides by zero" +
                       (mechanism.dimension == 3 ? ", or cannot be asked in space" : ""));
  }
  if (result.samples > 0 && !report.options.wanted) {
    document.paragraph(
        fmt::format("one motion {}at {} of them", mechanism.load ? "at every load " : "", result.one_everywhere));
  }
  if (mechanism.impact && result.samples > 0 && !report.options.wanted) write_balance(document, result);
  if (const auto count = result.count(MotionCount::undecided); count > 0) {
    document.paragraph("undecided at " + counted(count, "sample") +
                       ": one motion or none is known there, and that there is no other is not proved");
  }
  if (const auto count = result.count(MotionCount::hysteresis); count > 0) {
    document.paragraph("hysteresis at " + counted(count, "sample") +
                       ", which is left out: several motions, but one where the static coefficients are as low as the "
                       "kinetic ones (--hysteresis)");
  }
}

void write_cell(Document& document, const SearchReport& report, std::size_t index) {
  const Mechanism& mechanism = report.mechanism;
  const SearchCell& cell = report.result.cells[index];
  const auto impact = report.impacts.find(index);
  const bool gains = impact != report.impacts.end();
  Document& below = document.item(motions_text(cell.found) + (gains ? ", with a gain of energy" : ""));
  for (const std::size_t contact : cell.found.not_modelled) {
    below.paragraph("where it is not modelled that the contact " + mechanism.contacts[contact].name + " opens");
  }
  const std::string simplest = place_text(mechanism, cell.simplest);
  below.paragraph(counted(cell.samples, "sample") + (simplest.empty() ? "" : ", at " + simplest));
  if (gains) write_energies(below, impact->second);
  if (mechanism.realisable.empty()) return;
  const std::string built = cell.realisable ? place_text(mechanism, *cell.realisable) : "";
  if (!cell.realisable) {
    below.paragraph("none that could be built was found");
  } else if (built != simplest) {
    below.paragraph("could be built: at " + built);
  }
}

std::string last_line(const SearchReport& report) {
  const SearchResult& result = report.result;
  const SearchVerdict verdict = slipproof::verdict(report);
  std::string words(name(verdict));
  std::ranges::transform(words, words.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::string line = fmt::format("s {} samples {}", words, result.samples);
  if (report.options.wanted) {
    line += fmt::format(" for {}", name(*report.options.wanted));
  } else {
    line += fmt::format(" one {} none {} several {} continuum {} hysteresis {}", result.one_everywhere,
                        result.count(MotionCount::none) + result.count(MotionCount::none_modelled),
                        result.count(MotionCount::several), result.count(MotionCount::continuum),
                        result.count(MotionCount::hysteresis));
    if (report.mechanism.dimension == 3) line += fmt::format(" undecided {}", result.count(MotionCount::undecided));
    if (report.mechanism.impact) line += fmt::format(" gain {}", result.count(EnergyBalance::gained));
  }
  return line + (verdict == SearchVerdict::unique ? " by theorem 1 of two-wheeler" : "");
}

}  // namespace

Document search_document(const SearchReport& report) {
  Document document;
  write_head(document, report);
  std::optional<MotionCount> count;
  Document* section = nullptr;
  for (std::size_t i = 0; i < report.result.cells.size(); ++i) {
    const MotionCount its = report.result.cells[i].found.count;
    if (count != its) {
      count = its;
      section =
          &document.section(std::string(title(*count)) + ": at " + counted(report.result.count(*count), "sample"));
    }
    write_cell(*section, report, i);
  }
  document.status(last_line(report));
  return document;
}

}  // namespace slipproof
