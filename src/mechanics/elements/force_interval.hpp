// Sets of forces: exact intervals with open and closed ends.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/number/affine.hpp"
#include "base/number/rational.hpp"

namespace slipproof {

/// A convex set of rational forces: empty, a point, an interval, a half line or the whole line.
class ForceInterval {
 public:
  ForceInterval() = default;  ///< the whole line
  static ForceInterval nothing();
  static ForceInterval point(Rational force);
  /// No value: infinite. An interval with nothing in it becomes nothing().
  static ForceInterval between(std::optional<Rational> lower, bool lower_closed, std::optional<Rational> upper,
                               bool upper_closed);
  /// An open interval; without a value, an end is infinite.
  static ForceInterval open_between(std::optional<Rational> lower, std::optional<Rational> upper);

  bool empty() const { return empty_; }
  bool is_point() const { return !empty_ && lower_ && upper_ && *lower_ == *upper_; }
  bool contains(const Rational& force) const;
  const std::optional<Rational>& lower() const { return lower_; }
  const std::optional<Rational>& upper() const { return upper_; }
  bool lower_closed() const { return lower_closed_; }
  bool upper_closed() const { return upper_closed_; }

  /// Keeps the forces where condition(F) >= 0, or > 0 if strict.
  void restrict_to(const Affine<Rational>& condition, bool strict);
  void intersect(const ForceInterval& other);
  /// The interval without its ends; a point becomes empty.
  ForceInterval interior() const;
  /// The simplest rational inside that is not an end, or the point; the interval must not be empty.
  Rational sample() const;

  bool operator==(const ForceInterval&) const = default;

 private:
  void settle();
  void clear();

  std::optional<Rational> lower_, upper_;
  bool lower_closed_ = false, upper_closed_ = false;
  bool empty_ = false;
};

/// The forces of `from` that are not in `what`: at most two intervals for each of them, those below `what` first.
std::vector<ForceInterval> difference(const std::vector<ForceInterval>& from, const ForceInterval& what);

/// `[1/2, 3)`, `(-oo, 0]`, `{5}`, `{}`.
std::string to_string(const ForceInterval& interval);

}  // namespace slipproof
