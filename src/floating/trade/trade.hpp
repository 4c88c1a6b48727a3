// Measures speed and accuracy of the number types.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "floating/batch/mechanism_batch.hpp"

namespace slipproof {

class Crew;

struct TradeOptions {
  std::size_t scenes = 300;  ///< for each workload, > 0
  std::uint64_t seed = 1;
  double seconds = 0.02;  ///< least CPU time of each measurement of speed; nothing else depends on it
  unsigned threads = 0;   ///< for judging errors; 0: all cores. Speed is measured on one thread
};

/// The machine on which the numbers were measured.
struct Machine {
  std::string processor, compiler, flags;
  unsigned cores = 0;
};
Machine this_machine();

struct TradeType {
  std::string name;  ///< `binary64`, `MPFR 50 digits`, `filter`, `exact`
  int bits = 0;      ///< of the significand; 0 for exact
};

struct TradeWorkload {
  std::string name;
  std::optional<int> threshold_bits;  ///< k, if the forces are at a relative distance of 2^-k from a threshold
};

/// What one number type did on one workload.
struct TradeRow {
  std::string workload, type;
  std::size_t scenes = 0;
  double scenes_per_second = 0;  ///< on one thread, of at most 500 scenes; converting them to the type does not count
  std::size_t wrong = 0;         ///< scenes for which the set of consistent modes was decided incorrectly
  /// Filter: scenes that its first tier passes on; others: scenes with NaN or a division by 0.
  std::size_t undecided = 0;
  TierCounts tiers{};             ///< filter and exact only: how many scenes each tier decided
  std::size_t judged = 0;         ///< scenes whose errors count: the modes are right, and there is exactly one motion
  double worst_acceleration = 0;  ///< largest relative error of a
  double worst_force = 0;         ///< the same of S2, S3, N2, N3
  double digits_lost = 0;         ///< decimal digits of the type that are lost in the worst of these quantities
  double condition = 1;           ///< condition number of that quantity; infinite if it exceeds binary64

  double worst() const { return std::max(worst_acceleration, worst_force); }
};

/// Digits lost against the condition number, over all workloads.
struct Cancellation {
  std::string type;
  int decade = 0;               ///< condition numbers from 10^decade to 10^(decade + 1)
  std::size_t quantities = 0;   ///< number of accelerations and forces
  double digits_lost = 0;       ///< largest number of digits lost
  double mean_digits_lost = 0;  ///< mean number of digits lost
};

/// One number type over all workloads.
struct TradeTotal {
  std::size_t scenes = 0, wrong = 0, undecided = 0;
  double typical_speed = 0, typical_error = 0;  ///< on the first workload
  std::optional<int> first_wrong_bits;          ///< threshold_bits of the first workload with a wrong verdict
};

struct Trade {
  TradeOptions options;
  Machine machine;
  std::vector<TradeWorkload> workloads;
  std::vector<TradeType> types;
  std::vector<TradeRow> rows;  ///< every type on every workload, ordered by workload, then by type
  /// By type, then by decade from 0 to 40; decades without quantities are left out.
  std::vector<Cancellation> cancellations;

  /// Whether the filter gave the exact answer for every scene.
  bool sound() const;
  TradeTotal total(const std::string& type) const;
};

/// Calls `progress(done, all)` after each measurement. All results but scenes_per_second depend only on the options. A
/// crew, whose service must be trade_answer(), shares the work; rank 0 then measures speed while the others wait.
Trade measure_trade(const TradeOptions& options, const std::function<void(std::size_t, std::size_t)>& progress = {},
                    Crew* crew = nullptr);
std::string trade_answer(const TradeOptions& options, std::string_view request);

}  // namespace slipproof
