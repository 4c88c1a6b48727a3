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

/// A redundant equation: an exact linear combination of others.
struct DroppedEquation {
  std::size_t equation;
  std::vector<std::pair<std::size_t, Rational>> combination;
};

/// The proof of an enclosure in numbers longer than binary64.
struct LongProof {
  struct Entry {
    std::size_t unknown, equation;  ///< counted without the pinned and the dropped ones
    Rational value;
  };
  std::vector<Rational> center;  ///< by unknown
  std::vector<double> radius;    ///< around it; of a pinned one 1
  std::vector<Entry> inverse;
};

/// There is an exact solution of the problem in the mode's unknowns within `radius` of `center`.
struct Enclosure {
  ModeSystem system;
  std::vector<double> center, radius;  ///< by unknown; the radius of a pinned one is 0
  std::vector<std::size_t> pinned;     ///< unknowns that nothing determines, held at their center
  std::vector<DroppedEquation> dropped;
  std::vector<SystemBlock> blocks;
  /// True if all conditions hold strictly and nothing is pinned; then a neighbourhood contains no other solution.
  bool locally_unique = false;
  std::shared_ptr<const LongProof> proof = {};  ///< replaces the blocks

  /// The number of undetermined unknowns: pinned ones, except forces that are 0 at touching contacts.
  std::size_t undetermined() const;
};

/// Why there is no enclosure.
struct NoEnclosure {
  std::string reason;
  std::vector<std::size_t> contacts;  ///< contacts concerned, from 0
  bool at_border = false;             ///< between two modes that the box cannot distinguish
};

struct EnclosureOptions {
  std::size_t largest_block = 6000;  ///< unknowns; a block takes 24 bytes and about 4 n operations for each pair
  int modes = 40;                    ///< number of modes to try
  int dependent_modes = 40;          ///< of these, with equations that depend on each other, which costs most
  /// Blocks with at least this number of unknowns and a sparse derivative are enclosed without an inverse; 0: all
  /// blocks are.
  std::size_t sparse_from = 400;
};

/// Newton's method from an answer, which changes the mode where the projection says so, then Krawczyk's test and the
/// mode's conditions in the box. `x` is finite.
std::variant<Enclosure, NoEnclosure> enclose_solution(const MixedProblem& problem, std::span<const double> x,
                                                      const EnclosureOptions& options = {});

/// The same in one mode only.
std::optional<Enclosure> enclose_in_mode(const MixedProblem& problem, std::span<const double> x, ConeMode mode,
                                         const EnclosureOptions& options = {});

/// Encloses the solution in which these contacts, which lie between open and closed, touch without load. u_N = 0 must
/// follow exactly from equations of other contacts. Nothing if it does not, if one of them is pressed in `x`, and for
/// the associated law.
std::optional<Enclosure> enclose_touching(const MixedProblem& problem, std::span<const double> x,
                                          std::span<const std::size_t> contacts, const EnclosureOptions& options = {});

/// The improved answer: the box's center, forces of open contacts 0.
std::vector<double> center_of(const Enclosure& enclosure);
/// Bound on the distance of row `row` of A x + c at the solution from its value at the center.
double row_radius(const MixedProblem& problem, const Enclosure& enclosure, std::size_t row);
/// Upper bound on the distance of the exact solution from an answer, in the maximum norm of all components of x.
double distance_from(const Enclosure& enclosure, std::span<const double> x);
/// The same for a solution given as numbers.
double distance_from(const std::vector<Rational>& solution, std::span<const double> x);

}  // namespace slipproof
