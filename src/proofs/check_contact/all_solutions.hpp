// All motions of a problem: a list of them, and a tree of cases without others (FORMAT.md, `all-solutions`).
#pragma once

#include "proofs/check_contact/listed_motion.hpp"

namespace slipproof::check_contact {

/// Numbers at one contact; the tangential ones that the dimension does not have are 0.
struct AtContact {
  Number normal;
  Direction tangential;
};

inline AtContact at_contact(const Reduced& problem, const Vector& numbers, std::size_t k) {
  const std::size_t normal = problem.dimension * k;
  AtContact result{numbers[normal], {}};
  for (std::size_t t = 1; t < problem.dimension; ++t) result.tangential[t - 1] = numbers[normal + t];
  return result;
}

/// 1: v . u > 0 for all velocities u that the state allows; 0: v . u >= 0; -1: it may be negative.
inline int over_velocities(const State& state, const AtContact& v) {
  using Kind = State::Kind;
  if (state.kind == Kind::stick) return 0;
  if (state.kind == Kind::slip)
    return std::min(dot(v.tangential, state.from).sign(), dot(v.tangential, state.to).sign());
  if (dot(v.tangential, v.tangential).sign() > 0) return -1;
  return state.kind == Kind::closed ? 0 : std::min(v.normal.sign(), 0);
}

/// The same for g . r and all forces of the friction cone but 0.
inline int over_cone(const Number& mu, const AtContact& g) {
  if (g.normal.sign() < 0) return -1;
  return (square(g.normal) - square(mu) * dot(g.tangential, g.tangential)).sign();
}

/// The same for g . r and all forces r that the state allows. Where it slips these are r_N (1, -mu d), and g_T . d is
/// greatest along g_T, or at an end of the arc.
inline int over_forces(const State& state, const Number& mu, const AtContact& g) {
  using Kind = State::Kind;
  if (state.kind == Kind::open) return 0;
  if (state.kind == Kind::any) return std::min(over_cone(mu, g), 0);
  const bool arc = state.kind == Kind::slip;
  const bool inside = cross(state.from, g.tangential).sign() > 0 && cross(g.tangential, state.to).sign() > 0;
  if (!arc || inside) return over_cone(mu, g);
  const auto end = [&](const Direction& d) { return (g.normal - mu * dot(g.tangential, d)).sign(); };
  return std::min(end(state.from), end(state.to));
}

/// f . u + h . r >= least.
struct Bound {
  Row f, h;
  Number least;
};

/// Reads the tree depth first and judges it on the way; what is wrong first is kept until all is read.
class AllSolutions {
 public:
  AllSolutions(const Problem& problem, Reader& reader) : problem_(problem), reader_(reader) {
    const std::size_t motions = reader.count();
    const Matrix inverse = problem.free > 0 ? reader.entries("eliminated", problem.free, problem.free) : Matrix();
    judge([&] { problem.require_coulomb(); });
    judge([&] { reduced_ = Reduced(problem, inverse); });
    while (motions_.size() < motions) {
      ListedMotion& motion = motions_.emplace_back(problem, reader);
      judge("motion", motions_.size() - 1, [&] { motion.check(problem, reduced_); });
    }
    pattern_.resize(problem.contacts());
    read_tree();
  }

  std::string established() const {
    if (rejected_) throw Rejected(*rejected_);
    const std::string count = std::to_string(motions_.size());
    if (motions_.empty()) return "no motion at all";
    if (motions_.size() == 1) return "one motion and no other";
    return are_different() ? count + " motions and no others" : "at least one motion and at most " + count;
  }

 private:
  using Kind = State::Kind;

  /// What is still to be read: a case, or that all cases of a contact are.
  struct Pending {
    std::size_t contact;
    State state;
    bool node = true;
  };

  template <class Check>
  void judge(const Check& check) {
    if (rejected_) return;
    try {
      check();
    } catch (const Rejected& reason) {
      rejected_ = reason;
    }
  }
  /// `node 3: REASON`.
  template <class Check>
  void judge(const char* what, std::size_t index, const Check& check) {
    judge([&] {
      try {
        check();
      } catch (const Rejected& reason) {
        throw Rejected(what + (" " + std::to_string(index)) + ": " + reason.what());
      }
    });
  }
  template <class Check>
  void judge_node(const Check& check) {
    judge("node", node_, check);
  }

  /// Without recursion, for trees of any depth.
  void read_tree() {
    for (read_node(); !pending_.empty(); ++node_, read_node()) {
      for (; !pending_.empty() && !pending_.back().node; pending_.pop_back()) restore();
      if (pending_.empty()) return;
      restore();
      pending_.pop_back();
    }
  }
  void restore() { pattern_[pending_.back().contact] = pending_.back().state; }

  void split(std::size_t k, const std::vector<State>& cases) {
    pending_.push_back({k, pattern_[k], false});
    for (std::size_t i = cases.size(); i-- > 0;) pending_.push_back({k, cases[i]});
  }

  void read_node() {
    if (reader_.accept("decide")) return read_decision();
    if (reader_.accept("slips")) return read_slips();
    if (reader_.accept("arcs")) return read_arcs();
    if (reader_.accept("empty")) return read_empty();
    if (reader_.accept("known")) return read_known();
    reader_.refuse("'decide', 'slips', 'arcs', 'empty' or 'known'");
  }

  void read_decision() {
    const std::size_t k = reader_.index(pattern_.size());
    judge_node([&] { require(pattern_[k].kind == Kind::any, "contact", k, "it is decided already"); });
    split(k, {{Kind::open}, {Kind::closed}});
  }

  void read_slips() {
    const std::size_t k = reader_.index(pattern_.size());
    judge_node([&] {
      require(pattern_[k].kind == Kind::closed, "contact", k, "it is not closed, or it sticks or slips already");
      require(problem_.has_friction(k), "contact", k, "it has no friction");
    });
    std::vector<State> cases{{Kind::stick}};
    if (problem_.dimension < 3) {
      for (const int d : {1, -1}) cases.push_back({Kind::slip, {d, 0}, {d, 0}});
      return split(k, cases);
    }
    std::vector<Direction> directions = read_directions();
    judge_node([&] { require(directions.size() >= 3, "the arcs do not go round: there are fewer than 3"); });
    if (!directions.empty()) directions.push_back(directions.front());
    add_arcs(cases, directions);
    split(k, cases);
  }

  void read_arcs() {
    const std::size_t k = reader_.index(pattern_.size());
    judge_node([&] {
      require(pattern_[k].kind == Kind::slip, "contact", k, "it does not slip");
      require(problem_.dimension == 3, "contact", k, "it slips in one direction");
    });
    std::vector<Direction> directions = read_directions();
    directions.insert(directions.begin(), pattern_[k].from);
    directions.push_back(pattern_[k].to);
    std::vector<State> cases;
    add_arcs(cases, directions);
    split(k, cases);
  }

  std::vector<Direction> read_directions() {
    std::vector<Direction> result;
    for (std::size_t left = reader_.count(); left > 0; --left) {
      Direction& d = result.emplace_back();
      for (Number& x : d) x = reader_.number();
      judge_node([&] { require(dot(d, d) == 1, "a direction has not length 1"); });
    }
    return result;
  }

  /// From each direction to the next.
  void add_arcs(std::vector<State>& cases, const std::vector<Direction>& directions) {
    for (std::size_t i = 0; i + 1 < directions.size(); ++i) {
      const Direction &a = directions[i], &b = directions[i + 1];
      judge_node(
          [&] { require(cross(a, b).sign() > 0, "arc", i, "it is not counterclockwise and below half a turn"); });
      cases.push_back({Kind::slip, a, b});
    }
  }

  /// Proves that f . u + h . r >= y . q in the pattern; true: more than that.
  bool check_multipliers(const Bound& bound, const Vector& y) const {
    Vector v, g(y.size());
    for (const Number& component : y) v.push_back(-component);
    for (const auto& [i, f] : bound.f) v[i] += f;
    for (const auto& [i, h] : bound.h) g[i] += h;
    for (std::size_t i = 0; i < y.size(); ++i) {
      if (y[i].sign() == 0) continue;
      for (const auto& [j, a] : reduced_.W[i]) g[j] += a * y[i];
    }
    bool strict = false;
    for (std::size_t k = 0; k < pattern_.size(); ++k) {
      const int motion = over_velocities(pattern_[k], at_contact(reduced_, v, k));
      const int force = over_forces(pattern_[k], problem_.mu[k], at_contact(reduced_, g, k));
      require(motion >= 0, "contact", k, "v . u may be negative");
      require(force >= 0, "contact", k, "g . r may be negative");
      strict = strict || motion > 0 || force > 0;
    }
    return strict;
  }

  Number value(const Vector& y) const {
    Number sum;
    for (std::size_t i = 0; i < y.size(); ++i) sum += y[i] * reduced_.q[i];
    return sum;
  }

  Vector read_multipliers() { return reader_.numbers(problem_.size() - problem_.free); }

  void read_empty() {
    const Vector y = read_multipliers();
    judge_node([&] {
      const bool strict = check_multipliers({}, y);
      const int sign = value(y).sign();
      require(sign > 0 || (sign == 0 && strict), "y . q is not positive, and not 0 where more than that is proved");
    });
  }

  template <class Claim>
  void read_bound(const Claim& claim) {
    const Vector y = read_multipliers();
    judge_node([&] {
      const Bound bound = claim();
      check_multipliers(bound, y);
      require(value(y) >= bound.least, "y . q is less than the bound");
    });
  }

  void read_known() {
    const ListedMotion& motion = motions_[reader_.index(motions_.size())];
    if (motion.is_exact()) return read_velocities(motion);
    judge_node([&] { require(motion.is_alone(), "the motion is not claimed to be alone"); });
    for (std::size_t k = 0; k < pattern_.size(); ++k) {
      judge_node([&] { require(motion.has_state(k, pattern_[k]), "contact", k, "the motion has another mode"); });
      read_unknowns(motion, k);
    }
  }

  bool is_zero_row(std::size_t i) const {
    const Kind kind = pattern_[i / problem_.dimension].kind;
    return kind == Kind::stick || (i % problem_.dimension == 0 && (kind == Kind::closed || kind == Kind::slip));
  }

  /// u is that of the motion.
  void read_velocities(const ListedMotion& motion) {
    for (std::size_t i = 0; i < problem_.size() - problem_.free; ++i) {
      if (is_zero_row(i)) {
        judge_node([&] { require(motion.u(i).low.sign() == 0, "row", i, "u of the motion is not 0"); });
        continue;
      }
      for (const int sign : {1, -1}) read_bound([&] { return Bound{{{i, sign}}, {}, sign * motion.u(i).low}; });
    }
  }

  /// The unknowns of the mode at a contact are within `alone` of the center.
  void read_unknowns(const ListedMotion& motion, std::size_t k) {
    const std::size_t first = motion.first(k), row = problem_.dimension * k;
    for (std::size_t t = 0; t < motion.forces(k); ++t) {
      const auto middle = [&, t] { return motion.alone(first + t); };
      read_bound([&] { return Bound{{}, {{row + t, 1}}, middle().low}; });
      read_bound([&] { return Bound{{}, {{row + t, -1}}, -middle().high}; });
    }
    if (!motion.slides_in_space(k)) return;
    const Direction a = pattern_[k].from, b = pattern_[k].to, m{a[0] + b[0], a[1] + b[1]};
    judge_node([&] { check_arc(motion, first + 1, a, b); });
    // With m = a + b and c = 1 + a . b: c <= d . m <= |m| = sqrt(2 c) <= 1 + c/2 in the arc, and u_T . m = v d . m.
    const auto c = [&] { return 1 + dot(a, b); };
    read_bound([&] { return Bound{{{row + 1, -m[0]}, {row + 2, -m[1]}}, {}, -(motion.alone(first + 3).high * c())}; });
    read_bound([&] {
      return Bound{{{row + 1, m[0]}, {row + 2, m[1]}}, {}, motion.alone(first + 3).low * (1 + c() / 2)};
    });
  }

  /// The arc is in the triangle of its ends and the corner m / c of their tangents.
  static void check_arc(const ListedMotion& motion, std::size_t d, const Direction& a, const Direction& b) {
    const Number c = 1 + dot(a, b);
    for (const std::size_t t : {0U, 1U}) {
      const Range range = motion.alone(d + t);
      for (const Number& x : {a[t] * c, b[t] * c, a[t] + b[t]}) {
        require(range.low * c <= x && x <= range.high * c, "the arc is not where the motion is alone");
      }
    }
  }

  bool are_different() const {
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!motions_[i].differs(motions_[j])) return false;
      }
    }
    return true;
  }

  const Problem& problem_;
  Reader& reader_;
  Reduced reduced_;
  std::vector<ListedMotion> motions_;
  std::vector<State> pattern_;
  std::vector<Pending> pending_;
  std::size_t node_ = 0;
  std::optional<Rejected> rejected_;
};

inline std::string all_solutions(const Problem& problem, Reader& reader) {
  return AllSolutions(problem, reader).established();
}

}  // namespace slipproof::check_contact
