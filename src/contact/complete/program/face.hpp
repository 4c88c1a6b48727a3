// Multipliers at a border of what proves: conditions that hold with equality, exactly.
#pragma once

#include "contact/complete/program/pattern_program.hpp"

namespace slipproof {

/// The conditions that multipliers of a form satisfy with equality, up to rounding, as linear equations for them, each
/// with its right side last. Those of a circle of forces are not linear, and are left out.
class MultiplierFace {
 public:
  MultiplierFace(const ExactContacts& exact, const FloatingContacts& contacts, const ContactPattern& pattern,
                 const ContactForm& form, std::span<const double> y);

  const RationalMatrix& equations() const { return equations_; }

 private:
  void add_value();
  void add_velocities(std::size_t contact);
  void add_forces(std::size_t contact);
  void add_arc_of_forces(std::size_t contact);
  void require_velocity(std::size_t first, std::span<const Rational> direction);
  void require_force(std::size_t normal, const std::array<Rational, 3>& force);

  const ExactContacts& exact_;
  const FloatingContacts& contacts_;
  const ContactPattern& pattern_;
  const std::span<const double> y_;
  std::vector<Rational> f_, h_;  ///< the form
  std::vector<double> v_, g_;    ///< what is left of it for velocities, and for forces
  RationalMatrix equations_;
};

}  // namespace slipproof
