// Compares the answer of a record with the exact solutions of a mode, by the rule of contact/problem/yardstick.hpp.
#pragma once

#include "contact/problem/yardstick.hpp"
#include "contact/space/solved_space.hpp"
#include "mechanics/kernel/mode_solver.hpp"
#include "records/record/point.hpp"

namespace slipproof {

/// The yardstick of a kind is the largest of:
/// - the components of the solution; if a component is left open, the answer's own;
/// - terms and constants of the equations, gaps, slips and zeros;
/// - for accelerations: what the equations apply, divided by the coefficients of inertia;
/// - for a kind that lines of another kind contain, such as rotations: the yardstick of that other kind, divided by the
///   largest coefficient, such as the longest lever.
/// Forces that a file declares itself set no yardstick.
class RecordAnswer {
 public:
  /// Of a motion in space, wherever in its ranges it is. A component whose range holds 0 counts as one that is 0.
  struct Bounds {
    Distance least, most;
    std::size_t worst = 0;    ///< the component with the largest relative error
    bool open_force = false;  ///< the answer has forces that the motion leaves open, which are not compared
    /// An acceleration of the answer differs from all motions within `others_within` by more than `near`.
    bool far_from_others = false;
  };

  /// Reads the answer of a record. All arguments must outlive it. `problem` is the problem at the record's point, with
  /// its equations.
  RecordAnswer(const RecordSetting& setting, const Record& record, const FrictionProblem& problem,
               const std::optional<Rational>& load)
      : setting_(setting), record_(record), problem_(problem), load_(load) {}

  /// The distance to the nearest solution of a mode. `worst` becomes the answer field with the largest relative error.
  /// Throws TooMuchWork.
  Distance distance(const ConsistentMode& mode, Effort& effort, std::size_t& worst) const;
  /// `forces` are those with which the answer's are compared where the motion leaves them open: force_names().
  Bounds bounds(const SpaceMotion& motion, const Rational& near,
                const std::vector<std::optional<Rational>>& forces = {}) const;
  /// The forces of the answer, and for those that it does not have the motion's own.
  std::vector<Rational> forces_beside(const SpaceMotion& motion) const;

 private:
  struct Component {
    AffineForm form;  ///< form on the solutions of the mode
    bool open = false;
  };
  std::vector<Component> components(const AffineSpace& space) const;
  std::vector<Component> components(const SpaceMotion& motion) const;
  bool is_far_from_others(const SpaceMotion& motion, const std::vector<Rational>& sizes, const Rational& near) const;
  std::vector<Rational> yardsticks(const std::vector<Component>& components) const;
  Yardsticks sizes(const std::vector<Component>& components) const;
  void take_lines(const std::vector<Component>& components, Yardsticks& sizes) const;
  Rational largest_coefficient(const MechanismKinds::Quotient& quotient) const;
  Rational constant(std::size_t line) const;
  const AffineForm& line(std::size_t index) const;

  bool has(std::size_t i) const { return record_.present[setting_.fields.first_answer() + i]; }
  Rational answer(std::size_t i) const { return record_.exactly(setting_.fields.first_answer() + i); }
  std::size_t kind(std::size_t i) const;
  bool sets_yardstick(std::size_t i) const;
  /// The index of an unknown among the components of the answer.
  std::size_t place(std::size_t unknown) const;

  const RecordSetting& setting_;
  const Record& record_;
  const FrictionProblem& problem_;
  const std::optional<Rational>& load_;
};

}  // namespace slipproof
