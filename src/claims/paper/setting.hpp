// One way in which a paper describes a mechanism: a family in its own symbols, what it defines, and where to sample it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "claims/paper/paper.hpp"
#include "mechanics/family/family.hpp"

namespace slipproof {

/// A symbol defined by the paper.
struct Definition {
  std::string symbol;
  std::string equation;  ///< number in the paper, `3.1`
  std::size_t line = 0;
  Expression printed;
  Expression repaired;  ///< null: as printed
  std::string why;      ///< why the print must be a misprint

  const Expression& value(Reading reading) const {
    return reading == Reading::repaired && repaired ? repaired : printed;
  }
  /// The paper uses the symbol without a definition; the file defines it as a quotient by 0.
  bool is_nowhere(Reading reading) const;
};

/// The name of a definition in references and lists: `3.1.b1`, or its symbol if the paper gives it no number.
std::string id(const Definition& definition);

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

struct Setting : Family {
  std::string id;
  std::string statement;
  std::size_t line = 0;
  std::string mechanism_name;           ///< the name in the file; `bicycle` for settings in the old form
  std::string along;                    ///< a parameter that is used as the load; empty: the mechanism's own load
  bool strict = true;                   ///< the paper's motions satisfy their conditions strictly
  std::vector<Definition> definitions;  ///< none uses symbols that lead back to it
  std::vector<Boundary> boundaries;
  std::vector<Realisable> realisable;  ///< empty: the file does not say what can be built
};

}  // namespace slipproof
