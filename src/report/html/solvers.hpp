// What `certify` says of recorded outputs of solvers, file by file.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace slipproof {

/// certified, ambiguous, inaccurate, wrong, invalid, undecided: RecordVerdict in its order.
struct SolverVerdicts {
  std::string name;  ///< of the file, without its extension
  std::uint64_t records = 0;
  std::array<std::uint64_t, 6> verdicts{};
  /// Records that the solver's own column `info` calls a success (0), and that are wrong or invalid; nothing without
  /// such a column.
  std::optional<std::uint64_t> unfounded;
};

/// Certifies a CSV file with the default tolerance. Throws InputError.
SolverVerdicts certify_solver(const std::filesystem::path& file);

}  // namespace slipproof
