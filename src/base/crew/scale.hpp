// Predicts how long a crew of many ranks would take, from measurements on few.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace slipproof {

/// What was measured, in seconds and bytes.
struct MeasuredWork {
  std::vector<double> requests;  ///< the time in which one core answers each timed request
  double bytes = 0;              ///< of a result, on average
  double handling = 0;           ///< time of rank 0 for one result of any size: taking it and handing out the next
  double seconds_a_byte = 0;     ///< of rank 0: to receive and to take a byte of a result
  double alone = 0;              ///< what rank 0 does by itself before and after
  double latency = 2e-6;         ///< of a message
  std::uint64_t count = 0;       ///< requests there would be; those measured are drawn from, again and again
};

/// What keeps more cores from making it faster.
enum class Bottleneck : std::uint8_t {
  none,     ///< the cores are busy
  rank_0,   ///< handing out and taking results
  alone,    ///< what only rank 0 does
  longest,  ///< the requests that take longest, or too few of them
};
/// As a sentence has it: `the cores`, `rank 0`, ...
std::string_view name(Bottleneck bottleneck);

struct PredictedRun {
  double seconds = 0;
  double efficiency = 0;  ///< the time of one core, over this time and the number of cores
  Bottleneck bottleneck = Bottleneck::none;
};

/// Plays a crew of so many cores, a rank each with two requests on the way, event by event; the requests' times are
/// drawn from a seed, the same in each run. Takes O(count log cores). At least one measured request, and one core.
PredictedRun predict(const MeasuredWork& work, std::uint64_t cores, std::uint64_t seed = 1);

}  // namespace slipproof
