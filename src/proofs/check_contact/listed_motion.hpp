// A motion in the list of `all-solutions` (FORMAT.md): exact, or in a box of a mode's unknowns.
#pragma once

#include "proofs/check_contact/claims.hpp"

namespace slipproof::check_contact {

/// u = W r + q: a problem of which the free unknowns are eliminated.
struct Reduced {
  Reduced() = default;
  /// B is the inverse of the rows and columns of the free unknowns.
  Reduced(const Problem& problem, const Matrix& B) : dimension(problem.dimension) {
    const std::size_t free = problem.free;
    Matrix solved(free);  // B A - I
    Vector shift(free);   // B c
    for (std::size_t i = 0; i < free; ++i) {
      solved[i][i] = -1;
      for (const auto& [k, b] : B[i]) {
        shift[i] += b * problem.c[k];
        for (const auto& [j, a] : problem.A[k]) solved[i][j] += b * a;
      }
      for (const auto& [j, a] : solved[i]) require(j >= free || a.sign() == 0, "row", i, "B A_FF is not I");
    }
    for (std::size_t i = free; i < problem.size(); ++i) {
      Row& row = W.emplace_back();
      Number& constant = q.emplace_back(problem.c[i]);
      for (const auto& [j, a] : problem.A[i]) {
        if (j >= free) row[j - free] += a;
        if (j >= free) continue;
        constant += -(a * shift[j]);
        for (const auto& [l, s] : solved[j]) {
          if (l >= free) row[l - free] += -(a * s);
        }
      }
    }
  }

  std::size_t dimension = 0;
  Matrix W;
  Vector q;
};

using Direction = std::array<Number, 2>;

inline Number dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1];
}
inline Number cross(const Direction& a, const Direction& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// A case at a contact (FORMAT.md, the table of states).
struct State {
  enum class Kind { any, open, closed, stick, slip };
  Kind kind = Kind::any;
  Direction from{}, to{};  ///< slip: the ends of the arc; in dimension 2 both are (1, 0) or (-1, 0)
};

class ListedMotion {
 public:
  ListedMotion(const Problem& problem, Reader& reader) {
    reader.expect("motion");
    is_exact_ = reader.accept("exact");
    if (is_exact_) {
      forces_ = reader.numbers(problem.size() - problem.free);
      return;
    }
    if (!reader.accept("box")) reader.refuse("'exact' or 'box'");
    reader.expect("modes");
    for (std::size_t k = 0; k < problem.contacts(); ++k) {
      mode_.push_back(read_mode(problem, reader, k));
      first_.push_back(first_.back() + count(problem, k));
    }
    center_ = reader.numbers("center", first_.back());
    radius_ = reader.numbers("radius", first_.back());
    alone_ = reader.numbers("alone", first_.back());
    inverse_ = reader.entries("inverse", first_.back(), first_.back());
  }

  /// That there is such a motion, and no other where it is alone.
  void check(const Problem& problem, const Reduced& reduced) {
    if (is_exact_) return check_exact(problem, reduced);
    for (const Number& P : alone_) {
      require(P.sign() >= 0 && P.sign() == alone_[0].sign(), "alone is neither positive nor 0 everywhere");
    }
    check_zero(equations(problem, reduced));
    list_velocities(problem, reduced);
    for (std::size_t k = 0; k < mode_.size(); ++k) check_contact(problem, k);
  }

  bool is_exact() const { return is_exact_; }
  bool is_alone() const { return alone_.empty() || alone_[0].sign() > 0; }

  /// Whether the mode has this state at a contact, in whatever arc.
  bool has_state(std::size_t k, const State& state) const {
    return mode_[k].kind == state.kind && (slides_in_space(k) || mode_[k].from == state.from);
  }
  bool slides_in_space(std::size_t k) const { return first_[k + 1] - first_[k] == 4; }

  /// The place of the first unknown of a contact, and how many of its unknowns, the first ones, are components of r.
  std::size_t first(std::size_t k) const { return first_[k]; }
  std::size_t forces(std::size_t k) const { return slides_in_space(k) ? 1 : first_[k + 1] - first_[k]; }

  Range alone(std::size_t j) const { return around(center_[j], alone_[j]); }
  const Range& u(std::size_t i) const { return velocities_[i]; }

  /// Two motions of which each row of u may be the same need not be different.
  bool differs(const ListedMotion& other) const {
    for (std::size_t i = 0; i < velocities_.size(); ++i) {
      if ((velocities_[i] - other.velocities_[i]).misses_zero()) return true;
    }
    return false;
  }

 private:
  using Kind = State::Kind;

  static State read_mode(const Problem& problem, Reader& reader, std::size_t k) {
    const bool friction = problem.has_friction(k);
    if (reader.accept("open")) return {Kind::open};
    if (!friction && reader.accept("closed")) return {Kind::closed};
    if (friction && reader.accept("stick")) return {Kind::stick};
    if (friction && problem.dimension == 3 && reader.accept("slide")) return {Kind::slip};
    const bool planar = friction && problem.dimension == 2;
    if (planar && reader.accept("slide+")) return {Kind::slip, {1, 0}, {1, 0}};
    if (planar && reader.accept("slide-")) return {Kind::slip, {-1, 0}, {-1, 0}};
    reader.refuse("a mode that contact " + std::to_string(k) + " can have");
  }

  /// How many unknowns the contact has.
  std::size_t count(const Problem& problem, std::size_t k) const {
    switch (mode_[k].kind) {
      case Kind::open:
        return 0;
      case Kind::stick:
        return problem.dimension;
      case Kind::slip:
        return problem.dimension == 3 ? 4 : 1;
      default:
        return 1;
    }
  }

  void check_exact(const Problem& problem, const Reduced& reduced) {
    Vector x(problem.free), w(problem.free);
    x.insert(x.end(), forces_.begin(), forces_.end());
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      w.push_back(dot(reduced.W[i], forces_) + reduced.q[i]);
      velocities_.push_back(around(w.back(), 0));
    }
    for (std::size_t k = 0; k < problem.contacts(); ++k) check_law(problem, k, x, w);
  }

  /// F_i(z + d) = value + slope d + what is at most `bend` for |d| <= p, and `far_bend` for |d| <= P.
  struct Equation {
    Number value{};
    Row slope{};
    Number bend{}, far_bend{};
  };

  void add_term(Equation& equation, const Number& a, std::size_t j) const {
    equation.value += a * center_[j];
    equation.slope[j] += a;
  }
  void add_product(Equation& equation, const Number& b, std::size_t i, std::size_t j) const {
    equation.value += b * center_[i] * center_[j];
    equation.slope[i] += b * center_[j];
    equation.slope[j] += b * center_[i];
    equation.bend += abs(b) * radius_[i] * radius_[j];
    equation.far_bend += abs(b) * alone_[i] * alone_[j];
  }

  /// u_i of the unknowns.
  Equation velocity(const Problem& problem, const Reduced& reduced, std::size_t i) const {
    Equation result{reduced.q[i]};
    for (const auto& [j, a] : reduced.W[i]) {
      const std::size_t k = j / problem.dimension, t = j % problem.dimension, first = first_[k];
      const Kind kind = mode_[k].kind;
      if (kind == Kind::open || (kind == Kind::closed && t > 0)) continue;
      if (t == 0 || kind == Kind::stick) {
        add_term(result, a, first + t);
      } else if (problem.dimension == 3) {
        add_product(result, -(problem.mu[k] * a), first, first + t);
      } else {
        add_term(result, -(problem.mu[k] * mode_[k].from[0] * a), first);
      }
    }
    return result;
  }

  std::vector<Equation> equations(const Problem& problem, const Reduced& reduced) const {
    std::vector<Equation> result;
    for (std::size_t k = 0; k < mode_.size(); ++k) {
      const std::size_t normal = problem.dimension * k, first = first_[k];
      const bool slides = slides_in_space(k);
      if (mode_[k].kind != Kind::open) result.push_back(velocity(problem, reduced, normal));
      for (std::size_t t = 1; (mode_[k].kind == Kind::stick || slides) && t < problem.dimension; ++t) {
        result.push_back(velocity(problem, reduced, normal + t));
        if (slides) add_product(result.back(), -1, first + 3, first + t);
      }
      if (!slides) continue;
      result.push_back({-1});
      for (const std::size_t d : {first + 1, first + 2}) add_product(result.back(), 1, d, d);
    }
    return result;
  }

  /// |R f| + |I - R J| p + |R| q(p) <= p: there is a zero (Brouwer). |I - R J| P + 2 |R| q(P) < P: not two.
  void check_zero(const std::vector<Equation>& equations) const {
    for (std::size_t j = 0; j < center_.size(); ++j) {
      Number shift, bend, far_bend, spread, far_spread;
      Vector product(center_.size());
      product[j] = -1;
      for (const auto& [i, r] : inverse_[j]) {
        shift += r * equations[i].value;
        bend += abs(r) * equations[i].bend;
        far_bend += abs(r) * equations[i].far_bend;
        for (const auto& [k, a] : equations[i].slope) product[k] += r * a;
      }
      for (std::size_t k = 0; k < center_.size(); ++k) {
        spread += abs(product[k]) * radius_[k];
        far_spread += abs(product[k]) * alone_[k];
      }
      require(spread < radius_[j], "unknown", j, "|I - R J| p is not less than its radius");
      require(abs(shift) + spread + bend <= radius_[j], "unknown", j, "the box is not mapped into its radius");
      if (!is_alone()) continue;
      require(radius_[j] <= alone_[j], "unknown", j, "alone is less than its radius");
      require(far_spread + 2 * far_bend < alone_[j], "unknown", j, "there may be two zeros within alone");
    }
  }

  Range box(std::size_t j) const { return around(center_[j], radius_[j]); }

  /// Component t of the force of a contact.
  Range force(const Problem& problem, std::size_t k, std::size_t t) const {
    const std::size_t first = first_[k];
    if (mode_[k].kind == Kind::open || (mode_[k].kind == Kind::closed && t > 0)) return {};
    if (t == 0 || mode_[k].kind == Kind::stick) return box(first + t);
    const Range limit = around(-problem.mu[k], 0) * box(first);
    return limit * (slides_in_space(k) ? box(first + t) : around(mode_[k].from[0], 0));
  }

  void list_velocities(const Problem& problem, const Reduced& reduced) {
    for (std::size_t i = 0; i < reduced.q.size(); ++i) {
      Range& u = velocities_.emplace_back(around(reduced.q[i], 0));
      for (const auto& [j, a] : reduced.W[i]) {
        u = u + around(a, 0) * force(problem, j / problem.dimension, j % problem.dimension);
      }
    }
  }

  /// The conditions of the mode that are not equations, everywhere in the box.
  void check_contact(const Problem& problem, std::size_t k) const {
    const std::size_t normal = problem.dimension * k, first = first_[k];
    if (mode_[k].kind == Kind::open) {
      return require(velocities_[normal].low.sign() >= 0, "contact", k, "u_N may be negative");
    }
    require(box(first).low.sign() >= 0, "contact", k, "r_N may be negative");
    if (slides_in_space(k)) return require(box(first + 3).low.sign() >= 0, "contact", k, "v may be negative");
    if (mode_[k].kind == Kind::slip) {
      const Range speed = around(mode_[k].from[0], 0) * velocities_[normal + 1];
      return require(speed.low.sign() >= 0, "contact", k, "u_T may have the other sign");
    }
    Range tangential;
    for (std::size_t t = 1; t < forces(k); ++t) tangential = tangential + square(box(first + t));
    require(tangential.high <= square(problem.mu[k] * box(first).low), "contact", k,
            "the force may leave the friction cone");
  }

  bool is_exact_ = false;
  Vector forces_;            ///< exact
  std::vector<State> mode_;  ///< slip in space: without an arc
  std::vector<std::size_t> first_{0};
  Vector center_, radius_, alone_;
  Matrix inverse_;
  std::vector<Range> velocities_;  ///< of rows of u
};

}  // namespace slipproof::check_contact
