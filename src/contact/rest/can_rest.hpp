// Whether forces can hold a scene at rest, and up to which load.
#pragma once

#include <optional>
#include <string>

#include "contact/rest/rest_proof.hpp"

namespace slipproof {

struct RestDecision {
  std::optional<bool> can;  ///< nothing: undecided
  /// It is proved that forces are nowhere inside of all cones: `border` gains no power, and opens or resists.
  bool touching = false;
  std::vector<Rational> forces;               ///< that hold it, if it can
  std::optional<VirtualMotion> fall, border;  ///< what proves that it cannot, or that it only just can
};

/// A number between two rationals, each with its proof; the same where it is known exactly.
struct ProvedEnd {
  Rational lower, upper;
};
/// The loads at which a scene can rest: those between the two ends, nothing where there is no end.
struct RestLoads {
  bool none = false;    ///< at no load
  bool decided = true;  ///< false: no end was found within the rounds of polygons
  std::optional<ProvedEnd> from, to;
};

/// Answers to questions about one problem; each goes on with the polygons of those before it. A contact in space has a
/// polygon inside of its circle of friction, which proves that forces hold, and one around it, whose multipliers prove
/// that none do; both get finer in the direction of the present force until they agree. All methods throw TooMuchWork.
class RestSolver {
 public:
  RestSolver(const RestProblem& problem, Effort& effort);

  RestDecision decide(const RestPush& push);
  /// The loads at which push + load * unit can be held; with not_negative only those from 0 on.
  RestLoads loads(const RestPush& push, const RestPush& unit, bool not_negative);

  std::size_t programs() const { return programs_; }

 private:
  struct Answer {
    std::optional<ProposedOptimum> proposed;
    std::optional<SparseOptimum> exact;
    double least = 0;  ///< of the costs, about
    bool feasible = true;
  };
  Answer answer(const SparseProgram& program);
  void make_exact(const SparseProgram& program, Answer& answer);
  bool settle(const RestPush& push, const RestProgram& within, RestDecision& decision);
  bool refine(const std::vector<double>& forces);
  std::vector<double> forces_of(const RestProgram& program, const Answer& answer, bool margin) const;
  std::optional<ProvedEnd> end(const RestPush& push, const RestPush& unit, int direction, bool not_negative,
                               RestLoads& loads);

  const RestProblem& problem_;
  Effort& effort_;
  RestPolygons polygons_;
  bool has_circles_;
  std::size_t programs_ = 0;
};

}  // namespace slipproof
