// Describes as JSON the correct motions, and why an answer is wrong.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/output/json.hpp"
#include "mechanics/kernel/motions.hpp"
#include "records/record/point.hpp"

namespace slipproof {

/// Explains one record; all arguments must outlive it. `problem` is the problem at its point, without the equations.
class Explanation {
 public:
  Explanation(const RecordSetting& setting, const FrictionProblem& problem, const MotionsAtLoad& found,
              const std::optional<Rational>& load)
      : setting_(setting), problem_(problem), found_(found), load_(load) {}

  /// Adds `found`, `continua` and `hysteresis`: all motions that exist.
  void add_motions(Json& details) const;
  /// Adds why the mode that a record claims is wrong.
  void add_claimed(Json& details, const MechanismMode& mode, const MechanismValues& values) const;
  /// The same for the mode that an answer suggests; needs the forces of all contacts.
  void add_likely(Json& details, const Record& record, const MechanismValues& values) const;
  /// The mode that the forces of the contacts suggest, so far as the record has them. Only for mechanisms without other
  /// elements.
  std::optional<MechanismMode> guess_mode(const Record& record) const;

 private:
  Json motion_of(const MotionAtLoad& motion) const;
  void add_against(Json& details, const MechanismMode& mode, const MechanismValues& values) const;
  std::string not_modelled(const MechanismMode& mode, const MechanismValues& values) const;

  const RecordSetting& setting_;
  const FrictionProblem& problem_;
  const MotionsAtLoad& found_;
  const std::optional<Rational>& load_;
};

}  // namespace slipproof
