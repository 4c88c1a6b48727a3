// The answer of a record against the exact solutions of a mode, by the rule of contact/yardstick.hpp.
#pragma once

#include "contact/problem/yardstick.hpp"
#include "mechanics/checks/kinds.hpp"
#include "mechanics/kernel/mode_solver.hpp"
#include "records/certify/mechanism_record.hpp"

namespace slipproof {

/// What is judged, ready for many records; shared by threads.
struct MechanismSetting {
  const CertifiedMechanism& certified;
  const MechanismFields& fields;
  const ProblemMaker& maker;
  const MechanismKinds& kinds;
};

/// Yardsticks are the largest of: components of the solution, where they are left open the answer's own; terms and
/// constants of the equations, gaps, slips and zeros; of accelerations what the equations apply over the coefficients
/// of inertia; and of kinds that lines of another kind contain, such as rotations, that kind's over the largest
/// coefficient, such as the longest lever. The forces that a file declares itself set no yardstick.
class MechanismAnswer {
 public:
  /// All must outlive it. `problem` is that of the record's point, with the equations in it.
  MechanismAnswer(const MechanismSetting& setting, const MechanismRecord& record, const FrictionProblem& problem,
                  const std::optional<Rational>& load)
      : setting_(setting), record_(record), problem_(problem), load_(load) {}

  /// To the nearest solution of a mode. `worst` is the answer field with the largest relative error. Throws
  /// TooMuchWork.
  Distance distance(const ConsistentMode& mode, Effort& effort, std::size_t& worst) const;

 private:
  struct Component {
    AffineForm form;  ///< on the mode's solutions
    bool open = false;
  };
  std::vector<Component> components(const AffineSpace& space) const;
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
  /// The place of an unknown among the answer's components.
  std::size_t place(std::size_t unknown) const;

  const MechanismSetting& setting_;
  const MechanismRecord& record_;
  const FrictionProblem& problem_;
  const std::optional<Rational>& load_;
};

}  // namespace slipproof
