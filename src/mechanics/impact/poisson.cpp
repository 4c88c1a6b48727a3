#include "mechanics/impact/poisson.hpp"

#include <utility>

#include "mechanics/bodies/vectors.hpp"
#include "mechanics/mechanism/forms.hpp"

namespace slipproof {

namespace {

using bodies_in_motion::plus;
using bodies_in_motion::times;
using Role = MechanismUnknown::Role;

class PoissonMerge {
 public:
  PoissonMerge(const Mechanism& after, const Mechanism& compression, const std::vector<Expression>& restitution)
      : after_(after), compression_(compression), restitution_(restitution), result_(after) {}

  Mechanism merge(Mistakes& mistakes) {
    add_unknowns();
    add_contacts();
    add_friction();
    add_links();
    add_equations();
    result_.reciprocal = false;  // restitution depends on compression, which does not depend on it
    derive_forms(result_, mistakes);
    return std::move(result_);
  }

 private:
  std::size_t forces() const { return after_.unknowns.size() - after_.accelerations; }
  /// Where the unknowns of each phase are now.
  std::size_t of_after(std::size_t unknown) const {
    const std::size_t n = after_.accelerations;
    return unknown < n ? unknown : unknown + n + forces();
  }
  std::size_t of_compression(std::size_t unknown) const {
    const std::size_t n = after_.accelerations;
    return unknown < n ? unknown + n : of_after(unknown) + forces();
  }
  Expression symbol(std::size_t unknown) const { return make_symbol(result_.unknowns[unknown].symbol); }

  void add_unknowns() {
    const std::size_t n = after_.accelerations;
    const auto& one = after_.unknowns;
    const auto& other = compression_.unknowns;
    std::vector<MechanismUnknown> all(one.begin(), one.begin() + static_cast<std::ptrdiff_t>(n));
    all.insert(all.end(), other.begin(), other.begin() + static_cast<std::ptrdiff_t>(n));
    for (std::size_t i = n; i < one.size(); ++i) {
      all.push_back(one[i]);
      all.back().role = Role::force;
      all.back().owner = 0;
    }
    for (std::size_t i = n; i < one.size(); ++i) {
      all.push_back(one[i]);
      all.back().symbol += one[i].role == Role::normal ? "_extra" : "_restitution";
    }
    for (std::size_t i = n; i < other.size(); ++i) {
      all.push_back(other[i]);
      all.back().symbol = one[i].symbol + "_compression";
    }
    result_.unknowns = std::move(all);
    result_.accelerations = 2 * n;
    result_.forces = forces();
  }

  void add_contacts() {
    for (MechanismContact& contact : result_.contacts) {
      contact.normal = of_after(contact.normal);
      contact.static_friction = contact.kinetic_friction = contact.slip = {};
      contact.tangent.reset();
      contact.slip_name.clear();
    }
    for (MechanismContact contact : compression_.contacts) {
      contact.normal = of_compression(contact.normal);
      if (contact.tangent) contact.tangent = of_compression(*contact.tangent);
      result_.unknowns[contact.normal].owner = result_.contacts.size();
      if (contact.tangent) result_.unknowns[*contact.tangent].owner = result_.contacts.size();
      contact.at.clear();
      contact.name += "_compression";
      contact.gap_name += "_compression";
      if (!contact.slip_name.empty()) contact.slip_name += "_compression";
      result_.contacts.push_back(std::move(contact));
    }
  }

  /// P_r of a contact: what is given back, and more.
  Expression normal_impulse(std::size_t contact) const {
    return plus(symbol(of_after(after_.contacts[contact].normal)),
                times(restitution_[contact], symbol(of_compression(compression_.contacts[contact].normal))));
  }

  void add(MechanismFriction friction) {
    result_.unknowns[friction.force].role = Role::friction;
    result_.unknowns[friction.force].owner = result_.friction.size();
    result_.friction.push_back(std::move(friction));
  }

  void add_friction() {
    result_.friction.clear();
    for (std::size_t i = 0; i < after_.contacts.size(); ++i) {
      const MechanismContact& contact = after_.contacts[i];
      if (contact.frictionless() || contact.start == ElementKind::Start::open) continue;
      MechanismFriction friction;
      friction.name = contact.name + "_friction";
      friction.slip = contact.slip;
      friction.slip_name = contact.slip_name;
      friction.static_limit = friction.kinetic_limit = {times(contact.kinetic_friction.expression, normal_impulse(i)),
                                                        PlacedText("", contact.place)};
      friction.force = of_after(*contact.tangent);
      friction.place = contact.place;
      add(std::move(friction));
    }
    for (MechanismFriction friction : after_.friction) {  // rolling resistance
      const std::string& normal = after_.unknowns[after_.contacts[*friction.contact].normal].symbol;
      const Expression limit = substitute(friction.kinetic_limit.expression, normal, normal_impulse(*friction.contact));
      friction.static_limit.expression = friction.kinetic_limit.expression = limit;
      friction.force = of_after(friction.force);
      friction.contact.reset();
      add(std::move(friction));
    }
    for (MechanismFriction friction : compression_.friction) {
      const std::string& normal = compression_.unknowns[compression_.contacts[*friction.contact].normal].symbol;
      const Expression own = symbol(of_compression(compression_.contacts[*friction.contact].normal));
      const Expression limit = substitute(friction.kinetic_limit.expression, normal, own);
      friction.static_limit.expression = friction.kinetic_limit.expression = limit;
      friction.force = of_compression(friction.force);
      friction.contact = *friction.contact + after_.contacts.size();
      friction.name += "_compression";
      friction.slip_name += "_compression";
      add(std::move(friction));
    }
  }

  void add_links() {
    for (MechanismLink& link : result_.links) link.force = of_after(link.force);
    for (MechanismLink link : compression_.links) {
      link.force = of_compression(link.force);
      result_.unknowns[link.force].owner = result_.links.size();
      link.name += "_compression";
      result_.links.push_back(std::move(link));
    }
  }

  /// M (u - u_c) = J^T P_r, of which by virtual work all is there but J_N^T e P_c.
  void add_equations() {
    const std::size_t n = after_.accelerations;
    for (std::size_t i = 0; i < n; ++i) {
      Expression& right = result_.equations[i].right.expression;
      right = substitute(result_.equations[i].left.expression, [&](const std::string& name) -> Expression {
        for (std::size_t j = 0; j < n; ++j) {
          if (after_.unknowns[j].symbol == name) return symbol(n + j);
        }
        return nullptr;
      });
      for (std::size_t k = 0; k < after_.contacts.size(); ++k) {
        const Expression given = times(restitution_[k], symbol(of_compression(compression_.contacts[k].normal)));
        right = plus(right, times(after_.contacts[k].gap_form.coefficient(i), given));
      }
    }
    for (const MechanismEquation& equation : compression_.equations) result_.equations.push_back(equation);
    for (std::size_t i = n; i < after_.unknowns.size(); ++i) add_total(i);
  }

  /// The impulse of both phases.
  void add_total(std::size_t unknown) {
    const MechanismUnknown& old = after_.unknowns[unknown];
    Expression sum = plus(symbol(of_after(unknown)), symbol(of_compression(unknown)));
    if (old.role == Role::normal) {
      sum = plus(sum, times(restitution_[old.owner], symbol(of_compression(unknown))));
    }
    MechanismEquation total;
    total.name = old.symbol;
    total.left = {make_symbol(old.symbol), PlacedText("", old.place)};
    total.right = {sum, PlacedText("", old.place)};
    result_.equations.push_back(std::move(total));
  }

  const Mechanism &after_, &compression_;
  const std::vector<Expression>& restitution_;
  Mechanism result_;
};

}  // namespace

Mechanism poisson_of(const Mechanism& after, const Mechanism& compression, const std::vector<Expression>& restitution,
                     Mistakes& mistakes) {
  return PoissonMerge(after, compression, restitution).merge(mistakes);
}

}  // namespace slipproof
