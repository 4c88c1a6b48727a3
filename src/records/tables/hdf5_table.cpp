#include "records/tables/hdf5_table.hpp"

#include "base/files/hdf5_file.hpp"

#ifdef SLIPPROOF_HDF5
#include <hdf5.h>

#include <algorithm>
#include <mutex>
#include <optional>

#include "base/files/chunk_run.hpp"
#include "base/files/hdf5_id.hpp"
#endif

namespace slipproof {

#ifdef SLIPPROOF_HDF5

namespace hdf5 {

inline std::string name_of(hid_t group, hsize_t index) {
  const ssize_t length = H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, index, nullptr, 0, H5P_DEFAULT);
  constexpr ssize_t longest = 1U << 16U;
  if (length < 0 || length > longest) return {};
  std::string name(static_cast<std::size_t>(length) + 1, '\0');
  H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, index, name.data(), name.size(), H5P_DEFAULT);
  name.pop_back();
  return name;
}

/// The type of cells with numbers or with texts of fixed length; `other` for all other types.
inline CellType cell_type_of(hid_t type) {
  CellType result{CellType::Kind::other, H5Tget_size(type), H5Tget_order(type) == H5T_ORDER_BE, "a type of HDF5"};
  const H5T_class_t kind = H5Tget_class(type);
  const bool whole = result.size == 1 || result.size == 2 || result.size == 4 || result.size == 8;
  if (kind == H5T_INTEGER && whole && H5Tget_precision(type) == 8 * result.size) {
    result.kind = H5Tget_sign(type) == H5T_SGN_NONE ? CellType::Kind::natural : CellType::Kind::integer;
  }
  for (const hid_t real : {H5T_IEEE_F64LE, H5T_IEEE_F64BE, H5T_IEEE_F32LE, H5T_IEEE_F32BE}) {
    if (H5Tequal(type, real) > 0) result.kind = CellType::Kind::real;
  }
  if (kind == H5T_STRING && H5Tis_variable_str(type) == 0) result.kind = CellType::Kind::bytes;
  if (kind == H5T_STRING) result.name = result.kind == CellType::Kind::bytes ? "a text" : "a text of variable length";
  if (kind == H5T_ARRAY) result.name = "an array";
  if (kind == H5T_COMPOUND) result.name = "a type with fields of its own";
  if (kind == H5T_REFERENCE || kind == H5T_VLEN) result.name = "a type of variable length";
  if (kind == H5T_ENUM) result.name = "an enumeration";
  return result;
}

/// Finds tables and adds their columns.
class TableReader {
 public:
  TableReader(TableBuilder& table, std::shared_ptr<const ByteFile> file)
      : lock_(mutex()),
        table_(table),
        bytes_(std::move(file)),
        file_(H5Fopen(bytes_->name().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), &H5Fclose) {
    if (!file_.open()) table.fail("found no whole HDF5 file: it is cut off or damaged");
  }

  void read(const std::string& place) {
    const std::string at = place.empty() ? only_table("/", 0) : place.starts_with('/') ? place : '/' + place;
    if (at.empty()) table_.fail("found neither a contact problem (/fclib_local, /fclib_global) nor a table of records");
    if (kind_of(at) == H5I_DATASET) {
      read_records(at);
    } else {
      read_group(at);
    }
  }

 private:
  [[noreturn]] void fail(const std::string& path, const std::string& message) const {
    table_.fail(path + ": " + message);
  }

  /// The kind of object that a chain of hard links leads to.
  H5I_type_t kind_of(const std::string& path) const {
    for (std::size_t end = path.find('/', 1); path != "/"; end = path.find('/', end + 1)) {
      const std::string part = path.substr(0, end);
      H5L_info_t link;
      if (H5Lexists(file_.get(), part.c_str(), H5P_DEFAULT) <= 0 ||
          H5Lget_info(file_.get(), part.c_str(), &link, H5P_DEFAULT) < 0) {
        fail(part, "found nothing, expected a data set or a group");
      }
      if (link.type != H5L_TYPE_HARD) fail(part, "found a link to another place, expected the data itself");
      if (end == std::string::npos) break;
    }
    const Id object(H5Oopen(file_.get(), path.c_str(), H5P_DEFAULT), &H5Oclose);
    if (!object.open()) fail(path, "found something that cannot be read, expected a group or a data set");
    return H5Iget_type(object.get());
  }

  std::vector<std::string> names_in(const std::string& path) const {
    const Id group(H5Gopen2(file_.get(), path.c_str(), H5P_DEFAULT), &H5Gclose);
    H5G_info_t info;
    if (!group.open() || H5Gget_info(group.get(), &info) < 0) fail(path, "found a group that cannot be read");
    constexpr hsize_t most = 4096;
    if (info.nlinks > most) fail(path, "found " + std::to_string(info.nlinks) + " objects, expected at most 4096");
    std::vector<std::string> names;
    for (hsize_t k = 0; k < info.nlinks; ++k) names.push_back(name_of(group.get(), k));
    return names;
  }

  static std::string inside(const std::string& path, const std::string& name) {
    return (path == "/" ? path : path + '/') + name;
  }

  bool has_fields(const std::string& path) const {
    const Id set = open_set(path);
    const Id type(H5Dget_type(set.get()), &H5Tclose);
    return type.open() && H5Tget_class(type.get()) == H5T_COMPOUND;
  }

  /// The path of the only data set with fields, or of the only group of other data sets; empty if there is none.
  std::string only_table(const std::string& path, int depth) const {
    constexpr int deepest = 8;
    if (depth > deepest) fail(path, "found groups in groups, expected --table with the place of the records");
    std::string found;
    const auto candidate = [&](const std::string& place) {
      if (place.empty() || place == found) return;
      if (!found.empty()) {
        table_.fail("found tables at " + found + " and " + place + ", expected --table with the place of one");
      }
      found = place;
    };
    for (const std::string& name : names_in(path)) {
      const std::string here = inside(path, name);
      const H5I_type_t kind = kind_of(here);
      if (kind == H5I_GROUP) candidate(only_table(here, depth + 1));
      if (kind == H5I_DATASET) candidate(has_fields(here) ? here : path);
    }
    return found;
  }

  Id open_set(const std::string& path) const {
    const hid_t set = H5Dopen2(file_.get(), path.c_str(), H5P_DEFAULT);
    if (set < 0) fail(path, "found a data set that cannot be read");
    return {set, &H5Dclose};
  }

  /// The number of items of a data set with at most one dimension; nothing for other data sets.
  std::optional<std::uint64_t> length(const std::string& path, hid_t set) const {
    const Id space(H5Dget_space(set), &H5Sclose);
    if (!space.open()) fail(path, "found a data set without a size");
    if (H5Sget_simple_extent_type(space.get()) == H5S_NULL) return std::nullopt;
    const int dimensions = H5Sget_simple_extent_ndims(space.get());
    if (dimensions < 0 || dimensions > 1) return std::nullopt;
    const hssize_t points = H5Sget_simple_extent_npoints(space.get());
    return points < 0 ? 0 : static_cast<std::uint64_t>(points);
  }

  void read_records(const std::string& path) {
    const Id set = open_set(path);
    const Id type(H5Dget_type(set.get()), &H5Tclose);
    const auto items = length(path, set.get());
    if (!type.open() || H5Tget_class(type.get()) != H5T_COMPOUND) fail(path, "found no fields, expected records");
    if (!items) fail(path, "found several dimensions, expected one: a record each");
    const std::size_t item = H5Tget_size(type.get());
    const std::size_t part = table_.add_part(run_of(path, set.get(), item, *items), item, *items, path);
    for (unsigned k = 0; k < static_cast<unsigned>(H5Tget_nmembers(type.get())); ++k) {
      const Id member(H5Tget_member_type(type.get(), k), &H5Tclose);
      char* const name = H5Tget_member_name(type.get(), k);
      if (name == nullptr || !member.open()) fail(path, "found a field that cannot be read");
      TableColumn column{name, cell_type_of(member.get()), part, H5Tget_member_offset(type.get(), k)};
      H5free_memory(name);
      if (column.offset > item || item - column.offset < column.type.size) {
        fail(path, column.name + ": found a field outside of its record");
      }
      table_.add_column(std::move(column));
    }
  }

  void read_group(const std::string& path) {
    for (const std::string& name : names_in(path)) {
      const std::string here = inside(path, name);
      if (kind_of(here) != H5I_DATASET) continue;
      const Id set = open_set(here);
      const Id type(H5Dget_type(set.get()), &H5Tclose);
      if (!type.open()) fail(here, "found a type that cannot be read");
      CellType cell = cell_type_of(type.get());
      const auto items = length(here, set.get());
      if (!items || cell.kind == CellType::Kind::other) {
        if (!items) cell.name = "several dimensions";
        cell.kind = CellType::Kind::other;
        table_.add_column({name, cell, 0, 0});
        continue;
      }
      const std::size_t part = table_.add_part(run_of(here, set.get(), cell.size, *items), cell.size, *items, here);
      table_.add_column({name, cell, part, 0});
    }
  }

  std::unique_ptr<ByteRun> run_of(const std::string& path, hid_t set, std::size_t item, std::uint64_t items) const {
    const Id list(H5Dget_create_plist(set), &H5Pclose);
    if (!list.open() || H5Pget_external_count(list.get()) != 0) {
      fail(path, "found numbers in another file, expected them in this one");
    }
    if (items == 0) return std::make_unique<PlainRun>(bytes_, 0);
    std::uint64_t size = 0;
    if (__builtin_mul_overflow(items, item, &size)) fail(path, "found a size that is too large");
    const H5D_layout_t layout = H5Pget_layout(list.get());
    if (layout == H5D_CHUNKED) return chunks_of(path, set, list.get(), item, items);
    const haddr_t offset = H5Dget_offset(set);
    if (layout != H5D_CONTIGUOUS || offset == HADDR_UNDEF) {
      fail(path, layout == H5D_CONTIGUOUS ? "found records that were never written"
                                          : "found a compact or virtual data set, expected one piece or chunks");
    }
    if (offset > bytes_->size() || size > bytes_->size() - offset) {
      fail(path, "found " + std::to_string(items) + " items, for which the file has no data");
    }
    return std::make_unique<PlainRun>(bytes_, offset);
  }

  std::unique_ptr<ByteRun> chunks_of(const std::string& path, hid_t set, hid_t list, std::size_t item,
                                     std::uint64_t items) const {
    ChunkLayout layout{path, item, 0, items, filters(path, list), {}};
    hsize_t rows = 0;
    if (H5Pget_chunk(list, 1, &rows) != 1 || rows == 0) fail(path, "found chunks without a size");
    layout.rows = rows;
    hsize_t count = 0;
    const Id space(H5Dget_space(set), &H5Sclose);
    if (H5Dget_num_chunks(set, space.get(), &count) < 0) fail(path, "found chunks that cannot be counted");
    if (count != (items + rows - 1) / rows) {
      fail(path, "found " + std::to_string(count) + " chunks of " + std::to_string(rows) + ", expected " +
                     std::to_string(items) + " items: some were never written");
    }
    for (hsize_t k = 0; k < count; ++k) {
      const hsize_t at = k * rows;
      unsigned skipped = 0;
      haddr_t offset = 0;
      hsize_t size = 0;
      if (H5Dget_chunk_info_by_coord(set, &at, &skipped, &offset, &size) < 0 || offset == HADDR_UNDEF) {
        fail(path, "found a chunk that cannot be read");
      }
      if (skipped != 0) fail(path, "found a chunk that left out a filter, which is not read here");
      layout.chunks.push_back({offset, size});
    }
    layout.check(*bytes_);
    return std::make_unique<ChunkRun>(bytes_, std::move(layout));
  }

  std::vector<ChunkFilter> filters(const std::string& path, hid_t list) const {
    std::vector<ChunkFilter> result;
    for (unsigned k = 0; k < static_cast<unsigned>(std::max(H5Pget_nfilters(list), 0)); ++k) {
      unsigned flags = 0, config = 0;
      std::size_t values = 0;
      const H5Z_filter_t filter = H5Pget_filter2(list, k, &flags, &values, nullptr, 0, nullptr, &config);
      if (filter == H5Z_FILTER_DEFLATE) {
        result.push_back(ChunkFilter::deflate);
      } else if (filter == H5Z_FILTER_SHUFFLE) {
        result.push_back(ChunkFilter::shuffle);
      } else if (filter == H5Z_FILTER_FLETCHER32) {
        result.push_back(ChunkFilter::fletcher32);
      } else {
        fail(path, "found the filter " + std::to_string(filter) +
                       ", expected deflate (gzip), shuffle, fletcher32 or none; h5repack -f GZIP=1 writes it so");
      }
    }
    return result;
  }

  std::lock_guard<std::mutex> lock_;
  Silence silence_;
  TableBuilder& table_;
  std::shared_ptr<const ByteFile> bytes_;
  Id file_;
};

}  // namespace hdf5

bool has_contact_problem(const std::string& path) {
  const std::lock_guard lock(hdf5::mutex());
  const hdf5::Silence silence;
  const hdf5::Id file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), &H5Fclose);
  H5G_info_t info;
  if (!file.open() || H5Gget_info(file.get(), &info) < 0) return true;
  for (hsize_t k = 0; k < std::min<hsize_t>(info.nlinks, 4096); ++k) {
    if (hdf5::name_of(file.get(), k).starts_with("fclib_")) return true;
  }
  return false;
}

void read_hdf5_table(TableBuilder& table, const std::shared_ptr<const ByteFile>& file, const std::string& place) {
  hdf5::TableReader(table, file).read(place);
}

#else

bool has_contact_problem(const std::string&) {
  return true;
}

void read_hdf5_table(TableBuilder& table, const std::shared_ptr<const ByteFile>&, const std::string&) {
  table.fail(without_hdf5);
}

#endif

}  // namespace slipproof
