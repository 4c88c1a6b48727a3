// Certifying records several at once in vector registers: what judge() finds, where its first tier certifies.
#pragma once

#include <array>
#include <cstdint>

#include "floating/filter/lane_numbers.hpp"
#include "records/certify/judge.hpp"

namespace slipproof {

/// As many records are held side by side.
inline constexpr std::size_t lane_records = 256;

struct LaneRecords {
  std::size_t count = 0;
  /// By Field, of those that records have. Rows lie in different lines of a cache for each field.
  std::array<std::array<double, lane_records + 8>, field_count> numbers{};
  std::array<std::uint8_t, lane_records> modes;  ///< that the solver claims; no_mode
  std::array<ForceKind, lane_records> kinds;
};

/// Negative for no, anything else for yes; as long as the numbers, for the sake of vectors.
using LaneMarks = std::array<std::int64_t, lane_records>;

/// The one mode of each scene and a bound on the answer's error in it, as the first tier finds them; no_mode for what
/// judge() has to look at.
struct CertifiedLanes {
  /// Whether record i is certified here within the tolerance, as judge() would; it is put into `judgement` then.
  bool certified(std::size_t i, double tolerance, RecordJudgement& judgement) const;

  std::array<std::uint8_t, lane_records> modes;
  std::array<double, lane_records> errors;
};

/// Records that all have the same fields.
class LaneJudge {
 public:
  /// `present` are the fields that a record has, `own` those that do not come from `base`. The other ones are held in
  /// LaneRecords, too.
  LaneJudge(std::uint32_t present, std::uint32_t own, const Record& base);

  /// Whether it can decide anything; answers() is for those that can.
  bool able() const { return able_; }
  void answers(const LaneRecords& records, CertifiedLanes& found) const;

 private:
  using Rows = std::array<std::uint16_t, lane_records>;

  void inside(const LaneRecords& records, LaneMarks& marks) const;
  ForcedScene<LaneNumbers> scenes(const LaneRecords& records, const std::uint16_t* rows, std::size_t count,
                                  ForceKind kind) const;
  void find_modes(const LaneRecords& records, const Rows& rows, std::size_t count, ForceKind kind,
                  CertifiedLanes& found) const;
  void bound_errors(const LaneRecords& records, const Rows& rows, std::size_t count, ForceKind kind, unsigned mode,
                    CertifiedLanes& found) const;

  bool has(Field f) const { return (present_ & bit(f)) != 0; }

  std::uint32_t present_;
  bool exact_, able_;
};

}  // namespace slipproof
