// From a line of text to a record of a mechanism.
#pragma once

#include <string_view>
#include <vector>

#include "records/certify/certify.hpp"
#include "records/certify/mechanism_record.hpp"

namespace slipproof {

/// What a CSV header says, or what keys may stand in JSON Lines. Immutable once made; shared by threads.
class MechanismReader {
 public:
  /// The options have a mechanism. `header` is the first line of CSV. Throws InputError at line 1.
  MechanismReader(const CertifyOptions& options, std::string_view header);

  const MechanismFields& fields() const { return fields_; }
  /// Throws BrokenRecord.
  void read(std::string_view line, MechanismRecord& record) const;

 private:
  friend class MechanismJson;
  static constexpr int mode_column = -1;

  std::optional<int> find(std::string_view name) const;
  void put(MechanismRecord& record, int column, std::string_view text, std::size_t place) const;

  const CertifyOptions& options_;
  MechanismFields fields_;
  bool csv_;
  std::vector<int> columns_;
  std::vector<bool> complete_;  ///< the fields of a CSV line without empty cells
};

}  // namespace slipproof
