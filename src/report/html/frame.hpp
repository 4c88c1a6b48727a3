// The frame of all pages: head, links to the sections, footer. A page fetches nothing.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/markup/element.hpp"

namespace slipproof {

struct PageFrame {
  std::string title, version;
  std::vector<std::pair<std::string, std::string>> links;  ///< target and words of each
  std::string footer;
  std::string brand = "#overview";  ///< target of the program's name
  std::string skip = "#overview", skip_words = "Skip to the results";
  std::string_view script = {};  ///< empty: none
  std::string description = {};  ///< for search engines and for those who share the page; empty: none
  std::string image = {};        ///< the address of a picture for those who share the page; empty: none
};

/// The page, HTML 5. `fill` adds its content.
std::string framed(const PageFrame& frame, const std::function<void(const Element& main)>& fill);

/// A section with its heading.
Element add_section(const Element& main, const char* id, std::string_view heading);

/// A search field that hides what does not contain its words: the elements of the class `item` below the element with
/// the id `list`. `search_script` shows and runs it.
void add_search(const Element& section, const std::string& list, std::string_view label);
extern const std::string_view search_script;

}  // namespace slipproof
