// Certifies the records of a table: an array of NumPy.
#pragma once

#include "records/certify/certify.hpp"
#include "records/tables/table.hpp"

namespace slipproof {

/// certify() of the rows of a table: the same lines for the same numbers, in memory that does not grow with their
/// number. Columns are called as those of CSV. `mode` is a text, or a number among RecordFields::modes(), -1 for none;
/// words such as those of `kind` may be numbers, too. Integers that are no binary64 are rounded to one. Throws
/// InputError for columns that cannot be used, all of them at once, and for a file that is damaged.
CertifySummary certify(Table table, const LineSink& output, const CertifyOptions& options,
                       const Progress& progress = {});

}  // namespace slipproof
