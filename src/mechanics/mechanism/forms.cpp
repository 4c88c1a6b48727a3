#include "mechanics/mechanism/forms.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "mechanics/mechanism/algebra.hpp"
#include "mechanics/mechanism/extraction.hpp"

namespace slipproof {

namespace {

using mechanism_forms::Extraction;
using mechanism_forms::Linear;
using mechanism_forms::NotLinear;

/// Whether the expression is 0 as written, over any divisor.
bool vanishes(const Expression& x) {
  switch (x->operation) {
    case Operation::negate:
    case Operation::divide:
      return vanishes(x->operands[0]);
    case Operation::add:
    case Operation::subtract:
      return vanishes(x->operands[0]) && vanishes(x->operands[1]);
    case Operation::multiply:
      return vanishes(x->operands[0]) || vanishes(x->operands[1]);
    default:
      return is_literal_zero(x);
  }
}

/// The forms of one mechanism; what has mistakes keeps the form 0.
class FormsOfMechanism {
 public:
  FormsOfMechanism(Mechanism& mechanism, Mistakes& mistakes)
      : mechanism_(mechanism), mistakes_(mistakes), extraction_(mechanism) {}

  void derive() {
    for (MechanismContact& contact : mechanism_.contacts) {
      contact.gap_form = motion_form(contact.gap, contact.gap_name);
      contact.slip_form = motion_form(contact.slip, contact.slip_name);
      if (contact.second) contact.second->form = motion_form(contact.second->slip, contact.second->name);
      check_friction(contact, contact.static_friction);
      check_friction(contact, contact.kinetic_friction);
    }
    for (MechanismFriction& friction : mechanism_.friction) {
      friction.slip_form = motion_form(friction.slip, friction.slip_name);
      friction.static_form = form(friction.static_limit, "limit");
      friction.kinetic_form = form(friction.kinetic_limit, "limit");
    }
    for (MechanismLink& link : mechanism_.links) link.form = motion_form(link.zero, "zero");
    if (mechanism_.by_virtual_work) find_work();
    for (std::size_t i = 0; i < mechanism_.equations.size(); ++i) derive_equation(i);
    derive_energy();
  }

 private:
  SymbolicForm form(const PlacedExpression& placed, const std::string& what) {
    if (!placed) return extraction_.form(Linear{zero_literal(), {}});
    try {
      return extraction_.form(placed.expression);
    } catch (const NotLinear& error) {
      mistakes_.add(placed.place(error.where), what + ": " + error.message);
    }
    return extraction_.form(Linear{zero_literal(), {}});
  }

  std::string accelerations() const {
    std::string names;
    for (std::size_t i = 0; i < mechanism_.accelerations; ++i) {
      names += (i == 0 ? "" : ", ") + mechanism_.unknowns[i].symbol;
    }
    return names;
  }

  /// A gap, slip or zero, which must have an acceleration in it.
  SymbolicForm motion_form(const PlacedExpression& placed, const std::string& what) {
    if (!placed) return extraction_.form(Linear{zero_literal(), {}});
    try {
      const Linear linear = extraction_.linear(placed.expression);
      const bool moves = std::any_of(linear.terms.begin(), linear.terms.end(),
                                     [&](const auto& term) { return term.first < mechanism_.accelerations; });
      if (!moves) {
        mistakes_.add(placed.place(), what + ": found no acceleration in " + in_quotes(to_string(placed.expression)) +
                                          ", expected an acceleration, a sum with at least one of " + accelerations());
      }
      return extraction_.form(linear);
    } catch (const NotLinear& error) {
      mistakes_.add(placed.place(error.where), what + ": " + error.message);
    }
    return extraction_.form(Linear{zero_literal(), {}});
  }

  void check_friction(const MechanismContact& contact, const PlacedExpression& friction) {
    if (!friction || !mechanism_.load || !extraction_.has_load(friction.expression)) return;
    const std::string& normal = mechanism_.unknowns[contact.normal].symbol;
    const std::string product = to_string(make(Operation::multiply, {friction.expression, make_symbol(normal)}));
    mistakes_.add(friction.place(), "friction: not linear: " + in_quotes(product) + " multiplies the load " +
                                        mechanism_.load->symbol + " by the unknown " + normal);
  }

  void derive_equation(std::size_t index) {
    MechanismEquation& equation = mechanism_.equations[index];
    equation.contact_forces = mechanism_.by_virtual_work ? contact_forces(index) : nullptr;
    if (!equation.left || !equation.right) {
      equation.form = extraction_.form(Linear{zero_literal(), {}});
      return;
    }
    const SymbolicForm left = form(equation.left, equation.name);
    const SymbolicForm right = form(equation.right, equation.name);
    equation.form = difference(left, right);
    if (equation.contact_forces) {
      equation.form = difference(equation.form, extraction_.form(equation.contact_forces));
    }
  }

  /// The derivatives of a quadratic form are linear without a constant.
  void derive_energy() {
    mechanism_.energy_slopes.clear();
    const PlacedExpression& energy = mechanism_.energy;
    if (!energy) return;
    const auto refuse = [&](const Expression& where, const std::string& found) {
      mistakes_.add(energy.place(where),
                    "energy: " + found + ", expected a quadratic form such as \"m*(ax^2 + ay^2)/2\"");
    };
    for (std::size_t i = 0; i < mechanism_.accelerations; ++i) {
      const std::string& velocity = mechanism_.unknowns[i].symbol;
      try {
        mechanism_.energy_slopes.push_back(extraction_.form(derivative_of(energy.expression, velocity)));
      } catch (const NotLinear& error) {
        return refuse(error.where, "not quadratic in " + velocity);
      }
      if (vanishes(mechanism_.energy_slopes.back().constant)) continue;
      return refuse(energy.expression, "found a term that is linear in " + velocity);
    }
    const auto is_zero = [](const SymbolicForm& slope) {
      return std::ranges::all_of(slope.terms, vanishes, &std::pair<std::size_t, Expression>::second);
    };
    if (std::ranges::all_of(mechanism_.energy_slopes, is_zero)) refuse(energy.expression, "found no velocity");
  }

  SymbolicForm difference(const SymbolicForm& x, const SymbolicForm& y) const {
    const auto minus = [&](const Expression& a, const Expression& b) {
      return difference_of(a, b, [this](const Expression& e) { return extraction_.divides_by_nothing(e); });
    };
    SymbolicForm result{{}, minus(x.load, y.load), minus(x.constant, y.constant)};
    std::map<std::size_t, std::array<Expression, 2>> terms;
    for (const auto& [unknown, coefficient] : x.terms) terms[unknown][0] = coefficient;
    for (const auto& [unknown, coefficient] : y.terms) terms[unknown][1] = coefficient;
    for (const auto& [unknown, pair] : terms) {
      Expression rest = minus(pair[0] ? pair[0] : zero_literal(), pair[1] ? pair[1] : zero_literal());
      if (!is_literal_zero(rest)) result.terms.emplace_back(unknown, std::move(rest));
    }
    return result;
  }

  /// The forces of contacts, friction elements and links that work along each acceleration, and their factors.
  void find_work() {
    work_.resize(mechanism_.equations.size());
    const auto add = [&](const SymbolicForm& motion, std::size_t force) {
      for (const auto& [unknown, coefficient] : motion.terms) {
        if (unknown < work_.size()) work_[unknown].emplace_back(coefficient, force);
      }
    };
    for (const MechanismContact& contact : mechanism_.contacts) {
      add(contact.gap_form, contact.normal);
      if (contact.tangent) add(contact.slip_form, *contact.tangent);
      if (contact.second) add(contact.second->form, contact.second->force);
    }
    for (const MechanismFriction& friction : mechanism_.friction) add(friction.slip_form, friction.force);
    for (const MechanismLink& link : mechanism_.links) add(link.form, link.force);
  }

  /// What they do along an acceleration; null if nothing.
  Expression contact_forces(std::size_t acceleration) const {
    Expression sum = zero_literal();
    for (const auto& [factor, force] : work_[acceleration]) {
      sum = sum_of(sum, product_of(factor, make_symbol(mechanism_.unknowns[force].symbol)));
    }
    return is_literal_zero(sum) ? nullptr : sum;
  }

  std::vector<std::vector<std::pair<Expression, std::size_t>>> work_;
  Mechanism& mechanism_;
  Mistakes& mistakes_;
  Extraction extraction_;
};

/// One comparison of a load's domain as a bound.
class BoundReader {
 public:
  BoundReader(const Mechanism& mechanism, Mistakes& mistakes) : extraction_(mechanism), mistakes_(mistakes) {
    load_index_ = mechanism.unknowns.size();
    symbol_ = mechanism.load->symbol;
  }

  void read(const PlacedExpression& placed, const Expression& truth) {
    switch (truth->operation) {
      case Operation::logical_and:
        for (const Expression& operand : truth->operands) read(placed, operand);
        return;
      case Operation::truth:
        if (truth->truth) return;
        break;
      case Operation::compare:
        for (std::size_t i = 0; i < truth->relations.size(); ++i) {
          if (!link(placed, truth->operands[i], truth->operands[i + 1], truth->relations[i]))
            return refuse(placed, truth);
        }
        return;
      default:
        break;
    }
    refuse(placed, truth);
  }

  std::vector<LoadBound> bounds;

 private:
  bool link(const PlacedExpression& placed, const Expression& left, const Expression& right, Relation relation) {
    if (relation == Relation::not_equal) return false;
    const bool below = relation == Relation::less || relation == Relation::less_equal;
    const Expression difference = below ? difference_of(right, left) : difference_of(left, right);
    try {
      const Linear linear = extraction_.linear(difference);
      const auto load = linear.terms.find(load_index_);
      const bool strict = relation == Relation::less || relation == Relation::greater;
      bounds.push_back({load == linear.terms.end() ? zero_literal() : load->second, linear.constant,
                        relation == Relation::equal ? Relation::equal
                        : strict                    ? Relation::greater
                                                    : Relation::greater_equal,
                        placed});
      return true;
    } catch (const NotLinear&) {
      return false;
    }
  }

  void refuse(const PlacedExpression& placed, const Expression& truth) {
    mistakes_.add(placed.place(truth), "domain: found " + in_quotes(to_string(truth)) +
                                           ", expected an interval of the load " + symbol_ + " such as \"" + symbol_ +
                                           " >= 0\" or \"0 <= " + symbol_ + " < 1\"");
  }

  Extraction extraction_;
  Mistakes& mistakes_;
  std::size_t load_index_ = 0;
  std::string symbol_;
};

}  // namespace

void derive_forms(Mechanism& mechanism, Mistakes& mistakes) {
  FormsOfMechanism(mechanism, mistakes).derive();
}

std::vector<LoadBound> load_bounds(const Mechanism& mechanism, Mistakes& mistakes) {
  if (!mechanism.load) return {};
  BoundReader reader(mechanism, mistakes);
  for (const PlacedExpression& condition : mechanism.load->domain) {
    if (condition) reader.read(condition, condition.expression);
  }
  return std::move(reader.bounds);
}

}  // namespace slipproof
