// Certifies the records of a table: an array of NumPy.
#pragma once

#include "records/certify/certify.hpp"
#include "records/tables/table.hpp"

namespace slipproof {

/// Certifies the rows of a table; gives the same lines as a CSV file with the same numbers, in memory independent of
/// the number of rows. Columns have the names of CSV columns. `mode` is a text, or an index into RecordFields::modes(),
/// -1 for none; words such as those of `kind` may also be numbers. Integers are rounded to binary64. Throws InputError
/// with all unusable columns, and for a damaged file.
CertifySummary certify(Table table, const LineSink& output, const CertifyOptions& options,
                       const Progress& progress = {});

}  // namespace slipproof
