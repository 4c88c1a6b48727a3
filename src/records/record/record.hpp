// Records of a mechanism: the names of their columns, and one record.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/expression/program.hpp"
#include "mechanics/scene/scene.hpp"
#include "records/record/cells.hpp"
#include "records/record/record_modes.hpp"

namespace slipproof {

/// A short form: numbers that a record may give together in place of parameters of the mechanism or of its load.
struct ShortForm {
  struct Set {
    std::string target;      ///< a parameter, or the load
    std::string expression;  ///< over parameters and the numbers of the form
  };
  std::vector<std::string> symbols;
  std::vector<Set> sets;  ///< each may use earlier targets
};

/// A column of words that sets a parameter.
struct WordColumn {
  std::string name, parameter;
  std::vector<std::string> words;  ///< for the values 0, 1, ...
};

/// A mechanism whose records are judged, and the values that are the same for all records.
struct CertifiedMechanism {
  Mechanism mechanism;
  MechanismValues values;       ///< parameters that are `given`, and angles with `has_angle`
  std::vector<bool> has_angle;  ///< whether each angle has a value
  std::optional<Rational> load;
  std::vector<ShortForm> forms = {};      ///< fields that may replace parameters
  std::optional<WordColumn> word = {};    ///< a parameter that records may give as a word
  std::vector<std::string> answers = {};  ///< fields that an answer must have; empty: all unknown accelerations

  /// No value is the same for all records.
  explicit CertifiedMechanism(Mechanism mechanism);
  /// Makes records in which all values of the scene are common to all records.
  explicit CertifiedMechanism(MechanismScene scene);
};

/// The names of columns and keys: first the scene, that is, parameters; ANGLE.tan_half, ANGLE.cos and ANGLE.sin,
/// ANGLE.degrees; the load; numbers of short forms. Then the solver's answer: accelerations, gaps and slips, then
/// forces.
class RecordFields {
 public:
  enum AngleForm : std::size_t { tan_half, cosine, sine, degrees };
  static constexpr std::size_t angle_forms = 4;

  explicit RecordFields(const CertifiedMechanism& certified);

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
  const std::vector<std::size_t>& required_answers() const { return required_; }

  /// A compiled short form.
  struct Form {
    struct Set {
      std::size_t target;  ///< a parameter, or the number of parameters for the load
      Program value;       ///< its slots are fields
    };
    std::vector<std::size_t> symbols;  ///< fields
    std::vector<Set> sets;
  };
  const std::vector<Form>& forms() const { return forms_; }
  const std::optional<WordColumn>& word() const { return word_; }
  /// The field that a word sets.
  std::size_t word_field() const { return *find(word_->parameter); }
  std::optional<std::size_t> find_word(std::string_view word) const;

  /// The modes that a record may claim, in the order of enumeration; `lift` of every contact is among them.
  RecordModes& modes() const { return *modes_; }
  /// Whether a record may claim a mode: not in space, where a mode is none of these.
  bool has_modes() const { return has_modes_; }
  const std::string& mode_name(std::size_t mode) const { return modes_->name(mode); }
  std::optional<std::uint16_t> find_mode(std::string_view name) const { return modes_->find(name); }

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::size_t, std::less<>> places_;
  std::shared_ptr<RecordModes> modes_;
  bool has_modes_ = true;
  std::vector<Form> forms_;
  std::optional<WordColumn> word_;
  std::vector<std::size_t> required_;
  std::size_t parameters_, angles_, first_answer_ = 0, accelerations_ = 0;
  std::optional<std::size_t> load_;
};

/// The output of a solver. If it is used again for the next record, it keeps its memory.
struct Record {
  std::vector<double> values;                           ///< by field
  std::vector<bool> present;                            ///< which fields stand in the record
  std::vector<std::pair<std::size_t, Rational>> exact;  ///< those that `values` only rounds
  std::uint16_t mode = no_mode;         ///< claimed by the solver, by its number among the fields' modes
  std::optional<NotFinite> not_finite;  ///< the first in the line

  void clear(std::size_t fields);
  void set(std::size_t field, double value);
  void set(std::size_t field, Rational value);
  bool is_exact(std::size_t field) const;
  /// The value as it was written; the field must be present and finite.
  Rational exactly(std::size_t field) const;
};

/// The largest allowed |cos^2 + sin^2 - 1|.
inline constexpr double circle_tolerance = 0x1p-48;

/// tan(angle/2) of a record: exactly as written, or the binary64 that stands for a point near the circle or for
/// degrees. Nothing for a half turn.
struct RecordAngle {
  bool half_turn = false;
  double nearest = 0;
  std::optional<Rational> exact;  ///< if `nearest` is only a rounded value
};

/// The angle of a complete record. If it is not an angle, `mistake` says so: "found ..., expected ...".
RecordAngle angle_of(const Record& record, const RecordFields& fields, std::size_t angle, std::string& mistake);

/// Describes fields that are missing or given in two forms; empty if there is no mistake.
std::string incomplete(const std::vector<bool>& present, const RecordFields& fields,
                       const CertifiedMechanism& mechanism);

}  // namespace slipproof
