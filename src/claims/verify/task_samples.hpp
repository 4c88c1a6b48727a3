// The claims of a paper at samples, and along one line.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "claims/judge/tally.hpp"
#include "claims/lines/line.hpp"
#include "claims/verify/paper_tasks.hpp"

namespace slipproof {

/// The samples begin, ... end - 1 of a setting, given by its index.
struct SamplePiece {
  std::size_t setting;
  std::uint64_t begin, end;
};

/// All samples of all settings that claims are judged in.
std::vector<SamplePiece> sample_pieces(const PaperTasks& tasks);

/// The tallies of the tasks that say something of the samples, for add_tallies().
std::string judge_samples(const PaperTasks& tasks, const SamplePiece& piece);
/// `tallies` are by task.
void add_tallies(std::string_view judged, std::vector<Tally>& tallies);

Tally judge_line(const PaperTasks& tasks, const ClaimTask& task, const Line& line);

/// The claim at numbers that something else found, if they are a bicycle: values of the parameters, and of cosines and
/// sines, by their names. Others are passed over.
void judge_at(const PaperTasks& tasks, const ClaimTask& task, const NamedValues& numbers, Tally& tally);

}  // namespace slipproof
