// All motions of a problem: a list of them, and a tree of cases without others (FORMAT.md, `all-solutions`).
#pragma once

#include "proofs/check_contact/listed_motion.hpp"

namespace slipproof::check_contact {

/// Numbers at one contact; the tangential ones that the dimension does not have are 0.
struct AtContact {
  Number normal;
  Direction tangential;
};

inline AtContact at_contact(const Problem& reduced, const Vector& numbers, std::size_t k) {
  const std::size_t normal = reduced.normal(k);
  AtContact result{numbers[normal], {}};
  for (std::size_t t = 1; t < reduced.dimension; ++t) result.tangential[t - 1] = numbers[normal + t];
  return result;
}

/// 1: v . u > 0 for all velocities u that the state allows; 0: v . u >= 0; -1: it may be negative.
inline int over_velocities(const State& state, const AtContact& v) {
  if (state.kind == Case::stick) return 0;
  if (state.kind == Case::slip)
    return std::min(dot(v.tangential, state.from).sign(), dot(v.tangential, state.to).sign());
  if (dot(v.tangential, v.tangential).sign() > 0) return -1;
  const int normal = state.kind == Case::closed ? 0 : v.normal.sign();
  return state.kind == Case::open ? normal : std::min(normal, 0);
}

/// Whether g . r >= 0 for all forces r that the state allows. Where it slips these are r_N (1, -mu d), and g_T . d is
/// greatest along g_T, or at an end of the arc.
inline bool over_forces(const State& state, const Number& mu, const AtContact& g) {
  if (state.kind == Case::open) return true;
  const bool inside = cross(state.from, g.tangential).sign() > 0 && cross(g.tangential, state.to).sign() > 0;
  if (state.kind == Case::slip && !inside) {
    const auto end = [&](const Direction& d) { return g.normal >= mu * dot(g.tangential, d); };
    return end(state.from) && end(state.to);
  }
  return g.normal.sign() >= 0 && square(g.normal) >= square(mu) * dot(g.tangential, g.tangential);
}

/// f . u + h . r >= least.
struct Bound {
  Row f, h;
  Number least;
};

/// Reads the tree depth first and judges it on the way; what is wrong first is kept until all is read.
class AllSolutions {
 public:
  AllSolutions(const Problem& problem, Reader& reader) : reader_(reader) {
    const std::size_t motions = reader.count();
    const Matrix inverse = problem.free > 0 ? reader.entries("eliminated", problem.free, problem.free) : Matrix();
    problem_.dimension = problem.dimension;
    problem_.mu = problem.mu;
    judge([&] {
      problem.require_coulomb();
      problem_ = reduced(problem, inverse);
    });
    for (std::size_t i = 0; i < motions; ++i) {
      ListedMotion& motion = motions_.emplace_back(problem_, reader);
      place_ = "motion " + std::to_string(i) + ": ";
      judge([&] { motion.check(problem_); });
    }
    pattern_.resize(problem.contacts());
    read_tree();
  }

  std::string established() const {
    if (rejected_) throw Rejected(*rejected_);
    if (motions_.empty()) return "no motion at all";
    const std::string count = std::to_string(motions_.size());
    const bool different = are_different(), several = motions_.size() > 1;
    Number reach;
    for (const ListedMotion& motion : motions_) reach = std::max(reach, motion.reach());
    if (reach.sign() > 0) {
      const std::string least = several && different ? count + " motions" : "one motion";
      return "at least " + least + ", and every motion is within " + decimal(reach) + " of one of " + count;
    }
    if (!several) return "one motion and no other";
    return different ? count + " motions and no others" : "at least one motion and at most " + count;
  }

 private:
  /// What is still to be read: a case, or that all cases of a contact are.
  struct Pending {
    std::size_t contact;
    State state;
    bool node = true;
  };

  /// `node 3: REASON`.
  template <class Check>
  void judge(const Check& check) {
    if (rejected_) return;
    try {
      check();
    } catch (const Rejected& reason) {
      rejected_.emplace(place_ + reason.what());
    }
  }

  /// Without recursion, for trees of any depth.
  void read_tree() {
    read_node();
    while (!pending_.empty()) {
      const Pending next = pending_.back();
      pending_.pop_back();
      pattern_[next.contact] = next.state;
      if (next.node) read_node();
    }
  }

  void split(std::size_t k, const std::vector<State>& cases) {
    pending_.push_back({k, pattern_[k], false});
    for (std::size_t i = cases.size(); i-- > 0;) pending_.push_back({k, cases[i]});
  }

  void read_node() {
    place_ = "node " + std::to_string(nodes_++) + ": ";
    if (reader_.accept("decide")) return read_decision();
    if (reader_.accept("slips")) return read_slips();
    if (reader_.accept("arcs")) return read_arcs();
    if (reader_.accept("empty")) return read_empty();
    if (reader_.accept("known")) return read_known();
    if (reader_.accept("frictionless")) return read_frictionless();
    reader_.refuse("'decide', 'slips', 'arcs', 'empty', 'known' or 'frictionless'");
  }

  void read_decision() {
    const std::size_t k = reader_.index(pattern_.size());
    judge([&] { require(pattern_[k].kind == Case::any, "contact", k, "it is decided already"); });
    split(k, {{Case::open}, {Case::closed}});
  }

  void read_slips() {
    const std::size_t k = reader_.index(pattern_.size());
    judge([&] {
      require(pattern_[k].kind == Case::closed, "contact", k, "it is not closed, or it sticks or slips already");
      require(problem_.has_friction(k), "contact", k, "it has no friction");
    });
    const State sticks{Case::stick}, forward{Case::slip, {1, 0}, {1, 0}}, backward{Case::slip, {-1, 0}, {-1, 0}};
    if (problem_.dimension < 3) return split(k, {sticks, forward, backward});
    std::vector<Direction> directions = read_directions();
    judge([&] { require(directions.size() >= 3, "the arcs do not go round: there are fewer than 3"); });
    if (!directions.empty()) directions.push_back(directions.front());
    split(k, arcs({sticks}, directions));
  }

  void read_arcs() {
    const std::size_t k = reader_.index(pattern_.size());
    judge([&] {
      require(pattern_[k].kind == Case::slip, "contact", k, "it does not slip");
      require(problem_.dimension == 3, "contact", k, "it slips in one direction");
    });
    std::vector<Direction> directions = read_directions();
    directions.insert(directions.begin(), pattern_[k].from);
    directions.push_back(pattern_[k].to);
    split(k, arcs({}, directions));
  }

  std::vector<Direction> read_directions() {
    std::vector<Direction> result;
    for (std::size_t left = reader_.count(); left > 0; --left) {
      Direction& d = result.emplace_back();
      for (Number& x : d) x = reader_.number();
      judge([&] { require(dot(d, d) == 1, "a direction has not length 1"); });
    }
    return result;
  }

  /// These cases, and the arcs from each direction to the next.
  std::vector<State> arcs(std::vector<State> cases, const std::vector<Direction>& directions) {
    for (std::size_t i = 0; i + 1 < directions.size(); ++i) {
      const Direction &a = directions[i], &b = directions[i + 1];
      judge([&] { require(cross(a, b).sign() > 0, "arc", i, "it is not counterclockwise and below half a turn"); });
      cases.push_back({Case::slip, a, b});
    }
    return cases;
  }

  /// y . q, which f . u + h . r is at least in the pattern, and whether it is more than this.
  std::pair<Number, bool> proved(const Bound& bound, const Vector& y) const {
    bool strict = false;
    Vector v, g(y.size());
    for (const Number& component : y) v.push_back(-component);
    for (const auto& [i, f] : bound.f) v[i] += f;
    for (const auto& [i, h] : bound.h) g[i] += h;
    Number sum;
    for (std::size_t i = 0; i < y.size(); ++i) {
      if (y[i].sign() == 0) continue;
      sum += y[i] * problem_.c[i];
      for (const auto& [j, a] : problem_.A[i]) g[j] += a * y[i];
    }
    for (std::size_t k = 0; k < pattern_.size(); ++k) {
      const int motion = over_velocities(pattern_[k], at_contact(problem_, v, k));
      const bool force = over_forces(pattern_[k], problem_.mu[k], at_contact(problem_, g, k));
      require(motion >= 0, "contact", k, "v . u may be negative");
      require(force, "contact", k, "g . r may be negative");
      strict = strict || motion > 0;
    }
    return {sum, strict};
  }

  void read_empty() {
    const Vector y = reader_.numbers(problem_.size());
    judge([&] {
      const auto [sum, strict] = proved({}, y);
      require(sum.sign() > 0 || (sum.sign() == 0 && strict),
              "y . q is not positive, and not 0 where more than that is proved");
    });
  }

  template <class Claim>
  void read_bound(const Claim& claim) {
    const Vector y = reader_.numbers(problem_.size());
    judge([&] {
      const Bound bound = claim();
      require(proved(bound, y).first >= bound.least, "y . q is less than the bound");
    });
  }

  void read_known() {
    const ListedMotion& motion = motions_[reader_.index(motions_.size())];
    const MotionBox* alone = motion.alone();
    if (alone == nullptr) return read_velocities(motion);
    for (std::size_t k = 0; k < pattern_.size(); ++k) {
      judge([&] { require(alone->has_state(k, pattern_[k]), "contact", k, "the motion has another mode"); });
      for (std::size_t t = 0; t < problem_.dimension; ++t) {
        const std::size_t i = problem_.normal(k) + t;
        const auto force = alone->alone(i);
        if (!force) continue;
        read_bound([&] { return Bound{{}, {{i, 1}}, force->low}; });
        read_bound([&] { return Bound{{}, {{i, -1}}, -force->high}; });
      }
      if (alone->slides_in_space(k)) read_slip(alone->alone_slip(k), k);
    }
  }

  bool is_zero_row(std::size_t i) const {
    const Case kind = pattern_[i / problem_.dimension].kind;
    return kind == Case::stick || (i % problem_.dimension == 0 && (kind == Case::closed || kind == Case::slip));
  }

  /// u is where the motion is.
  void read_velocities(const ListedMotion& motion) {
    for (std::size_t i = 0; i < problem_.size(); ++i) {
      if (is_zero_row(i)) {
        judge([&] { require(!motion.place(i).misses_zero(), "row", i, "u of the motion is not 0"); });
      } else {
        read_bound([&] { return Bound{{{i, 1}}, {}, motion.place(i).low}; });
        read_bound([&] { return Bound{{{i, -1}}, {}, -motion.place(i).high}; });
      }
    }
  }

  /// s is in a range. With m = a + b and c = 1 + a . b: c <= d . m <= |m| = sqrt(2 c) <= 1 + c/2 in the arc, and
  /// u_T . m = s m r_N d . m.
  void read_slip(const Range& s, std::size_t k) {
    const Direction &a = pattern_[k].from, &b = pattern_[k].to;
    const Number c = 1 + dot(a, b), x = a[0] + b[0], y = a[1] + b[1], &mu = problem_.mu[k];
    const std::size_t i = problem_.normal(k);
    read_bound([&] { return Bound{{{i + 1, -x}, {i + 2, -y}}, {{i, s.high * mu * c}}, {}}; });
    read_bound([&] { return Bound{{{i + 1, x}, {i + 2, y}}, {{i, -(s.low * mu * (1 + c / 2))}}, {}}; });
  }

  /// Of another solution, (r' - r) . W (r' - r) = (r' - r) . (u' - u) <= 0 where r and u need no friction; with W a sum
  /// of squares, u' = u.
  void read_frictionless() {
    const ListedMotion& motion = motions_[reader_.index(motions_.size())];
    judge([&] { motion.check_frictionless(problem_); });
    Matrix rest = problem_.A;
    for (std::size_t s = 0, count = reader_.count(); s < count; ++s) {
      const Number d = reader_.number();
      Row l;
      for (std::size_t i = 0; i < problem_.size(); ++i) l.emplace(i, reader_.number());
      std::erase_if(l, [](const auto& entry) { return entry.second.sign() == 0; });
      judge([&] {
        require(d.sign() >= 0, "square", s, "its factor is negative");
        add_square(rest, -d, l);
      });
    }
    judge([&] {
      for (std::size_t i = 0; i < rest.size(); ++i) {
        for (const auto& [j, a] : rest[i]) require(a.sign() == 0, "row", i, "W is not the sum of the squares");
      }
    });
  }

  bool are_different() const {
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!motions_[i].differs(motions_[j])) return false;
      }
    }
    return true;
  }

  Reader& reader_;
  Problem problem_;  ///< without free unknowns
  std::vector<ListedMotion> motions_;
  std::vector<State> pattern_;
  std::vector<Pending> pending_;
  std::size_t nodes_ = 0;
  std::string place_;  ///< of what is judged
  std::optional<Rejected> rejected_;
};

}  // namespace slipproof::check_contact
