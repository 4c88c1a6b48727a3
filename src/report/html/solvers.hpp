// The verdicts of `certify` on recorded outputs of solvers, file by file.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace slipproof {

/// Counts by RecordVerdict: certified, ambiguous, inaccurate, wrong, invalid, undecided.
struct SolverVerdicts {
  std::string name;  ///< of the file, without its extension
  std::uint64_t records = 0;
  std::array<std::uint64_t, 6> verdicts{};
  /// The number of records that the solver's column `info` calls a success (0) although they are wrong or invalid;
  /// nothing if there is no such column.
  std::optional<std::uint64_t> unfounded;
};

/// Certifies a CSV file with the default tolerance. Throws InputError.
SolverVerdicts certify_solver(const std::filesystem::path& file);

}  // namespace slipproof
