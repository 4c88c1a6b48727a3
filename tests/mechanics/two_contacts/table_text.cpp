#include <cstdio>
#include <sstream>

#include "mechanics/two_contacts/table.hpp"

namespace slipproof::test::two_contacts {

std::string table_text(const std::vector<Example>& examples) {
  std::ostringstream text;
  text << "motions ";
  const std::vector<std::string> shown{"SS", "SO", "++", "+-", "+O", "-+", "--", "-O", "OS", "O+", "O-", "OO"};
  for (const std::string& mode : shown) text << ' ' << mode;
  text << "  sets\n";
  char number[16];
  for (const auto& [modes, count] : up_to_names(examples, Below::rest)) {
    std::snprintf(number, sizeof number, "%5zu   ", modes.size());
    text << number;
    for (const std::string& mode : shown) text << (modes.contains(mode) ? "  x" : "  .");
    std::snprintf(number, sizeof number, "%6zu", count);
    text << number << '\n';
  }
  return text.str();
}

}  // namespace slipproof::test::two_contacts
