// What the checker of contact certificates is asked in tests, for another checker to judge alike.
#pragma once

#include <cstdlib>
#include <fstream>
#include <string>

#include "proofs/check_contact/check_contact.hpp"

namespace slipproof::check_contact {

/// Checks a certificate, and adds `VERDICT SIZE` and its text to the file, or pipe, that SLIPPROOF_CHECK_RECORD names,
/// if it names one.
inline ContactVerdict checked_on_record(const std::string& certificate) {
  const ContactVerdict found = check_contact_certificate(certificate);
  static const char* const path = std::getenv("SLIPPROOF_CHECK_RECORD");
  if (path == nullptr) return found;
  using Kind = ContactVerdict::Kind;
  static std::ofstream file(path, std::ios::binary);
  file << (found.kind == Kind::accepted   ? "accepted"
           : found.kind == Kind::rejected ? "rejected"
                                          : "unreadable")
       << ' ' << certificate.size() << '\n'
       << certificate;
  return found;
}

}  // namespace slipproof::check_contact
