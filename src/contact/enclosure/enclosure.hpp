// From an answer to an exact solution near it: a mode, an improved point, a box, and the conditions that hold in it.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "contact/enclosure/krawczyk.hpp"

namespace slipproof {

/// An equation that holds wherever others do: the exact linear combination of them that it is.
struct DroppedEquation {
  std::size_t equation;
  std::vector<std::pair<std::size_t, Rational>> combination;
};

/// What proves an enclosure in numbers that are longer than binary64.
struct LongProof {
  struct Entry {
    std::size_t unknown, equation;  ///< counted without the pinned and the dropped ones
    Rational value;
  };
  std::vector<Rational> center;  ///< of all unknowns
  std::vector<double> radius;    ///< around it; of a pinned one 1
  std::vector<Entry> inverse;
};

/// There is an exact solution of the problem in the mode's unknowns within `radius` of `center`.
struct Enclosure {
  ModeSystem system;
  std::vector<double> center, radius;  ///< of the unknowns; the radius of a pinned one is 0
  std::vector<std::size_t> pinned;     ///< unknowns that nothing determines, held at their center
  std::vector<DroppedEquation> dropped;
  std::vector<SystemBlock> blocks;
  /// All conditions hold strictly, nothing is pinned: there is a neighbourhood with no other solution.
  bool locally_unique = false;
  std::shared_ptr<const LongProof> proof = {};  ///< in place of the blocks

  /// How many unknowns nothing determines: those pinned, but for forces that are 0 where contacts touch.
  std::size_t undetermined() const;
};

/// Why there is no enclosure.
struct NoEnclosure {
  std::string reason;
  std::vector<std::size_t> contacts;  ///< that it is about, from 0
  bool at_border = false;             ///< between modes, closer than the box can tell
};

struct EnclosureOptions {
  std::size_t largest_block = 6000;  ///< unknowns; a block takes 24 bytes and about 4 n operations for each pair
  int modes = 40;                    ///< how many are tried on the way
  /// Blocks of so many unknowns, of whose derivative nearly all is 0, are enclosed without an inverse; 0: all are.
  std::size_t sparse_from = 400;
};

/// Newton's method from an answer, which changes the mode where the projection says so, then Krawczyk's test and the
/// mode's conditions in the box. `x` is finite.
std::variant<Enclosure, NoEnclosure> enclose_solution(const MixedProblem& problem, std::span<const double> x,
                                                      const EnclosureOptions& options = {});

/// Where these contacts are at a border between open and closed: the mode in which they touch without load. That u_N =
/// 0 has to follow exactly from equations of other contacts. Nothing if it does not, where one of them is pressed in
/// `x`, and for the associated law.
std::optional<Enclosure> enclose_touching(const MixedProblem& problem, std::span<const double> x,
                                          std::span<const std::size_t> contacts, const EnclosureOptions& options = {});

/// The improved answer: the box's center, forces of open contacts 0.
std::vector<double> center_of(const Enclosure& enclosure);
/// How far row `row` of A x + c at the solution may be from its value at the center.
double row_radius(const MixedProblem& problem, const Enclosure& enclosure, std::size_t row);
/// Upper bound on the distance of the exact solution from an answer, in the maximum norm of all components of x.
double distance_from(const Enclosure& enclosure, std::span<const double> x);
/// The same of a solution in numbers.
double distance_from(const std::vector<Rational>& solution, std::span<const double> x);

}  // namespace slipproof
