// Which modes of a mechanism are consistent, at many points at once: the exact kernel's answer at nearly the speed of
// binary64.
//
//   const MechanismBatch batch(mechanism);
//   const MechanismAnswers answers = batch.modes_at({.parameters = {12, 2.0, inertias}, .tan_halves = {0.5}, .load =
//   loads}); answers.at(17, mode) == ModeAt::strict
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "floating/filter/batch.hpp"
#include "mechanics/scene/problem.hpp"

namespace slipproof {

class ModeCode;

/// Points of a mechanism, taken exactly: a number of each, or one for all.
struct MechanismColumns {
  std::vector<Column> parameters;  ///< in the order of the mechanism; no number: not given
  std::vector<Column> tan_halves;  ///< tan(angle/2) of each angle
  Column load;                     ///< no number: a mechanism without one
};

/// Boundary: consistent, and no solution meets all conditions strictly. Unsure: of a point that was left.
enum class ModeAt : std::uint8_t { inconsistent, boundary, strict, unsure };

/// What becomes of points at which binary64 is not sure of all modes: the kernel decides them, or they are left.
enum class Unsure : std::uint8_t { decided, left };

struct MechanismAnswers {
  std::size_t modes = 0;
  std::vector<ModeAt> status;  ///< of each point all modes
  TierCounts tiers{};          ///< how many points were decided by which

  ModeAt at(std::size_t point, std::size_t mode) const { return status[point * modes + mode]; }
};

/// A mechanism made ready. May be used by several threads.
class MechanismBatch {
 public:
  /// The mechanism must outlive the batch. Takes the file's states, or these. `given`: whether each parameter has a
  /// value. Throws InputError where it has more than max_modes modes.
  explicit MechanismBatch(const Mechanism& mechanism);
  MechanismBatch(const Mechanism& mechanism, std::vector<ElementKind::Start> starts, std::vector<bool> given);
  ~MechanismBatch();

  /// In the order of enumeration.
  const std::vector<MechanismMode>& modes() const { return modes_; }
  /// Whether each parameter has a value.
  const std::vector<bool>& given() const { return given_; }
  /// Null for a mechanism that only the exact kernel does.
  const ModeCode* code() const { return code_.get(); }

  /// All modes at all points, which need not be in the domain. All columns have the same length, or 1; throws
  /// std::invalid_argument otherwise, and NoValue, NumberError for a point that has none.
  MechanismAnswers modes_at(const MechanismColumns& points, Unsure unsure = Unsure::decided) const;

 private:
  struct Points;
  void pass_on(const Points& points, std::size_t point, Unsure unsure, MechanismAnswers& answers) const;

  const Mechanism* mechanism_;
  ProblemMaker maker_;
  std::vector<ElementKind::Start> starts_;
  std::vector<bool> given_;
  std::vector<MechanismMode> modes_;
  std::unique_ptr<const ModeCode> code_;
};

}  // namespace slipproof
