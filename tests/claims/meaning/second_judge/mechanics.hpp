// A mechanism as the second judge has it: trees for coefficients. What it judges is what text() writes as a file.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "claims/meaning/second_judge/tree.hpp"
#include "mechanics/elements/element.hpp"

namespace slipproof::meaning {

using Mode = MechanismMode;

struct Parameter {
  std::string symbol;
  Tree domain;
};

/// Coefficients with what they stand before: an unknown, the load, or nothing.
using Sum = std::vector<std::pair<Tree, std::string>>;

struct Mechanics {
  /// A contact; without `gap` a friction element, without `slip` frictionless.
  struct Element {
    std::string name;
    Sum gap, slip;
    Tree static_friction, kinetic_friction;  ///< of a contact
    Sum static_limit, kinetic_limit;         ///< of a friction element
    ElementKind::Start start = ElementKind::Start::rest;
    bool bilateral = false;
    bool lift_needs_J = false;

    bool is_contact() const { return !gap.empty(); }
    std::string normal() const { return "N_" + name; }
    std::string tangent() const { return "S_" + name; }
  };
  struct Link {
    std::string name;
    Sum zero;

    std::string force() const { return "R_" + name; }
  };
  struct Equation {
    Sum left, right;
  };

  std::vector<Parameter> parameters;  ///< J among them is optional
  Tree assume;                        ///< null: nothing
  std::vector<std::pair<std::string, Tree>> definitions;
  bool angle = false;  ///< theta, with the cosine c and the sine s
  std::string load;    ///< empty: none
  Tree load_domain;
  std::vector<std::string> accelerations, forces;
  bool by_virtual_work = true;  ///< one equation for each acceleration, without the forces of elements and links
  std::vector<Equation> equations;
  std::vector<Element> elements;  ///< contacts first
  std::vector<Link> links;

  std::string text() const;
  /// Accelerations, forces, then those of elements and links.
  std::vector<std::string> unknowns() const;
  /// All trees of coefficients, for shrinking and for what they divide by.
  std::vector<Tree*> coefficients();
  std::vector<Tree> coefficients() const;
  /// What by virtual work the forces of elements and links add on the right of an equation.
  Sum contact_forces(std::size_t equation) const;
};

/// The states of an element, by the table of mechanisms.
std::vector<ElementState> states_of(const Mechanics::Element& element);
std::string text(const Mode& mode);

}  // namespace slipproof::meaning
