// The equations of motion reduced to what is solved: in each contact mode two equations in two unknowns, without a
// division, over any commutative ring. MATHEMATICS.md beside this file derives them; tests hold them against
// equations.hpp.
#pragma once

#include <array>

#include "model/bicycle.hpp"
#include "model/contact_mode.hpp"

namespace slipproof {

/// numerator / denominator, kept apart: signs need no division, and rings have none.
template <class V, class T>
struct Quotient {
  V numerator;
  T denominator;
};

/// The bodies without the contacts: sprocket, chain and vertical motion eliminated. T is a ring; V is T, or a module
/// over it such as Affine<T>, in which the force is known.
template <class T, class V>
struct ReducedDynamics {
  T M, R, h, b2, b3;
  T I3;
  T weight;    ///< M g
  T A;         ///< r1^2 I0 = I1 r2^2 + I2 r1^2, (2.7)
  T K;         ///< r1^2 times the coupling of eps2 and phi, (r1 - r2) r2 I1; 0 for mu = 1
  T B;         ///< r1^2 times the pitch inertia, J r1^2 + I1 (r1 - r2)^2; unused without J
  T rho;       ///< r1^2
  T fn, fd;    ///< Coulomb coefficient fn / fd, fd > 0
  V thrust;    ///< force along x: 0, external -F
  V drive;     ///< r1^2 times the moment on the rear wheel, r1 r2 L F
  V overturn;  ///< r1^2 times the moment that pitches the frame
};

/// The force F is given as a V. `road.f` is the numerator of the Coulomb coefficient over `friction_denominator`.
template <class T, class V>
ReducedDynamics<T, V> reduce(const Bicycle<T>& p, const Road<T>& road, ForceKind kind, const V& F,
                             const T& friction_denominator) {
  const T step = p.r1 - p.r2;
  const T rho = p.r1 * p.r1;
  const T arm = p.r1 * p.r2 * p.L;
  const T I1_step = p.I1 * step;
  const bool external = kind == ForceKind::external;
  return {.M = p.M,
          .R = p.R,
          .h = p.h,
          .b2 = p.b2,
          .b3 = p.b3,
          .I3 = p.I3,
          .weight = p.M * road.g,
          .A = p.I1 * p.r2 * p.r2 + p.I2 * rho,
          .K = I1_step * p.r2,
          .B = p.J ? T(*p.J * rho + I1_step * step) : T(0),
          .rho = rho,
          .fn = road.f,
          .fd = friction_denominator,
          .thrust = T(external ? -1 : 0) * F,
          .drive = arm * F,
          .overturn = (external ? T(rho * (p.L + p.h) - arm) : T(-arm)) * F};
}

/// The solution of one contact mode by Cramer's rule. Every quantity is a quotient whose denominator is the
/// determinant times something positive. The mode is regular iff all its denominators are non-zero.
template <class T, class V>
class ReducedMotion {
 public:
  /// A mode with a wheel off the road needs a bicycle with J.
  /// The dynamics must outlive the motion.
  ReducedMotion(const ReducedDynamics<T, V>& dynamics, ContactMode mode) : d_(dynamics), mode_(mode) { solve(); }

  ContactMode mode() const { return mode_; }
  /// Zero: the mode has no motion or a continuum.
  const T& determinant() const { return determinant_; }
  /// A wheel that does not stick and has no inertia spins as it likes: singular whatever the determinant.
  const T& rear_spin_inertia() const { return d_.A; }
  const T& front_spin_inertia() const { return d_.I3; }

  /// Any of the 13 quantities.
  Quotient<V, T> quantity(Quantity q) const;
  /// Left-hand side of one of the mode's conditions, over a denominator with the sign of the determinant.
  Quotient<V, T> condition_value(const Condition& condition) const;

 private:
  /// alpha a + beta y + sigma S = gamma: what the contact state says of a wheel's tangential force.
  struct WheelLaw {
    T alpha, beta, sigma;
    V gamma;
  };
  /// constant + slope y.
  struct InY {
    T constant, slope;
  };

  bool sticks(Wheel w) const { return mode_[w] == ContactState::stick; }
  const WheelLaw& law(Wheel w) const { return w == Wheel::rear ? rear_ : front_; }
  const InY& normal(Wheel w) const { return w == Wheel::rear ? N2_ : N3_; }

  void set_normals();
  WheelLaw wheel_law(Wheel w) const;
  void solve();

  V at_y(const InY& x) const { return V(T(x.constant * determinant_)) + x.slope * y_; }
  V phi() const { return slope_ * y_; }
  V vertical() const;
  V gap(Wheel w) const;
  V tangential(Wheel w) const {
    const WheelLaw& l = law(w);
    return determinant_ * l.gamma - l.alpha * a_ - l.beta * y_;
  }
  Quotient<V, T> spin(Wheel w) const;
  Quotient<V, T> slip(Wheel w) const;

  const ReducedDynamics<T, V>& d_;
  ContactMode mode_;
  InY N2_{}, N3_{};  ///< normal forces; y is N2 with both wheels on the road, else phi
  T slope_{};        ///< phi = slope y
  WheelLaw rear_{}, front_{};
  T determinant_{};
  V a_{}, y_{};  ///< numerators over the determinant
};

template <class T, class V>
void ReducedMotion<T, V>::set_normals() {
  const T zero(0), one(1);
  const bool rear = mode_.rear != ContactState::lift, front = mode_.front != ContactState::lift;
  slope_ = rear && front ? zero : one;
  if (rear && front) {
    N2_ = {zero, one};
    N3_ = {d_.weight, T(-one)};
  } else {
    N2_ = rear ? InY{d_.weight, T(-(d_.M * d_.b2))} : InY{zero, zero};
    N3_ = front ? InY{d_.weight, T(d_.M * d_.b3)} : InY{zero, zero};
  }
}

template <class T, class V>
typename ReducedMotion<T, V>::WheelLaw ReducedMotion<T, V>::wheel_law(Wheel w) const {
  const T zero(0);
  const ContactState state = mode_[w];
  if (state == ContactState::lift) return {zero, zero, T(1), V(zero)};
  if (state == ContactState::stick) {
    if (w == Wheel::front) return {d_.I3, T(-(d_.I3 * d_.h) * slope_), T(d_.R * d_.R), V(zero)};
    return {d_.A, T((d_.K * d_.R - d_.A * d_.h) * slope_), T(d_.rho * d_.R * d_.R), d_.R * d_.drive};
  }
  const T friction = slip_direction(state) > 0 ? d_.fn : T(-d_.fn);
  const InY& N = normal(w);
  return {zero, T(friction * N.slope), d_.fd, V(T(-(friction * N.constant)))};
}

template <class T, class V>
void ReducedMotion<T, V>::solve() {
  set_normals();
  rear_ = wheel_law(Wheel::rear);
  front_ = wheel_law(Wheel::front);

  // Along x: M a = S2 + S3 + thrust, the tangential forces replaced by the wheel laws.
  const T sigmas = rear_.sigma * front_.sigma;
  const T x_a = d_.M * sigmas + front_.sigma * rear_.alpha + rear_.sigma * front_.alpha;
  const T x_y = front_.sigma * rear_.beta + rear_.sigma * front_.beta;
  const V x_0 = sigmas * d_.thrust + front_.sigma * rear_.gamma + rear_.sigma * front_.gamma;

  // Pitch: K eps2 + B phi = rho (b2 N2 - b3 N3 - h (S2 + S3)) + overturn, times what removes the fractions.
  const T moment_0 = d_.b2 * N2_.constant - d_.b3 * N3_.constant;
  const T moment_y = d_.b2 * N2_.slope - d_.b3 * N3_.slope;
  const bool stick = sticks(Wheel::rear);
  const T factor = stick ? d_.R : T(d_.A * rear_.sigma);
  const T scaled = d_.rho * factor;
  T p_a = scaled * d_.h * d_.M;
  T p_y = -(scaled * moment_y);
  V p_0 = V(T(scaled * moment_0)) + factor * d_.overturn + T(scaled * d_.h) * d_.thrust;
  if (stick) {
    p_a = p_a + d_.K;
    p_y = p_y + (d_.R * d_.B - d_.K * d_.h) * slope_;
  } else {
    p_y = p_y + rear_.sigma * (d_.A * d_.B - d_.K * d_.K) * slope_ + d_.K * d_.rho * d_.R * rear_.beta;
    p_0 = p_0 - T(d_.K * rear_.sigma) * d_.drive + T(d_.K * d_.rho * d_.R) * rear_.gamma;
  }

  determinant_ = x_a * p_y - x_y * p_a;
  a_ = p_y * x_0 - x_y * p_0;
  y_ = x_a * p_0 - p_a * x_0;
}

template <class T, class V>
V ReducedMotion<T, V>::vertical() const {
  const bool rear = mode_.rear != ContactState::lift, front = mode_.front != ContactState::lift;
  if (rear && front) return V(T(0));
  if (rear) return d_.b2 * y_;
  if (front) return T(-d_.b3) * y_;
  return V(T(d_.weight * determinant_));  // over M determinant
}

template <class T, class V>
V ReducedMotion<T, V>::gap(Wheel w) const {
  const bool rear = mode_.rear != ContactState::lift, front = mode_.front != ContactState::lift;
  if (w == Wheel::rear ? rear : front) return V(T(0));
  if (rear || front) return (rear ? T(-(d_.b2 + d_.b3)) : T(d_.b2 + d_.b3)) * y_;
  return T(d_.M * (w == Wheel::rear ? d_.b2 : T(-d_.b3))) * y_ - V(T(d_.weight * determinant_));  // over M determinant
}

template <class T, class V>
Quotient<V, T> ReducedMotion<T, V>::spin(Wheel w) const {
  if (sticks(w)) return {a_ - d_.h * phi(), T(d_.R * determinant_)};
  const T& sigma = law(w).sigma;
  if (w == Wheel::front) return {T(-d_.R) * tangential(w), T(d_.I3 * sigma * determinant_)};
  return {T(sigma * determinant_) * d_.drive - T(d_.rho * d_.R) * tangential(w) - T(d_.K * sigma) * phi(),
          T(d_.A * sigma * determinant_)};
}

template <class T, class V>
Quotient<V, T> ReducedMotion<T, V>::slip(Wheel w) const {
  if (sticks(w)) return {V(T(0)), determinant_};
  const Quotient<V, T> eps = spin(w);
  const T ratio = (w == Wheel::rear ? d_.A : d_.I3) * law(w).sigma;
  return {ratio * (a_ - d_.h * phi()) - d_.R * eps.numerator, eps.denominator};
}

template <class T, class V>
Quotient<V, T> ReducedMotion<T, V>::quantity(Quantity q) const {
  const bool airborne = mode_.rear == ContactState::lift && mode_.front == ContactState::lift;
  const T vertical_unit = airborne ? T(d_.M * determinant_) : determinant_;
  switch (q) {
    case Quantity::a:
      return {a_, determinant_};
    case Quantity::a_y:
      return {vertical(), vertical_unit};
    case Quantity::phi:
      return {phi(), determinant_};
    case Quantity::eps2:
      return spin(Wheel::rear);
    case Quantity::eps3:
      return spin(Wheel::front);
    case Quantity::S2:
      return {tangential(Wheel::rear), T(rear_.sigma * determinant_)};
    case Quantity::S3:
      return {tangential(Wheel::front), T(front_.sigma * determinant_)};
    case Quantity::N2:
      return {at_y(N2_), determinant_};
    case Quantity::N3:
      return {at_y(N3_), determinant_};
    case Quantity::gap2:
      return {gap(Wheel::rear), vertical_unit};
    case Quantity::gap3:
      return {gap(Wheel::front), vertical_unit};
    case Quantity::slip2:
      return slip(Wheel::rear);
    case Quantity::slip3:
      return slip(Wheel::front);
  }
  return {V(T(0)), T(1)};
}

template <class T, class V>
Quotient<V, T> ReducedMotion<T, V>::condition_value(const Condition& c) const {
  switch (c.kind) {
    case ConditionKind::normal:
      return quantity(c.wheel == Wheel::rear ? Quantity::N2 : Quantity::N3);
    case ConditionKind::gap:
      return quantity(c.wheel == Wheel::rear ? Quantity::gap2 : Quantity::gap3);
    case ConditionKind::slip: {
      Quotient<V, T> s = slip(c.wheel);
      if (c.state == ContactState::slip_backward) s.numerator = -s.numerator;
      return s;
    }
    case ConditionKind::friction_up:
    case ConditionKind::friction_dn:
      break;
  }
  const T& sigma = law(c.wheel).sigma;
  const V limit = T(d_.fn * sigma) * at_y(normal(c.wheel));
  const V force = d_.fd * tangential(c.wheel);
  return {c.kind == ConditionKind::friction_up ? limit - force : limit + force, T(d_.fd * sigma * determinant_)};
}

}  // namespace slipproof
