// The motions that a list of all solutions has, in the second reading. Derivatives and products come from differences
// of the equations, which are evaluated as they stand.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "contact/convex/second_words.hpp"

namespace slipproof::test::second {

struct Interval {
  Q low, high;
};

inline Interval times(const Interval& x, const Interval& y) {
  const std::array<Q, 4> corners{x.low * y.low, x.low * y.high, x.high * y.low, x.high * y.high};
  Interval result{corners[0], corners[0]};
  for (const Q& c : corners) {
    if (c < result.low) result.low = c;
    if (c > result.high) result.high = c;
  }
  return result;
}
inline Interval times(const Q& a, const Interval& x) {
  return times(Interval{a, a}, x);
}
inline Q largest(const Interval& x) {
  return -x.low > x.high ? Q(-x.low) : x.high;
}

struct Listed {
  bool exact = false;
  Vec r;
  std::vector<std::string> modes;
  std::vector<std::size_t> first;  ///< unknown of each contact
  std::size_t N = 0;
  Vec z, p, P;
  Mat R;
  std::vector<Interval> u;

  bool alone() const { return N == 0 || P[0] > 0; }
};

/// Reads and checks them.
class Motions {
 protected:
  Motions(const Certificate& problem, Words& words) : p_(problem), words_(words), n_(p_.D * p_.K) {}

  bool rubs(std::size_t k) const { return p_.D > 1 && p_.mu[k] != 0; }
  std::size_t row(std::size_t k) const { return p_.D * k; }

  /// What is wrong first waits until all is read.
  void when_read(const std::function<void()>& check) {
    if (no_) return;
    try {
      check();
    } catch (const No& why) {
      no_ = why;
    }
  }

  void eliminate(const Mat& B) {
    for (std::size_t i = 0; i < p_.F; ++i) {
      for (std::size_t j = 0; j < p_.F; ++j) {
        Q sum;
        for (std::size_t k = 0; k < p_.F; ++k) sum += B[i][k] * p_.A[k][j];
        need(sum == (i == j ? 1 : 0), "inverse");
      }
    }
    // The velocities for no force, and for each force of 1.
    const auto velocities = [&](std::size_t j) {
      Vec x(p_.n);
      if (j < n_) x[p_.F + j] = 1;
      const Vec w = p_.motion(x);
      for (std::size_t i = 0; i < p_.F; ++i) {
        for (std::size_t k = 0; k < p_.F; ++k) x[i] -= B[i][k] * w[k];
      }
      const Vec all = p_.motion(x);
      for (std::size_t i = 0; i < p_.F; ++i) need(all[i] == 0, "free row");
      return Vec(all.begin() + static_cast<std::ptrdiff_t>(p_.F), all.end());
    };
    q_ = velocities(n_);
    W_.assign(n_, Vec(n_));
    for (std::size_t j = 0; j < n_; ++j) {
      const Vec u = velocities(j);
      for (std::size_t i = 0; i < n_; ++i) W_[i][j] = u[i] - q_[i];
    }
  }

  Vec velocities(const Vec& r) const {
    Vec u = q_;
    for (std::size_t i = 0; i < n_; ++i) u[i] += second::dot(W_[i], r);
    return u;
  }

  void read_motion() {
    words_.expect("motion");
    Listed& m = motions_.emplace_back();
    m.exact = words_.take("exact");
    if (m.exact) {
      m.r = words_.numbers(n_);
      when_read([&] { check_exact(m); });
      return;
    }
    words_.expect("box");
    words_.expect("modes");
    for (std::size_t k = 0; k < p_.K; ++k) {
      const std::string mode = words_.next();
      const bool known = mode == "open" || (rubs(k) ? mode == "stick" : mode == "closed") ||
                         (rubs(k) && (p_.D == 3 ? mode == "slide" : mode == "slide+" || mode == "slide-"));
      if (!known) throw Garbled();
      m.modes.push_back(mode);
      m.first.push_back(m.N);
      m.N += mode == "open" ? 0 : mode == "stick" ? p_.D : mode == "slide" ? 4 : 1;
    }
    m.z = words_.named("center", m.N);
    m.p = words_.named("radius", m.N);
    m.P = words_.named("alone", m.N);
    words_.expect("inverse");
    m.R = words_.entries(m.N, m.N);
    when_read([&] { check_box(m); });
  }

  void check_exact(Listed& m) const {
    const Vec u = velocities(m.r);
    for (std::size_t k = 0; k < p_.K; ++k) {
      const Q &N = m.r[row(k)], &gap = u[row(k)];
      need(N >= 0 && gap >= 0 && (N == 0 || gap == 0), "normal");
      Q force2, speed2, power;
      for (std::size_t i = row(k) + 1; i < row(k) + p_.D; ++i) {
        force2 += m.r[i] * m.r[i], speed2 += u[i] * u[i], power += m.r[i] * u[i];
      }
      // Friction dissipates the most that it can.
      const Q limit2 = p_.mu[k] * p_.mu[k] * N * N;
      need(force2 <= limit2 && power <= 0 && power * power == limit2 * speed2, "friction");
    }
    for (const Q& x : u) m.u.push_back({x, x});
  }

  Vec forces(const Listed& m, const Vec& z) const {
    Vec r(n_);
    for (std::size_t k = 0; k < p_.K; ++k) {
      const std::string& mode = m.modes[k];
      const std::size_t f = m.first[k], i = row(k);
      if (mode != "open") r[i] = z[f];
      for (std::size_t t = 1; t < p_.D; ++t) {
        if (mode == "stick") r[i + t] = z[f + t];
        if (mode == "slide") r[i + t] = -p_.mu[k] * z[f] * z[f + t];
        if (mode == "slide+") r[i + t] = -p_.mu[k] * z[f];
        if (mode == "slide-") r[i + t] = p_.mu[k] * z[f];
      }
    }
    return r;
  }

  Vec equations(const Listed& m, const Vec& z) const {
    const Vec u = velocities(forces(m, z));
    Vec result;
    for (std::size_t k = 0; k < p_.K; ++k) {
      const std::string& mode = m.modes[k];
      const std::size_t f = m.first[k], i = row(k);
      if (mode == "open") continue;
      result.push_back(u[i]);
      for (std::size_t t = 1; t < p_.D && mode == "stick"; ++t) result.push_back(u[i + t]);
      if (mode != "slide") continue;
      for (std::size_t t = 1; t < 3; ++t) result.push_back(u[i + t] - z[f + 3] * z[f + t]);
      result.push_back(z[f + 1] * z[f + 1] + z[f + 2] * z[f + 2] - 1);
    }
    return result;
  }

  void check_box(Listed& m) const {
    for (const Q& P : m.P) need(P >= 0 && (P > 0) == (m.P[0] > 0), "alone");
    const auto at = [&](Vec z, std::size_t j, int step) {
      if (j < m.N) z[j] += step;
      return z;
    };
    const Vec f = equations(m, m.z), zero = equations(m, Vec(m.N));
    Mat J(m.N, Vec(m.N));
    Vec bend(m.N), far(m.N);
    for (std::size_t j = 0; j < m.N; ++j) {
      const Vec up = equations(m, at(m.z, j, 1)), down = equations(m, at(m.z, j, -1));
      const Vec one = equations(m, at(Vec(m.N), j, 1)), minus = equations(m, at(Vec(m.N), j, -1));
      for (std::size_t i = 0; i < m.N; ++i) {
        J[i][j] = (up[i] - down[i]) / 2;
        const Q b = absolute(one[i] + minus[i] - 2 * zero[i]) / 2;
        bend[i] += b * m.p[j] * m.p[j], far[i] += b * m.P[j] * m.P[j];
      }
      for (std::size_t k = 0; k < j; ++k) {
        const Vec other = equations(m, at(Vec(m.N), k, 1)), both = equations(m, at(at(Vec(m.N), k, 1), j, 1));
        for (std::size_t i = 0; i < m.N; ++i) {
          const Q b = absolute(both[i] - one[i] - other[i] + zero[i]);
          bend[i] += b * m.p[j] * m.p[k], far[i] += b * m.P[j] * m.P[k];
        }
      }
    }
    for (std::size_t j = 0; j < m.N; ++j) {
      Q shift, rest, far_rest, spread, far_spread;
      for (std::size_t i = 0; i < m.N; ++i) {
        shift += m.R[j][i] * f[i], rest += absolute(m.R[j][i]) * bend[i], far_rest += absolute(m.R[j][i]) * far[i];
      }
      for (std::size_t k = 0; k < m.N; ++k) {
        Q defect = j == k ? 1 : 0;
        for (std::size_t i = 0; i < m.N; ++i) defect -= m.R[j][i] * J[i][k];
        spread += absolute(defect) * m.p[k], far_spread += absolute(defect) * m.P[k];
      }
      need(spread < m.p[j] && absolute(shift) + spread + rest <= m.p[j], "box");
      need(!m.alone() || (m.p[j] <= m.P[j] && far_spread + 2 * far_rest < m.P[j]), "alone");
    }
    check_conditions(m);
  }

  void check_conditions(Listed& m) const {
    const auto range = [&](std::size_t j) { return Interval{m.z[j] - m.p[j], m.z[j] + m.p[j]}; };
    std::vector<Interval> r(n_);
    for (std::size_t k = 0; k < p_.K; ++k) {
      const std::string& mode = m.modes[k];
      const std::size_t f = m.first[k];
      if (mode != "open") r[row(k)] = range(f);
      for (std::size_t t = 1; t < p_.D; ++t) {
        Interval& friction = r[row(k) + t];
        if (mode == "stick") friction = range(f + t);
        if (mode == "slide") friction = times(-p_.mu[k], times(range(f), range(f + t)));
        if (mode == "slide+") friction = times(-p_.mu[k], range(f));
        if (mode == "slide-") friction = times(p_.mu[k], range(f));
      }
    }
    for (std::size_t i = 0; i < n_; ++i) {
      Interval u{q_[i], q_[i]};
      for (std::size_t j = 0; j < n_; ++j) {
        const Interval part = times(W_[i][j], r[j]);
        u.low += part.low, u.high += part.high;
      }
      m.u.push_back(u);
    }
    for (std::size_t k = 0; k < p_.K; ++k) {
      const std::string& mode = m.modes[k];
      const std::size_t i = row(k);
      need(mode == "open" ? m.u[i].low >= 0 : r[i].low >= 0, "normal");
      need(mode != "slide" || range(m.first[k] + 3).low >= 0, "speed");
      need(mode != "slide+" || m.u[i + 1].low >= 0, "speed");
      need(mode != "slide-" || m.u[i + 1].high <= 0, "speed");
      if (mode != "stick") continue;
      Q force2;
      for (std::size_t t = 1; t < p_.D; ++t) force2 += largest(r[i + t]) * largest(r[i + t]);
      need(force2 <= p_.mu[k] * p_.mu[k] * r[i].low * r[i].low, "cone");
    }
  }

  const Certificate& p_;
  Words& words_;
  std::size_t n_;
  Mat W_;
  Vec q_;
  std::vector<Listed> motions_;
  std::optional<No> no_;
};

}  // namespace slipproof::test::second
