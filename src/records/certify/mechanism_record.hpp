// Records of a mechanism: what their columns may be called, and one of them.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mechanics/scene/scene.hpp"
#include "records/certify/cells.hpp"

namespace slipproof {

/// A mechanism whose records are judged, and the values that are the same for all of them.
struct CertifiedMechanism {
  Mechanism mechanism;
  MechanismValues values;       ///< of parameters that are `given`, and angles that `has_angle`
  std::vector<bool> has_angle;  ///< whether each angle has a value
  std::optional<Rational> load;

  /// Nothing is the same for all records.
  explicit CertifiedMechanism(Mechanism mechanism);
  /// Everything that the scene says.
  explicit CertifiedMechanism(MechanismScene scene);
};

/// Names of columns and keys: parameters; ANGLE.tan_half, ANGLE.cos and ANGLE.sin, ANGLE.degrees; the load; then what a
/// solver answers: accelerations, gaps and slips, then forces.
class MechanismFields {
 public:
  enum AngleForm : std::size_t { tan_half, cosine, sine, degrees };
  static constexpr std::size_t angle_forms = 4;

  /// Throws InputError where there are more than max_modes modes.
  explicit MechanismFields(const Mechanism& mechanism);

  std::size_t size() const { return names_.size(); }
  const std::string& name(std::size_t field) const { return names_[field]; }
  std::optional<std::size_t> find(std::string_view name) const;

  std::size_t parameters() const { return parameters_; }
  std::size_t angles() const { return angles_; }
  std::size_t angle(std::size_t index, AngleForm form) const { return parameters_ + angle_forms * index + form; }
  std::optional<std::size_t> load() const { return load_; }
  std::size_t first_answer() const { return first_answer_; }  ///< acceleration_names(), then force_names()
  std::size_t accelerations() const { return accelerations_; }
  std::size_t answers() const { return names_.size() - first_answer_; }

  /// The modes that a record may claim, `lift` of every contact among them.
  const MechanismMode* find_mode(std::string_view name) const;
  std::string some_mode() const { return modes_.empty() ? std::string() : modes_.begin()->first; }

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::size_t, std::less<>> places_;
  std::map<std::string, MechanismMode, std::less<>> modes_;
  std::size_t parameters_, angles_, first_answer_ = 0, accelerations_ = 0;
  std::optional<std::size_t> load_;
};

/// A solver's output. Used again for the next one it keeps its memory.
struct MechanismRecord {
  std::vector<double> values;                           ///< by field
  std::vector<bool> present;                            ///< which fields stand in the record
  std::vector<std::pair<std::size_t, Rational>> exact;  ///< those that `values` may only round
  const MechanismMode* mode = nullptr;                  ///< claimed by the solver
  std::optional<NotFinite> not_finite;                  ///< the first in the line

  void clear(std::size_t fields);
  void set(std::size_t field, double value);
  void set(std::size_t field, Rational value);
  bool is_exact(std::size_t field) const;
  /// What was written; the field must be there and finite.
  Rational exactly(std::size_t field) const;
};

/// How far cos^2 + sin^2 may be from 1.
inline constexpr double circle_tolerance = 0x1p-48;

/// tan(angle/2) of a record: exactly as it is written, or the binary64 that stands for a point near the circle or for
/// degrees. Nothing for half a turn.
struct RecordAngle {
  bool half_turn = false;
  double nearest = 0;
  std::optional<Rational> exact;  ///< where `nearest` only rounds
};

/// The angle of a complete record; what is no angle is told in `mistake`, as "found ..., expected ...".
RecordAngle angle_of(const MechanismRecord& record, const MechanismFields& fields, std::size_t angle,
                     std::string& mistake);

/// What is missing from a record, or given in two forms; empty if nothing is.
std::string incomplete(const MechanismRecord& record, const MechanismFields& fields,
                       const CertifiedMechanism& mechanism);

}  // namespace slipproof
