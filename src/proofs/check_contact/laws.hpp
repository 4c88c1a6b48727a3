// Whether forces and velocities of a contact satisfy its law (FORMAT.md, "Laws"), without roots.
#pragma once

#include "proofs/check_contact/problem.hpp"

namespace slipproof::check_contact {

/// A contact with its force r and its velocity u.
class Contact {
 public:
  Contact(const Problem& problem, std::size_t k, const Vector& x, const Vector& w)
      : problem_(problem), k_(k), first_(problem.normal(k)), x_(x), w_(w) {
    for (std::size_t i = 1; i < problem.dimension; ++i) {
      force += check_contact::square(r(i));
      motion += check_contact::square(u(i));
      product += r(i) * u(i);
    }
  }

  void check() const {
    using Kind = Law::Kind;
    must(u(0).sign() >= 0, "u_N is negative");
    must(r(0).sign() >= 0, "r_N is negative");
    const Kind kind = problem_.law.kind;
    if (kind == Kind::associated) return must(gap().sign() == 0, "r . u is not 0");
    must((r(0) * u(0)).sign() == 0, "neither u_N nor r_N is 0");
    const Number limit = problem_.mu[k_] * r(0);
    if (kind == Kind::coulomb) return coulomb(square(limit));
    if (kind == Kind::diamond) return diamond(limit);
    if (kind == Kind::linear || kind == Kind::soft) return regularised(limit);
    for (std::size_t i = 1; i < problem_.dimension; ++i) bounded(i, kind == Kind::box ? limit : bound(i));
  }

  /// What it lacks to be complementary, for r in the law's convex set: the largest r' . (-u) there, and r . u. The
  /// associated law needs u in the dual cone, fixed bounds u_N >= 0; without friction only the normal parts count.
  Number gap() const {
    must(u(0).sign() >= 0, "u_N is negative");
    must(r(0).sign() >= 0, "r_N is negative");
    const Number square_of_mu = square(problem_.mu[k_]);
    Number result = r(0) * u(0) + product;
    if (problem_.law.is(Law::Kind::associated)) {
      must(force <= square_of_mu * square(r(0)), "the force is outside of the friction cone");
      must(square_of_mu * motion <= square(u(0)), "u_N is less than m |u_T|");
    } else if (problem_.law.is(Law::Kind::fixed)) {
      for (std::size_t i = 1; i < problem_.dimension; ++i) {
        must(abs(r(i)) <= bound(i), "a force is above its bound");
        result += bound(i) * abs(u(i));
      }
    } else {
      must(problem_.mu[k_].sign() == 0, "its law has friction, and is not convex");
      must(force.sign() == 0, "a force is tangential, without friction");
    }
    return result;
  }

 private:
  const Number& r(std::size_t i) const { return x_[first_ + i]; }
  const Number& u(std::size_t i) const { return w_[first_ + i]; }
  const Number& bound(std::size_t i) const { return problem_.law.bounds[(problem_.dimension - 1) * k_ + i - 1]; }
  void must(bool condition, const char* otherwise) const { require(condition, "contact", k_, otherwise); }

  void parallel() const {
    must(problem_.dimension < 3 || (r(1) * u(2) - r(2) * u(1)).sign() == 0, "friction is not parallel to the sliding");
  }

  /// |u_T| r_T = -limit u_T says: if u_T is not 0, r_T is antiparallel to it, and |r_T| is the limit.
  void coulomb(const Number& square_of_limit) const {
    must(force <= square_of_limit, "the force is outside of the friction cone");
    if (motion.sign() == 0) return;
    must(force == square_of_limit, "it slides with a force inside of the friction cone");
    must(product.sign() <= 0, "friction drives the sliding");
    parallel();
  }

  /// Friction of one direction, for itself.
  void bounded(std::size_t i, const Number& limit) const {
    must(abs(r(i)) <= limit, "a force is above its bound");
    must(u(i).sign() == 0 || r(i) == (u(i).sign() > 0 ? -limit : limit), "it slides with a force below its bound");
  }

  /// |r_1| + |r_2| <= limit, and r . u is as small as that allows.
  void diamond(const Number& limit) const {
    Number size, fastest;
    for (std::size_t i = 1; i < problem_.dimension; ++i) {
      size += abs(r(i));
      fastest = std::max(fastest, abs(u(i)));
    }
    must(size <= limit, "the force is outside of the pyramid");
    must(product == -(limit * fastest), "another force of the pyramid dissipates more");
  }

  /// linear: r_T max(v_s, |u_T|) = -limit u_T; soft: r_T sqrt(v_s^2 + |u_T|^2) = -limit u_T.
  void regularised(const Number& limit) const {
    const Number speed = square(problem_.law.slip_speed), squares = square(limit) * motion;
    must(product.sign() <= 0, "friction drives the sliding");
    parallel();
    const Number divisor = problem_.law.is(Law::Kind::linear) ? std::max(speed, motion) : speed + motion;
    must(force * divisor == squares, "the force is not that of its velocity");
  }

  const Problem& problem_;
  std::size_t k_, first_;
  const Vector &x_, &w_;
  Number force, motion, product;  ///< |r_T|^2, |u_T|^2, r_T . u_T
};

inline void check_law(const Problem& problem, std::size_t k, const Vector& x, const Vector& w) {
  Contact(problem, k, x, w).check();
}

}  // namespace slipproof::check_contact
