// The motions of a body on two contacts by Cramer's rule. A row (x, y, turn) of a contact is what its gap or its slip
// is of the accelerations, and what its force does to the body; with the inverse masses (1, 1, 1/I) two rows have a
// product: what the force of one does to the acceleration of the other.
#include <utility>

#include "mechanics/two_contacts/body.hpp"

namespace slipproof::test::two_contacts {

namespace {

using Row = std::array<Rational, 3>;

Row plus(const Row& a, const Rational& factor, const Row& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

Rational determinant(const Row& a, const Row& b, const Row& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

struct Rows {
  explicit Rows(const Body& body) : inertia(body.inertia), load(body.load) {
    for (std::size_t i = 0; i < 2; ++i) {
      const Body::Contact& c = body.contacts[i];
      const auto& [cosine, sine] = c.normal;
      normal[i] = {cosine, sine, c.x * sine - c.y * cosine};
      tangent[i] = {sine, -cosine, -c.x * cosine - c.y * sine};
      mu[i] = c.mu;
      slides[i] = body.slides(i);
    }
  }

  Rational product(const Row& a, const Row& b) const { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] / inertia; }
  /// The force of a contact that slips one way, per unit of its N.
  Row edge(std::size_t contact, int side) const { return plus(normal[contact], -side * mu[contact], tangent[contact]); }

  Rational inertia;
  Row load;
  std::array<Row, 2> normal, tangent;
  std::array<Rational, 2> mu;
  std::array<bool, 2> slides;
};

int side_of(char state) {
  return state == '+' ? 1 : -1;
}

struct Solution {
  std::vector<Rational> x;
  int sign;  ///< of the determinant
};

/// The x with a x = b, of up to three unknowns; nothing where the determinant is 0.
std::optional<Solution> cramer(const std::vector<std::vector<Rational>>& a, const std::vector<Rational>& b) {
  const std::size_t size = b.size();
  const auto value = [&](std::size_t replaced) {
    std::array<Row, 3> m{Row{1, 0, 0}, Row{0, 1, 0}, Row{0, 0, 1}};
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t k = 0; k < size; ++k) m[i][k] = k == replaced ? b[i] : a[i][k];
    }
    return determinant(m[0], m[1], m[2]);
  };
  const Rational all = value(3);
  if (all.is_zero()) return std::nullopt;
  Solution result{{}, all.sign()};
  for (std::size_t k = 0; k < size; ++k) result.x.push_back(value(k) / all);
  return result;
}

/// What a mode is found to be.
struct Tried {
  bool special = false;      ///< its determinant is 0, or the forces of two that stick end at the edges of both cones
  std::optional<int> index;  ///< of its motion, if there is one
};

/// Both contacts stick: the load is balanced by positive parts along the four edges of the cones. Three of them have
/// one solution, and the fourth edge adds a multiple of what balances itself. The index is 1 less the ends at which a
/// contact leaves its cone while its tangential force falls.
Tried both_stick(const Rows& rows) {
  const std::array<Row, 4> edges{rows.edge(0, 1), rows.edge(0, -1), rows.edge(1, 1), rows.edge(1, -1)};
  const Rational all = determinant(edges[0], edges[1], edges[2]);
  const auto parts = [&](const Row& of) {
    return Row{determinant(of, edges[1], edges[2]) / all, determinant(edges[0], of, edges[2]) / all,
               determinant(edges[0], edges[1], of) / all};
  };
  const Row fixed = parts(plus({}, -1, rows.load)), fourth = parts(edges[3]);
  struct End {
    std::optional<Rational> at;      // of the part along the fourth edge
    std::vector<std::size_t> edges;  // along which there is nothing there
    void meet(const Rational& value, std::size_t edge, int outwards) {
      const int beyond = at ? outwards * Rational(value - *at).sign() : -1;
      if (beyond > 0) return;
      if (beyond < 0) edges.clear();
      at = value;
      edges.push_back(edge);
    }
  };
  End low{Rational(0), {3}}, high;
  for (std::size_t i = 0; i < 3; ++i) {
    if (fourth[i].is_zero()) {
      if (fixed[i].sign() <= 0) return {};
      continue;
    }
    if (fourth[i].sign() < 0) {
      low.meet(fixed[i] / fourth[i], i, -1);
    } else {
      high.meet(fixed[i] / fourth[i], i, 1);
    }
  }
  if (high.at && *low.at >= *high.at) return {};
  const std::array<Rational, 4> gained{-fourth[0], -fourth[1], -fourth[2], Rational(1)};
  const auto unloads = [&](const End& end, int outwards) {
    if (end.edges.empty()) return false;
    const std::size_t edge = end.edges.front(), contact = edge / 2;
    const Rational tangential = rows.mu[contact] * (gained[2 * contact + 1] - gained[2 * contact]);
    return (edge % 2 == 0 ? 1 : -1) * outwards * tangential.sign() < 0;
  };
  const bool special = low.edges.size() > 1 || high.edges.size() > 1;
  return {special, 1 - int{unloads(low, -1)} - int{unloads(high, 1)}};
}

Tried motion_of(const Rows& rows, const std::string& mode) {
  std::vector<Row> asked, forces;  // accelerations that are 0, and forces
  for (std::size_t i = 0; i < 2; ++i) {
    if (mode[i] == 'O') continue;
    asked.push_back(rows.normal[i]);
    forces.push_back(mode[i] == 'S' ? rows.normal[i] : rows.edge(i, side_of(mode[i])));
    if (mode[i] != 'S') continue;
    asked.push_back(rows.tangent[i]);
    forces.push_back(rows.tangent[i]);
  }
  if (asked.size() == 4) return both_stick(rows);
  std::vector<std::vector<Rational>> a;
  std::vector<Rational> b;
  for (const Row& row : asked) {
    a.emplace_back();
    for (const Row& force : forces) a.back().push_back(rows.product(row, force));
    b.push_back(-rows.product(row, rows.load));
  }
  const auto solution = cramer(a, b);
  if (!solution) return {true, {}};
  Row total = rows.load;
  for (std::size_t k = 0; k < forces.size(); ++k) total = plus(total, solution->x[k], forces[k]);
  std::size_t next = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    if (mode[i] == 'O') {
      if (rows.product(rows.normal[i], total).sign() <= 0) return {};
      continue;
    }
    const Rational& pressed = solution->x[next++];
    if (pressed.sign() <= 0) return {};
    if (mode[i] == 'S') {
      const Rational &held = solution->x[next++], limit = rows.mu[i] * pressed;
      if (held >= limit || -held >= limit) return {};
    } else if (!rows.slides[i] && side_of(mode[i]) * rows.product(rows.tangent[i], total).sign() <= 0) {
      return {};
    }
  }
  return {false, solution->sign};
}

}  // namespace

std::optional<Indices> by_cramers_rule(const Body& body) {
  const Rows rows(body);
  for (const Row& tangent : rows.tangent) {
    if (determinant(rows.normal[0], rows.normal[1], tangent).is_zero()) return std::nullopt;
  }
  const bool has_three = !determinant(rows.edge(0, 1), rows.edge(0, -1), rows.edge(1, 1)).is_zero();
  if (body.below == Below::rest && !has_three) return std::nullopt;  // for both_stick()
  Indices result;
  for (const char one : std::string(rows.slides[0] ? "+O" : "S+-O")) {
    for (const char two : std::string(rows.slides[1] ? "+O" : "S+-O")) {
      const std::string mode{one, two};
      const Tried tried = motion_of(rows, mode);
      if (tried.special) return std::nullopt;
      if (tried.index) result.emplace(mode, *tried.index);
    }
  }
  return result;
}

int sum(const Indices& indices) {
  int result = 0;
  for (const auto& [mode, index] : indices) result += index;
  return result;
}

Modes modes_of(const Indices& indices) {
  Modes result;
  for (const auto& [mode, index] : indices) result.insert(mode);
  return result;
}

bool slip_alike(const Body& body) {
  const Rows rows(body);
  const auto slip = [&](const Row& tangent) { return determinant(rows.normal[0], rows.normal[1], tangent).sign(); };
  return slip(rows.tangent[0]) * slip(rows.tangent[1]) > 0;
}

std::vector<Rational> thresholds(const Body& body) {
  const Rows rows(body);
  std::vector<Rational> result;
  const auto add = [&](const Rational& normal, const Rational& tangent) {  // normal - mu tangent vanishes
    if (!tangent.is_zero() && (normal / tangent).sign() > 0) result.push_back(normal / tangent);
  };
  const Row &n = rows.normal[0], &t = rows.tangent[0];
  for (const int side : {1, -1}) {
    add(rows.product(n, n), side * rows.product(n, t));
    add(determinant(n, rows.normal[1], rows.tangent[1]), side * determinant(t, rows.normal[1], rows.tangent[1]));
    for (const int other : {1, -1}) {
      const Row edge = rows.edge(1, other);
      const auto minor = [&](const Row& force) {
        return rows.product(n, force) * rows.product(rows.normal[1], edge) -
               rows.product(n, edge) * rows.product(rows.normal[1], force);
      };
      add(minor(n), side * minor(t));
    }
  }
  return result;
}

}  // namespace slipproof::test::two_contacts
