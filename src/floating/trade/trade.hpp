// Speed against accuracy over the number types, measured.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "floating/filter/filter.hpp"

namespace slipproof {

class Crew;

struct TradeOptions {
  std::size_t scenes = 300;  ///< for each workload, > 0
  std::uint64_t seed = 1;
  double seconds = 0.02;  ///< CPU time for each measurement of speed, at least; nothing else depends on it
  unsigned threads = 0;   ///< for the errors; 0: all cores. Speed is that of one
};

/// Where the numbers come from.
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
  std::optional<int> threshold_bits;  ///< k, where the forces are at a relative distance of 2^-k from a threshold
};

/// What one number type did on one workload.
struct TradeRow {
  std::string workload, type;
  std::size_t scenes = 0;
  double scenes_per_second = 0;  ///< on one thread, of 500 scenes at most; bringing them into the type does not count
  std::size_t wrong = 0;         ///< scenes whose set of consistent modes is decided, and not the exact one
  std::size_t undecided = 0;     ///< filter: scenes its first tier passes on; others: NaN or a division by 0 in the way
  TierCounts tiers{};            ///< filter and exact alone: which tier decided how many scenes
  std::size_t judged = 0;        ///< scenes whose errors count: modes right, and of the motion there is one
  double worst_acceleration = 0;  ///< largest relative error of a
  double worst_force = 0;         ///< the same of S2, S3, N2, N3
  double digits_lost = 0;         ///< decimal digits of the type that the worst of all these has lost
  double condition = 1;           ///< condition number of that quantity; infinite beyond binary64

  double worst() const { return std::max(worst_acceleration, worst_force); }
};

/// Digits lost against the condition number, over all workloads.
struct Cancellation {
  std::string type;
  int decade = 0;               ///< condition numbers from 10^decade to 10^(decade + 1)
  std::size_t quantities = 0;   ///< so many accelerations and forces
  double digits_lost = 0;       ///< by the worst of them
  double mean_digits_lost = 0;  ///< by all of them
};

struct Trade {
  TradeOptions options;
  Machine machine;
  std::vector<TradeWorkload> workloads;
  std::vector<TradeType> types;
  std::vector<TradeRow> rows;               ///< every type on every workload, in this order of workloads and types
  std::vector<Cancellation> cancellations;  ///< by type, then by decade; decades from 0 to 40, where there are any

  /// The filter gave the exact answer to every scene.
  bool sound() const;
};

/// `progress(done, all)` is called after each measurement. Everything but scenes_per_second depends on the options
/// alone: a crew whose service is trade_answer() shares it out. Then rank 0 measures speed, while the others wait.
Trade measure_trade(const TradeOptions& options, const std::function<void(std::size_t, std::size_t)>& progress = {},
                    Crew* crew = nullptr);
std::string trade_answer(const TradeOptions& options, std::string_view request);

}  // namespace slipproof
