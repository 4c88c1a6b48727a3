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
/// The proof that a load has no end: `forces` hold `load`, and with `more` added for each unit they hold it farther
/// out.
struct EndlessLoad {
  Rational load;
  std::vector<Rational> forces, more;
};
/// The loads at which a scene can rest: those between the two ends, nothing where there is no end.
struct RestLoads {
  bool none = false;    ///< at no load
  bool decided = true;  ///< false: no end was found within the rounds of polygons
  std::optional<ProvedEnd> from, to;
  std::optional<EndlessLoad> below, above;  ///< in place of an end
};

/// The least cost of loads that vary, from both sides.
struct RestExtreme {
  enum class Kind : std::uint8_t { found, unbounded, none, undecided };
  Kind kind = Kind::undecided;
  std::vector<Rational> inner,
      outer;                     ///< found: loads at which it can rest; those of the least cost that is not excluded
  std::vector<Rational> forces;  ///< found, and unbounded in one load: that hold it at `inner`
  std::vector<Rational> more;    ///< unbounded in one load: that hold a unit more of it, and nothing else
  std::vector<Rational> multipliers;  ///< found: no cost is less than that of `outer`; none: there are no such loads
};
/// How near both sides must be: relative to the cost, or absolutely.
struct Nearness {
  double relative = 1e-10, absolute = 0;
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
  /// The least cost at which push and the loads can be held. In the plane both sides are one.
  RestExtreme extreme(const RestPush& push, const std::vector<VariedLoad>& loads, const Nearness& near);

  std::size_t programs() const { return programs_; }
  /// Whether polygons stand in for circles of friction: without them all ends are exact.
  bool has_circles() const { return has_circles_; }

 private:
  struct Answer {
    std::optional<ProposedOptimum> proposed;
    std::optional<SparseOptimum> exact;
    double least = 0;  ///< of the costs, about
    bool feasible = true;
  };
  Answer answer(const SparseProgram& program);
  /// The program about loads with cones of one kind, and what is known of its answer.
  struct Side {
    RestProgram cones;
    SparseProgram program;
    Answer answer;
  };
  Side side(RestProgram::Cones cones, const RestPush& push, const std::vector<VariedLoad>& loads);
  RestExtreme proved(Side& inner, Side& outer, std::size_t loads);
  /// Of a program whose inner cones have a point: that, and what holds more of the only load.
  static RestExtreme unbounded(const Side& inner, std::size_t loads, std::vector<Rational> more);
  /// Forces within the cones that hold a unit of the load in the direction of its cost, and nothing else; empty if none
  /// are found. They can be added to any that hold a load: it has no end there, if it begins.
  std::vector<Rational> what_holds_more(const VariedLoad& load);
  void make_exact(const SparseProgram& program, Answer& answer);
  bool settle(const RestPush& push, const RestProgram& within, RestDecision& decision);
  bool refine(const std::vector<double>& forces);
  std::vector<double> forces_of(const RestProgram& program, const Answer& answer, bool margin) const;
  void find_end(const RestPush& push, const RestPush& unit, int direction, bool not_negative, RestLoads& loads);

  const RestProblem& problem_;
  Effort& effort_;
  RestPolygons polygons_;
  bool has_circles_;
  std::size_t programs_ = 0;
};

}  // namespace slipproof
