// Judges the claims of a paper at samples, and along one line.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "claims/judge/tally.hpp"
#include "claims/verify/paper_tasks.hpp"
#include "mechanics/lines/line.hpp"

namespace slipproof {

/// Samples begin, ..., end - 1 of a setting, given by its index.
struct SamplePiece {
  std::size_t setting;
  std::uint64_t begin, end;
};

/// All samples of all settings that have claims to judge.
std::vector<SamplePiece> sample_pieces(const PaperTasks& tasks);

/// The tallies of the tasks at these samples, for add_tallies().
std::string judge_samples(const PaperTasks& tasks, const SamplePiece& piece);
/// `tallies` are by task.
void add_tallies(std::string_view judged, std::vector<Tally>& tallies);

Tally judge_line(const PaperTasks& tasks, const ClaimTask& task, const Line& line);

/// Judges the claim at numbers that were found in another way, if they are a bicycle: values of the parameters, and of
/// cosines and sines, by name. Skips numbers that are not.
void judge_at(const PaperTasks& tasks, const ClaimTask& task, const NamedValues& numbers, Tally& tally);

}  // namespace slipproof
