// The equations of motion (equations.hpp) reduced to what is solved: in each contact mode two equations in two
// unknowns, without a division, over any commutative ring. Tests hold the kernel's motions of mechanism `bicycle`
// against these.
//
// With mu = r2/r1, I0 = I1 mu^2 + I2, and e = 1 for an external force, 0 for an internal one: the chain gives eps1 =
// mu eps2 + (1 - mu) phi, the sprocket's equation T = (I1 eps1 - F L)/r1. With both in the rear wheel's equation and
// in the pitch equation, less mu times the former,
//
//   M a     = S2 + S3 - e F
//   M a_y   = M g - N2 - N3
//   I0 eps2 + k phi = mu L F - R S2                                                   k = mu (1 - mu) I1
//   I3 eps3         = -R S3
//   k eps2 + Jt phi = b2 N2 - b3 N3 - h (S2 + S3) - mu L F + e (L + h) F              Jt = J + (1 - mu)^2 I1
//
// The code keeps r1^2 I0 = A, r1^2 k = K, r1^2 Jt = B, so that no division is needed. A wheel that sticks has R eps =
// a - h phi, so R^2 S3 = -I3 (a - h phi), and the like for S2; one that slips has S = -+ f N; one that lifts S = N =
// 0. So each S is an affine function of a, and of one more unknown y:
//
//   both on the road  y = N2   N2 = y            N3 = M g - y      phi = 0   a_y = 0
//   front lifts       y = phi  N2 = M (g - b2 y) N3 = 0            phi = y   a_y = b2 y
//   rear lifts        y = phi  N2 = 0            N3 = M (g + b3 y) phi = y   a_y = -b3 y
//   both lift         y = phi  N2 = 0            N3 = 0            phi = y   a_y = g
//
// The equation along x and the pitch equation are left in (a, y). A wheel that does not stick has eps from its own
// equation, divided by its inertia; where the rear one slips or lifts, the pitch equation is multiplied by A to put
// that eps2 in. Cramer's rule gives a and y over the determinant D of the two equations, and every other quantity
// over D times something positive. F enters linearly, so that it may be a symbol (alpha + beta F): each condition is
// then (alpha + beta F)/(D positive) >= 0, a half line of forces, all of them or none, and a mode is consistent on
// one interval. A mode is singular iff D = 0, or a wheel without inertia (I3 = 0, or I1 = I2 = 0) does not stick: its
// eps is then free.
#pragma once

#include <array>
#include <utility>

#include "support/bicycle/contact_mode.hpp"
#include "support/bicycle/reduced_dynamics.hpp"

namespace slipproof {

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
  /// Left-hand side of one of the mode's conditions, times something positive and the determinant.
  V condition_numerator(const Condition& condition) const;

 private:
  /// alpha a + beta y + sigma S = gamma: what the contact state says of a wheel's tangential force. What is not there
  /// is zero.
  struct WheelLaw {
    T alpha{}, beta{}, gamma{}, sigma{};
    bool has_alpha = false, has_beta = false, has_gamma = false;  ///< what is not there is zero
  };

  bool sticks(Wheel w) const { return mode_[w] == WheelState::stick; }
  bool lifted(Wheel w) const { return mode_[w] == WheelState::lift; }
  bool on_road() const { return mode_.on_road(); }
  bool airborne() const { return lifted(Wheel::rear) && lifted(Wheel::front); }

  WheelLaw wheel_law(Wheel w) const;
  void solve();
  void set_forces();

  V vertical() const;
  V gap(Wheel w) const;
  V spin_numerator(Wheel w) const;
  T spin_unit(Wheel w) const;
  V slip(Wheel w) const;  ///< over spin_unit() and the determinant

  const ReducedDynamics<T, V>& d_;
  ContactMode mode_;
  T rear_sigma_{}, front_sigma_{};
  T determinant_{};
  // Numerators over the determinant; y is N2 with both wheels on the road, else phi. S2 and S3 are over sigma too.
  V a_{}, y_{};
  V N2_{}, N3_{}, S2_{}, S3_{};
  V rolling_{};  ///< a - h phi
};

template <class T, class V>
typename ReducedMotion<T, V>::WheelLaw ReducedMotion<T, V>::wheel_law(Wheel w) const {
  const bool rear = w == Wheel::rear;
  WheelLaw law;
  if (sticks(w)) {
    law.has_alpha = true;
    law.alpha = rear ? d_.A : d_.I3;
    law.sigma = rear ? d_.rho_RR : d_.RR;
    law.has_beta = !on_road();
    if (law.has_beta) law.beta = rear ? d_.KR_hA : T(-d_.hI3);
  } else if (lifted(w)) {
    law.sigma = T(1);
  } else {
    // sigma S = -direction fn N, with N = y, weight - y, weight - M b2 y, weight + M b3 y.
    const bool forward = mode_[w] == WheelState::slip_forward;
    law.sigma = d_.fd;
    law.has_beta = true;
    if (on_road()) {
      law.beta = forward == rear ? d_.fn : T(-d_.fn);
    } else {
      const T slope = d_.fn * (rear ? d_.b2M : d_.b3M);
      law.beta = forward == rear ? T(-slope) : slope;
    }
    law.has_gamma = !(on_road() && rear);
    if (law.has_gamma) law.gamma = forward ? T(-d_.friction_weight) : d_.friction_weight;
  }
  return law;
}

template <class T, class V>
void ReducedMotion<T, V>::solve() {
  const WheelLaw rear = wheel_law(Wheel::rear), front = wheel_law(Wheel::front);
  const bool stick = sticks(Wheel::rear);

  // Along x: M a = S2 + S3 + thrust, the tangential forces replaced by the wheel laws.
  const T sigmas = rear.sigma * front.sigma;
  T x_a = d_.M * sigmas;
  if (rear.has_alpha) x_a = x_a + front.sigma * rear.alpha;
  if (front.has_alpha) x_a = x_a + rear.sigma * front.alpha;
  T x_y(0);
  if (rear.has_beta) x_y = front.sigma * rear.beta;
  if (front.has_beta) x_y = x_y + rear.sigma * front.beta;
  V x_0 = sigmas * d_.thrust;
  if (stick) x_0 = x_0 + front.sigma * d_.R_drive;
  if (rear.has_gamma) x_0 = x_0 + V(T(front.sigma * rear.gamma));
  if (front.has_gamma) x_0 = x_0 + V(T(rear.sigma * front.gamma));

  // Pitch: K eps2 + B phi = rho (b2 N2 - b3 N3 - h (S2 + S3)) + overturn, times what removes the fractions.
  const T factor = stick ? d_.R : T(d_.A * rear.sigma);
  const T scaled = stick ? d_.rho_R : T(d_.A_rho * rear.sigma);
  T p_a = scaled * d_.hM;
  T p_y(0);
  V p_0 = factor * d_.overturn + T(scaled * d_.h) * d_.thrust;
  if (on_road()) {
    p_y = -(scaled * d_.base);
    p_0 = p_0 - V(T(scaled * d_.b3_weight));
  } else if (!lifted(Wheel::rear)) {
    p_y = scaled * T(d_.b2M * d_.b2);
    p_0 = p_0 + V(T(scaled * d_.b2_weight));
  } else if (!lifted(Wheel::front)) {
    p_y = scaled * T(d_.b3M * d_.b3);
    p_0 = p_0 - V(T(scaled * d_.b3_weight));
  }
  if (stick) {
    p_a = p_a + d_.K;
    if (!on_road()) p_y = p_y + d_.RB_hK;
  } else {
    if (!on_road()) p_y = p_y + rear.sigma * d_.AB_KK;
    if (rear.has_beta) p_y = p_y + d_.K_rho_R * rear.beta;
    p_0 = p_0 - T(d_.K * rear.sigma) * d_.drive;
    if (rear.has_gamma) p_0 = p_0 + V(T(d_.K_rho_R * rear.gamma));
  }

  determinant_ = x_a * p_y - x_y * p_a;
  a_ = p_y * x_0 - x_y * p_0;
  y_ = x_a * p_0 - p_a * x_0;
  rear_sigma_ = rear.sigma;
  front_sigma_ = front.sigma;
  set_forces();
}

template <class T, class V>
void ReducedMotion<T, V>::set_forces() {
  const bool road = on_road();
  rolling_ = road ? a_ : V(a_ - d_.h * y_);
  if (!airborne()) {
    const V weight(T(d_.weight * determinant_));
    if (road) {
      N2_ = y_;
      N3_ = weight - y_;
    } else if (!lifted(Wheel::rear)) {
      N2_ = weight - d_.b2M * y_;
    } else {
      N3_ = weight + d_.b3M * y_;
    }
  }
  if (sticks(Wheel::rear)) {
    S2_ = determinant_ * d_.R_drive - d_.A * rolling_;
    if (!road) S2_ = S2_ - d_.KR * y_;
  } else if (!lifted(Wheel::rear)) {
    S2_ = (slip_direction(mode_.rear) > 0 ? T(-d_.fn) : d_.fn) * N2_;
  }
  if (sticks(Wheel::front)) {
    S3_ = T(-d_.I3) * rolling_;
  } else if (!lifted(Wheel::front)) {
    S3_ = (slip_direction(mode_.front) > 0 ? T(-d_.fn) : d_.fn) * N3_;
  }
}

/// Over the determinant; with both wheels off the road, over M determinant.
template <class T, class V>
V ReducedMotion<T, V>::vertical() const {
  if (on_road()) return V(T(0));
  if (airborne()) return V(T(d_.weight * determinant_));
  return lifted(Wheel::front) ? V(d_.b2 * y_) : V(T(-d_.b3) * y_);
}

/// As vertical().
template <class T, class V>
V ReducedMotion<T, V>::gap(Wheel w) const {
  if (!lifted(w)) return V(T(0));
  const bool rear = w == Wheel::rear;
  if (!airborne()) return (rear ? d_.base : T(-d_.base)) * y_;
  return (rear ? d_.b2M : T(-d_.b3M)) * y_ - V(T(d_.weight * determinant_));
}

template <class T, class V>
V ReducedMotion<T, V>::spin_numerator(Wheel w) const {
  if (sticks(w)) return rolling_;
  if (w == Wheel::front) return T(-d_.R) * S3_;
  V moment = T(rear_sigma_ * determinant_) * d_.drive - d_.rho_R * S2_;
  if (!on_road()) moment = moment - T(d_.K * rear_sigma_) * y_;
  return moment;
}

/// What eps times the determinant is over.
template <class T, class V>
T ReducedMotion<T, V>::spin_unit(Wheel w) const {
  if (sticks(w)) return d_.R;
  return w == Wheel::rear ? T(d_.A * rear_sigma_) : T(d_.I3 * front_sigma_);
}

template <class T, class V>
V ReducedMotion<T, V>::slip(Wheel w) const {
  if (sticks(w)) return V(T(0));
  if (w == Wheel::front) return spin_unit(w) * rolling_ + d_.RR * S3_;
  return spin_unit(w) * rolling_ - d_.R * spin_numerator(w);
}

template <class T, class V>
Quotient<V, T> ReducedMotion<T, V>::quantity(Quantity q) const {
  const T& D = determinant_;
  const auto vertical_unit = [&] { return airborne() ? T(d_.M * D) : D; };
  switch (q) {
    case Quantity::a:
      return {a_, D};
    case Quantity::a_y:
      return {vertical(), vertical_unit()};
    case Quantity::phi:
      return {on_road() ? V(T(0)) : y_, D};
    case Quantity::eps2:
      return {spin_numerator(Wheel::rear), T(spin_unit(Wheel::rear) * D)};
    case Quantity::eps3:
      return {spin_numerator(Wheel::front), T(spin_unit(Wheel::front) * D)};
    case Quantity::S2:
      return {S2_, T(rear_sigma_ * D)};
    case Quantity::S3:
      return {S3_, T(front_sigma_ * D)};
    case Quantity::N2:
      return {N2_, D};
    case Quantity::N3:
      return {N3_, D};
    case Quantity::gap2:
      return {gap(Wheel::rear), vertical_unit()};
    case Quantity::gap3:
      return {gap(Wheel::front), vertical_unit()};
    case Quantity::slip2:
      return {slip(Wheel::rear), T(spin_unit(Wheel::rear) * D)};
    case Quantity::slip3:
      return {slip(Wheel::front), T(spin_unit(Wheel::front) * D)};
  }
  return {V(T(0)), T(1)};
}

template <class T, class V>
V ReducedMotion<T, V>::condition_numerator(const Condition& c) const {
  const bool rear = c.wheel == Wheel::rear;
  const V &N = rear ? N2_ : N3_, &S = rear ? S2_ : S3_;
  const T& sigma = rear ? rear_sigma_ : front_sigma_;
  switch (c.kind) {
    case StateCondition::pushes:
      return N;
    case StateCondition::opens:
      return gap(c.wheel);
    case StateCondition::slips_forward:
      return slip(c.wheel);
    case StateCondition::slips_backward:
      return -slip(c.wheel);
    case StateCondition::holds_forward:
      return T(d_.fn * sigma) * N - d_.fd * S;
    default:
      return T(d_.fn * sigma) * N + d_.fd * S;
  }
}

}  // namespace slipproof
