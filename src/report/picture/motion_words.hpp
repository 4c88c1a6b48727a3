// Texts in pictures and beside them, about a motion's forces and modes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mechanics/kernel/motion.hpp"
#include "mechanics/scene/scene.hpp"

namespace slipproof {

/// The value of a force in a picture: its own, or one in its range; nothing if all numbers are possible.
std::optional<Rational> shown_value(const Range& range);

/// How the numbers of one picture are written: all exactly where all are short, otherwise all as decimals.
class NumberWords {
 public:
  /// For all numbers that the picture shows.
  explicit NumberWords(const std::vector<Range>& shown);

  /// `3/4`, `−5`; as a decimal `0.75`, or `≈ 0.3333` where that is rounded.
  std::string label(const Rational& x) const;
  /// `= 3/4`, `≈ 0.3333`.
  std::string value(const Rational& x) const;
  /// The same for a range that is a point; otherwise `in [0, 5/2]`.
  std::string range(const Range& range) const;

 private:
  bool fractions_ = true;
};

/// `F = 3 N`: the load of a scene that has one.
std::string load_text(const MechanismScene& scene, const NumberWords& numbers);

/// `2 motions`; `1 continuum of motions, with 2 motions of other modes in it`; `1 motion, 2 continua of motions`.
std::string counted_motions(const MotionsAtLoad& found);

/// Where the acceleration of a contact's gap is among acceleration_names().
std::size_t gap_index(const Mechanism& mechanism, std::size_t contact);

/// The load, the forces of a motion, and the accelerations that have an arrow: what its picture shows.
std::vector<Range> shown_numbers(const MechanismScene& scene, const MotionAtLoad* motion);

/// The state of an element if it is the same in all modes of a motion; otherwise empty.
std::string common_state(const MotionAtLoad& motion, std::size_t element);
/// The mode's name; of one of very many elements how many are in each state.
std::string short_name(const MechanismMode& mode);
/// The names of the motion's modes, as many as a heading holds, and whether they hold only at a boundary.
std::string modes_text(const MotionAtLoad& motion);

/// Of a force among the mechanism's unknowns.
const Range& range_of_force(const MechanismScene& scene, const MotionAtLoad& motion, std::size_t unknown);

/// The contact's name, with its state if there is a motion.
std::string contact_text(const MechanismScene& scene, const MotionAtLoad* motion, std::size_t contact);

/// The load, friction elements, contacts without a place, and forces that are not drawn; `drawn` says of each contact
/// whether its forces are.
std::vector<std::string> told_of(const MechanismScene& scene, const MotionAtLoad* motion,
                                 const std::vector<bool>& drawn, const NumberWords& numbers);

/// The pieces, with commas between those of a line, in lines of at most so many characters where a piece is not longer.
std::vector<std::string> caption_lines(const std::vector<std::string>& pieces, std::size_t length);

}  // namespace slipproof
