#include <algorithm>
#include <map>
#include <numeric>

#include "base/algebra/linear_program.hpp"
#include "mechanics/reading/reader.hpp"

namespace slipproof::mechanism_reader {

namespace {

/// constant + coefficients . variables, without zeros.
struct SparseForm {
  Rational constant;
  std::map<std::size_t, Rational> coefficients;

  void add(const SparseForm& other, const Rational& factor) {
    constant += factor * other.constant;
    for (const auto& [variable, coefficient] : other.coefficients) {
      Rational& own = coefficients[variable];
      own += factor * coefficient;
      if (own.is_zero()) coefficients.erase(variable);
    }
  }
};

/// form >= 0, or > 0.
struct LinearCondition {
  SparseForm form;
  bool strict = false;
  const PlacedExpression* placed = nullptr;  ///< null: cosines and sines are between -1 and 1
  Expression comparison;
};
using Conditions = std::vector<LinearCondition>;

/// Whether some point satisfies all; true also if deciding takes too long.
bool have_point(const Conditions& all) {
  constexpr std::size_t enough = 500, largest = 24;
  std::map<std::size_t, std::size_t> columns;
  for (const LinearCondition& one : all) {
    for (const auto& [variable, unused] : one.form.coefficients) columns.try_emplace(variable, columns.size());
  }
  if (columns.size() > largest || all.size() > 3 * largest) return true;
  const std::size_t margin = columns.size();  // by which strict conditions hold, at most 1
  AffineForm objective{0, std::vector<Rational>(margin + 1)}, bound = objective;
  objective.coefficients[margin] = -1;
  bound.constant = 1;
  bound.coefficients[margin] = -1;
  std::vector<AffineForm> constraints{bound};
  for (const LinearCondition& one : all) {
    AffineForm form{one.form.constant, std::vector<Rational>(margin + 1)};
    for (const auto& [variable, coefficient] : one.form.coefficients)
      form.coefficients[columns[variable]] = coefficient;
    if (one.strict) form.coefficients[margin] = -1;
    constraints.push_back(std::move(form));
  }
  const LinearOptimum best = minimize(objective, constraints, enough);
  if (best.kind == LinearOptimum::Kind::infeasible) return false;
  return best.kind != LinearOptimum::Kind::attained || best.value < 0;
}

class DomainCheck {
 public:
  explicit DomainCheck(Context& context)
      : context_(context), m_(context.mechanism), names_(m_), definitions_(m_.definitions.size()) {}

  void check() {
    for (std::size_t i = 0; i < definitions_.size(); ++i) {
      definitions_[i] = linear(m_.definitions[i].expression.expression);
    }
    for (const MechanismParameter& one : m_.parameters) {
      collect(one.domain, one.domain.expression, one.optional ? one.symbol : "");
    }
    for (std::size_t i = 0; i < m_.angles.size(); ++i) {
      for (const std::size_t variable : {angle(2 * i), angle(2 * i + 1)}) {
        for (const int sign : {1, -1})
          conditions_.push_back({{1, {{variable, Rational(sign)}}}, false, nullptr, nullptr});
      }
      collect(m_.angles[i].domain, m_.angles[i].domain.expression, "");
    }
    for (const MechanismCondition& one : m_.assume) collect(one.condition, one.condition.expression, "");
    if (m_.load) {
      for (const PlacedExpression& one : m_.load->domain) collect(one, one.expression, "");
    }
    for (const Conditions& part : parts()) {
      if (!have_point(part)) return report(part);
    }
  }

 private:
  std::size_t angle(std::size_t symbol) const { return m_.parameters.size() + symbol; }
  std::size_t load() const { return angle(2 * m_.angles.size()); }

  std::optional<SparseForm> symbol(const std::string& symbol) const {
    const auto entry = names_.find(symbol);
    if (!entry) return std::nullopt;
    const auto variable = [](std::size_t index) { return SparseForm{0, {{index, Rational(1)}}}; };
    switch (entry->kind) {
      case NameKind::parameter:
        return variable(entry->index);
      case NameKind::angle:
        return variable(angle(entry->index));
      case NameKind::load:
        return variable(load());
      case NameKind::definition:
        return definitions_[entry->index];
      default:
        return std::nullopt;
    }
  }

  /// Nothing if it is not linear.
  std::optional<SparseForm> linear(const Expression& e) const {
    if (e->operation == Operation::number) return SparseForm{e->number, {}};
    if (e->operation == Operation::symbol) return symbol(e->symbol);
    if (e->operation > Operation::divide) return std::nullopt;
    const auto left = linear(e->operands[0]);
    const auto right = e->operands.size() > 1 ? linear(e->operands[1]) : SparseForm{};
    if (!left || !right) return std::nullopt;
    SparseForm result;
    switch (e->operation) {
      case Operation::negate:
        result.add(*left, -1);
        return result;
      case Operation::add:
      case Operation::subtract:
        result = *left;
        result.add(*right, e->operation == Operation::add ? 1 : -1);
        return result;
      case Operation::multiply: {
        const bool first = left->coefficients.empty();
        if (!first && !right->coefficients.empty()) return std::nullopt;
        const Rational& factor = (first ? left : right)->constant;
        if (!factor.is_zero()) result.add(first ? *right : *left, factor);
        return result;
      }
      default:
        break;
    }
    if (!right->coefficients.empty() || right->constant.is_zero()) return std::nullopt;
    result.add(*left, Rational(1) / right->constant);
    return result;
  }

  /// Collects what must hold. For an optional parameter, named here, only its own domain counts, which does not bind
  /// others.
  void collect(const PlacedExpression& placed, const Expression& truth, const std::string& optional) {
    if (truth->operation == Operation::logical_and) {
      for (const Expression& operand : truth->operands) collect(placed, operand, optional);
    } else if (truth->operation == Operation::truth && !truth->truth) {
      conditions_.push_back({{-1, {}}, false, &placed, truth});
    } else if (truth->operation == Operation::compare) {
      for (std::size_t i = 0; i < truth->relations.size(); ++i) {
        auto form = linear(make(Operation::subtract, {truth->operands[i], truth->operands[i + 1]}));
        if (form && counts(*form, optional)) add(placed, truth, *form, truth->relations[i]);
      }
    }
  }

  bool counts(const SparseForm& form, const std::string& optional) const {
    return std::ranges::all_of(form.coefficients, [&](const auto& term) {
      const bool parameter = term.first < m_.parameters.size();
      if (!optional.empty()) return parameter && m_.parameters[term.first].symbol == optional;
      return !parameter || !m_.parameters[term.first].optional;
    });
  }

  void add(const PlacedExpression& placed, const Expression& comparison, const SparseForm& difference,
           Relation relation) {
    const auto push = [&](int sign, bool strict) {
      SparseForm form;
      form.add(difference, sign);
      conditions_.push_back({std::move(form), strict, &placed, comparison});
    };
    const bool strict = relation == Relation::less || relation == Relation::greater;
    if (relation == Relation::not_equal) return;
    if (relation != Relation::less && relation != Relation::less_equal) push(1, strict);
    if (relation != Relation::greater && relation != Relation::greater_equal) push(-1, strict);
  }

  /// The conditions, those with a variable in common together.
  std::vector<Conditions> parts() const {
    std::vector<std::size_t> part(load() + 1);
    std::iota(part.begin(), part.end(), std::size_t{0});
    const auto root = [&](std::size_t variable) {
      while (part[variable] != variable) variable = part[variable] = part[part[variable]];
      return variable;
    };
    for (const LinearCondition& one : conditions_) {
      const auto& terms = one.form.coefficients;
      for (const auto& [variable, unused] : terms) part[root(variable)] = root(terms.begin()->first);
    }
    std::map<std::size_t, Conditions> result;
    for (const LinearCondition& one : conditions_) {
      const auto& terms = one.form.coefficients;
      result[terms.empty() ? part.size() : root(terms.begin()->first)].push_back(one);
    }
    std::vector<Conditions> list;
    for (auto& [unused, conditions] : result) list.push_back(std::move(conditions));
    return list;
  }

  /// The first condition that cannot be met, with those before it that are needed for that.
  void report(Conditions all) {
    std::size_t count = 1;
    while (have_point({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)})) ++count;
    all.resize(count);
    const LinearCondition last = all.back();
    for (std::size_t i = all.size(); i-- > 0;) {
      Conditions fewer = all;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      if (!have_point(fewer)) all = std::move(fewer);
    }
    std::string others;
    for (const LinearCondition& one : all) {
      if (one.placed == nullptr || one.comparison == last.comparison) continue;
      others += (others.empty() ? " together with " : ", ") + in_quotes(to_string(one.comparison));
    }
    context_.mistakes.add(last.placed->place(last.comparison), "found " + in_quotes(to_string(last.comparison)) +
                                                                   ", which no point satisfies" + others +
                                                                   ", expected a domain that has a point");
  }

  Context& context_;
  const Mechanism& m_;
  MechanismNames names_;
  std::vector<std::optional<SparseForm>> definitions_;
  Conditions conditions_;
};

}  // namespace

void check_domain(Context& context) {
  DomainCheck(context).check();
}

}  // namespace slipproof::mechanism_reader
