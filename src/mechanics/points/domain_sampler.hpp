// Points of a mechanism's domain, drawn one symbol after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "mechanics/points/problem.hpp"

namespace slipproof {

/// Which points are wanted.
enum class PointsOf : std::uint8_t {
  domain,     ///< domains of parameters and angles, and [assume]
  realisable  ///< [realisable], too
};

class DomainSampler {
 public:
  /// What is given must outlive the sampler.
  DomainSampler(const Mechanism& mechanism, const ProblemMaker& maker, PointsOf points = PointsOf::domain);

  /// What is known when a symbol gets its value: a parameter, or an angle, for which the value is tan(angle/2).
  struct Drawing {
    int attempt = 0;                         ///< how many values of this symbol broke a condition before
    std::size_t angles = 0, parameters = 0;  ///< so many have their values, the first ones
    bool is_angle = false;
    const MechanismValues* values = nullptr;
    /// values where sides of a condition become equal; none for an angle
    const std::vector<Rational>* roots = nullptr;
    bool fixed = false;  ///< only at the first of them an equation of the domain holds
  };
  using Draw = std::function<Rational(const Drawing&)>;

  enum class Way : std::uint8_t {
    draw,  ///< parameters from the first to the last; where no drawn number is possible, as below
    solve  ///< from the last to the first, each drawn between the roots of the conditions; none is known to the drawing
  };
  /// Angles, then parameters that are given, each so that it breaks no condition that can be decided by then; nothing
  /// if no value of some symbol is found.
  std::optional<MechanismValues> sample(const std::vector<bool>& given, const Draw& draw, Way way = Way::draw) const;

  /// Whether all conditions hold.
  bool contains(const MechanismValues& values) const;

  /// Gives parameters the values that equations of the domain, such as `3*I = m*l^2`, require. For each equation that
  /// does not hold, it changes the last parameter in it that is given and not `kept`.
  void restore(MechanismValues& values, std::size_t kept) const;

 private:
  struct Comparison {
    Program difference;  ///< of both sides
    bool equation;       ///< it must hold, and is one
  };
  struct Roots {
    std::vector<Rational> values;
    bool fixed = false;
  };
  /// Which symbols have their values.
  struct Known {
    std::size_t angles = 0;  ///< the first ones
    std::vector<bool> parameters;
  };
  /// A value of a symbol, or an open interval of values; without an end, infinite.
  struct Place {
    std::optional<Rational> lower, upper;
    Rational inside;
  };
  class Run;

  void add_comparisons(const Expression& condition, bool required = true);
  std::vector<const Program*> conditions(const std::vector<bool>& given) const;
  Known all_known(const MechanismValues& values) const;
  template <class T, class Field = FieldOf<T>>
  Evaluator<T, Field> evaluator(const MechanismValues& values, const Known& known) const;
  std::optional<Rational> root(const Program& difference, const MechanismValues& values, const Known& known,
                               std::size_t unknown) const;
  Roots roots(const MechanismValues& values, const Known& known, std::size_t parameter) const;
  /// Where comparisons change along an unknown symbol: a parameter, or without one the tangent of half of the first
  /// angle that is not known.
  std::vector<Place> places(const MechanismValues& values, const Known& known,
                            std::optional<std::size_t> parameter) const;

  const Mechanism* mechanism_;
  const CompiledMechanism* compiled_;
  PointsOf points_;
  std::vector<Comparison> comparisons_;
};

}  // namespace slipproof
