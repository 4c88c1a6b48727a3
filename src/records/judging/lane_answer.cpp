#include "records/judging/lane_answer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace slipproof {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A lower bound on the magnitude of a number that is known only by its bounds.
Lanes least(const RunningError& x) {
  return absolute(x.value) * (1 - 0x1p-50) - x.error;
}

Lanes larger(const Lanes& x, const Lanes& y) {
  return chosen(y > x, y, x);
}

/// An upper bound on the relative error of an answer; `scale` is a lower bound on the yardstick of its kind without
/// this component. A component that varies is divided by the answer where it is surely left open, and by the smaller of
/// the two where that is unsure.
Lanes relative_error(const RunningError& answer, const RunningError& exact, const Lanes& scale, bool varies,
                     const LaneBits& open) {
  constexpr double up = 1 + 0x1p-48;
  const RunningError difference = answer - exact;
  const Lanes distance = (absolute(difference.value) + difference.error) * up;
  Lanes unit = least(exact);
  if (varies) {
    const Lanes own = least(answer);
    unit = chosen(open, larger(own, scale), chosen(own < unit, own, unit));
  } else {
    unit = chosen(surely_zero(exact), scale, unit);
  }
  const LaneBits both_zero = surely_zero(answer) & surely_zero(exact);
  const Lanes relative = chosen(unit > 0, distance / unit * up, Lanes{} + infinite);
  return chosen(both_zero, Lanes{}, relative);
}

/// The larger one; infinite where one of them is NaN.
Lanes worse(const Lanes& x, const Lanes& y) {
  return chosen((x == x) & (y == y), larger(x, y), Lanes{} + infinite);
}

/// Lower bounds on the yardsticks of all kinds that need no solution; 0 where nothing is sure.
std::vector<Lanes> least_yardsticks(const ModeRun& run, const ModePrograms& programs) {
  const MechanismKinds& kinds = programs.kinds;
  std::vector<Lanes> sizes(kinds.count);
  // Divides by the sum of the coefficients: it is at least the largest one, and NaN if one is not known.
  const auto over = [&](const Lanes& x, const std::vector<TapeRef>& coefficients) {
    Lanes sum{};
    for (const TapeRef ref : coefficients) sum += absolute(run.at(ref).value) + run.at(ref).error;
    const Lanes quotient = x / (sum * (1 + 0x1p-40)) * (1 - 0x1p-50);
    // The bound is far above the range in which digits are lost.
    return chosen((sum > 0) & (quotient > 0x1p-900), quotient, Lanes{});
  };
  const auto constant = [&](std::size_t line) { return least(run.at(programs.line_constants[line])); };
  for (std::size_t i = 0; i < kinds.lines.size(); ++i) {
    sizes[kinds.lines[i]] = larger(sizes[kinds.lines[i]], constant(i));
  }
  for (std::size_t i = 0; i < kinds.inertias.size(); ++i) {
    Lanes& size = sizes[kinds.inertias[i].kind];
    for (const auto& place : kinds.inertias[i].places) {
      size = larger(size, over(constant(place.first), programs.inertias[i]));
    }
  }
  std::vector<Lanes> result = sizes;
  for (std::size_t i = 0; i < kinds.levers.size(); ++i) {
    Lanes& size = result[kinds.levers[i].kind];
    size = larger(size, over(sizes[kinds.levers[i].of], programs.levers[i]));
  }
  return result;
}

/// The answers of some rows in one field; all records have the field, or none has.
struct LaneAnswer {
  RunningError value;
  LaneBits present{};
};

/// The free forces of a mode, computed from the forces in an answer.
class FreeForces {
 public:
  explicit FreeForces(std::size_t free) : free_(free) {}

  /// Uses a force of the answer that depends on the free forces.
  void take(const LaneForm& form, const LaneAnswer& answer) {
    asked_ |= answer.present;
    const RunningError rest = answer.value - form.constant;
    if (free_ == 1) {
      const RunningError value = rest / form.slopes[0];
      put(values_[0], value, answer.present & ~known_);
      known_ |= answer.present;
    } else if (free_ == 2) {
      take_of_two(form, rest, answer.present);
    }
  }

  /// Records whose answers contain nothing about the free forces, or determine all of them.
  LaneBits settled() const { return ~asked_ | known_; }
  LaneBits asked() const { return asked_; }
  std::span<const RunningError> values() const { return std::span(values_).first(std::min<std::size_t>(free_, 2)); }

 private:
  static void put(RunningError& to, const RunningError& from, const LaneBits& mask) {
    to.value = chosen(mask, from.value, to.value);
    to.error = chosen(mask, from.error, to.error);
  }

  /// Keeps the first force; the next independent one then determines both free forces.
  void take_of_two(const LaneForm& form, const RunningError& rest, const LaneBits& present) {
    const RunningError &x = form.slopes[0], &y = form.slopes[1];
    const RunningError determinant = first_[0] * y - first_[1] * x;
    const LaneBits solves = present & has_first_ & ~known_ & surely_not_zero(determinant);
    put(values_[0], (first_rest_ * y - first_[1] * rest) / determinant, solves);
    put(values_[1], (first_[0] * rest - first_rest_ * x) / determinant, solves);
    known_ |= solves;
    const LaneBits is_first = present & ~has_first_;
    put(first_[0], x, is_first);
    put(first_[1], y, is_first);
    put(first_rest_, rest, is_first);
    has_first_ |= is_first;
  }

  std::size_t free_;
  LaneBits asked_{}, known_{}, has_first_{};
  std::array<RunningError, 2> values_{}, first_{};
  RunningError first_rest_;
};

/// The answers of some rows.
class AnswersOfRows {
 public:
  AnswersOfRows(const RecordBlock& block, std::span<const std::uint16_t> rows, std::size_t first_answer)
      : block_(block), rows_(rows), first_(first_answer) {}

  LaneAnswer at(std::size_t answer) const {
    const std::size_t field = first_ + answer;
    LaneAnswer result;
    if (!block_.present()[field]) return result;
    result.present = ~LaneBits{};
    const std::span<const double> numbers = block_.numbers(field);
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
      result.value.value[lane] = numbers[rows_[std::min(lane, rows_.size() - 1)]];
    }
    if (block_.rounded(field)) {
      result.value.error = absolute(result.value.value) * batch_rounding + batch_underflow;
    }
    return result;
  }

 private:
  const RecordBlock& block_;
  std::span<const std::uint16_t> rows_;
  std::size_t first_;
};

}  // namespace

Lanes answer_errors(const RecordBlock& block, std::span<const std::uint16_t> rows, const RecordFields& fields,
                    const ModePrograms& programs, std::size_t mode, const ModeRun& run, const ModeRun::Values& values) {
  const ModeProgram& program = programs.programs[mode];
  const AnswersOfRows answers(block, rows, fields.first_answer());
  FreeForces free(program.free);
  Lanes error{};
  std::vector<LaneAnswer> forces;
  for (std::size_t i = 0; i < program.forces.size(); ++i) {
    forces.push_back(answers.at(fields.accelerations() + i));
    if (program.forces[i].varies()) free.take(values.forces[i], forces.back());
  }
  LaneBits inside = free.settled();
  for (const LaneForm& condition : values.conditions) {
    inside &= ~free.asked() | surely_not_negative(condition.at(free.values()));
  }
  const std::vector<Lanes> yardsticks = least_yardsticks(run, programs);
  const auto compare = [&](const LaneAnswer& answer, const RunningError& exact, std::size_t kind,
                           const SolvedForm& form, const LaneForm& at) {
    LaneBits open{};
    for (std::size_t k = 0; k < free.values().size(); ++k) open |= surely_not_zero(at.slopes[k]);
    const Lanes relative = relative_error(answer.value, exact, yardsticks[kind], form.varies(), open);
    error = worse(error, chosen(answer.present, relative, Lanes{}));
  };
  for (std::size_t i = 0; i < program.accelerations.size(); ++i) {
    const LaneForm& at = values.accelerations[i];
    compare(answers.at(i), at.constant, programs.kinds.accelerations[i], program.accelerations[i], at);
  }
  for (std::size_t i = 0; i < program.forces.size(); ++i) {
    const LaneForm& at = values.forces[i];
    compare(forces[i], at.at(free.values()), programs.kinds.forces[i], program.forces[i], at);
  }
  return chosen(inside, error, Lanes{} + infinite);
}

}  // namespace slipproof
