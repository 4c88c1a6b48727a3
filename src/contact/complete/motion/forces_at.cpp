#include "contact/complete/motion/forces_at.hpp"

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
  /// Whether they span all of the cones.
  bool are_all() const { return are_all_; }

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
    if (!speed) return add_own(k);  // the direction is no rational one
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
  bool are_all_ = true;
};

/// Of forces that press where all members of a family can: as many directions as forces of their contacts move nothing,
/// where a contact that sticks inside of its cone may push in any direction.
std::size_t directions_of(const ExactContacts& contacts, std::span<const Rational> r, std::span<const Rational> u) {
  RationalMatrix forces;
  for (std::size_t k = 0; k < contacts.contacts(); ++k) {
    const std::size_t i = contacts.normal(k);
    if (r[i].is_zero()) continue;
    const Rational limit = contacts.mu[k] * r[i];
    const bool is_inside = square_of_tangent(contacts, r, k) < limit * limit;
    if (is_inside && square_of_tangent(contacts, u, k).is_zero()) {
      for (std::size_t t = 0; t < contacts.dimension; ++t) {
        std::vector<Rational> axis(t + 1);
        axis[t] = 1;
        forces.push_back(force_on(contacts, k, std::move(axis)));
      }
    } else {
      const auto own = r.subspan(i, contacts.dimension);
      forces.push_back(force_on(contacts, k, {own.begin(), own.end()}));
    }
  }
  RationalMatrix columns;
  const std::vector<Rational> still(contacts.size());
  for (const std::vector<Rational>& force : forces) {
    std::vector<Rational>& column = columns.emplace_back(velocities(contacts, force));
    for (std::size_t i = 0; i < column.size(); ++i) column[i] -= contacts.q[i];
  }
  return columns.empty() ? 0 : columns.size() - eliminate(columns).rank();
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
    const std::vector<Rational> moved = velocities(contacts, rays_[j]);
    for (std::size_t i = 0; i < size_; ++i) system[i][j] = moved[i] - contacts.q[i];
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
  const ForceFamily alone{motion.r, 0, false};
  const MotionRays rays(contacts, motion);
  if (rays.rays().size() > most_rays) return alone;
  auto r = ForcesAlong(contacts, motion.u, rays.rays()).most_open();
  if (!r) return alone;
  const std::size_t open = directions_of(contacts, *r, motion.u);
  return {open > 0 ? std::move(*r) : motion.r, open, rays.are_all()};
}

}  // namespace slipproof
