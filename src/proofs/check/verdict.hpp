// What can be said of a certificate.
#pragma once

#include <cstdint>
#include <string_view>

namespace slipproof::check {

enum class Verdict : std::uint8_t {
  accepted,    ///< it proves the statement
  rejected,    ///< it does not
  missing,     ///< the statement has none
  undecided,   ///< a record in place of the certificate says that the search ended without one
  unreadable,  ///< the statement is malformed, or a file cannot be read
};
std::string_view to_string(Verdict verdict);

}  // namespace slipproof::check
