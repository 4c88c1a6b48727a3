// Whether a certificate about a contact problem proves what it claims (FORMAT.md).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace slipproof::check_contact {

struct ContactVerdict {
  enum class Kind : std::uint8_t {
    accepted,
    rejected,   ///< it does not prove its claim
    missing,    ///< there is no such file
    unreadable  ///< the text is no certificate, or the file cannot be read
  };
  Kind kind = Kind::unreadable;
  /// The established result; or why the text is rejected or unreadable, such as `line L, column C: found ..., expected
  /// ...`.
  std::string message;
};

/// Checks a certificate. Rejects one about a problem with another name (FORMAT.md) than `required_name`, unless that is
/// empty. Does not throw for any text.
ContactVerdict check_contact_certificate(std::string_view text, std::string_view required_name = "");

}  // namespace slipproof::check_contact
