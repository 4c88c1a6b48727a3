// A second checker, as a program of its own, that judges the certificates of a paper beside ours: the one of
// proofs/coq, which is proved right. What both accept rests on neither alone.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace slipproof {

/// What the program says of the certificates in a folder and below: `accepted`, `rejected`, ..., by their paths as
/// check::printable shows them. The program gets the folder as its argument and writes a line `VERDICT PATH` for each,
/// and one that begins with `s `, as slipproof-check-verified does. Throws InputError if it cannot be run, if it ends
/// otherwise than with the exit codes 0, 3, 4 and 5, and if its last line is no summary.
std::map<std::filesystem::path, std::string> ask_second_checker(const std::string& program,
                                                                const std::filesystem::path& folder);

}  // namespace slipproof
