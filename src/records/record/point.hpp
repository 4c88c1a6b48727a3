// The point of a mechanism that a record describes.
#pragma once

#include <optional>
#include <string>

#include "mechanics/checks/kinds.hpp"
#include "records/record/record.hpp"

namespace slipproof {

/// The objects needed to judge records of a mechanism; may be shared by threads.
struct RecordSetting {
  const CertifiedMechanism& certified;
  const RecordFields& fields;
  const ProblemMaker& maker;
  const MechanismKinds& kinds;
};

/// The point of a record, or the reason why it has none.
struct RecordPoint {
  MechanismValues values;
  std::optional<Rational> load;
  std::string mistake;

  bool operator==(const RecordPoint&) const = default;
};
RecordPoint point_of(const RecordSetting& setting, const Record& record);

/// The condition of the domain that a point violates, as `found ..., expected ...`; empty if it is in the domain.
std::string outside_domain(const RecordSetting& setting, const RecordPoint& point);

/// Whether a record gives an angle, in any form.
bool gives_angle(const std::vector<bool>& present, const RecordFields& fields, std::size_t angle);

}  // namespace slipproof
