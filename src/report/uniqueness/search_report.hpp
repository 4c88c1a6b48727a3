// The report on a search, as text and as `slipproof/search/1`.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "claims/uniqueness/everywhere.hpp"
#include "contact/impact/solved_impact.hpp"
#include "mechanics/search/search.hpp"
#include "report/document/document.hpp"

namespace slipproof {

struct SearchReport {
  const Mechanism& mechanism;    ///< the mechanism that was searched, with the conditions that narrow its domain
  const SearchOptions& options;  ///< of the search
  std::string within;            ///< the conditions that narrowed its domain; empty: none
  SearchResult result;
  std::optional<UniqueEverywhere> proof = {};        ///< proves that there is one motion in the whole domain
  std::map<std::size_t, SolvedImpact> impacts = {};  ///< of cells that gain energy, at their simplest places
};

/// solve_impact()
using SolveImpact = std::function<SolvedImpact(MechanismScene)>;

/// Searches, and looks for a proof if the search finds nothing; uses the crew if there is one.
SearchReport searched(const Mechanism& mechanism, const SearchOptions& options, std::string within,
                      MotionSearch& search, const SolveImpact& solve, Crew* crew = nullptr);

enum class SearchVerdict : std::uint8_t {
  unique,      ///< it is proved that there is one motion in the whole domain
  none_found,  ///< one motion at every load of every sample; if only one kind was searched for, no place of that kind
  found,       ///< another number of motions, or a gain of energy; if only one kind was searched for, a place of it
  undecided    ///< no sample was found; or nothing was, and a sample is undecided, in space or about energy
};
SearchVerdict verdict(const SearchReport& report);
/// `unique`, `none found`, `found`, `undecided`.
std::string_view name(SearchVerdict verdict);

/// For people.
Document search_document(const SearchReport& report);
/// The document slipproof/search/1.
std::string search_json(const SearchReport& report);

}  // namespace slipproof
