// What all pages have in common: nothing is fetched from anywhere, and there is a way to each section.
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
  std::vector<std::pair<std::string, std::string>> links;  ///< what each leads to, and its words
  std::string footer;
  std::string brand = "#overview";  ///< where the program's name leads
  std::string skip = "#overview", skip_words = "Skip to the results";
  std::string_view script = {};  ///< empty: none
};

/// The page, HTML 5, with what `fill` adds to its <main>.
std::string framed(const PageFrame& frame, const std::function<void(const Element& main)>& fill);

/// A section with its heading.
Element add_section(const Element& main, const char* id, std::string_view heading);

}  // namespace slipproof
