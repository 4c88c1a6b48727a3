// Is it ever undecided what happens? A mechanism over its whole domain, at samples, each for every load at once.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/mechanism/mechanism.hpp"
#include "mechanics/search/simpler_place.hpp"

namespace slipproof {

class Crew;

/// What is looked for alone.
enum class SearchFor : std::uint8_t {
  none,
  several,
  continuum,
  gain  ///< an outcome of an impact with more energy than before
};
inline constexpr std::array<std::string_view, 4> search_words{"none", "several", "continuum", "gain"};
std::string_view name(SearchFor what);                             ///< one of search_words
std::optional<SearchFor> parse_search_for(std::string_view text);  ///< nothing unless as written by name()

struct SearchOptions {
  std::optional<std::uint64_t> samples;  ///< by default as many as take some seconds: default_samples()
  std::uint64_t seed = 1;
  unsigned threads = 0;             ///< 0: all cores
  std::optional<SearchFor> wanted;  ///< this alone, and the first of it ends the search
  bool hysteresis = false;          ///< hysteresis counts as several motions
  /// For a mechanism in space, which has no load: without_load() makes it a parameter.
  FindInSpace in_space = {};
  /// Called now and then, from one thread, with the number of samples done and of all.
  std::function<void(std::uint64_t, std::uint64_t)> progress;
};

/// The same motions, wherever they were found.
struct SearchCell {
  FoundMotions found;
  std::uint64_t samples = 0;  ///< at some load of so many
  SearchPlace simplest;
  std::optional<SearchPlace> realisable;  ///< the simplest that could be built, if such a one was found
};

struct SearchResult {
  std::uint64_t tried = 0;           ///< samples that were asked for; with `wanted`, up to the first of it
  std::uint64_t samples = 0;         ///< points found in the domain at which everything has a value
  std::uint64_t without_value = 0;   ///< points at which something divides by zero
  std::uint64_t one_everywhere = 0;  ///< samples with one motion at every load, hysteresis and undecided left out
  std::array<std::uint64_t, motion_counts> with{};        ///< by MotionCount: samples that have it at some load
  std::array<std::uint64_t, energy_balances> energies{};  ///< by EnergyBalance: samples with it as the greatest
  /// Findings without hysteresis: none first, then several, continua, none_modelled, and one; those that gain energy
  /// first, then frequent ones. Undecided ones, the last, if they gain energy.
  std::vector<SearchCell> cells;

  std::uint64_t count(MotionCount what) const { return with[static_cast<std::size_t>(what)]; }
  std::uint64_t count(EnergyBalance what) const { return energies[static_cast<std::size_t>(what)]; }
};

/// Fewer for a mechanism with more modes.
std::uint64_t default_samples(const Mechanism& mechanism);

/// search_motions() in requests that any rank can answer.
class MotionSearch {
 public:
  /// What is given must outlive it. Throws InputError for more modes than are tried, and for a gain of energy that is
  /// looked for in what is no impact.
  MotionSearch(const Mechanism& mechanism, const SearchOptions& options);
  ~MotionSearch();

  /// The service of a crew, from many threads at once.
  std::string answer(std::string_view request) const;

  /// Computes the result with the crew, whose service is answer(), or with threads if there is no crew. Call it once.
  SearchResult result(Crew* crew = nullptr);

 private:
  class Run;
  std::unique_ptr<Run> run_;
};

/// The same result at any number of threads. Throws InputError, before the work, for more modes than are tried.
SearchResult search_motions(const Mechanism& mechanism, const SearchOptions& options = {});

}  // namespace slipproof
