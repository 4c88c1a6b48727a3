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
  /// What is established; why it is rejected or cannot be read, such as `line L, column C: found ..., expected ...`.
  std::string message;
};

/// One that is about another problem than the one `asked` about, by its name (FORMAT.md), is rejected; empty: any is
/// right. Never throws because of what the text contains.
ContactVerdict check_contact_certificate(std::string_view text, std::string_view asked = "");

}  // namespace slipproof::check_contact
