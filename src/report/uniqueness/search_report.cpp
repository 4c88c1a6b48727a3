#include "report/uniqueness/search_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>

#include "base/input/utf8.hpp"
#include "base/number/format.hpp"
#include "mechanics/scene/sampling.hpp"

namespace slipproof {

namespace {

bool finds_something(const SearchReport& report) {
  const SearchResult& result = report.result;
  return report.options.wanted ? !result.cells.empty() : result.one_everywhere < result.samples;
}

}  // namespace

SearchReport searched(const Mechanism& mechanism, const SearchOptions& options, std::string within,
                      MotionSearch& search, Crew* crew) {
  SearchReport report{mechanism, options, std::move(within), search.result(crew)};
  if (report.result.samples > 0 && !finds_something(report))
    report.proof = unique_everywhere(mechanism, !options.hysteresis);
  return report;
}

SearchVerdict verdict(const SearchReport& report) {
  if (report.result.samples == 0) return SearchVerdict::undecided;
  if (finds_something(report)) return SearchVerdict::found;
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
  if (found.on_boundary > 0) {
    const char* more = words.empty() ? "" : " more";
    words.push_back(fmt::format("{}{} on a boundary of modes", found.on_boundary, more));
  }
  if (words.empty()) words.emplace_back("none");
  return fmt::format("{}", fmt::join(words, "; "));
}

/// Builds the text for one search.
class SearchText {
 public:
  explicit SearchText(const SearchReport& report)
      : report_(report), mechanism_(report.mechanism), result_(report.result) {}

  std::string whole() {
    head();
    std::optional<MotionCount> section;
    for (const SearchCell& cell : result_.cells) {
      if (section != cell.found.count) {
        section = cell.found.count;
        text_ += fmt::format("\n{}: at {}\n", title(*section), counted(result_.count(*section), "sample"));
      }
      add(cell);
    }
    return text_ + "\n" + last_line();
  }

  std::string last_line() const {
    const SearchVerdict verdict = slipproof::verdict(report_);
    std::string words(name(verdict));
    std::ranges::transform(words, words.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    std::string line = fmt::format("s {} samples {}", words, result_.samples);
    if (report_.options.wanted) {
      line += fmt::format(" for {}", name(*report_.options.wanted));
    } else {
      line += fmt::format(" one {} none {} several {} continuum {} hysteresis {}", result_.one_everywhere,
                          result_.count(MotionCount::none) + result_.count(MotionCount::none_modelled),
                          result_.count(MotionCount::several), result_.count(MotionCount::continuum),
                          result_.count(MotionCount::hysteresis));
    }
    if (verdict == SearchVerdict::unique) line += " by theorem 1 of two-wheeler";
    return line + '\n';
  }

 private:
  void head() {
    text_ += wrapped("", fmt::format("{}: {:.0f} modes", mechanism_.name, mode_count(element_kinds(mechanism_))));
    if (!report_.within.empty()) text_ += wrapped("within ", report_.within);
    std::string samples = counted(result_.samples, "sample") + " of the domain";
    if (mechanism_.load) samples += ", each for every load " + mechanism_.load->symbol;
    if (result_.samples == 0) {
      text_ += wrapped("", "no point of the domain was found in " + counted(result_.tried, "try") +
                               ": nothing is known, more --samples or another --seed may find some");
    } else {
      text_ += wrapped("", samples + (report_.proof ? "" : ": a search, no proof"));
    }
    if (report_.proof) text_ += wrapped("", "proved: " + in_words(*report_.proof));
    if (result_.without_value > 0) {
      text_ += wrapped("", "at " + counted(result_.without_value, "more point") + " something divides by zero");
    }
    if (result_.samples > 0 && !report_.options.wanted) {
      text_ +=
          fmt::format("one motion {}at {} of them\n", mechanism_.load ? "at every load " : "", result_.one_everywhere);
    }
    if (const auto count = result_.count(MotionCount::hysteresis); count > 0) {
      text_ += wrapped("", "hysteresis at " + counted(count, "sample") +
                               ", which is left out: several motions, but one where the static coefficients are as "
                               "low as the kinetic ones (--hysteresis)");
    }
  }

  void add(const SearchCell& cell) {
    text_ += wrapped("  ", motions_text(cell.found));
    for (const std::size_t contact : cell.found.not_modelled) {
      text_ +=
          wrapped("    ", "where it is not modelled that the contact " + mechanism_.contacts[contact].name + " opens");
    }
    text_ += wrapped("    ", counted(cell.samples, "sample") + ", at " + place_text(cell.simplest));
    if (mechanism_.realisable.empty()) return;
    if (!cell.realisable) {
      text_ += "    none that could be built was found\n";
    } else if (place_text(*cell.realisable) != place_text(cell.simplest)) {
      text_ += wrapped("    ", "could be built: at " + place_text(*cell.realisable));
    }
  }

  std::string place_text(const SearchPlace& place) const {
    std::string text = values_text(mechanism_, place.values);
    if (place.load) text += ", " + mechanism_.load->symbol + " = " + exact_text(*place.load);
    return text;
  }

  const SearchReport& report_;
  const Mechanism& mechanism_;
  const SearchResult& result_;
  std::string text_;
};

}  // namespace

std::string search_text(const SearchReport& report, bool quiet) {
  SearchText text(report);
  return quiet ? text.last_line() : text.whole();
}

}  // namespace slipproof
