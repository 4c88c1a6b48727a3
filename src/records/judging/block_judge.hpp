// Certifies records side by side, if binary64 is sure of the motion and of the answer's error.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "floating/batch/sure_points.hpp"
#include "records/judging/record_judge.hpp"
#include "records/record/record_block.hpp"

namespace slipproof {

/// Judges blocks of records. For one thread only; the judge must outlive it.
class BlockJudge {
 public:
  explicit BlockJudge(const RecordJudge& judge);

  /// Judges all records of a block.
  void look_at(const RecordBlock& block);
  /// Whether a record is certified; if so, fills `judgement`. If not, ExactJudge must judge it.
  bool certified(std::size_t row, RecordJudgement& judgement) const;

 private:
  /// A number from the scene or from a literal.
  struct Number {
    double nearest = 0;
    bool exact = true;
  };
  static Number number_of(const Rational& x);

  /// The source of an input of the mechanism: none, a number that is the same for all records, a field, the difference
  /// of a field or number and a field, or, if binary64 cannot compute it, the kernel.
  struct Source {
    enum class Kind : std::uint8_t { none, same, field, difference, exact_only };
    Kind kind = Kind::none;
    Number number = {};
    std::size_t field = 0, minus = 0;
    bool minus_number = false;  ///< `number` is subtracted, not a field
  };

  void use(const std::vector<bool>& present);
  Source source(std::size_t input, const std::vector<bool>& present) const;
  Source source(const RecordFields::Form::Set& set, const std::vector<bool>& present) const;
  Column column(const Source& source, const RecordBlock& block, std::vector<double>& buffer) const;
  Column angle(std::size_t index, const RecordBlock& block, std::vector<double>& buffer) const;
  void fill_columns(const RecordBlock& block);
  template <class See>
  void for_each_word(const RecordBlock& block, const See& see);
  void look_at(const RecordBlock& part, std::span<const std::uint16_t> rows, double word);
  void find_motions(std::span<const std::uint16_t> rows, SurePoints& points);
  std::uint16_t claimed_mode(std::size_t row, std::uint16_t only, std::uint16_t claimed) const;
  bool is_of_motion(std::size_t row, std::uint16_t motion, std::uint16_t mode) const;
  void bound_errors(const RecordBlock& part, std::uint16_t mode, std::span<const std::uint16_t> own,
                    std::span<const std::uint16_t> rows);

  const RecordJudge& judge_;
  RecordBlock part_;                        ///< records with the same word
  std::vector<Number> base_, base_angles_;  ///< values common to all records: parameters and the load; angles
  std::optional<std::vector<bool>> present_;
  const MechanismBatch* batch_ = nullptr;
  bool able_ = false;
  std::unique_ptr<ModeRun> run_;
  std::vector<std::uint16_t> modes_;  ///< by mode of the fields: its number among the batch's modes, or no_mode
  std::vector<std::uint16_t> names_;  ///< by mode of the batch: its number among the fields' modes
  std::vector<Source> sources_;       ///< for the parameters and the load
  std::vector<std::vector<double>> buffers_;
  MechanismColumns columns_;
  std::map<double, SurePoints> points_;  ///< by the word that the records of a part have in common
  std::vector<ModeAt> status_;
  std::vector<std::uint16_t> motions_;
  std::array<double, block_records> errors_;
};

}  // namespace slipproof
