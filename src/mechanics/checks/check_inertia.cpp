#include <algorithm>
#include <numeric>

#include "base/number/format.hpp"
#include "mechanics/checks/check_parts.hpp"
#include "mechanics/checks/free_motion.hpp"

namespace slipproof::mechanism_checks {

namespace {

using Check = MechanismFinding::Check;

/// The inertia of one [motion]: what multiplies accelerations in its rows.
class InertiaCheck {
 public:
  InertiaCheck(const CheckPoints& points, const std::vector<bool>& scaled_well)
      : points_(points), mechanism_(points.mechanism()), scaled_well_(scaled_well), n_(mechanism_.accelerations) {
    for (const SymbolicForm& slope : mechanism_.energy_slopes) {
      energy_.push_back(points.maker().compiled().compile(slope));
    }
  }

  std::vector<MechanismFinding> check() {
    std::size_t count = 0;
    for (const CheckPoint& point : points_.all()) {
      if (auto finding = energy_.empty() ? asymmetry(point) : against_energy(point)) return {std::move(*finding)};
      if (++count == CheckPoints::enough) break;
    }
    if (!energy_.empty()) return {};
    return scale();
  }

 private:
  const MechanismEquation& row(std::size_t i) const { return mechanism_.equations[i]; }
  const std::string& acceleration(std::size_t i) const { return mechanism_.unknowns[i].symbol; }

  Matrix inertia(const FrictionProblem& problem) const {
    Matrix result;
    for (std::size_t i = 0; i < n_; ++i) {
      const auto& all = problem.equations[i].coefficients;
      result.emplace_back(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(n_));
    }
    return result;
  }

  std::string where(const CheckPoint& point, std::size_t i, std::size_t k) const {
    return points_.where(point, [&](const CheckPoint& there) -> std::optional<Rational> {
      return there.problem.equations[i].coefficients[k];
    });
  }

  std::optional<MechanismFinding> asymmetry(const CheckPoint& point) const {
    const Matrix matrix = inertia(point.problem);
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        if (matrix[i][k] == matrix[k][i]) continue;
        const bool late = matrix[k][i].is_zero();  // then the row of k lacks a term
        return warning(Check::inertia, row(late ? k : i).left.place(),
                       "the inertia is not symmetric, as virtual work requires: row " + row(i).name + " has " +
                           exact_text(matrix[i][k]) + " times " + acceleration(k) + ", row " + row(k).name + " " +
                           exact_text(matrix[k][i]) + " times " + acceleration(i) + ", expected the same" +
                           points_.where(point, [&](const CheckPoint& there) -> std::optional<Rational> {
                             const auto& equations = there.problem.equations;
                             return equations[i].coefficients[k] - equations[k].coefficients[i];
                           }));
      }
    }
    const auto negative = negative_direction(matrix);
    if (!negative) return std::nullopt;
    return warning(Check::inertia, row(*negative).left.place(),
                   "the inertia in row " + row(*negative).name + " is negative: " +
                       exact_text(matrix[*negative][*negative]) + " times " + acceleration(*negative) +
                       ", expected a positive semidefinite matrix of inertia" + where(point, *negative, *negative));
  }

  std::optional<Matrix> energy_at(const CheckPoint& point) const {
    Evaluator<Rational> at = points_.maker().at(point.values);
    Matrix result;
    for (const CompiledForm& slope : energy_) {
      auto row = coefficients(slope, at, mechanism_.unknowns.size());
      if (!row) return std::nullopt;
      row->resize(n_);
      result.push_back(std::move(*row));
    }
    return result;
  }

  /// The factor that rows and energy differ by: 1 if it is that of any row, or the most common one.
  static Rational common_factor(const Matrix& rows, const Matrix& energy) {
    std::vector<Rational> factors;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!energy[i][i].is_zero() && rows[i][i] > 0) factors.push_back(rows[i][i] / energy[i][i]);
    }
    if (factors.empty() || std::ranges::count(factors, Rational(1)) != 0) return 1;
    return *std::ranges::max_element(factors, {}, [&](const Rational& x) { return std::ranges::count(factors, x); });
  }

  std::optional<MechanismFinding> against_energy(const CheckPoint& point) const {
    const auto energy = energy_at(point);
    if (!energy) return std::nullopt;
    if (const auto negative = negative_direction(*energy)) {
      return warning(Check::inertia, mechanism_.energy.place(),
                     "the kinetic energy is negative where only " + acceleration(*negative) +
                         " moves, or with it what is coupled to it" + where(point, *negative, *negative));
    }
    const Matrix rows = inertia(point.problem);
    const Rational factor = common_factor(rows, *energy);
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t k = 0; k < n_; ++k) {
        const Rational expected = factor * (*energy)[i][k];
        if (rows[i][k] == expected) continue;
        const auto difference = [&](const CheckPoint& there) -> std::optional<Rational> {
          const auto other = energy_at(there);
          if (!other) return std::nullopt;
          const Matrix own = inertia(there.problem);
          return own[i][k] - common_factor(own, *other) * (*other)[i][k];
        };
        return warning(Check::inertia, row(i).left.place(),
                       "scale of row " + row(i).name + ": " + acceleration(k) + " is multiplied by " +
                           exact_text(rows[i][k]) + ", by the energy and the other rows it would be " +
                           exact_text(expected) + ", so forces that virtual work adds get a wrong factor" +
                           points_.where(point, difference));
      }
    }
    const MechanismFriction* absolute = absolute_limit();
    if (absolute == nullptr || factor == 1) return std::nullopt;
    return warning(Check::inertia, absolute->static_limit.place(),
                   "all rows are " + exact_text(factor) +
                       " times the derivatives of the energy, and so is the force of " + absolute->name +
                       ", but not its limit");
  }

  /// A friction element whose limit does not grow with the forces of the other elements.
  const MechanismFriction* absolute_limit() const {
    for (const MechanismFriction& friction : mechanism_.friction) {
      const SymbolicForm& limit = friction.static_form;
      if (!is_literal_zero(limit.constant) || !is_literal_zero(limit.load)) return &friction;
    }
    return nullptr;
  }

  /// For each row the first one with which inertia couples it.
  std::vector<std::size_t> blocks() const {
    std::vector<std::size_t> block(n_);
    std::iota(block.begin(), block.end(), std::size_t{0});
    for (std::size_t i = 0; i < n_; ++i) {
      for (const auto& [k, coefficient] : row(i).form.terms) {
        if (k >= n_ || block[i] == block[k]) continue;
        const std::size_t from = std::max(block[i], block[k]), to = std::min(block[i], block[k]);
        std::ranges::replace(block, from, to);
      }
    }
    return block;
  }

  /// A symmetric matrix fixes the scale within a block; forces act on several blocks, or have a limit.
  std::vector<MechanismFinding> scale() const {
    if (mechanism_.bodies) return {};  // all rows follow from them in one way
    const std::vector<std::size_t> block = blocks();
    std::vector<bool> forced(n_), shown(n_);
    for (std::size_t i = 0; i < n_; ++i) {
      forced[block[i]] = forced[block[i]] || row(i).contact_forces != nullptr;
      shown[block[i]] = shown[block[i]] || scaled_well_[i];
    }
    std::vector<std::size_t> open;
    std::size_t scales = absolute_limit() == nullptr ? 0 : 1;
    for (std::size_t i = 0; i < n_; ++i) {
      scales += forced[i] ? 1 : 0;
      if (forced[i] && !shown[i]) open.push_back(i);
    }
    if (open.empty() || scales < 2) return {};
    std::string others;
    for (std::size_t i = 1; i < open.size(); ++i) others += (i == 1 ? ", nor of " : ", ") + row(open[i]).name;
    return {warning(Check::inertia, row(open.front()).left.place(),
                    "scale of row " + row(open.front()).name + " not checkable" + others +
                        ": a row that was divided by a mass gets contact forces with a wrong factor; expected "
                        "`energy = \"...\"`, or units that show it")};
  }

  const CheckPoints& points_;
  const Mechanism& mechanism_;
  const std::vector<bool>& scaled_well_;
  std::size_t n_;
  std::vector<CompiledForm> energy_;
};

}  // namespace

std::vector<MechanismFinding> check_inertia(const CheckPoints& points, const std::vector<bool>& scaled_well) {
  const Mechanism& mechanism = points.mechanism();
  if (!mechanism.reciprocal || !mechanism.by_virtual_work) return {};
  return InertiaCheck(points, scaled_well).check();
}

}  // namespace slipproof::mechanism_checks
