// Tables in HDF5: a data set with fields, as PyTables, h5py and pandas write it, or a group with one data set for each
// column.
#pragma once

#include <memory>
#include <string>

#include "records/tables/table_builder.hpp"

namespace slipproof {

/// True if the file has an FCLIB group or cannot be read; in the second case the FCLIB reader reports why.
bool has_contact_problem(const std::string& path);

/// `place` is a path in the file; empty: the only table in it. The HDF5 library only says where the data are. They are
/// then read directly, so that memory does not grow with their number and damaged pieces are reported. Data sets may be
/// contiguous or in chunks, deflated and shuffled. Throws InputError with the path.
void read_hdf5_table(TableBuilder& table, const std::shared_ptr<const ByteFile>& file, const std::string& place);

}  // namespace slipproof
