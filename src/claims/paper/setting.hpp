// One way in which a paper describes a mechanism, with what is needed to draw samples of it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "claims/paper/paper_scene.hpp"
#include "claims/paper/paper_symbols.hpp"

namespace slipproof {

/// A value of a parameter at which something changes: `b = b1`.
struct Boundary {
  std::string symbol;
  Expression value;  ///< over parameters and definitions, independent of the symbol and of the force
};

/// A condition that a mechanism must meet if it can be built.
struct Realisable {
  std::string name;
  Expression condition;  ///< over parameters and definitions, in the repaired reading; independent of the force
};

/// Which symbols are free, and which scene they give.
struct Setting : PaperSymbols, PaperScene {
  std::string id;
  std::string statement;
  std::size_t line = 0;
  bool strict = true;  ///< the paper's motions satisfy their conditions strictly
  std::vector<Boundary> boundaries;
  std::vector<Realisable> realisable;  ///< empty: the file does not say what can be built

  /// The conditions under which the scene is a point of the mechanism and the load is a polynomial of degree at most 1
  /// in the force.
  struct PointConditions {
    std::vector<Expression> truths;   ///< domains, assumptions, and that no divisor in a coefficient is 0
    std::vector<Expression> defined;  ///< numbers that must have a value
    Expression slope;  ///< slope of the load in the force variable, not 0; null if the load is not linear as written
  };
  PointConditions point_conditions() const;
};

}  // namespace slipproof
