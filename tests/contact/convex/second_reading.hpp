// Certificates about contact problems read a second time, from FORMAT.md alone: another program than the checker, with
// other formulas where there are some. It knows `eps`, `enclosure`, `ball`,
// `every-solution` and `all-solutions`.
#pragma once

#include <string>

#include "proofs/check_contact/record.hpp"

namespace slipproof::test {

/// Whether the checker accepts a certificate.
inline bool accepted(const std::string& certificate) {
  using Kind = check_contact::ContactVerdict::Kind;
  return check_contact::checked_on_record(certificate).kind == Kind::accepted;
}

/// `accepted`, or why not. What it does not know, and what is no certificate, is `unreadable`.
std::string second_reading(const std::string& certificate);

}  // namespace slipproof::test
