// The motions that a search has found.
#pragma once

#include "contact/complete/closing.hpp"

namespace slipproof {

/// What is known to exist, in the order in which it was found, and the place of each: where u is in all motions that
/// count as this one.
class MotionList {
 public:
  static constexpr int near_bits = 16;      ///< what is within 2^-16 of a motion may count as it
  static constexpr int continuum_bits = 4;  ///< and what is within 2^-4, where forces are open

  /// Keeps motions in `found`, which must outlive it.
  explicit MotionList(CompleteSolutions& found) : found_(found) {}

  /// Unless it may be one of the list, or is the third of one mode in a continuum.
  void add(SpatialMotion&& motion);
  /// Forgets all others.
  void keep_only(SpatialMotion&& motion);
  /// Whether the list needs no motion of this mode with these velocities, up to rounding: it is one of the list, or the
  /// third of its mode in a continuum.
  bool is_known(const ContactPattern& mode, std::span<const double> u) const;
  const VelocityBox& place(std::size_t motion) const { return places_[motion]; }
  /// Lets all motions with these velocities count as this one.
  void count_as(std::size_t motion, const VelocityBox& others) { places_[motion].add(others); }
  /// Whether forces that are open move the body differently: another motion of its mode is known near it.
  bool is_in_continuum(std::size_t motion) const;
  /// At the end: joins places that overlap, keeps of each continuum what stands for nodes and one that differs, and
  /// sets `within`.
  void settle();

 private:
  bool join_two_places();
  void forget_what_stands_for_nothing();
  void keep(const std::vector<bool>& kept);
  std::vector<Rational> reach(std::size_t motion) const;

  CompleteSolutions& found_;
  std::vector<VelocityBox> places_;
};

}  // namespace slipproof
