// What is told of a search: as text and as `slipproof/search/1`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "claims/uniqueness/everywhere.hpp"
#include "mechanics/search/search.hpp"
#include "report/document/document.hpp"

namespace slipproof {

struct SearchReport {
  const Mechanism& mechanism;    ///< as it was searched, with what narrows its domain
  const SearchOptions& options;  ///< of the search
  std::string within;            ///< what narrowed its domain; empty: nothing
  SearchResult result;
  std::optional<UniqueEverywhere> proof = {};  ///< that there is one motion in the whole domain
};

/// The search, and a proof where it finds nothing; with a crew, by it.
SearchReport searched(const Mechanism& mechanism, const SearchOptions& options, std::string within,
                      MotionSearch& search, Crew* crew = nullptr);

enum class SearchVerdict : std::uint8_t {
  unique,      ///< one motion in the whole domain, which is proved
  none_found,  ///< one motion at every load of every sample; of what was looked for alone, nothing
  found,       ///< another number of motions; what was looked for alone
  undecided    ///< no sample was found
};
SearchVerdict verdict(const SearchReport& report);
/// `unique`, `none found`, `found`, `undecided`.
std::string_view name(SearchVerdict verdict);

/// For people.
Document search_document(const SearchReport& report);
/// The document slipproof/search/1.
std::string search_json(const SearchReport& report);

}  // namespace slipproof
