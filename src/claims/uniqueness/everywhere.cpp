#include "claims/uniqueness/everywhere.hpp"

#include <algorithm>
#include <utility>

#include "base/expression/logic.hpp"
#include "base/input/diagnostic.hpp"
#include "claims/statements/formulas.hpp"
#include "claims/uniqueness/written_matrix.hpp"
#include "mechanics/kernel/mode_solver.hpp"
#include "mechanics/mechanism/system.hpp"
#include "proofs/check/judge.hpp"
#include "proofs/search/prove.hpp"
#include "proofs/statement/statement_text.hpp"

namespace slipproof {

namespace {

constexpr double max_modes_proved = 64;
constexpr std::uint64_t steps_each = 3'000'000;  ///< steps of the prover for each statement: about a second

/// The definition of a symbol, over parameters and angle symbols; null if it is a parameter or angle symbol itself.
Expression meaning(const Mechanism& mechanism, const std::string& symbol) {
  const auto is = [&](const MechanismDefinition& d) { return d.symbol == symbol; };
  const auto found = std::find_if(mechanism.definitions.begin(), mechanism.definitions.end(), is);
  if (found == mechanism.definitions.end()) return nullptr;
  return substitute(found->expression.expression, [&](const std::string& s) { return meaning(mechanism, s); });
}

Expression compared(const Expression& number, Relation relation) {
  return make_comparison({number, make_number(0)}, {relation});
}

/// Conditions that hold at all points of the domain, including those where an optional parameter is left out and counts
/// as 0.
std::vector<Expression> domain_of(const Mechanism& mechanism) {
  std::vector<Expression> all;
  for (const MechanismParameter& parameter : mechanism.parameters) {
    const Expression& domain = parameter.domain.expression;
    const Expression left_out = compared(make_symbol(parameter.symbol), Relation::equal);
    all.push_back(parameter.optional ? make(Operation::logical_or, {domain, left_out}) : domain);
  }
  for (const MechanismAngle& angle : mechanism.angles) {
    const Expression c = make_power(make_symbol(angle.cosine), 2), s = make_power(make_symbol(angle.sine), 2);
    all.push_back(make_comparison({make(Operation::add, {c, s}), make_number(1)}, {Relation::equal}));
    all.push_back(angle.domain.expression);
  }
  for (const MechanismCondition& one : mechanism.assume) all.push_back(one.condition.expression);
  for (Expression& condition : all) {
    condition = substitute(condition, [&](const std::string& s) { return meaning(mechanism, s); });
  }
  return all;
}

bool theorem_is_about(const Mechanism& mechanism) {
  const auto& contacts = mechanism.contacts;
  if (contacts.empty() || !mechanism.friction.empty()) return false;
  return std::all_of(contacts.begin(), contacts.end(), [](const MechanismContact& c) {
    return c.start == ElementKind::Start::rest && !c.bilateral && !c.frictionless();
  });
}

class StatementWriter {
 public:
  StatementWriter(const Mechanism& mechanism, bool hysteresis_apart)
      : mechanism_(mechanism),
        domain_(conjuncts(domain_of(mechanism))),
        contacts_(mechanism.contacts.size()),
        hysteresis_apart_(hysteresis_apart) {}

  std::optional<UniqueEverywhere> all() {
    if (!theorem_is_about(mechanism_) || !read_matrix()) return std::nullopt;
    const std::vector<ElementKind> kinds = element_kinds(mechanism_);
    if (mode_count(kinds) > max_modes_proved) return std::nullopt;
    add_conditions();
    add_definite();
    for (const MechanismMode& mode : modes_of(kinds)) {
      add_positive("mode" + std::to_string(++result_.modes), name(mode), mode_part(mode));
    }
    return complete_ ? std::optional(std::move(result_)) : std::nullopt;
  }

 private:
  /// Reads the equations, then gap and slip of each contact; unknowns are ordered so that N and S of the contacts come
  /// last.
  bool read_matrix() {
    const CompiledMechanism compiled(mechanism_);
    Evaluator<WrittenNumber, WrittenField> at(compiled.scope());
    for (std::size_t i = 0; i < mechanism_.parameters.size(); ++i) {
      at.set(compiled.parameter(i), WrittenNumber(make_symbol(mechanism_.parameters[i].symbol)));
    }
    for (std::size_t i = 0; i < mechanism_.angles.size(); ++i) {
      at.set(compiled.cosine(i), WrittenNumber(make_symbol(mechanism_.angles[i].cosine)));
      at.set(compiled.sine(i), WrittenNumber(make_symbol(mechanism_.angles[i].sine)));
    }
    auto system = system_of(mechanism_, compiled, element_kinds(mechanism_), at);
    if (!system) return false;
    std::vector<std::size_t> columns, forces;
    for (const MechanismContact& contact : mechanism_.contacts) {
      forces.insert(forces.end(), {contact.normal, *contact.tangent});
    }
    for (std::size_t j = 0; j < system->unknowns; ++j) {
      if (std::find(forces.begin(), forces.end(), j) == forces.end()) columns.push_back(j);
    }
    base_ = columns.size();
    if (system->equations.size() != base_) return false;
    columns.insert(columns.end(), forces.begin(), forces.end());
    const auto add = [&](const FormRow<WrittenNumber>& form) {
      rows_.emplace_back();
      for (const std::size_t j : columns) rows_.back().push_back(form.entries[j]);
    };
    for (const auto& equation : system->equations) add(equation);
    for (std::size_t i = 0; i < contacts_; ++i) {
      const auto& element = system->elements[i];
      add(element.gap);
      add(element.slip);
      const std::size_t n = mechanism_.contacts[i].normal;
      friction_.push_back(element.kinetic_limit.entries[n]);
      static_friction_.push_back(element.static_limit.entries[n]);
    }
    return true;
  }

  void add_conditions() {
    std::vector<Expression> shown;
    for (std::size_t i = 0; i < contacts_; ++i) {
      shown.push_back(compared(friction_[i].expression(), Relation::greater_equal));
      const Expression &slow = friction_[i].expression(), &still = static_friction_[i].expression();
      const Relation relation = hysteresis_apart_ ? Relation::greater_equal : Relation::equal;
      if (!same(still, slow)) shown.push_back(make_comparison({still, slow}, {relation}));
    }
    for (const MechanismContact& contact : mechanism_.contacts) {
      for (const std::size_t p : contact.lift_needs) {
        shown.push_back(compared(make_symbol(mechanism_.parameters[p].symbol), Relation::not_equal));
      }
    }
    add("conditions", "coefficients are not negative, contacts can open", all_of(shown));
  }

  /// States that W is symmetric and that its leading minors are positive.
  void add_definite() {
    std::vector<Expression> symmetric;
    for (std::size_t i = base_; i < rows_.size(); ++i) {
      for (std::size_t j = base_; j < i; ++j) {
        const auto one = bordered(i, j), other = bordered(j, i);
        if (!one || !other) return give_up();
        if (same(one->expression(), other->expression())) continue;
        symmetric.push_back(make_comparison({one->expression(), other->expression()}, {Relation::equal}));
      }
    }
    if (!symmetric.empty()) add("symmetric", "W is symmetric", all_of(symmetric));
    for (std::size_t k = base_ + 1; k <= rows_.size(); ++k) {
      add_positive("minor" + std::to_string(k - base_), "a leading minor of W", first_rows(k));
    }
  }

  WrittenMatrix first_rows(std::size_t count) const {
    WrittenMatrix part(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(count));
    for (auto& row : part) row.erase(row.begin() + static_cast<std::ptrdiff_t>(count), row.end());
    return part;
  }

  /// An entry of W, times the determinant of the equations.
  std::optional<WrittenNumber> bordered(std::size_t row, std::size_t column) const {
    WrittenMatrix part = first_rows(base_);
    part.push_back(rows_[row]);
    part.back().resize(base_, WrittenNumber(Rational(0)));
    for (std::size_t i = 0; i <= base_; ++i) part[i].push_back(rows_[i < base_ ? i : row][column]);
    return determinant_of(part);
  }

  /// Its determinant is the mode determinant times that of the equations: a contact that slips has S = -t mu N.
  WrittenMatrix mode_part(const MechanismMode& mode) const {
    std::vector<std::size_t> kept;
    WrittenMatrix part = rows_;
    for (std::size_t i = 0; i < base_; ++i) kept.push_back(i);
    for (std::size_t i = 0; i < contacts_; ++i) {
      if (mode[i] == ElementState::lift) continue;
      const std::size_t n = base_ + 2 * i;
      kept.push_back(n);
      if (mode[i] == ElementState::stick) kept.push_back(n + 1);
      const int t = slip_direction(mode[i]);
      for (auto& row : part) {
        if (t != 0) row[n] = row[n] - WrittenNumber(Rational(t)) * friction_[i] * row[n + 1];
      }
    }
    WrittenMatrix result;
    for (const std::size_t i : kept) {
      result.emplace_back();
      for (const std::size_t j : kept) result.back().push_back(part[i][j]);
    }
    return result;
  }

  /// States that a determinant has the sign of the equations' determinant.
  void add_positive(const std::string& name, const std::string& comment, const WrittenMatrix& part) {
    const auto equations = determinant_of(first_rows(base_)), determinant = determinant_of(part);
    if (!equations || !determinant) return give_up();
    add(name, comment, compared((*equations * *determinant).expression(), Relation::greater));
  }

  void add(const std::string& name, const std::string& comment, const Expression& shown) {
    WrittenStatement statement("unique." + name, comment);
    std::vector<std::string> variables;
    for (const MechanismParameter& parameter : mechanism_.parameters) variables.push_back(parameter.symbol);
    for (const MechanismAngle& angle : mechanism_.angles) variables.insert(variables.end(), {angle.cosine, angle.sine});
    if (variables.empty()) return give_up();
    statement.declare(Directive::Kind::real, variables);
    std::vector<Expression> assumed;
    for (const Expression& condition : domain_) {
      const Expression formula = formula_of(condition);
      if (!formula) return give_up();
      assumed.push_back(has_cases(formula) ? braced(formula) : formula);
    }
    if (!assumed.empty()) statement.add(Directive::Kind::assume, "domain", conjoined(assumed));
    const Expression formula = formula_of(shown);
    if (!formula) return give_up();
    statement.show(formula);
    result_.statements.push_back({"unique." + name, statement.text(), {}});
    try {
      read_statement(name, result_.statements.back().text);
    } catch (const InputError&) {  // longer than statements may be
      give_up();
    }
  }

  void give_up() { complete_ = false; }

  const Mechanism& mechanism_;
  const std::vector<Expression> domain_;
  const std::size_t contacts_;
  const bool hysteresis_apart_;
  std::size_t base_ = 0;
  WrittenMatrix rows_;
  std::vector<WrittenNumber> friction_, static_friction_;
  UniqueEverywhere result_;
  bool complete_ = true;
};

}  // namespace

std::optional<UniqueEverywhere> uniqueness_statements(const Mechanism& mechanism, bool hysteresis_apart) {
  return StatementWriter(mechanism, hysteresis_apart).all();
}

std::optional<UniqueEverywhere> unique_everywhere(const Mechanism& mechanism, bool hysteresis_apart) {
  auto result = uniqueness_statements(mechanism, hysteresis_apart);
  if (!result) return std::nullopt;
  prove::Limits limits;
  limits.steps = steps_each;
  for (CheckedStatement& one : result->statements) {
    ProofOutcome outcome = prove_statement(one.name, one.text, limits);
    if (!outcome.proved()) return std::nullopt;
    one.certificate = std::move(outcome.certificate);
    if (check::judge(one.text, one.certificate).verdict != check::Verdict::accepted) return std::nullopt;
  }
  return result;
}

}  // namespace slipproof
