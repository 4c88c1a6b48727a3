// The equations of a mode without those that follow from others, and without unknowns that they leave open.
#pragma once

#include <Eigen/Dense>

#include "contact/complete/motion/equations.hpp"

namespace slipproof {

/// The places that are not left out.
std::vector<std::size_t> all_but(std::size_t count, const std::vector<bool>& without);

/// As many equations as unknowns, and an approximate inverse of their derivative. Linear equations that are
/// combinations of others, constants included, are dropped, rather those of contacts that touch; forces of these are
/// held at 0, and others where pivots of the derivative at a zero leave them open.
class ModeSquare {
 public:
  ModeSquare(const ExactContacts& contacts, const ContactPattern& mode, const std::vector<bool>& touching);

  /// False if the derivative is singular still.
  bool pin(const Eigen::MatrixXd& derivative, const std::vector<double>& zero);
  /// Whether an unknown is the force of a contact that touches, which is 0.
  bool is_touching(std::size_t unknown) const;

  const ExactContacts& contacts;
  const ContactPattern& mode;
  const std::vector<bool>& touching;
  const ModeUnknowns unknowns;
  const std::vector<ModeEquation<Rational>> equations;
  std::vector<DependentEquation> dropped;
  std::vector<std::size_t> kept, left;  ///< equations and unknowns
  std::vector<double> sizes;            ///< of the unknowns, powers of 2
  RationalMatrix inverse;               ///< rows for `left`, columns for `kept`

 private:
  struct Scaled;

  bool invert(const Scaled& scaled);
  std::vector<double> sizes_at(const std::vector<double>& zero) const;
  void drop_dependent();
  std::vector<std::size_t> linear_equations() const;
};

}  // namespace slipproof
