// Tables in HDF5: a data set with fields, as PyTables, h5py and pandas write it, or a group with a data set a column.
#pragma once

#include <memory>
#include <string>

#include "records/tables/table_builder.hpp"

namespace slipproof {

/// Whether a group of FCLIB's stands in the file, or the file cannot be read, which whoever reads such groups tells.
bool has_contact_problem(const std::string& path);

/// `place` is a path in the file; empty: the only table that there is. The library is asked where the data stand; they
/// are read past it, so that memory does not grow with their number and damaged pieces are told. Data sets may be in
/// one piece or in chunks, deflated and shuffled. Throws InputError with the path.
void read_hdf5_table(TableBuilder& table, const std::shared_ptr<const ByteFile>& file, const std::string& place);

}  // namespace slipproof
