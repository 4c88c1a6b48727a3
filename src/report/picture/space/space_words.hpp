// Texts in pictures of scenes in space, about their motions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "contact/space/solved_space.hpp"
#include "report/picture/motion_words.hpp"

namespace slipproof {

/// The mode as a heading holds it: of many contacts how many do what; `(boundary)` where the mode holds only just.
std::string heading_of(const SpaceMotion& motion);
/// `2 motions and a continuum of motions, and there may be others`.
std::string counted_motions(const SolvedSpace& solved);
/// What is below the heading: `one of a continuum, forces open along 1 direction`; empty for a motion alone.
std::string kind_of(const SpaceMotion& motion);
/// `26.6°`; `[20°, 31.5°]`.
std::string angle_text(const Range& degrees);

/// The middle of a range.
double range_middle(const Range& range);

/// The numbers of a picture: exact, rounded, or the ends of wide ranges.
class SpaceNumbers {
 public:
  /// For all of these motions, and the load.
  SpaceNumbers(const MechanismScene& scene, const std::vector<SpaceMotion>& motions);

  const NumberWords& words() const { return words_; }
  /// An enclosure whose ends cannot be told apart in the picture.
  bool is_narrow(const Range& range) const;
  /// `= 3/4`, `≈ 2.45`, `in ≈ [1, 2]`; `open` for nothing.
  std::string text(const std::optional<Range>& range) const;
  /// `≈ (2.45, −1)`.
  std::string pair(const std::optional<Range>& first, const std::optional<Range>& second) const;

 private:
  double scale_ = 0;  ///< of the numbers
  NumberWords words_;
};

/// A line for each contact: its name, what it does, and its forces; without a motion only what letters stand for.
std::vector<std::vector<std::string>> contact_rows(const MechanismScene& scene, const SpaceMotion* motion,
                                                   const SpaceNumbers& numbers, bool lettered);

/// The symbol of a force at a contact, without the contact's name: `N` of `N_foot`.
std::string force_symbol(const Mechanism& mechanism, std::size_t contact, std::size_t unknown);

/// `A: slip`; the name alone without a motion.
std::string contact_text(const MechanismScene& scene, const SpaceMotion* motion, std::size_t contact);

}  // namespace slipproof
