// A motion in the list of `all-solutions` (FORMAT.md): exact, or in a box of a mode's unknowns.
#pragma once

#include "proofs/check_contact/enclosure.hpp"

namespace slipproof::check_contact {

/// u = W r + q: a problem whose free unknowns are eliminated by B, the inverse of their rows and columns.
inline Problem reduced(const Problem& problem, const Matrix& B) {
  Problem result;
  result.dimension = problem.dimension;
  result.mu = problem.mu;
  const std::size_t free = problem.free, constant = problem.size();  // as if this were a column of A
  Matrix solved(free);                                               // B A
  for (std::size_t i = 0; i < free; ++i) {
    for (const auto& [k, b] : B[i]) {
      for (const auto& [j, a] : problem.A[k]) solved[i][j] += b * a;
      solved[i][constant] += b * problem.c[k];
    }
    for (std::size_t j = 0; j < free; ++j) require(solved[i][j] == Number(i == j), "row", i, "B A_FF is not I");
  }
  for (std::size_t i = free; i < problem.size(); ++i) {
    Row row{{constant, problem.c[i]}};
    for (const auto& [j, a] : problem.A[i]) {
      if (j >= free) row[j] += a;
      for (const auto& [l, s] : j < free ? solved[j] : Row()) row[l] += -(a * s);
    }
    result.c.push_back(row.extract(constant).mapped());
    Row& own = result.A.emplace_back();
    for (const auto& [j, a] : row) {
      if (j >= free) own.emplace(j - free, a);
    }
  }
  return result;
}

using Direction = std::array<Number, 2>;

inline Number dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1];
}
inline Number cross(const Direction& a, const Direction& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// FORMAT.md, the table of states.
enum class Case { any, open, closed, stick, slip };

/// A case at a contact.
struct State {
  Case kind = Case::any;
  Direction from{}, to{};  ///< slip: the ends of the arc; in dimension 2 both are (1, 0) or (-1, 0)
};

/// Where it is alone, the unknowns of its mode have no other zero within `alone` times its radii.
class MotionBox : public Enclosure {
 public:
  MotionBox(const Problem& problem, Reader& reader) : Enclosure(problem, reader) {
    is_alone_ = reader.accept("alone");
    if (is_alone_) alone_ = reader.number();
  }

  void check() {
    require(!is_alone() || (pinned_.empty() && alone_ >= 1), "alone is less than 1, or an unknown is pinned");
    Enclosure::check();
  }

  bool is_alone() const { return is_alone_; }

  /// Whether the mode has this state at a contact, in whatever arc.
  bool has_state(std::size_t k, const State& state) const {
    const Mode mode = modes_[k];
    if (mode == Mode::open) return state.kind == Case::open;
    if (mode == Mode::stick) return state.kind == (problem_.has_friction(k) ? Case::stick : Case::closed);
    const bool same_side = mode == Mode::slide || state.from[0].sign() == signs_[k][0];
    return mode != Mode::touch && state.kind == Case::slip && same_side;
  }

  /// Where component i of r may be for the mode; nothing if it is 0 there.
  std::optional<Range> alone(std::size_t i) const {
    const auto unknown = unknown_.find(i);
    return unknown == unknown_.end() ? std::nullopt : std::optional(alone_unknown(unknown->second));
  }
  bool slides_in_space(std::size_t k) const { return modes_[k] == Mode::slide; }
  /// The same for s of a contact that slides in space.
  Range alone_slip(std::size_t k) const { return alone_unknown(unknown_.at(problem_.normal(k)) + 3); }

 private:
  bool is_alone_;
  Range alone_unknown(std::size_t j) const { return around(center_[j], alone_ * radius_[j]); }
};

class ListedMotion {
 public:
  ListedMotion(const Problem& reduced, Reader& reader) : within_(reduced.size()) {
    reader.expect("motion");
    if (reader.accept("exact")) {
      forces_ = reader.numbers(reduced.size());
    } else if (reader.accept("box")) {
      box_.emplace(reduced, reader);
    } else {
      reader.refuse("'exact' or 'box'");
    }
    if (alone() == nullptr && reader.accept("within")) within_ = reader.numbers(reduced.size());
  }

  /// That there is such a motion.
  void check(const Problem& reduced) {
    for (const Number& e : within_) require(e.sign() >= 0, "a number of within is negative");
    if (box_) box_->check();
    Vector velocities;
    for (std::size_t i = 0; i < within_.size(); ++i) {
      u_.push_back(box_ ? box_->w(i) : around(velocities.emplace_back(reduced.motion(i, forces_)), 0));
    }
    for (std::size_t k = 0; !box_ && k < reduced.contacts(); ++k) check_law(reduced, k, forces_, velocities);
  }

  /// The box in whose mode no other is near, if it is claimed.
  const MotionBox* alone() const { return box_ && box_->is_alone() ? &*box_ : nullptr; }

  /// Where others may be that count as this one.
  Range place(std::size_t i) const { return {u_[i].low - within_[i], u_[i].high + within_[i]}; }

  /// The largest distance from it of such others.
  Number reach() const {
    Number result;
    for (std::size_t i = 0; !alone() && i < u_.size(); ++i) result = std::max(result, place(i).high - u_[i].low);
    return result;
  }

  /// Exact, without a tangential force, and without sliding where there is friction.
  void check_frictionless(const Problem& reduced) const {
    require(!box_, "the motion is in a box");
    for (std::size_t i = 0; i < u_.size(); ++i) {
      if (i % reduced.dimension == 0) continue;
      const bool friction = reduced.has_friction(i / reduced.dimension);
      require(forces_[i].sign() == 0, "row", i, "r_T of the motion is not 0");
      require(!friction || u_[i].low.sign() == 0, "row", i, "u_T of the motion is not 0, with friction");
    }
  }

  /// Two motions of which each row of u may be the same need not be different.
  bool differs(const ListedMotion& other) const {
    for (std::size_t i = 0; i < u_.size(); ++i) {
      if ((u_[i] - other.u_[i]).misses_zero()) return true;
    }
    return false;
  }

 private:
  std::optional<MotionBox> box_;
  Vector forces_;  ///< exact
  Vector within_;
  std::vector<Range> u_;
};

}  // namespace slipproof::check_contact
