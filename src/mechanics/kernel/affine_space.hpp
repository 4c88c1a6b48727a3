// The solutions of linear equations, added one at a time: each equation fixes one more unknown.
//
// Gauss-Jordan elimination that keeps the solved form: each fixed unknown is an affine form in the free ones. The load
// is eliminated last, so that equations without a free unknown fix the load. A mode extends the space that it shares
// with modes of the same first states, so no equation is eliminated twice.
#pragma once

#include <vector>

#include "mechanics/elements/friction_problem.hpp"

namespace slipproof {

class AffineSpace {
 public:
  /// The whole space: all unknowns and the load are free. In a problem without a load, the load is 0.
  AffineSpace(std::size_t unknowns, bool has_load);
  /// The space of one solution that is affine in the load; with a value of the load, a single point.
  AffineSpace(std::vector<AffineForm> solution, const std::optional<Rational>& load);

  /// Adds the equation form = 0. False if no load is left for which it has a solution; the space is of no use then.
  bool require(const AffineForm& form);

  /// The form on the space: its coefficients of unknowns that are fixed are 0, and so is that of a fixed load.
  AffineForm on(const AffineForm& form) const;

  /// The affine form of a fixed variable.
  const AffineForm& fixed(std::size_t variable) const { return fixed_[variable]; }
  bool is_free(std::size_t variable) const { return free_[variable]; }
  /// The free unknowns, in order, without the load.
  std::vector<std::size_t> free_unknowns() const;
  std::size_t unknowns() const { return free_.size() - 1; }
  /// The dimension of the solutions for one load.
  std::size_t dimension() const { return dimension_; }
  bool load_is_free() const { return free_.back(); }
  /// The only load that is left; it must not be free.
  const Rational& load() const { return fixed_.back().constant; }

 private:
  void fix(std::size_t variable, AffineForm form);

  std::vector<bool> free_;
  std::vector<AffineForm> fixed_;  ///< empty for free variables
  std::size_t dimension_;
};

/// A form in the free unknowns of a space, given as `free`, and the load.
AffineForm compressed(const AffineSpace& space, const std::vector<std::size_t>& free, const AffineForm& form);

/// Values of forms where all free variables are 0.
std::vector<Rational> at_origin(const AffineSpace& space, const std::vector<AffineForm>& forms);

/// The form `load - value` over this number of unknowns.
AffineForm load_minus(const Rational& value, std::size_t unknowns);

/// Whether a form has no coefficient, of an unknown; it may still depend on the load.
bool is_free_of_unknowns(const AffineForm& form);
bool is_constant(const AffineForm& form);

}  // namespace slipproof
