#include "contact/solutions.hpp"

#include <algorithm>

#include "number/bareiss.hpp"

namespace slipproof {

namespace {

ProblemMode next_mode(ProblemMode mode, bool frictional, bool& done) {
  for (ContactState& state : mode) {
    if (state == ContactState::lift) {
      state = ContactState::stick;
      continue;
    }
    state = frictional ? static_cast<ContactState>(static_cast<int>(state) + 1) : ContactState::lift;
    return mode;
  }
  done = true;
  return mode;
}

/// A fraction that nobody has brought to lowest terms yet: most conditions are asked for their sign alone.
struct Fraction {
  Integer numerator, denominator;
  int sign() const { return numerator.sign() * denominator.sign(); }
};

}  // namespace

/// The problem in integers. Rows of W and q are multiplied by something positive: neither solutions nor signs change.
struct ContactSolver::Scaled {
  std::vector<std::vector<Integer>> rows;  ///< W, then q
  std::vector<Integer> factor;             ///< what each row was multiplied by
  std::vector<Integer> friction, unit;     ///< mu = friction / unit of each contact
  std::size_t bits = 0;                    ///< of the longest number

  /// The left-hand side of a condition for z / pivot.
  Fraction condition_value(const ProblemCondition& condition, const std::vector<Integer>& z,
                           const Integer& pivot) const;
  /// A component of w, times its factor and the pivot.
  Integer acceleration(std::size_t row, const std::vector<Integer>& z, const Integer& pivot) const;
};

Integer ContactSolver::Scaled::acceleration(std::size_t row, const std::vector<Integer>& z,
                                            const Integer& pivot) const {
  Integer w = rows[row].back() * pivot;
  for (std::size_t j = 0; j < z.size(); ++j) {
    if (!z[j].is_zero()) w += rows[row][j] * z[j];
  }
  return w;
}

Fraction ContactSolver::Scaled::condition_value(const ProblemCondition& condition, const std::vector<Integer>& z,
                                                const Integer& pivot) const {
  const std::size_t i = condition.contact, normal = friction.empty() ? i : 2 * i;
  switch (condition.kind) {
    case ConditionKind::normal:
      return {z[normal], pivot};
    case ConditionKind::friction_up:
      return {friction[i] * z[normal] - unit[i] * z[normal + 1], unit[i] * pivot};
    case ConditionKind::friction_dn:
      return {friction[i] * z[normal] + unit[i] * z[normal + 1], unit[i] * pivot};
    case ConditionKind::slip: {
      const Integer w = acceleration(normal + 1, z, pivot);
      return {condition.state == ContactState::slip_forward ? w : Integer(-w), factor[normal + 1] * pivot};
    }
    case ConditionKind::gap:
      return {acceleration(normal, z, pivot), factor[normal] * pivot};
  }
  return {};
}

ContactSolver::ContactSolver(const ContactProblem& problem) : problem_(problem) {
  Scaled s;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    std::vector<Rational> row = problem.W[i];
    row.push_back(problem.q[i]);
    s.factor.push_back(common_denominator(row));
    s.rows.push_back(clear_denominators(row));
    for (const Integer& x : s.rows.back()) s.bits = std::max(s.bits, bit_count(x));
  }
  for (const Rational& mu : problem.mu) {
    s.friction.push_back(numerator(mu));
    s.unit.push_back(denominator(mu));
    s.bits = std::max(s.bits, bit_count(s.friction.back()) + bit_count(s.unit.back()));
  }
  scaled_ = std::make_unique<const Scaled>(std::move(s));
}

ContactSolver::~ContactSolver() = default;

Work ContactSolver::modes() const {
  return problem_.size() < 63 ? Work{1} << problem_.size() : endless;  // 4 for two components with friction, 2 for one
}

/// Of a mode that leaves so many components of z open: elimination, in which the numbers grow, then the conditions.
Work ContactSolver::work_of(std::size_t unknowns) const {
  Work work = times(problem_.size() * unknowns, product_work(scaled_->bits * (unknowns + 1)));
  for (std::size_t step = 1; step <= unknowns; ++step) {
    work = plus(work, times(3 * unknowns * (unknowns + 1), product_work(scaled_->bits * step)));
  }
  return work;
}

Work ContactSolver::work_of_all() const {
  const std::size_t n = problem_.size();
  if (modes() == endless) return endless;
  Work work = 0, chosen = 1;  // k of n components: so many modes leave k open, with friction as without
  for (std::size_t k = 0; k <= n; ++k) {
    work = plus(work, times(chosen, work_of(k)));
    if (chosen > endless / 64) return endless;
    chosen = chosen * (n - k) / (k + 1);
  }
  return work;
}

ModeOutcome ContactSolver::solve(const ProblemMode& mode, Effort& effort) const {
  // z = sum of y_k columns[k]: the forces that the mode leaves open, each with the components it drives.
  using Column = std::vector<std::pair<std::size_t, Integer>>;
  std::vector<Column> columns;
  std::vector<std::size_t> equations;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const std::size_t normal = problem_.frictional() ? 2 * i : i;
    if (mode[i] == ContactState::lift) continue;
    equations.push_back(normal);
    if (!problem_.frictional() || mode[i] == ContactState::stick) {
      columns.push_back({{normal, 1}});
    } else {
      const Integer& friction = scaled_->friction[i];
      columns.push_back(
          {{normal, scaled_->unit[i]}, {normal + 1, slip_direction(mode[i]) > 0 ? Integer(-friction) : friction}});
    }
    if (problem_.frictional() && mode[i] == ContactState::stick) {
      equations.push_back(normal + 1);
      columns.push_back({{normal + 1, 1}});
    }
  }
  const std::size_t size = problem_.size(), unknowns = columns.size();
  effort.spend(work_of(unknowns));
  IntegerMatrix matrix;
  for (const std::size_t row : equations) {
    std::vector<Integer> entries;
    for (const Column& column : columns) {
      Integer sum = 0;
      for (const auto& [j, factor] : column) sum += scaled_->rows[row][j] * factor;
      entries.push_back(std::move(sum));
    }
    entries.push_back(-scaled_->rows[row][size]);
    matrix.push_back(std::move(entries));
  }
  const Echelon echelon = eliminate(std::move(matrix), unknowns);
  ModeOutcome outcome;
  for (std::size_t i = echelon.rank(); i < echelon.rows.size(); ++i) {
    if (!echelon.rows[i][unknowns].is_zero()) return outcome;
  }
  // A column of the echelon form, as z: the right-hand side, or what one of the free unknowns adds.
  const auto to_z = [&](std::size_t right, bool homogeneous) {
    std::vector<Rational> z(size);
    const auto add = [&](std::size_t k, const Rational& y) {
      for (const auto& [j, factor] : columns[k]) z[j] += y * Rational(factor);
    };
    for (std::size_t i = 0; i < echelon.rank(); ++i) {
      const Integer& value = echelon.rows[i][right];
      if (!value.is_zero()) {
        add(echelon.pivot_columns[i], Rational(homogeneous ? Integer(-value) : value, echelon.pivot));
      }
    }
    if (homogeneous) add(right, 1);
    return z;
  };
  if (echelon.rank() == unknowns) {
    std::vector<Integer> z(size);  // times the pivot
    for (std::size_t i = 0; i < unknowns; ++i) {
      for (const auto& [j, factor] : columns[i]) z[j] = echelon.rows[i][unknowns] * factor;
    }
    outcome.kind = ModeOutcome::Kind::solution;
    outcome.strict = true;
    for (const ProblemCondition& condition : conditions(problem_, mode)) {
      const Fraction value = scaled_->condition_value(condition, z, echelon.pivot);
      if (value.sign() < 0) {
        outcome.kind = ModeOutcome::Kind::violated;
        outcome.condition = condition;
        outcome.margin = Rational(value.numerator, value.denominator);
        return outcome;
      }
      outcome.strict = outcome.strict && value.sign() > 0;
    }
    outcome.z = to_z(unknowns, false);
    return outcome;
  }
  outcome.z = to_z(unknowns, false);
  ContactContinuum continuum{mode, outcome.z, {}, {}};
  std::vector<std::vector<Rational>> changes;  // of w, by each direction
  for (std::size_t k = 0; k < unknowns; ++k) {
    if (std::find(echelon.pivot_columns.begin(), echelon.pivot_columns.end(), k) != echelon.pivot_columns.end()) {
      continue;
    }
    continuum.directions.push_back(to_z(k, true));
    auto change = accelerations(problem_, continuum.directions.back());
    for (std::size_t i = 0; i < size; ++i) change[i] -= problem_.q[i];
    changes.push_back(std::move(change));
  }
  const auto w = accelerations(problem_, continuum.base);
  for (const ProblemCondition& condition : conditions(problem_, mode)) {
    AffineForm form{condition_value(problem_, condition, continuum.base, w), {}};
    for (std::size_t k = 0; k < changes.size(); ++k) {
      form.coefficients.push_back(condition_value(problem_, condition, continuum.directions[k], changes[k]));
    }
    continuum.conditions.push_back(std::move(form));
  }
  // One point, or more?
  AffineForm parameter{0, std::vector<Rational>(changes.size())};
  bool point = true;
  LinearOptimum lowest;
  for (std::size_t k = 0; k < changes.size() && point; ++k) {
    parameter.coefficients[k] = 1;
    lowest = minimize(parameter, continuum.conditions, effort);
    if (lowest.kind == LinearOptimum::Kind::infeasible) return outcome;
    parameter.coefficients[k] = -1;
    const LinearOptimum highest = minimize(parameter, continuum.conditions, effort);
    parameter.coefficients[k] = 0;
    point = lowest.kind == LinearOptimum::Kind::attained && highest.kind == LinearOptimum::Kind::attained &&
            lowest.value == -highest.value;
  }
  if (point) {
    outcome.kind = ModeOutcome::Kind::solution;
    outcome.z = continuum.at(lowest.x);
  } else {
    outcome.kind = ModeOutcome::Kind::continuum;
    outcome.continuum = std::move(continuum);
  }
  return outcome;
}

std::optional<ContactSolutions> ContactSolver::all(Effort& effort) const {
  if (!effort.allows(work_of_all())) return std::nullopt;
  try {
    return try_all(effort);
  } catch (const TooMuchWork&) {
    return std::nullopt;
  }
}

std::optional<ContactSolutions> ContactSolver::all() const {
  Effort effort(usual_effort);
  return all(effort);
}

ContactSolutions ContactSolver::try_all(Effort& effort) const {
  ContactSolutions found;
  ProblemMode mode(problem_.contacts(), ContactState::stick);
  for (bool done = false; !done; mode = next_mode(std::move(mode), problem_.frictional(), done)) {
    ModeOutcome outcome = solve(mode, effort);
    if (outcome.kind == ModeOutcome::Kind::continuum) found.continua.push_back(std::move(*outcome.continuum));
    if (outcome.kind != ModeOutcome::Kind::solution) continue;
    const auto same = std::find_if(found.solutions.begin(), found.solutions.end(),
                                   [&](const ContactSolution& s) { return s.z == outcome.z; });
    if (same == found.solutions.end()) {
      auto w = accelerations(problem_, outcome.z);
      found.solutions.push_back({{mode}, outcome.strict, std::move(outcome.z), std::move(w)});
    } else {
      same->modes.push_back(mode);
      same->strict = same->strict || outcome.strict;
    }
  }
  std::erase_if(found.solutions, [&](const ContactSolution& s) {
    return std::any_of(found.continua.begin(), found.continua.end(),
                       [&](const ContactContinuum& c) { return solves(problem_, c.mode, s.z); });
  });
  return found;
}

std::optional<ContactSolution> ContactSolver::only(ProblemMode mode, Effort& effort) const {
  // As integers with one denominator the entries may be longer than those of a row.
  const Work definite = times(work_of(problem_.size()), 4);
  if (problem_.frictional() || !effort.allows(definite) || !positive_definite(problem_.W)) return std::nullopt;
  try {
    while (true) {
      ModeOutcome outcome = solve(mode, effort);
      if (outcome.kind == ModeOutcome::Kind::solution) {
        auto w = accelerations(problem_, outcome.z);
        return ContactSolution{{mode}, outcome.strict, std::move(outcome.z), std::move(w)};
      }
      ContactState& state = mode[outcome.condition->contact];
      state = state == ContactState::lift ? ContactState::stick : ContactState::lift;
    }
  } catch (const TooMuchWork&) {
    return std::nullopt;
  }
}

std::optional<ContactSolution> ContactSolver::only(ProblemMode start) const {
  Effort effort(usual_effort);
  return only(std::move(start), effort);
}

bool positive_definite(const RationalMatrix& W) {
  std::vector<Rational> flat;
  for (const auto& row : W) flat.insert(flat.end(), row.begin(), row.end());
  const Integer common = common_denominator(flat);
  const std::size_t n = W.size();
  IntegerMatrix m(n, std::vector<Integer>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) m[i][j] = integer_times(W[i][j] + W[j][i], common);
  }
  // Bareiss without a choice of pivots: they are the leading principal minors.
  Integer previous = 1;
  for (std::size_t k = 0; k < n; ++k) {
    if (m[k][k].sign() <= 0) return false;
    for (std::size_t i = k + 1; i < n; ++i) {
      for (std::size_t j = k + 1; j < n; ++j) m[i][j] = (m[k][k] * m[i][j] - m[i][k] * m[k][j]) / previous;
    }
    previous = m[k][k];
  }
  return true;
}

std::vector<Rational> ContactContinuum::at(const std::vector<Rational>& t) const {
  std::vector<Rational> z = base;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    for (std::size_t i = 0; i < z.size(); ++i) z[i] += t[k] * directions[k][i];
  }
  return z;
}

}  // namespace slipproof
