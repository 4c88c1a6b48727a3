// What is told of a search: as text and as `slipproof/search/1`.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "search/search.hpp"

namespace slipproof {

struct SearchReport {
  const Mechanism& mechanism;    ///< as it was searched, with what narrows its domain
  const SearchOptions& options;  ///< of the search
  std::string within;            ///< what narrowed its domain; empty: nothing
  SearchResult result;
};

enum class SearchVerdict : std::uint8_t {
  unique,      ///< one motion at every load of every sample
  not_unique,  ///< or not
  found,       ///< what was looked for alone
  not_found,   ///< or not
  undecided    ///< no sample was found
};
SearchVerdict verdict(const SearchReport& report);
/// `unique`, `not unique`, `found`, `not found`, `undecided`.
std::string_view name(SearchVerdict verdict);

/// For people, in lines of 80 columns unless a word is longer; `quiet`: the last line alone.
std::string search_text(const SearchReport& report, bool quiet);
/// The document slipproof/search/1.
std::string search_json(const SearchReport& report);

}  // namespace slipproof
