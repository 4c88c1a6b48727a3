#include "claims/lines/line_mechanism.hpp"

#include <algorithm>
#include <utility>

namespace slipproof {

namespace {

/// Undetermined forces are eliminated from no more conditions than this.
constexpr std::size_t max_forms = 400;

struct ScaledRow {
  PolynomialRow row;
  IntegerPolynomial factor;  ///< by which the form is multiplied
};

/// A form over the force variable in place of the load, times the common denominator of its coefficients, which is
/// critical.
ScaledRow to_polynomials(const FormRow<LineFunction>& form, const LineFunction& load, CriticalSet& found) {
  const std::size_t unknowns = form.entries.size() - 2;
  LineFunction slope, constant = form.entries[unknowns + 1];
  if (!form.entries[unknowns].is_zero()) {
    const LineFunction of_load = form.entries[unknowns] * load;  // alpha + beta x, without x in its denominator
    const auto part = [&](std::size_t power) {
      if (power >= of_load.numerator().size()) return LineFunction();
      return LineFunction(ForcePolynomial{of_load.numerator()[power]}, ForcePolynomial{of_load.denominator().front()});
    };
    slope = part(1);
    constant = constant + part(0);
  }
  std::vector<const LineFunction*> all;
  for (std::size_t j = 0; j < unknowns; ++j) all.push_back(&form.entries[j]);
  all.insert(all.end(), {&slope, &constant});
  IntegerPolynomial common(1);
  for (const LineFunction* x : all) common = least_common_multiple(common, x->denominator().front());
  found.add(common);
  PolynomialRow row;
  for (const LineFunction* x : all) {
    row.push_back(x->is_zero() ? IntegerPolynomial(0)
                               : scaled(x->numerator().front(), common, x->denominator().front()));
  }
  return {std::move(row), std::move(common)};
}

/// Divides by what all entries have in common; where that vanishes, the row is another one.
void make_primitive(PolynomialRow& row, CriticalSet& found) {
  IntegerPolynomial common(0);
  for (const IntegerPolynomial& x : row) {
    if (!x.is_zero()) common = common.is_zero() ? x : gcd(common, x);
  }
  if (common.is_zero() || common.is_one()) return;
  found.add(common);
  for (IntegerPolynomial& x : row) x = exact_quotient(x, common);
}

/// The rows of a mode's equations, solved for as many unknowns as they determine.
class SolvedRows {
 public:
  SolvedRows(std::size_t unknowns, CriticalSet& found) : unknowns_(unknowns), pivot_row_(unknowns), found_(found) {}

  void solve(std::vector<PolynomialRow> rows) {
    for (PolynomialRow& row : rows) make_primitive(row, found_);
    rows_ = std::move(rows);
    std::vector<bool> used(rows_.size());
    while (const auto pivot = next_pivot(used)) {
      const auto [r, column] = *pivot;
      used[r] = true;
      pivot_row_[column] = r;
      found_.add(rows_[r][column]);
      for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (i != r) subtract(rows_[i], rows_[r], column);
      }
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (!used[i]) add_rest(rows_[i]);
    }
    for (std::size_t j = 0; j < unknowns_; ++j) {
      if (!pivot_row_[j]) free_.push_back(j);
    }
  }

  /// Whether there are solutions at some force.
  bool solvable() const { return solvable_; }
  const std::vector<std::size_t>& free() const { return free_; }

  /// A form on the solutions, times a polynomial that is critical anyway, which is returned: over the free unknowns.
  IntegerPolynomial reduce(PolynomialRow& form) const {
    IntegerPolynomial factor(1);
    for (std::size_t j = 0; j < unknowns_; ++j) {
      if (form[j].is_zero() || !pivot_row_[j]) continue;
      factor = factor * subtract_from(form, rows_[*pivot_row_[j]], j);
    }
    return factor;
  }

 private:
  /// The entry of lowest degree, in the sparsest row.
  std::optional<std::pair<std::size_t, std::size_t>> next_pivot(const std::vector<bool>& used) const {
    std::optional<std::pair<std::size_t, std::size_t>> best;
    std::pair<long, std::ptrdiff_t> least{};
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (used[i]) continue;
      const auto entries = std::count_if(rows_[i].begin(), rows_[i].end(), [](const auto& x) { return !x.is_zero(); });
      for (std::size_t j = 0; j < unknowns_; ++j) {
        if (rows_[i][j].is_zero() || pivot_row_[j]) continue;
        const std::pair<long, std::ptrdiff_t> cost{rows_[i][j].degree(), entries};
        if (!best || cost < least) best = {i, j}, least = cost;
      }
    }
    return best;
  }

  /// What the row is multiplied by so that its entry in the column vanishes.
  static IntegerPolynomial subtract_from(PolynomialRow& row, const PolynomialRow& pivot, std::size_t column) {
    const IntegerPolynomial common = gcd(row[column], pivot[column]);
    const IntegerPolynomial mine = exact_quotient(pivot[column], common), other = exact_quotient(row[column], common);
    for (std::size_t j = 0; j < row.size(); ++j) {
      if (!mine.is_one() && !row[j].is_zero()) row[j] = mine * row[j];
      if (!pivot[j].is_zero()) row[j] = std::move(row[j]) - other * pivot[j];
    }
    return mine;
  }

  void subtract(PolynomialRow& row, const PolynomialRow& pivot, std::size_t column) {
    if (row[column].is_zero()) return;
    subtract_from(row, pivot, column);
    make_primitive(row, found_);
  }

  /// A row without unknowns: it fixes the force, or contradicts itself.
  void add_rest(const PolynomialRow& row) {
    const IntegerPolynomial &slope = row[unknowns_], &constant = row[unknowns_ + 1];
    if (slope.is_zero() && constant.is_zero()) return;
    found_.add(Affine<IntegerPolynomial>(constant, slope));
    solvable_ = solvable_ && !slope.is_zero();
  }

  std::size_t unknowns_;
  std::vector<PolynomialRow> rows_;
  std::vector<std::optional<std::size_t>> pivot_row_;  ///< by unknown; nothing: it is free
  std::vector<std::size_t> free_;
  bool solvable_ = true;
  CriticalSet& found_;
};

/// Eliminates an unknown from conditions, whatever their signs; false where that makes too many.
bool eliminate(std::vector<PolynomialRow>& forms, std::size_t unknown, CriticalSet& found) {
  std::vector<PolynomialRow> result, with;
  for (PolynomialRow& form : forms) {
    (form[unknown].is_zero() ? result : with).push_back(std::move(form));
  }
  for (const PolynomialRow& form : with) found.add(form[unknown]);
  if (result.size() + with.size() * (with.size() + 1) / 2 > max_forms) return false;
  for (std::size_t i = 0; i < with.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      PolynomialRow combined;
      for (std::size_t j = 0; j < with[i].size(); ++j) {
        combined.push_back(with[k][unknown] * with[i][j] - with[i][unknown] * with[k][j]);
      }
      make_primitive(combined, found);
      result.push_back(std::move(combined));
    }
  }
  forms = std::move(result);
  return true;
}

Affine<IntegerPolynomial> over_force(const PolynomialRow& row) {
  return {row[row.size() - 1], row[row.size() - 2]};
}

}  // namespace

LineMechanism::LineMechanism(const CompiledSetting& setting, LineEvaluator& paper) : setting_(setting) {
  const CompiledMechanism& compiled = setting.maker().compiled();
  const CompiledScene& scene = setting.scene();
  LineEvaluator at(compiled.scope(), paper.field());
  if (!put_scene(setting, paper, at, [](const LineFunction& value) { return value.without_force(); })) return;
  if (scene.load) {
    auto load = paper.number(*scene.load).number;
    if (!load || load->numerator().size() > 2 || load->denominator().size() != 1) return;
    load_ = std::move(*load);
  }
  system_ = system_of(setting.mechanism(), compiled, setting.kinds(), at);
}

std::vector<PolynomialRow> LineMechanism::equations(const MechanismMode& mode, CriticalSet& found) const {
  std::vector<PolynomialRow> rows;
  const auto add = [&](const FormRow<LineFunction>& form) { rows.push_back(to_polynomials(form, load_, found).row); };
  for (const auto& equation : system_->equations) add(equation);
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const auto& element = system_->elements[i];
    for (const StateEquation e : slipproof::equations(element.kind, mode[i])) add(form_of(element, mode[i], e));
  }
  return rows;
}

bool LineMechanism::add_mode(const MechanismMode& mode, const std::vector<std::size_t>& wanted, CriticalSet& found,
                             LineEvaluator& paper) const {
  std::vector<PolynomialRow> conditions;
  for (std::size_t i = 0; i < mode.size(); ++i) {
    const auto& element = system_->elements[i];
    for (const StateCondition c : slipproof::conditions(element.kind, mode[i])) {
      conditions.push_back(to_polynomials(form_of(element, mode[i], c), load_, found).row);
    }
  }
  const std::size_t unknowns = setting_.unknowns();
  SolvedRows solved(unknowns, found);
  solved.solve(equations(mode, found));
  if (!solved.solvable()) return false;
  for (PolynomialRow& condition : conditions) solved.reduce(condition);
  bool complete = true;
  for (const std::size_t unknown : solved.free()) complete = complete && eliminate(conditions, unknown, found);
  if (complete) {
    for (const PolynomialRow& condition : conditions) found.add(over_force(condition));
  }
  for (const std::size_t slot : wanted) {
    const std::size_t quantity = slot - setting_.quantity_slot(0), first = system_->accelerations.size();
    const auto& form = quantity < first ? system_->accelerations[quantity] : system_->forces[quantity - first];
    auto [value, factor] = to_polynomials(form, load_, found);
    const IntegerPolynomial denominator = factor * solved.reduce(value);
    const bool determined = std::all_of(value.begin(), value.begin() + static_cast<std::ptrdiff_t>(unknowns),
                                        [](const auto& x) { return x.is_zero(); });
    if (determined) paper.set(slot, LineFunction(over_force(value), denominator));
  }
  return complete;
}

}  // namespace slipproof
