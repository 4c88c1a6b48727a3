#include "contact/complete/motion/forces_at.hpp"

#include <cmath>

namespace slipproof {

namespace {

constexpr std::size_t most_pivots = 1000, most_rays = 160;

Rational square_of_tangent(const ExactContacts& contacts, std::span<const Rational> x, std::size_t contact) {
  Rational sum;
  for (std::size_t t = 1; t < contacts.dimension; ++t) {
    const Rational& component = x[contacts.normal(contact) + t];
    sum += component * component;
  }
  return sum;
}

/// Rays of the cones of a motion's contacts.
class MotionRays {
 public:
  MotionRays(const ExactContacts& contacts, const SpatialMotion& motion) : contacts_(contacts), motion_(motion) {
    for (std::size_t k = 0; k < contacts.contacts(); ++k) {
      if (motion.u[contacts.normal(k)].is_zero()) add_rays_of(k);
    }
  }

  const std::vector<std::vector<Rational>>& rays() const { return rays_; }
  /// Whether they span all of the cones; and whether they have at least all directions in which forces may differ.
  bool are_all() const { return are_all_; }
  bool has_all_directions() const { return has_all_directions_; }

 private:
  void add(std::size_t k, std::vector<Rational> components) {
    rays_.push_back(force_on(contacts_, k, std::move(components)));
  }

  void add_rays_of(std::size_t k) {
    if (!contacts_.has_friction(k)) return add(k, {1});
    const Rational square = square_of_tangent(contacts_, motion_.u, k);
    if (!square.is_zero()) return add_against_slip(k, exact_root(square));
    const Rational& mu = contacts_.mu[k];
    if (contacts_.dimension == 2) {
      add(k, {1, mu});
      return add(k, {1, -mu});
    }
    for (const auto& [x, y] : {std::pair(5, 0), {4, 3}, {3, 4}, {0, 5}, {-3, 4}, {-4, 3}}) {
      const Rational cosine = mu * Rational(x, 5), sine = mu * Rational(y, 5);
      add(k, {1, cosine, sine});
      add(k, {1, -cosine, -sine});
    }
    add_own(k);
  }

  void add_against_slip(std::size_t k, const std::optional<Rational>& speed) {
    if (!speed) {  // the direction is no rational one, unless it is that of a force
      has_all_directions_ = has_all_directions_ && !motion_.r[contacts_.normal(k)].is_zero();
      return add_own(k);
    }
    std::vector<Rational> ray{1};
    for (std::size_t t = 1; t < contacts_.dimension; ++t) {
      ray.push_back(-contacts_.mu[k] * motion_.u[contacts_.normal(k) + t] / *speed);
    }
    add(k, std::move(ray));
  }

  void add_own(std::size_t k) {
    are_all_ = false;
    const auto own = std::span(motion_.r).subspan(contacts_.normal(k), contacts_.dimension);
    if (!own.front().is_zero()) add(k, {own.begin(), own.end()});
  }

  const ExactContacts& contacts_;
  const SpatialMotion& motion_;
  std::vector<std::vector<Rational>> rays_;
  bool are_all_ = true, has_all_directions_ = true;
};

/// Some of these that are independent, as many as there are.
std::vector<std::vector<Rational>> independent(const std::vector<std::vector<Rational>>& forces) {
  if (forces.empty()) return {};
  RationalMatrix columns(forces.front().size(), std::vector<Rational>(forces.size()));
  for (std::size_t j = 0; j < forces.size(); ++j) {
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i][j] = forces[j][i];
  }
  std::vector<std::vector<Rational>> result;
  for (const std::size_t j : eliminate(columns).pivot_columns) result.push_back(forces[j]);
  return result;
}

/// How many independent combinations of these forces move nothing. They are independent themselves.
std::size_t open_among(const ExactContacts& contacts, const std::vector<std::vector<Rational>>& forces) {
  RationalMatrix moved;
  for (const std::vector<Rational>& force : forces) moved.push_back(velocity_changes(contacts, force));
  return moved.empty() ? 0 : moved.size() - eliminate(moved).rank();
}

/// Directions of these forces: any where they lie inside of the cone of a contact that sticks, else along themselves.
std::vector<std::vector<Rational>> directions_from(const ExactContacts& contacts, std::span<const Rational> r,
                                                   std::span<const Rational> u) {
  std::vector<std::vector<Rational>> result;
  for (std::size_t k = 0; k < contacts.contacts(); ++k) {
    const std::size_t i = contacts.normal(k);
    if (r[i].is_zero()) continue;
    const Rational limit = contacts.mu[k] * r[i];
    if (square_of_tangent(contacts, u, k).is_zero() && square_of_tangent(contacts, r, k) < limit * limit) {
      for (std::size_t t = 0; t < contacts.dimension; ++t) {
        std::vector<Rational> axis(t + 1);
        axis[t] = 1;
        result.push_back(force_on(contacts, k, std::move(axis)));
      }
    } else {
      const auto own = r.subspan(i, contacts.dimension);
      result.push_back(force_on(contacts, k, {own.begin(), own.end()}));
    }
  }
  return result;
}

}  // namespace

std::vector<Rational> force_on(const ExactContacts& contacts, std::size_t contact, std::vector<Rational> components) {
  std::vector<Rational> r(contacts.size());
  std::ranges::move(components, r.begin() + static_cast<std::ptrdiff_t>(contacts.normal(contact)));
  return r;
}

ForcesAlong::ForcesAlong(const ExactContacts& contacts, std::span<const Rational> u,
                         std::vector<std::vector<Rational>> rays)
    : rays_(std::move(rays)), size_(contacts.size()) {
  const std::size_t count = rays_.size();
  RationalMatrix system(size_, std::vector<Rational>(count + 1));
  for (std::size_t j = 0; j < count; ++j) {
    const std::vector<Rational> moved = velocity_changes(contacts, rays_[j]);
    for (std::size_t i = 0; i < size_; ++i) system[i][j] = moved[i];
  }
  for (std::size_t i = 0; i < size_; ++i) system[i][count] = u[i] - contacts.q[i];
  const Echelon echelon = eliminate(system);
  exist_ = echelon.rank(count) == echelon.rank();
  if (!exist_) return;
  open_ = count - echelon.rank();
  std::vector<bool> is_pivot(count, false);
  for (const std::size_t j : echelon.pivot_columns) is_pivot[j] = true;
  weights_.resize(count, {Rational(), std::vector<Rational>(open_)});
  for (std::size_t j = 0, open = 0; j < count; ++j) {
    if (is_pivot[j]) continue;
    weights_[j].coefficients[open] = 1;
    for (std::size_t p = 0; p < echelon.rank(); ++p) {
      weights_[echelon.pivot_columns[p]].coefficients[open] = Rational(-echelon.rows[p][j], echelon.pivot);
    }
    ++open;
  }
  for (std::size_t p = 0; p < echelon.rank(); ++p) {
    weights_[echelon.pivot_columns[p]].constant = Rational(echelon.rows[p][count], echelon.pivot);
  }
}

std::optional<std::vector<Rational>> ForcesAlong::greatest(std::size_t first_ray, std::size_t rays) const {
  if (!exist_) return std::nullopt;
  std::vector<AffineForm> conditions;
  for (std::size_t j = 0; j < weights_.size(); ++j) {
    conditions.push_back(weights_[j]);
    conditions.back().coefficients.emplace_back(j >= first_ray && j < first_ray + rays ? -1 : 0);
  }
  AffineForm objective{Rational(), std::vector<Rational>(open_ + 1)}, below_one{Rational(1), objective.coefficients};
  objective.coefficients[open_] = below_one.coefficients[open_] = -1;
  conditions.push_back(std::move(below_one));
  const LinearOptimum found = minimize(objective, conditions, most_pivots);
  if (found.kind != LinearOptimum::Kind::attained || found.value.sign() > 0) return std::nullopt;
  const std::vector<Rational> point(found.x.begin(), found.x.end() - 1);
  std::vector<Rational> weights;
  for (const AffineForm& weight : weights_) weights.push_back(weight.at(point));
  return weights;
}

std::vector<Rational> ForcesAlong::sum(const std::vector<Rational>& weights) const {
  std::vector<Rational> r(size_);
  for (std::size_t j = 0; j < weights.size(); ++j) {
    if (weights[j].is_zero()) continue;
    for (std::size_t i = 0; i < size_; ++i) r[i] += weights[j] * rays_[j][i];
  }
  return r;
}

std::optional<std::vector<Rational>> ForcesAlong::most_even() const {
  const auto weights = greatest(0, rays_.size());
  return weights ? std::optional(sum(*weights)) : std::nullopt;
}

std::optional<std::vector<Rational>> ForcesAlong::most_open() const {
  auto mean = greatest(0, rays_.size());
  if (!mean) return std::nullopt;
  std::size_t members = 1;
  for (std::size_t ray = 0; ray < rays_.size(); ++ray) {
    if (!(*mean)[ray].is_zero()) continue;
    const auto weights = greatest(ray, 1);
    if (!weights) return std::nullopt;
    if ((*weights)[ray].is_zero()) continue;
    for (std::size_t j = 0; j < rays_.size(); ++j) (*mean)[j] += (*weights)[j];
    ++members;
  }
  for (Rational& weight : *mean) weight /= static_cast<long>(members);
  return sum(*mean);
}

ForceFamily forces_at(const ExactContacts& contacts, const SpatialMotion& motion) {
  const MotionRays rays(contacts, motion);
  const auto open_from = [&](std::span<const Rational> r) {
    return open_among(contacts, directions_from(contacts, r, motion.u));
  };
  ForceFamily family{motion.r, open_from(motion.r), false};
  // No forces are open along more directions than those of all cones.
  const std::size_t most = open_among(contacts, independent(rays.rays()));
  family.are_all = rays.has_all_directions() && family.open_directions == most;
  if (family.are_all || rays.rays().size() > most_rays) return family;
  auto r = ForcesAlong(contacts, motion.u, rays.rays()).most_open();
  if (!r) return family;
  const std::size_t open = open_from(*r);
  if (open > family.open_directions) family = {std::move(*r), open, false};
  family.are_all = rays.are_all() || (rays.has_all_directions() && open == most);
  return family;
}

std::optional<SpatialMotion> pressing_motion(const ExactContacts& contacts, const SpatialMotion& motion) {
  constexpr int arc_bits = 20;
  constexpr double arc = 0x1p-12;
  using Kind = ContactState::Kind;
  ContactPattern mode = motion.mode;
  for (std::size_t k = 0; k < mode.size(); ++k) {
    if (!motion.touching.empty() && motion.touching[k]) {
      const Rational square = square_of_tangent(contacts, motion.u, k);
      mode[k].kind = !contacts.has_friction(k) ? Kind::closed : square.is_zero() ? Kind::stick : Kind::slip;
    }
    if (mode[k].kind != Kind::slip || contacts.dimension < 3) continue;
    const std::size_t i = contacts.normal(k);
    const double angle = std::atan2(motion.u[i + 2].to_double(), motion.u[i + 1].to_double());
    mode[k].from = Direction::near(angle - arc, arc_bits);
    mode[k].to = Direction::near(angle + arc, arc_bits);
  }
  const IntegerContacts integers(contacts);
  const FloatingContacts floating(contacts);
  PatternProgram program(contacts, integers, floating, mode, PatternProgram::Cones::within);
  if (!program.feasibility().point) return std::nullopt;
  auto found = find_motion(contacts, floating, mode, program.middle(), [](std::span<const double>) { return false; });
  if (!found.motion || found.motion->differs(motion) || !found.motion->touching.empty()) return std::nullopt;
  return found.motion;
}

std::optional<SpatialMotion> rest_by_short_forces(const ExactContacts& contacts) {
  constexpr std::size_t most_contacts = 5;
  if (contacts.contacts() > most_contacts) return std::nullopt;
  SpatialMotion rest;
  rest.u.resize(contacts.size()), rest.r.resize(contacts.size());
  auto r = ForcesAlong(contacts, rest.u, MotionRays(contacts, rest).rays()).most_even();
  if (!r) return std::nullopt;
  auto motion = exact_motion(contacts, rest_pattern(contacts), std::move(*r));
  if (motion) motion->open_directions = forces_at(contacts, *motion).open_directions;
  return motion;
}

}  // namespace slipproof
