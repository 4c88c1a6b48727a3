// A second checker: a separate program that judges the certificates of a paper in addition to ours. The one in
// proofs/coq is proved correct. If both accept a certificate, it does not depend on either one alone.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace slipproof {

/// The program's verdicts on the certificates in a folder and below: `accepted`, `rejected`, ..., by path as
/// check::printable shows it. The program gets the folder as its argument. For each certificate it writes a line
/// `VERDICT PATH`, and at the end a line that begins with `s `, as slipproof-check-verified does. Throws InputError if
/// the program cannot be run, if its exit code is not 0, 3, 4 or 5, or if its last line is not a summary.
std::map<std::filesystem::path, std::string> ask_second_checker(const std::string& program,
                                                                const std::filesystem::path& folder);

}  // namespace slipproof
