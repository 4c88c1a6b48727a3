// Which modes of a mechanism are consistent, at many points at once: the exact kernel's answer at nearly the speed of
// binary64.
//
//   const MechanismBatch batch(mechanism);
//   const MechanismAnswers answers = batch.modes_at({.parameters = {12, 2.0, inertias}, .tan_halves = {0.5}, .load =
//   loads}); answers.at(17, mode) == ModeAt::strict
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string_view>
#include <vector>

#include "floating/batch/column.hpp"
#include "mechanics/points/problem.hpp"

namespace slipproof {

class ModeCode;
struct BlockCode;

/// Points of a mechanism. Each column has one number for each point, or one for all, taken exactly or as the nearest
/// binary64 of what is meant.
struct MechanismColumns {
  std::vector<Column> parameters;  ///< in the order of the mechanism; empty: the parameter is not given
  std::vector<Column> tan_halves;  ///< tan(angle/2) of each angle
  Column load;                     ///< empty: the mechanism has no load
};

/// Boundary: consistent, but no solution meets all conditions strictly. Unsure: the point was left undecided.
enum class ModeAt : std::uint8_t { inconsistent, boundary, strict, unsure };

/// What to do with points at which binary64 is not sure of all modes: let the kernel decide them, or leave them.
enum class Unsure : std::uint8_t { decided, left };

/// Which tier decided, the fastest first.
enum class Tier : std::uint8_t { filter, exact };
inline constexpr std::size_t tier_count = 2;
std::string_view name(Tier tier);
using TierCounts = std::array<std::uint64_t, tier_count>;

struct MechanismAnswers {
  std::size_t modes = 0;
  std::vector<ModeAt> status;  ///< for each point, the status of every mode
  TierCounts tiers{};          ///< how many points each tier decided

  ModeAt at(std::size_t point, std::size_t mode) const { return status[point * modes + mode]; }
};

/// A mechanism, compiled for many points. May be used by several threads.
class MechanismBatch {
 public:
  /// The mechanism must outlive the batch. Uses the states before the motion from the mechanism's file unless `starts`
  /// is given. `given`: whether each parameter has a value. Throws InputError if there are more than max_modes modes.
  explicit MechanismBatch(const Mechanism& mechanism);
  MechanismBatch(const Mechanism& mechanism, std::vector<ElementKind::Start> starts, std::vector<bool> given);
  ~MechanismBatch();

  /// In the order of enumeration.
  const std::vector<MechanismMode>& modes() const { return modes_; }
  /// Whether each parameter has a value.
  const std::vector<bool>& given() const { return given_; }
  const ProblemMaker& maker() const { return maker_; }
  /// Null if only the exact kernel can solve the mechanism.
  const ModeCode* code() const { return code_.get(); }

  /// The number of points. Throws std::invalid_argument unless exactly the given parameters have a column, and each
  /// column has 1 number or as many as there are points.
  std::size_t count(const MechanismColumns& points) const;

  /// The status of all modes at all points, which need not be in the domain. Throws as count(); NoValue and NumberError
  /// for a point that has no value. A column may be rounded only with Unsure::left, because the kernel takes numbers as
  /// they are.
  MechanismAnswers modes_at(const MechanismColumns& points, Unsure unsure = Unsure::decided) const;

  /// The values of a point, taken exactly, without its load. Throws NumberError.
  MechanismValues values_at(const MechanismColumns& points, std::size_t point) const;
  /// Decides the modes at a point by the kernel.
  void decide(const MechanismColumns& points, std::size_t point, std::span<ModeAt> modes) const;

  /// The code for blocks of points where some inputs are constant; compiled at the first call. Requires code().
  const BlockCode& block_code(const std::vector<bool>& constant) const;

 private:
  const Mechanism* mechanism_;
  ProblemMaker maker_;
  std::vector<ElementKind::Start> starts_;
  std::vector<bool> given_;
  std::vector<MechanismMode> modes_;
  std::unique_ptr<const ModeCode> code_;
  mutable std::mutex mutex_;
  mutable std::map<std::vector<bool>, std::unique_ptr<const BlockCode>> blocks_;
};

}  // namespace slipproof
