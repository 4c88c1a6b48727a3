// Certifying the records of a binary table: NumPy's arrays, HDF5.
#pragma once

#include "records/certify/certify.hpp"
#include "records/tables/table.hpp"

namespace slipproof {

/// certify() of the rows of a table: the same lines for the same numbers, in memory that does not grow with their
/// number. Columns are called as those of CSV, `mode` and `kind` texts or codes: ContactMode::index(), -1 for none, and
/// 0 or 1 for internal or external; of a mechanism `mode` is a text. Integers that are no binary64 are rounded to one.
/// Throws InputError for columns that cannot be used, all of them at once, and for a file that is damaged.
CertifySummary certify(Table table, const LineSink& output, const CertifyOptions& options,
                       const Progress& progress = {});

}  // namespace slipproof
