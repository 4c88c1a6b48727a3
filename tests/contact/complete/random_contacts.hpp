// Contact problems in rational numbers: of a rigid body on some contacts, or of any matrix.
#pragma once

#include <array>
#include <random>

#include "contact/complete/contacts.hpp"

namespace slipproof {

using Vector3 = std::array<Rational, 3>;

inline Vector3 cross_product(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A body of mass 1 with its main axes along those of the scene.
struct ContactBody {
  Vector3 inertia{1, 1, 1};
  std::array<Rational, 6> acceleration;            ///< without contacts
  std::vector<Vector3> points;                     ///< from its centre of mass
  std::vector<std::array<Vector3, 3>> directions;  ///< of each contact: the normal, and two tangents
  std::vector<Rational> mu;

  void add(const Vector3& point, const Rational& friction,
           const std::array<Vector3, 3>& axes = {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}}) {
    points.push_back(point);
    directions.push_back(axes);
    mu.push_back(friction);
  }

  ExactContacts contacts() const {
    std::vector<std::array<Rational, 6>> rows;
    for (std::size_t k = 0; k < points.size(); ++k) {
      for (const Vector3& d : directions[k]) {
        const Vector3 moment = cross_product(points[k], d);
        rows.push_back({d[0], d[1], d[2], moment[0], moment[1], moment[2]});
      }
    }
    ExactContacts result{3, RationalMatrix(rows.size(), std::vector<Rational>(rows.size())), {}, mu};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Rational& q = result.q.emplace_back();
      for (std::size_t m = 0; m < 6; ++m) q += rows[i][m] * acceleration[m];
      for (std::size_t j = 0; j < rows.size(); ++j) {
        for (std::size_t m = 0; m < 6; ++m) {
          result.W[i][j] += rows[i][m] * rows[j][m] / (m < 3 ? Rational(1) : inertia[m - 3]);
        }
      }
    }
    return result;
  }
};

/// Cubes of mass 1 and side 2 on each other, each on its four corners, under gravity 1; the topmost one is pushed along
/// the first tangent. Contact 4 b + c is corner c of cube b.
inline ExactContacts stack(std::size_t boxes, const Rational& mu, const Rational& push) {
  const std::size_t n = 12 * boxes;
  RationalMatrix rows(n, std::vector<Rational>(6 * boxes));
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t box = i / 12, corner = i / 3 % 4, axis = i % 3;
    Vector3 d{};
    d[axis == 0 ? 2 : axis - 1] = 1;
    for (std::size_t own = box == 0 ? box : box - 1; own <= box; ++own) {
      const Rational sign(own == box ? 1 : -1);
      const Vector3 moment = cross_product({corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, -sign}, d);
      for (std::size_t m = 0; m < 3; ++m) {
        rows[i][6 * own + m] = sign * d[m];
        rows[i][6 * own + 3 + m] = sign * moment[m];
      }
    }
  }
  ExactContacts result{3, RationalMatrix(n, std::vector<Rational>(n)), std::vector<Rational>(n),
                       std::vector<Rational>(4 * boxes, mu)};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t b = 0; b < boxes; ++b) result.q[i] -= rows[i][6 * b + 2];
    result.q[i] += push * rows[i][6 * (boxes - 1)];
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t m = 0; m < 6 * boxes; ++m) {
        result.W[i][j] +=
            rows[i][m] * rows[j][m] * (m % 6 < 3 ? Rational(1) : Rational(3, 2));  // 2/3 is a cube's inertia
      }
    }
  }
  return result;
}

class RandomContacts {
 public:
  explicit RandomContacts(std::uint64_t seed) : engine_(seed) {}

  /// A multiple of 1 / denominator up to `size`.
  Rational number(int size, int denominator = 64) { return Rational(whole(size * denominator), denominator); }
  int whole(int size) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(2 * size + 1)) - size; }

  /// On contacts whose normals point up, more or less.
  ExactContacts body(std::size_t contacts, int most_mu = 1) {
    ContactBody result;
    for (Rational& x : result.inertia) x = abs(number(1)) + Rational(1, 4);
    for (Rational& x : result.acceleration) x = number(2);
    result.acceleration[2] -= 1;
    for (std::size_t k = 0; k < contacts; ++k) {
      const Vector3 point{number(2), number(2), number(2)};
      result.add(point, abs(number(most_mu)), turned(8, whole(4), whole(4), whole(8)));
    }
    return result.contacts();
  }

  ExactContacts any(std::size_t dimension, std::size_t contacts, int size, int denominator) {
    const std::size_t n = dimension * contacts;
    ExactContacts result{dimension, RationalMatrix(n, std::vector<Rational>(n)), {}, std::vector<Rational>(contacts)};
    for (auto& row : result.W) {
      for (Rational& x : row) x = number(size, denominator);
    }
    for (std::size_t i = 0; i < n; ++i) result.q.push_back(number(size, denominator));
    for (Rational& m : result.mu) {
      if (dimension > 1) m = abs(number(1, 4));
    }
    return result;
  }

  /// The same with a constant for which some forces r_N >= 0, r_T = 0 leave no velocity.
  void let_rest(ExactContacts& contacts) {
    std::vector<Rational> r(contacts.size());
    for (std::size_t k = 0; k < contacts.contacts(); ++k) r[contacts.normal(k)] = abs(number(2, 2));
    for (std::size_t i = 0; i < r.size(); ++i) {
      contacts.q[i] = 0;
      for (std::size_t j = 0; j < r.size(); ++j) contacts.q[i] -= contacts.W[i][j] * r[j];
    }
  }

  /// B^T B, of the rank of B.
  ExactContacts symmetric(std::size_t dimension, std::size_t contacts, std::size_t rank, int size, int denominator) {
    ExactContacts result = any(dimension, contacts, size, denominator);
    RationalMatrix B(rank, std::vector<Rational>(result.size()));
    for (auto& row : B) {
      for (Rational& x : row) x = number(size, denominator);
    }
    for (std::size_t i = 0; i < result.size(); ++i) {
      for (std::size_t j = 0; j < result.size(); ++j) {
        result.W[i][j] = 0;
        for (const auto& row : B) result.W[i][j] += row[i] * row[j];
      }
    }
    return result;
  }

 private:
  /// The normal and the tangents of a contact on the floor, turned by a quaternion.
  static std::array<Vector3, 3> turned(const Rational& w, const Rational& x, const Rational& y, const Rational& z) {
    const Rational n = w * w + x * x + y * y + z * z;
    return {{{2 * (x * z + w * y) / n, 2 * (y * z - w * x) / n, (w * w - x * x - y * y + z * z) / n},
             {(w * w + x * x - y * y - z * z) / n, 2 * (x * y + w * z) / n, 2 * (x * z - w * y) / n},
             {2 * (x * y - w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z + w * x) / n}}};
  }

  std::mt19937_64 engine_;
};

/// The velocities of a motion in the units of the problem, before it was scaled.
inline std::vector<Rational> in_given_units(const std::vector<Rational>& u, const std::vector<Rational>& units) {
  std::vector<Rational> result;
  for (std::size_t i = 0; i < u.size(); ++i) result.push_back(u[i] * units[i]);
  return result;
}

}  // namespace slipproof
