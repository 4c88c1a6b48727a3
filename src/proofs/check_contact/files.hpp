// Checks certificate files about contact problems. check_contact.hpp decides; this loads the files and reports the
// results.
#pragma once

#include <string>
#include <vector>

#include "proofs/check_contact/check_contact.hpp"

namespace slipproof::check_contact {

inline constexpr std::size_t kMaxFile = std::size_t{1} << 28;  ///< bytes

/// Checks a regular file, or standard input for `-`; `required_name` as in check_contact_certificate(). Does not throw
/// for any content or kind of file.
ContactVerdict check_contact_file(const std::string& path, std::string_view required_name = "");

std::string_view to_string(ContactVerdict::Kind kind);

struct ContactReport {
  std::vector<ContactVerdict> verdicts;
  std::string text;     ///< for each file `accepted` and a line in words, or `VERDICT: REASON`
  std::string summary;  ///< a line with the counts, as slipproof-check has it
  int exit_code = 0;    ///< 0 all accepted, 5 some rejected, else 3 some unreadable or missing
};

/// A file may have several certificates, each beginning with the line `slipproof-contact 1`; each gets a verdict. With
/// several files, each line begins with the name; with several certificates in a file, with the name and the first
/// line.
ContactReport check_contact_files(const std::vector<std::string>& paths, std::string_view required_name = "");

}  // namespace slipproof::check_contact
