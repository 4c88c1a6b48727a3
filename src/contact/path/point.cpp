#include "contact/path/point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/enclosure/residual.hpp"
#include "contact/path/long_number.hpp"

namespace slipproof {

namespace {

/// a over the scale of a contact: rounding changes a Delassus matrix by a few times 2^-52. Where a differs between
/// contacts, the path is another one.
double regularisation_of(std::size_t contact, unsigned attempt) {
  const std::size_t mixed = (contact + 1) * 2654435761U * attempt;
  return 0x1p-40 * (1 + 3 * static_cast<double>(mixed % 1021) / 1021);
}

DoubleDouble length(const DoubleDouble& a, const DoubleDouble& b) {
  return sqrt(a * a + b * b);
}

}  // namespace

PathPoint::PathPoint(const MixedProblem& problem, std::span<const double> x, unsigned attempt)
    : problem_(&problem),
      x_(problem.size(), 0),
      p_(problem.size(), 0),
      a_(problem.size(), 0),
      mode_(problem.contacts(), ConeState::open),
      slip_(problem.contacts(), 0),
      direction_(problem.contacts(), {1, 0}) {
  const std::vector<Rational> w = exact_rows(problem, x);
  const Residual fit = residual(problem, x, w);
  const std::vector<double> scales = contact_scales(problem);
  double largest = 0;
  for (std::size_t i = problem.free; i < problem.size(); ++i) largest = std::max(largest, std::abs(x[i]));
  force_ = largest > 0 ? largest : 1;
  std::copy(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(problem.free), x_.begin());
  std::vector<DoubleDouble> motion(problem.size(), 0);
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    const std::size_t n = problem.normal(k), d = problem.dimension;
    const double regularisation = regularisation_of(k, attempt) * scales[k];
    const double least = regularisation * force_;  // a velocity, so that the mode holds strictly
    std::fill_n(a_.begin() + static_cast<std::ptrdiff_t>(n), d, regularisation);
    std::vector<DoubleDouble> r, u;
    for (std::size_t i = 0; i < d; ++i) {
      r.push_back(to_double_double(fit.contacts[k].r[i]));
      u.push_back(to_double_double(fit.contacts[k].u[i]));
    }
    if (fit.contacts[k].fit == ContactFit::open || r[0].high <= 1e-13 * force_) {
      motion[n] = u[0].high > least ? u[0] : DoubleDouble(least);
      for (std::size_t i = 1; i < d; ++i) motion[n + i] = u[i];
      continue;
    }
    x_[n] = r[0];
    mode_[k] = stick;
    if (!has_friction(k)) continue;
    const double N = r[0].high, T = d == 3 ? length(r[1], r[2]).high : std::abs(r[1].high);
    if (fit.contacts[k].fit == ContactFit::stick && T < problem.mu[k] * N * (1 - 1e-13)) {
      for (std::size_t i = 1; i < d; ++i) x_[n + i] = r[i];
      continue;
    }
    const DoubleDouble speed = d == 3 ? length(u[1], u[2]) : abs(u[1]);
    const bool moves = speed.high > least;
    const DoubleDouble sum = d == 3 ? length(r[1], r[2]) : abs(r[1]);
    slip_[k] = moves ? speed : DoubleDouble(least);
    if (d == 3) {
      mode_[k] = slide;
      direction_[k] = moves ? std::array{u[1] / speed, u[2] / speed} : std::array{-r[1] / sum, -r[2] / sum};
      for (std::size_t i = 0; i < 2; ++i) motion[n + 1 + i] = slip_[k] * direction_[k][i];
    } else {
      const bool forward = moves ? u[1].high > 0 : r[1].high < 0;
      mode_[k] = forward ? slide_plus : slide_minus;
      motion[n + 1] = forward ? slip_[k] : -slip_[k];
    }
    set_tangential_force(k);
  }
  x0_ = x_;
  double largest_change = 1;  // p moves forces by no more than about their own size
  for (std::size_t i = 0; i < problem.size(); ++i) {
    p_[i] = motion[i] - row(i);
    if (a_[i] > 0) largest_change = std::max(largest_change, 4 * std::abs(p_[i].high) / (a_[i] * force_));
  }
  for (double& a : a_) a *= largest_change;
  t_ = 1;
  number_unknowns();
}

void PathPoint::number_unknowns() {
  first_.assign(mode_.size(), -1);
  unknowns_ = static_cast<Eigen::Index>(problem_->free);
  for (std::size_t k = 0; k < mode_.size(); ++k) {
    if (mode_[k] == open) continue;
    first_[k] = unknowns_;
    const bool along_edge = mode_[k] == slide_plus || mode_[k] == slide_minus;
    unknowns_ += has_friction(k) && !along_edge ? static_cast<Eigen::Index>(problem_->dimension) : 1;
  }
}

/// Of a contact that slides: its force is on the cone.
void PathPoint::set_tangential_force(std::size_t k) {
  const std::size_t n = problem_->normal(k);
  const DoubleDouble bound = DoubleDouble(problem_->mu[k]) * x_[n];
  if (mode_[k] == slide) {
    for (std::size_t i = 0; i < 2; ++i) x_[n + 1 + i] = -(bound * direction_[k][i]);
  } else {
    x_[n + 1] = mode_[k] == slide_plus ? -bound : bound;
  }
}

DoubleDouble PathPoint::slope(std::size_t row) const {
  return DoubleDouble(a_[row]) * (x_[row] - x0_[row]) + p_[row];
}

DoubleDouble PathPoint::row(std::size_t i) const {
  DoubleDouble sum = problem_->c[i];
  const auto columns = problem_->A.columns_of(i);
  const auto values = problem_->A.values_of(i);
  for (std::size_t e = 0; e < columns.size(); ++e) sum += DoubleDouble(values[e]) * x_[columns[e]];
  return t_.high == 0 ? sum : sum + t_ * slope(i);
}

/// Adds what a component of x, times a, gives to a row of the derivative.
void PathPoint::spread(LongVector& row, std::size_t component, const DoubleDouble& a) const {
  if (component < problem_->free) {
    row[static_cast<Eigen::Index>(component)] += a;
    return;
  }
  const std::size_t k = (component - problem_->free) / problem_->dimension, i = component - problem_->normal(k);
  if (mode_[k] == open || (i > 0 && !has_friction(k))) return;
  const Eigen::Index first = first_[k];
  const DoubleDouble bent = DoubleDouble(problem_->mu[k]) * a;
  if (i == 0) {
    row[first] += a;
  } else if (mode_[k] == stick) {
    row[first + static_cast<Eigen::Index>(i)] += a;
  } else if (mode_[k] == slide) {
    row[first] -= bent * direction_[k][i - 1];
    const DoubleDouble turned = i == 1 ? -direction_[k][1] : direction_[k][0];
    row[first + 1] -= bent * x_[problem_->normal(k)] * turned;
  } else {
    row[first] += mode_[k] == slide_plus ? -bent : bent;
  }
}

LongVector PathPoint::row_gradient(std::size_t i) const {
  LongVector gradient = LongVector::Zero(unknowns_ + 1);
  const auto columns = problem_->A.columns_of(i);
  const auto values = problem_->A.values_of(i);
  for (std::size_t e = 0; e < columns.size(); ++e) spread(gradient, columns[e], values[e]);
  if (a_[i] != 0) spread(gradient, i, t_ * DoubleDouble(a_[i]));
  gradient[unknowns_] = slope(i);
  return gradient;
}

LongVector PathPoint::equations(LongMatrix* derivative) const {
  LongVector F = LongVector::Zero(unknowns_ + 1);
  const auto put = [&](Eigen::Index equation, std::size_t i) {
    F[equation] = row(i);
    if (derivative != nullptr) derivative->row(equation) = row_gradient(i).transpose();
  };
  for (std::size_t i = 0; i < problem_->free; ++i) put(static_cast<Eigen::Index>(i), i);
  for (std::size_t k = 0; k < mode_.size(); ++k) {
    if (mode_[k] == open) continue;
    const std::size_t n = problem_->normal(k);
    const Eigen::Index first = first_[k];
    put(first, n);
    const bool more = has_friction(k) && (mode_[k] == stick || mode_[k] == slide);
    for (std::size_t i = 1; more && i < problem_->dimension; ++i) {
      const Eigen::Index e = first + static_cast<Eigen::Index>(i);
      put(e, n + i);
      if (mode_[k] != slide) continue;
      F[e] -= slip_[k] * direction_[k][i - 1];
      if (derivative == nullptr) continue;
      const DoubleDouble turned = i == 1 ? -direction_[k][1] : direction_[k][0];
      (*derivative)(e, first + 1) -= slip_[k] * turned;
      (*derivative)(e, first + 2) -= direction_[k][i - 1];
    }
  }
  return F;
}

void PathPoint::move(const LongVector& step) {
  for (std::size_t i = 0; i < problem_->free; ++i) x_[i] += step[static_cast<Eigen::Index>(i)];
  for (std::size_t k = 0; k < mode_.size(); ++k) {
    if (mode_[k] == open) continue;
    const Eigen::Index first = first_[k];
    const std::size_t n = problem_->normal(k);
    x_[n] += step[first];
    if (!has_friction(k)) continue;
    if (mode_[k] == stick) {
      for (std::size_t i = 1; i < problem_->dimension; ++i) x_[n + i] += step[first + static_cast<Eigen::Index>(i)];
      continue;
    }
    if (mode_[k] == slide) {
      const DoubleDouble& angle = step[first + 1];
      auto& [a, b] = direction_[k];
      const DoubleDouble x = a - angle * b, y = b + angle * a, size = length(x, y);
      direction_[k] = {x / size, y / size};
      slip_[k] += step[first + 2];
    }
    set_tangential_force(k);
  }
  t_ += step[unknowns_];
}

double PathPoint::size_of(const LongVector& step) const {
  double size = std::abs(step[unknowns_].high);
  for (std::size_t k = 0; k < mode_.size(); ++k) {
    if (mode_[k] == open) continue;
    const Eigen::Index first = first_[k];
    size = std::max(size, std::abs(step[first].high) / force_);
    if (mode_[k] == slide) size = std::max(size, std::abs(step[first + 1].high));
    if (mode_[k] != stick || !has_friction(k)) continue;
    for (std::size_t i = 1; i < problem_->dimension; ++i) {
      size = std::max(size, std::abs(step[first + static_cast<Eigen::Index>(i)].high) / force_);
    }
  }
  return std::all_of(step.begin(), step.end(), [](const DoubleDouble& x) { return std::isfinite(x.high); })
             ? size
             : std::numeric_limits<double>::infinity();
}

std::vector<Margin> PathPoint::margins() const {
  using Kind = Margin::Kind;
  std::vector<Margin> result{{Kind::end, 0}};
  for (std::size_t k = 0; k < mode_.size(); ++k) {
    if (mode_[k] == open) {
      result.push_back({Kind::gap, k});
    } else if (mode_[k] == stick) {
      result.push_back({has_friction(k) ? Kind::cone : Kind::force, k});
    } else {
      result.push_back({Kind::force, k});
      result.push_back({Kind::slip, k});
    }
  }
  return result;
}

double PathPoint::scale(const Margin& margin) const {
  if (margin.kind == Margin::Kind::end) return 1;
  const bool of_motion = margin.kind == Margin::Kind::gap || margin.kind == Margin::Kind::slip;
  return of_motion ? a_[problem_->normal(margin.contact)] * force_ : force_;
}

DoubleDouble PathPoint::tangential_force(std::size_t k) const {
  const std::size_t n = problem_->normal(k);
  return problem_->dimension == 3 ? length(x_[n + 1], x_[n + 2]) : abs(x_[n + 1]);
}

DoubleDouble PathPoint::value(const Margin& margin) const {
  const std::size_t k = margin.contact;
  if (margin.kind == Margin::Kind::end) return t_;
  const std::size_t n = problem_->normal(k);
  switch (margin.kind) {
    case Margin::Kind::gap:
      return row(n);
    case Margin::Kind::force:
      return x_[n];
    case Margin::Kind::cone:
      return DoubleDouble(problem_->mu[k]) * x_[n] - tangential_force(k);
    default:
      return mode_[k] == slide ? slip_[k] : mode_[k] == slide_plus ? row(n + 1) : -row(n + 1);
  }
}

LongVector PathPoint::gradient(const Margin& margin) const {
  LongVector gradient = LongVector::Zero(unknowns_ + 1);
  const std::size_t k = margin.contact;
  if (margin.kind == Margin::Kind::end) {
    gradient[unknowns_] = 1;
    return gradient;
  }
  const std::size_t n = problem_->normal(k);
  switch (margin.kind) {
    case Margin::Kind::gap:
      return row_gradient(n);
    case Margin::Kind::force:
      gradient[first_[k]] = 1;
      return gradient;
    case Margin::Kind::cone: {
      const DoubleDouble T = tangential_force(k);
      gradient[first_[k]] = problem_->mu[k];
      for (std::size_t i = 1; i < problem_->dimension && T.high > 0; ++i) {
        gradient[first_[k] + static_cast<Eigen::Index>(i)] = -(x_[n + i] / T);
      }
      return gradient;
    }
    default:
      if (mode_[k] != slide) return mode_[k] == slide_plus ? row_gradient(n + 1) : LongVector(-row_gradient(n + 1));
      gradient[first_[k] + 2] = 1;
      return gradient;
  }
}

Margin PathPoint::pass(const Margin& margin) {
  using Kind = Margin::Kind;
  constexpr double none = 1e-9;
  const std::size_t k = margin.contact, n = problem_->normal(k);
  Margin entered{Kind::force, k};
  if (margin.kind == Kind::gap) {  // it slides as it did in the air
    if (!has_friction(k)) {
      mode_[k] = stick;
    } else if (problem_->dimension == 2) {
      mode_[k] = row(n + 1).high > 0 ? slide_plus : slide_minus;
    } else {
      const DoubleDouble a = row(n + 1), b = row(n + 2), speed = length(a, b);
      mode_[k] = speed.high > none * scale(margin) ? slide : stick;  // without a direction it comes down to stick
      if (mode_[k] == slide) {
        slip_[k] = speed;
        direction_[k] = {a / speed, b / speed};
      }
    }
  } else if (margin.kind == Kind::force || (margin.kind == Kind::cone && !(tangential_force(k).high > none * force_))) {
    mode_[k] = open;
    for (std::size_t i = 0; i < problem_->dimension; ++i) x_[n + i] = 0;
    entered.kind = Kind::gap;
  } else if (margin.kind == Kind::cone) {
    if (problem_->dimension == 2) {
      mode_[k] = x_[n + 1].high < 0 ? slide_plus : slide_minus;
    } else {
      const DoubleDouble T = tangential_force(k);
      mode_[k] = slide;
      direction_[k] = {-x_[n + 1] / T, -x_[n + 2] / T};
      slip_[k] = 0;
    }
    entered.kind = Kind::slip;
  } else {
    mode_[k] = stick;
    entered.kind = Kind::cone;
  }
  number_unknowns();
  return entered;
}

}  // namespace slipproof
