// A box around a solution in given modes (FORMAT.md, `enclosure`).
#pragma once

#include "proofs/check_contact/claims.hpp"

namespace slipproof::check_contact {

enum class Mode { open, touch, stick, slide, faces };

/// The signs of u where each tangential direction sticks, 0, or slides for itself: on faces of a pyramid.
using Signs = std::array<int, 2>;

/// F_i(z + d) = value + slope d + what is at most `rest` in absolute value, for all |d_j| <= p_j.
struct Equation {
  Number value{};
  Row slope{};
  Number rest{};
  bool linear = true;
};

/// A dropped equation is this combination of others.
using Dropped = std::map<std::size_t, Row>;

/// A neighbourhood of a point in given modes, and what holds everywhere in it; that it contains a zero of their
/// equations is for those that derive from it.
class Neighbourhood {
 public:
  Neighbourhood(const Problem& problem, Reader& reader) : problem_(problem) {
    reader.expect("modes");
    signs_.resize(problem.contacts());
    for (std::size_t k = 0; k < problem.contacts(); ++k) modes_.push_back(mode(reader, k));
    count_unknowns();
    center_ = reader.numbers("center", unknowns_);
    radius_ = reader.numbers("radius", unknowns_);
    reader.expect("pinned");
    for (std::size_t left = reader.count(); left > 0; --left) pinned_.insert(reader.index(unknowns_, pinned_));
    reader.expect("dropped");
    for (std::size_t left = reader.count(); left > 0; --left) read_dropped(reader);
  }
  virtual ~Neighbourhood() = default;

  /// That there is a solution in the box.
  void check() {
    opens_ = problem_.law.is(Law::Kind::associated);
    if (!opens_ && !problem_.law.is(Law::Kind::box)) problem_.require_coulomb();
    for (std::size_t j = 0; j < unknowns_; ++j)
      require(radius_[j].sign() > 0, "unknown", j, "its radius is not positive");
    for (const std::size_t j : pinned_) radius_[j] = 0;
    list_equations();
    for (const auto& [row, combination] : dropped_) check_dropped(row, combination);
    require(pinned_.size() == dropped_.size(), "as many unknowns as equations must be left");
    check_zero();
    for (std::size_t k = 0; k < problem_.contacts(); ++k) check_contact(k);
  }

  /// Component i of the solution.
  Range x(std::size_t i) const {
    const auto unknown = unknown_.find(i);
    return unknown == unknown_.end() ? Range() : around(center_[unknown->second], radius_[unknown->second]);
  }
  /// Row i of A x + c.
  Range w(std::size_t i) const {
    const Equation row = motion(i);
    Number spread;
    for (const auto& [j, a] : row.slope) spread += abs(a) * radius_[j];
    return around(row.value, spread);
  }

 protected:
  /// The equations that are kept have a zero within the radii of the center.
  virtual void check_zero() const = 0;

  std::vector<const Equation*> kept() const {
    std::vector<const Equation*> result;
    for (std::size_t i = 0; i < unknowns_; ++i) {
      if (dropped_.count(i) == 0) result.push_back(&equations_[i]);
    }
    return result;
  }

  const Problem& problem_;
  std::vector<Mode> modes_;
  std::vector<Signs> signs_;
  std::size_t unknowns_ = 0;                    ///< and equations
  std::map<std::size_t, std::size_t> unknown_;  ///< the place among the unknowns of a component of x that is one
  Vector center_, radius_;                      ///< radius 0 where pinned
  Indices pinned_;
  Dropped dropped_;

 private:
  Mode mode(Reader& reader, std::size_t k) {
    const bool friction = problem_.has_friction(k), box = problem_.law.is(Law::Kind::box);
    if (reader.accept("open")) return Mode::open;
    if (reader.accept("touch")) return Mode::touch;
    if (reader.accept("stick")) return Mode::stick;
    if (friction && problem_.dimension == 3 && !box && reader.accept("slide")) return Mode::slide;
    for (const std::string_view signs : {"+", "-", "+0", "-0", "0+", "0-", "++", "+-", "-+", "--"}) {
      const bool possible = friction && signs.size() == problem_.dimension - 1 && (problem_.dimension == 2 || box);
      if (!possible || !reader.accept("slide" + std::string(signs))) continue;
      for (std::size_t t = 0; t < signs.size(); ++t) signs_[k][t] = signs[t] == '+' ? 1 : signs[t] == '-' ? -1 : 0;
      return Mode::faces;
    }
    reader.refuse("a mode that contact " + std::to_string(k) + " can have");
  }

  /// How many rows of A are equations, and components of x unknowns, of contact k.
  std::size_t forces(std::size_t k) const {
    if (modes_[k] == Mode::open) return 0;
    return problem_.has_friction(k) && modes_[k] != Mode::touch ? problem_.dimension : 1;
  }

  void count_unknowns() {
    for (std::size_t j = 0; j < problem_.free; ++j) unknown_.emplace(j, unknowns_++);
    for (std::size_t k = 0; k < problem_.contacts(); ++k) {
      for (std::size_t t = 0; t < forces(k); ++t) unknown_.emplace(problem_.normal(k) + t, unknowns_++);
      if (modes_[k] == Mode::slide) ++unknowns_;
    }
  }

  void read_dropped(Reader& reader) {
    const std::size_t row = reader.index(unknowns_, dropped_);
    Row& combination = dropped_[row];
    for (std::size_t left = reader.count(); left > 0; --left) reader.entry(combination, unknowns_);
  }

  /// w_i as a function of the unknowns.
  Equation motion(std::size_t i) const {
    Equation result{problem_.c[i]};
    for (const auto& [j, a] : problem_.A[i]) {
      const auto unknown = unknown_.find(j);
      if (unknown == unknown_.end()) continue;
      result.value += a * center_[unknown->second];
      result.slope[unknown->second] = a;
    }
    return result;
  }

  void list_equations() {
    for (std::size_t i = 0; i < problem_.free; ++i) equations_.push_back(motion(i));
    for (std::size_t k = 0; k < problem_.contacts(); ++k) {
      const std::size_t normal = problem_.normal(k);
      if (modes_[k] != Mode::open) equations_.push_back(opens_ ? opening(k) : motion(normal));
      if (modes_[k] == Mode::stick) {
        for (std::size_t t = 1; t < forces(k); ++t) equations_.push_back(motion(normal + t));
      }
      if (modes_[k] == Mode::slide) list_sliding(k);
      for (std::size_t t = 1; modes_[k] == Mode::faces && t < problem_.dimension; ++t) {
        const int sign = signs_[k][t - 1];
        equations_.push_back(sign == 0 ? motion(normal + t) : edge(k, t, sign * problem_.mu[k]));
      }
    }
  }

  /// u_N, and where the associated law slides u_N - s m^2 r_N, in dimension 2 u_N -+ m u_T.
  Equation opening(std::size_t k) const {
    const std::size_t row = problem_.normal(k);
    Equation result = motion(row);
    const Number& m = problem_.mu[k];
    if (modes_[k] == Mode::slide) {
      const std::size_t normal = unknown_.at(row), slip = normal + 3;
      const Number m2 = square(m);
      result.value += -(m2 * center_[slip] * center_[normal]);
      result.slope[slip] += -(m2 * center_[normal]);
      result.slope[normal] += -(m2 * center_[slip]);
      result.rest = m2 * radius_[slip] * radius_[normal];
      result.linear = false;
    } else if (modes_[k] == Mode::faces) {
      const Number slope = -(signs_[k][0] * m);
      const Equation tangential = motion(row + 1);
      result.value += slope * tangential.value;
      for (const auto& [j, a] : tangential.slope) result.slope[j] += slope * a;
    }
    return result;
  }

  /// r_T + m r_N.
  Equation edge(std::size_t k, std::size_t t, const Number& m) const {
    const std::size_t normal = unknown_.at(problem_.normal(k)), tangential = normal + t;
    return {center_[tangential] + m * center_[normal], {{tangential, 1}, {normal, m}}};
  }

  /// u_T + s r_T, twice, and r_T1^2 + r_T2^2 - m^2 r_N^2.
  void list_sliding(std::size_t k) {
    const std::size_t normal = unknown_.at(problem_.normal(k)), slip = normal + 3;
    const Number m2 = square(problem_.mu[k]);
    Equation cone{-m2 * square(center_[normal]), {{normal, -2 * m2 * center_[normal]}}, {}, false};
    for (const std::size_t t : {1U, 2U}) {
      const Number &s = center_[slip], &r = center_[normal + t];
      Equation tangential = motion(problem_.normal(k) + t);
      tangential.value += s * r;
      tangential.slope[normal + t] += s;
      tangential.slope[slip] += r;
      tangential.rest = radius_[slip] * radius_[normal + t];
      tangential.linear = false;
      equations_.push_back(tangential);
      cone.value += square(r);
      cone.slope[normal + t] = 2 * r;
      cone.rest += square(radius_[normal + t]);
    }
    cone.rest = std::max(cone.rest, m2 * square(radius_[normal]));
    equations_.push_back(cone);
  }

  /// The equation is linear, and where the pinned unknowns are pinned it is the combination of linear ones that are
  /// kept.
  void check_dropped(std::size_t row, const Row& combination) const {
    Equation difference = equations_[row];
    require(difference.linear, "dropped equation", row, "it is not linear");
    for (const auto& [i, coefficient] : combination) {
      require(dropped_.count(i) == 0, "dropped equation", row, "it is combined of one that is dropped");
      require(equations_[i].linear, "dropped equation", row, "it is combined of one that is not linear");
      difference.value += -coefficient * equations_[i].value;
      for (const auto& [j, a] : equations_[i].slope) difference.slope[j] += -coefficient * a;
    }
    require(difference.value.sign() == 0, "dropped equation", row, "it is not the combination, at the center");
    for (const auto& [j, a] : difference.slope) {
      require(a.sign() == 0 || pinned_.count(j) > 0, "dropped equation", row, "it is not the combination, in a column");
    }
  }

  /// u_N >= 0, and by the associated law u_N >= m |u_T|.
  void check_open(std::size_t k) const {
    const std::size_t row = problem_.normal(k);
    const Number normal = w(row).low;
    require(normal.sign() >= 0, "contact", k, "u_N may be negative");
    if (!opens_) return;
    Number tangential;
    for (std::size_t t = 1; t < problem_.dimension; ++t) {
      const Range u = w(row + t);
      tangential += square(std::max(-u.low, u.high));
    }
    require(square(problem_.mu[k]) * tangential <= square(normal), "contact", k, "u_N may be less than m |u_T|");
  }

  /// No force, where u_N = 0. By the associated law u_T would have to be 0, too.
  void check_touch(std::size_t k, std::size_t normal) const {
    require(pinned_.count(normal) > 0 && center_[normal].sign() == 0, "contact", k, "it touches with a force");
    require(!opens_ || !problem_.has_friction(k), "contact", k, "by the associated law it cannot touch in motion");
  }

  /// The conditions of the law that the equations do not imply, everywhere in the box.
  void check_contact(std::size_t k) const {
    const std::size_t row = problem_.normal(k);
    if (modes_[k] == Mode::open) return check_open(k);
    const std::size_t normal = unknown_.at(row), slip = normal + 3;
    if (modes_[k] == Mode::touch) return check_touch(k, normal);
    const Number r = center_[normal] - radius_[normal];
    require(r.sign() >= 0, "contact", k, "r_N may be negative");
    if (modes_[k] == Mode::slide) return require(center_[slip] >= radius_[slip], "contact", k, "s may be negative");
    const Number limit = problem_.mu[k] * r;
    Number force;
    for (std::size_t t = 1; t < forces(k); ++t) {
      const int sign = signs_[k][t - 1];
      const Number most = sign == 0 ? abs(center_[normal + t]) + radius_[normal + t] : Number(0);
      force += square(most);
      if (problem_.law.is(Law::Kind::box)) require(most <= limit, "contact", k, "the force may leave the friction box");
      if (sign == 0) continue;
      const Range u = w(row + t);
      require((sign > 0 ? u.low : -u.high).sign() >= 0, "contact", k, "u_T may have the other sign");
    }
    const bool cone = modes_[k] == Mode::stick && !problem_.law.is(Law::Kind::box);
    require(!cone || force <= square(limit), "contact", k, "the force may leave the friction cone");
  }

  bool opens_ = false;  ///< by the associated law, what slides
  std::vector<Equation> equations_;
};

/// By an approximate inverse, component by component.
class Enclosure : public Neighbourhood {
 public:
  Enclosure(const Problem& problem, Reader& reader) : Neighbourhood(problem, reader) {
    inverse_ = reader.entries("inverse", unknowns_ - pinned_.size(), unknowns_ - dropped_.size());
  }

 protected:
  Number alone_{};  ///< how many times the radii hold no second zero

 private:
  /// For each unknown that is left, |R f| + |I - R J| p + |R| q <= p and |I - R J| p < p.
  void check_zero() const override {
    const std::vector<const Equation*> kept = this->kept();
    std::size_t row = 0;
    for (std::size_t j = 0; j < unknowns_; ++j) {
      if (pinned_.count(j) > 0) continue;
      Number shift, rest, spread;
      Vector product(unknowns_);
      product[j] = -1;
      for (const auto& [i, r] : inverse_[row++]) {
        shift += r * kept[i]->value;
        rest += abs(r) * kept[i]->rest;
        for (const auto& [k, a] : kept[i]->slope) product[k] += r * a;
      }
      for (std::size_t k = 0; k < unknowns_; ++k) spread += abs(product[k]) * radius_[k];
      require(spread < radius_[j], "unknown", j, "|I - R J| p is not less than its radius");
      require(abs(shift) + spread + rest <= radius_[j], "unknown", j, "the box is not mapped into its radius");
      require(spread + 4 * alone_ * rest < radius_[j], "unknown", j, "there may be two zeros where it is alone");
    }
  }

  Matrix inverse_;
};

/// The answer is near a solution that a box holds.
template <class Box>
std::string near_answer(const Problem& problem, Reader& reader) {
  const Number rho = reader.number();
  const bool moves = reader.accept("velocities");
  const Number eta = moves ? reader.number() : Number();
  Box box(problem, reader);
  require(rho.sign() >= 0, "RHO is negative");
  box.check();
  const Vector& answer = problem.the_answer();
  for (std::size_t i = 0; i < problem.size(); ++i) {
    require(is_near(box.x(i), answer[i], rho), "component", i, "the solution may be farther than RHO from the answer");
  }
  const std::string found = "a solution within " + decimal(rho) + " of the answer";
  if (!moves) return found;
  for (std::size_t i = problem.free; i < problem.size(); ++i) {
    require(is_near(box.w(i), problem.motion(i, answer), eta), "row", i,
            "the velocity may be farther than ETA from the answer's");
  }
  return found + ", its velocities within " + decimal(eta);
}

}  // namespace slipproof::check_contact
