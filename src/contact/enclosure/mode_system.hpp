// The equations of one contact mode, as a square system with one quadratic term for each sliding contact.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "contact/problem/mixed_problem.hpp"

namespace slipproof {

/// `slide_plus` (u_T >= 0) and `slide_minus` are the two ways of sliding in the plane, `slide` is that of space. In the
/// box pyramid each tangential direction sticks or slides independently: the states from `slide_plus_0` on. For mu = 0,
/// and in dimension 1, a closed contact sticks. `touch` is the boundary between open and closed: r = 0 and u_N = 0.
enum class ConeState : std::uint8_t {
  open,
  touch,
  stick,
  slide,
  slide_plus,
  slide_minus,
  slide_plus_0,
  slide_minus_0,
  slide_0_plus,
  slide_0_minus,
  slide_plus_plus,
  slide_plus_minus,
  slide_minus_plus,
  slide_minus_minus
};
std::string_view name(ConeState state);

/// The signs of u in the tangential directions of a state, 0 where it sticks; all 0 for `open`, `touch`, `stick` and
/// `slide`.
std::array<int, 2> slip_signs(ConeState state);

using ConeMode = std::vector<ConeState>;  ///< by contact

/// Component `part` of r - u / scale at a contact, 0 being the normal one. Where x is a solution, r is its projection
/// onto the cone: for the associated law the nearest point of it, for Coulomb's with the normal part kept.
double before_projection(const MixedProblem& problem, std::span<const double> x, std::size_t contact, std::size_t part,
                         double scale);

/// Guesses a mode from `x`: by the part of the cone into which r - u / scale is projected.
ConeMode guess_mode(const MixedProblem& problem, std::span<const double> x, std::span<const double> scales);

/// The problem must outlive it. Unknowns and equations as src/proofs/check_contact/FORMAT.md orders them. With z for
/// the unknowns:
///   F_i(z) = a row of A x + c                         (balance, u_N = 0, u = 0)
///   F_i(z) = the same + s r_T                         (u_T = -s r_T)
///   F_i(z) = r_T1^2 + r_T2^2 - mu^2 r_N^2             (on the cone)
///   F_i(z) = r_T +- mu r_N                            (on the edge of the planar cone, on a face of the box)
/// and in place of u_N = 0, where the associated law slides and so opens, u_N = mu |u_T|:
///   F_i(z) = a row of A x + c - s mu^2 r_N            (|u_T| = s mu r_N)
///   F_i(z) = a row -+ mu the next one                 (in the plane)
class ModeSystem {
 public:
  ModeSystem(const MixedProblem& problem, ConeMode mode);

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  enum class Kind : std::uint8_t { linear, tangential, cone, edge, opening, leaning };
  struct Equation {
    Kind kind = Kind::linear;
    std::size_t row = 0;        ///< row of A, if the equation is one
    std::size_t force = none;   ///< tangential, edge: the unknown r_T; others: the first of the contact's force
    std::size_t slip = none;    ///< tangential, opening: the unknown s
    double mu = 0;              ///< its coefficient; edge, leaning: negative where r_T - mu r_N = 0
    std::size_t normal = none;  ///< edge: the unknown r_N
  };
  struct Entry {
    std::size_t unknown;
    double value;
    double error;  ///< bound on what its rounding changed
  };

  std::size_t size() const { return unknowns_.size(); }
  const ConeMode& mode() const { return mode_; }
  /// The index of an unknown in x; `none` for slips.
  std::size_t place(std::size_t unknown) const { return unknowns_[unknown]; }
  /// The unknown that a component of x is; `none` if it is 0 in this mode.
  std::size_t unknown(std::size_t place) const { return unknown_of_[place]; }
  /// Whether a component of x is 0 in this mode, though it may be an unknown: the force of a contact that touches.
  bool is_zero(std::size_t place) const {
    return unknown_of_[place] == none || (place >= problem_->free && touches(contact_of(place)));
  }
  bool touches(std::size_t contact) const { return mode_[contact] == ConeState::touch; }
  /// The slip of a contact that slides in space.
  std::size_t slip(std::size_t contact) const { return slip_of_[contact]; }
  const std::vector<Equation>& equations() const { return equations_; }

  /// Unknowns at x; slips are what fits u and r best.
  std::vector<double> unknowns_at(std::span<const double> x) const;
  /// x at unknowns.
  std::vector<double> x_at(std::span<const double> z) const;
  /// F_i, exactly; `x` is x_at(z).
  Rational value(std::size_t equation, std::span<const double> z, std::span<const double> x) const;
  /// The same for unknowns that need not be binary64.
  Rational value(std::size_t equation, std::span<const Rational> z) const;
  /// The binary64 nearest to F_i; `x` is x_at(z).
  double nearest_value(std::size_t equation, std::span<const double> z, std::span<const double> x) const;
  /// Row i of the derivative of F, in no order, each unknown once.
  std::vector<Entry> derivative(std::size_t equation, std::span<const double> z) const;
  /// The same without rounding.
  std::vector<std::pair<std::size_t, Rational>> exact_derivative(std::size_t equation,
                                                                 std::span<const Rational> z) const;
  /// Upper bound on the terms of second order in F_i for steps up to `radius`, apart from rounding (a few ulps).
  double second_order(std::size_t equation, std::span<const double> radius) const;

 private:
  std::size_t contact_of(std::size_t place) const { return (place - problem_->free) / problem_->dimension; }
  void add_contact(std::size_t k);
  template <class Row, class At>
  Rational value_of(const Equation& e, const Row& row, const At& at) const;
  std::vector<Entry> leaning_row(const Equation& e) const;

  const MixedProblem* problem_;  ///< a pointer, so that systems can be assigned
  ConeMode mode_;
  std::vector<std::size_t> unknowns_, unknown_of_, slip_of_;
  std::vector<Equation> equations_;
};

}  // namespace slipproof
