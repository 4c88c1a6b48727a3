#include "contact/enclosure/mode_system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "base/number/binary64.hpp"
#include "contact/linear/rounding.hpp"

namespace slipproof {

namespace {

double approximate_row(const MixedProblem& problem, std::size_t row, std::span<const double> x) {
  return row_sum(problem, row, x).nearest();
}

/// The state of a closed contact that slides with these signs, if with any.
ConeState with_signs(std::array<int, 2> signs, std::size_t dimension) {
  if (signs == std::array<int, 2>{0, 0}) return ConeState::stick;
  const auto first = static_cast<std::size_t>(dimension == 2 ? ConeState::slide_plus : ConeState::slide_plus_0);
  const auto last = static_cast<std::size_t>(dimension == 2 ? ConeState::slide_minus : ConeState::slide_minus_minus);
  for (std::size_t state = first; state < last; ++state) {
    if (slip_signs(static_cast<ConeState>(state)) == signs) return static_cast<ConeState>(state);
  }
  return static_cast<ConeState>(last);
}

}  // namespace

std::string_view name(ConeState state) {
  constexpr std::array<std::string_view, 14> names{"open",    "touch",   "stick",   "slide",   "slide+",
                                                   "slide-",  "slide+0", "slide-0", "slide0+", "slide0-",
                                                   "slide++", "slide+-", "slide-+", "slide--"};
  return names[static_cast<std::size_t>(state)];
}

std::array<int, 2> slip_signs(ConeState state) {
  const std::string_view signs = name(state).substr(std::min<std::size_t>(name(state).size(), 5));  // after `slide`
  const auto sign = [&](std::size_t i) { return i >= signs.size() || signs[i] == '0' ? 0 : signs[i] == '+' ? 1 : -1; };
  return {sign(0), sign(1)};
}

double before_projection(const MixedProblem& problem, std::span<const double> x, std::size_t contact, std::size_t part,
                         double scale) {
  const std::size_t row = problem.normal(contact) + part;
  return x[row] - approximate_row(problem, row, x) / scale;
}

ConeMode guess_mode(const MixedProblem& problem, std::span<const double> x, std::span<const double> scales) {
  ConeMode mode;
  const bool box = problem.law.kind == FrictionLaw::box;
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    const auto projected = [&](std::size_t part) { return before_projection(problem, x, k, part, scales[k]); };
    const auto slips = [&](std::size_t part, double bound) {
      const double T = projected(part);
      return std::abs(T) <= bound ? 0 : T < 0 ? 1 : -1;
    };
    const double N = projected(0), mu = problem.mu[k];
    const bool leans = problem.law.kind == FrictionLaw::associated && problem.dimension > 1 && mu > 0;
    const double T = leans ? std::hypot(projected(1), problem.dimension == 3 ? projected(2) : 0) : 0;
    if (leans ? !(N > -mu * T) : !(N > 0)) {
      mode.push_back(ConeState::open);
    } else if (problem.dimension == 1 || mu == 0) {
      mode.push_back(ConeState::stick);
    } else if (problem.dimension == 2) {
      mode.push_back(with_signs({slips(1, mu * N), 0}, 2));
    } else if (box) {
      mode.push_back(with_signs({slips(1, mu * N), slips(2, mu * N)}, 3));
    } else {
      const bool sticks = std::hypot(projected(1), projected(2)) <= mu * N;
      mode.push_back(sticks ? ConeState::stick : ConeState::slide);
    }
  }
  return mode;
}

ModeSystem::ModeSystem(const MixedProblem& problem, ConeMode mode)
    : problem_(&problem),
      mode_(std::move(mode)),
      unknown_of_(problem.size(), none),
      slip_of_(problem.contacts(), none) {
  for (std::size_t i = 0; i < problem.free; ++i) {
    unknown_of_[i] = i;
    unknowns_.push_back(i);
    equations_.push_back({Kind::linear, i});
  }
  for (std::size_t k = 0; k < problem.contacts(); ++k) {
    if (mode_[k] != ConeState::open) add_contact(k);
  }
}

void ModeSystem::add_contact(std::size_t k) {
  const std::size_t first = problem_->normal(k), force = unknowns_.size();
  const std::size_t d = problem_->mu[k] == 0 || touches(k) ? 1 : problem_->dimension;
  for (std::size_t i = 0; i < d; ++i) {
    unknown_of_[first + i] = unknowns_.size();
    unknowns_.push_back(first + i);
  }
  const bool opens = problem_->law.kind == FrictionLaw::associated;
  const double mu = problem_->mu[k];
  if (mode_[k] == ConeState::slide) {
    slip_of_[k] = unknowns_.size();
    unknowns_.push_back(none);
    equations_.push_back({opens ? Kind::opening : Kind::linear, first, force, opens ? slip_of_[k] : none, mu});
    for (std::size_t i = 1; i < d; ++i) equations_.push_back({Kind::tangential, first + i, force + i, slip_of_[k]});
    equations_.push_back({Kind::cone, first, force, none, mu});
    return;
  }
  const std::array<int, 2> signs = slip_signs(mode_[k]);
  const bool leans = opens && signs[0] != 0;
  equations_.push_back({leans ? Kind::leaning : Kind::linear, first, force, none, leans ? signs[0] * mu : 0});
  for (std::size_t i = 1; i < d; ++i) {
    if (signs[i - 1] == 0) {
      equations_.push_back({Kind::linear, first + i, force});
    } else {
      equations_.push_back({Kind::edge, first, force + i, none, signs[i - 1] * mu, force});
    }
  }
}

std::vector<double> ModeSystem::unknowns_at(std::span<const double> x) const {
  std::vector<double> z(size());
  for (std::size_t j = 0; j < size(); ++j) {
    if (unknowns_[j] != none && !is_zero(unknowns_[j])) z[j] = x[unknowns_[j]];
  }
  for (std::size_t k = 0; k < mode_.size(); ++k) {
    if (slip_of_[k] == none) continue;
    const std::size_t t = problem_->normal(k) + 1;
    const double u1 = approximate_row(*problem_, t, x), u2 = approximate_row(*problem_, t + 1, x);
    const double square = x[t] * x[t] + x[t + 1] * x[t + 1];
    const double slip = -(u1 * x[t] + u2 * x[t + 1]) / square;
    z[slip_of_[k]] = std::isfinite(slip) ? std::max(slip, 0.0) : 0;
  }
  return z;
}

std::vector<double> ModeSystem::x_at(std::span<const double> z) const {
  std::vector<double> x(problem_->size(), 0);
  for (std::size_t j = 0; j < size(); ++j) {
    if (unknowns_[j] != none) x[unknowns_[j]] = z[j];
  }
  return x;
}

template <class Row, class At>
Rational ModeSystem::value_of(const Equation& e, const Row& row, const At& at) const {
  switch (e.kind) {
    case Kind::linear:
      return row(e.row);
    case Kind::tangential:
      return row(e.row) + at(e.slip) * at(e.force);
    case Kind::opening:
      return row(e.row) - at(e.slip) * at(e.force) * to_rational(e.mu) * to_rational(e.mu);
    case Kind::leaning:
      return row(e.row) - to_rational(e.mu) * row(e.row + 1);
    case Kind::edge:
      return at(e.force) + to_rational(e.mu) * at(e.normal);
    default: {
      const Rational bound = to_rational(e.mu) * at(e.force), r1 = at(e.force + 1), r2 = at(e.force + 2);
      return r1 * r1 + r2 * r2 - bound * bound;
    }
  }
}

Rational ModeSystem::value(std::size_t equation, std::span<const double> z, std::span<const double> x) const {
  return value_of(
      equations_[equation], [&](std::size_t row) { return exact_row(*problem_, row, x); },
      [&](std::size_t j) { return to_rational(z[j]); });
}

Rational ModeSystem::value(std::size_t equation, std::span<const Rational> z) const {
  const auto row = [&](std::size_t i) {
    Rational sum = to_rational(problem_->c[i]);
    for (std::size_t e = problem_->A.starts[i]; e < problem_->A.starts[i + 1]; ++e) {
      const std::size_t j = unknown_of_[problem_->A.column[e]];
      if (j != none) sum += to_rational(problem_->A.value[e]) * z[j];
    }
    return sum;
  };
  return value_of(equations_[equation], row, [&](std::size_t j) -> const Rational& { return z[j]; });
}

double ModeSystem::nearest_value(std::size_t equation, std::span<const double> z, std::span<const double> x) const {
  const Equation& e = equations_[equation];
  if (e.kind != Kind::linear && e.kind != Kind::tangential) return nearest_binary64(value(equation, z, x));
  ExactSum sum = row_sum(*problem_, e.row, x);
  if (e.kind == Kind::tangential) sum.add(z[e.slip], z[e.force]);
  return sum.nearest();
}

std::vector<ModeSystem::Entry> ModeSystem::derivative(std::size_t equation, std::span<const double> z) const {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  const Equation& e = equations_[equation];
  std::vector<Entry> entries;
  if (e.kind == Kind::edge) return {{e.normal, e.mu, 0}, {e.force, 1, 0}};
  if (e.kind == Kind::cone) {
    const double slope = -2 * (e.mu * e.mu) * z[e.force];  // two roundings, by more than half an ulp together
    return {{e.force, slope, 4 * unit_roundoff * std::abs(slope) + 4 * tiny * (1 + std::abs(z[e.force]))},
            {e.force + 1, 2 * z[e.force + 1], 0},
            {e.force + 2, 2 * z[e.force + 2], 0}};
  }
  if (e.kind == Kind::leaning) return leaning_row(e);
  const auto columns = problem_->A.columns_of(e.row);
  const auto values = problem_->A.values_of(e.row);
  const bool slips = e.slip != none;
  // The term k s r: k is 1, exactly, or -mu^2, rounded by an ulp at most.
  const double k = e.kind == Kind::opening ? -(e.mu * e.mu) : 1;
  const double by_force = slips ? k * z[e.slip] : 0, by_slip = slips ? k * z[e.force] : 0;
  const auto error = [&](double x) { return k == 1 ? 0 : 4 * unit_roundoff * std::abs(x) + 4 * tiny; };
  bool found = !slips;
  for (std::size_t n = 0; n < columns.size(); ++n) {
    const std::size_t j = unknown_of_[columns[n]];
    if (j == none) continue;
    entries.push_back({j, values[n], 0});
    if (!slips || j != e.force) continue;
    found = true;
    entries.back().value += by_force;
    entries.back().error = 2 * unit_roundoff * std::abs(entries.back().value) + error(by_force);
  }
  if (!found) entries.push_back({e.force, by_force, error(by_force)});
  if (slips) entries.push_back({e.slip, by_slip, error(by_slip)});
  return entries;
}

/// A row less mu times the next one.
std::vector<ModeSystem::Entry> ModeSystem::leaning_row(const Equation& e) const {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  std::map<std::size_t, Entry> entries;
  for (const bool next : {false, true}) {
    const auto columns = problem_->A.columns_of(e.row + (next ? 1 : 0));
    const auto values = problem_->A.values_of(e.row + (next ? 1 : 0));
    for (std::size_t n = 0; n < columns.size(); ++n) {
      const std::size_t j = unknown_of_[columns[n]];
      if (j == none) continue;
      Entry& entry = entries.try_emplace(j, Entry{j, 0, 0}).first->second;
      const double term = next ? -e.mu * values[n] : values[n];
      entry.value += term;
      if (next) entry.error = 2 * unit_roundoff * (std::abs(entry.value) + std::abs(term)) + 2 * tiny;
    }
  }
  std::vector<Entry> result;
  for (const auto& [j, entry] : entries) result.push_back(entry);
  return result;
}

std::vector<std::pair<std::size_t, Rational>> ModeSystem::exact_derivative(std::size_t equation,
                                                                           std::span<const Rational> z) const {
  const Equation& e = equations_[equation];
  const Rational mu = to_rational(e.mu);
  if (e.kind == Kind::edge) return {{e.normal, mu}, {e.force, 1}};
  if (e.kind == Kind::cone) {
    return {{e.force, -2 * mu * mu * z[e.force]}, {e.force + 1, 2 * z[e.force + 1]}, {e.force + 2, 2 * z[e.force + 2]}};
  }
  std::map<std::size_t, Rational> entries;
  const auto add_row = [&](std::size_t row, const Rational& factor) {
    const auto columns = problem_->A.columns_of(row);
    for (std::size_t n = 0; n < columns.size(); ++n) {
      const std::size_t j = unknown_of_[columns[n]];
      if (j != none) entries[j] += factor * to_rational(problem_->A.values_of(row)[n]);
    }
  };
  add_row(e.row, 1);
  if (e.kind == Kind::leaning) add_row(e.row + 1, -mu);
  if (e.slip != none) {
    const Rational k = e.kind == Kind::opening ? Rational(-mu * mu) : Rational(1);
    entries[e.force] += k * z[e.slip];
    entries[e.slip] += k * z[e.force];
  }
  return {entries.begin(), entries.end()};
}

double ModeSystem::second_order(std::size_t equation, std::span<const double> radius) const {
  const Equation& e = equations_[equation];
  if (e.kind == Kind::tangential) return radius[e.slip] * radius[e.force];
  if (e.kind == Kind::opening) return e.mu * e.mu * radius[e.slip] * radius[e.force];
  if (e.kind != Kind::cone) return 0;
  const double N = e.mu * radius[e.force], T1 = radius[e.force + 1], T2 = radius[e.force + 2];
  return std::max(T1 * T1 + T2 * T2, N * N);
}

}  // namespace slipproof
