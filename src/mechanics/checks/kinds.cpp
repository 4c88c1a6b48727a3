#include "mechanics/checks/kinds.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "mechanics/mechanism/units.hpp"

namespace slipproof {

namespace {

/// Sets of nodes that are of one kind. Two that are known to have different units never become one.
class KindSets {
 public:
  explicit KindSets(std::size_t nodes) : parent_(nodes), unit_(nodes) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  void set_unit(std::size_t node, std::optional<Unit> unit) { unit_[node] = std::move(unit); }
  const std::optional<Unit>& unit(std::size_t node) const { return unit_[root(node)]; }
  std::size_t root(std::size_t node) const {
    while (parent_[node] != node) node = parent_[node];
    return node;
  }
  void join(std::size_t x, std::size_t y) {
    x = root(x);
    y = root(y);
    if (x == y || (unit_[x] && unit_[y] && !(*unit_[x] == *unit_[y]))) return;
    parent_[y] = x;
    if (!unit_[x]) unit_[x] = unit_[y];
  }

 private:
  std::vector<std::size_t> parent_;
  std::vector<std::optional<Unit>> unit_;
};

/// Symbols that are plain numbers.
std::set<std::string> plain_symbols(const Mechanism& mechanism) {
  std::set<std::string> plain;
  for (const MechanismAngle& angle : mechanism.angles) plain.insert({angle.cosine, angle.sine});
  for (const MechanismParameter& p : mechanism.parameters) {
    if (!p.unit.empty() && parse_unit(p.unit) == Unit()) plain.insert(p.symbol);
  }
  return plain;
}

bool is_plain(const Expression& e, const std::set<std::string>& symbols) {
  if (e->operation == Operation::symbol) return symbols.contains(e->symbol);
  return std::all_of(e->operands.begin(), e->operands.end(),
                     [&](const Expression& operand) { return is_plain(operand, symbols); });
}

std::vector<const SymbolicForm*> lines_of(const Mechanism& mechanism) {
  std::vector<const SymbolicForm*> lines;
  for (const MechanismEquation& equation : mechanism.equations) lines.push_back(&equation.form);
  for (const MechanismLink& link : mechanism.links) lines.push_back(&link.form);
  for (const MechanismContact& contact : mechanism.contacts) {
    lines.push_back(&contact.gap_form);
    if (contact.slip) lines.push_back(&contact.slip_form);
    if (contact.second) lines.push_back(&contact.second->form);
  }
  for (const MechanismFriction& friction : mechanism.friction) lines.push_back(&friction.slip_form);
  return lines;
}

/// Nodes are the unknowns, then the lines.
KindSets kind_sets(const Mechanism& mechanism, const std::vector<const SymbolicForm*>& lines) {
  const std::size_t unknowns = mechanism.unknowns.size();
  KindSets sets(unknowns + lines.size());
  std::vector<std::size_t> with_unit;
  for (std::size_t i = 0; i < unknowns; ++i) {
    const std::string& unit = mechanism.unknowns[i].unit;
    if (!unit.empty()) sets.set_unit(i, parse_unit(unit));
    if (!sets.unit(i)) continue;
    for (const std::size_t j : with_unit) sets.join(j, i);
    with_unit.push_back(i);
  }
  const std::set<std::string> plain = plain_symbols(mechanism);
  for (std::size_t line = 0; line < lines.size(); ++line) {
    for (const auto& [i, coefficient] : lines[line]->terms) {
      if (is_plain(coefficient, plain)) sets.join(i, unknowns + line);
    }
  }
  std::size_t line = unknowns + mechanism.equations.size() + mechanism.links.size();
  for (const MechanismContact& contact : mechanism.contacts) {
    if (contact.slip) sets.join(line, line + 1);
    if (contact.tangent) sets.join(contact.normal, *contact.tangent);
    if (contact.second) {
      sets.join(line, line + 2);
      sets.join(contact.normal, contact.second->force);
    }
    line += contact.second ? 3 : contact.slip ? 2 : 1;
  }
  return sets;
}

}  // namespace

MechanismKinds::MechanismKinds(const Mechanism& mechanism) : unknown_accelerations(mechanism.accelerations) {
  const std::vector<const SymbolicForm*> forms = lines_of(mechanism);
  const std::size_t unknowns = mechanism.unknowns.size(), equations = mechanism.equations.size();
  const std::size_t quantities = equations + mechanism.links.size();
  const KindSets sets = kind_sets(mechanism, forms);
  std::map<std::size_t, std::size_t> numbers;
  const auto kind = [&](std::size_t node) { return numbers.emplace(sets.root(node), numbers.size()).first->second; };
  for (std::size_t i = 0; i < unknowns; ++i) {
    (i < unknown_accelerations ? accelerations : forces).push_back(kind(i));
    if (i >= unknown_accelerations) {
      own_force.push_back(mechanism.unknowns[i].role == MechanismUnknown::Role::force);
    }
  }
  for (std::size_t line = 0; line < forms.size(); ++line) {
    lines.push_back(kind(unknowns + line));
    if (line >= quantities) accelerations.push_back(lines.back());
  }
  count = numbers.size();

  using Pair = std::pair<std::size_t, std::size_t>;
  std::map<Pair, Quotient> by_equations, by_levers, by_all;
  std::set<std::size_t> of_contacts(lines.begin() + static_cast<std::ptrdiff_t>(quantities),
                                    lines.end() - static_cast<std::ptrdiff_t>(mechanism.friction.size()));
  std::set<std::size_t> with_lever;
  for (std::size_t line = 0; line < forms.size(); ++line) {
    for (const auto& [i, coefficient] : forms[line]->terms) {
      if (unknown(i) == lines[line]) continue;
      const auto add = [&, i = i](std::map<Pair, Quotient>& to) {
        Quotient& quotient = to[{unknown(i), lines[line]}];
        quotient.kind = unknown(i);
        quotient.of = lines[line];
        quotient.places.emplace_back(line, i);
      };
      add(by_all);
      if (i >= unknown_accelerations) continue;
      add(line < equations ? by_equations : by_levers);
      if (line >= equations) with_lever.insert(unknown(i));
    }
  }
  for (auto& [pair, quotient] : by_equations) {
    if (of_contacts.contains(quotient.kind) || !with_lever.contains(quotient.kind)) {
      inertias.push_back(std::move(quotient));
    }
  }
  for (auto& [pair, quotient] : by_levers) levers.push_back(std::move(quotient));
  for (auto& [pair, quotient] : by_all) all.push_back(std::move(quotient));
}

}  // namespace slipproof
