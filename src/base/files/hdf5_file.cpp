#include "base/files/hdf5_file.hpp"

#include "base/files/words.hpp"

#ifdef SLIPPROOF_HDF5
#include <hdf5.h>

#include <algorithm>
#include <mutex>

#include "base/files/hdf5_id.hpp"
#endif

namespace slipproof {

void Hdf5File::refuse(const std::string& path, const std::string& message) const {
  slipproof::refuse(file_, path + ": " + message);
}

#ifdef SLIPPROOF_HDF5

namespace hdf5 {

/// A file whose name is only a name: the bytes are the file, and nothing is written back.
inline hid_t open_image(const std::string& bytes) {
  const Id access(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose);
  if (!access.open() || H5Pset_fapl_core(access.get(), std::size_t{1} << 16U, false) < 0) return H5I_INVALID_HID;
  // The library copies the bytes, though it does not promise so in the type.
  if (H5Pset_file_image(access.get(), const_cast<char*>(bytes.data()), bytes.size()) < 0) return H5I_INVALID_HID;
  return H5Fopen("problem in memory", H5F_ACC_RDONLY, access.get());
}

}  // namespace hdf5

class Hdf5File::Library {
 public:
  Library(const Hdf5File& owner, const std::string& bytes)
      : lock_(hdf5::mutex()), owner_(owner), size_(bytes.size()), file_(hdf5::open_image(bytes), &H5Fclose) {
    if (!file_.open()) slipproof::refuse(owner.file_, "found no whole HDF5 file: it is cut off or damaged");
  }

  /// Every part of the path is an object of this very file.
  bool has(const std::string& path) const {
    for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
      const std::string part = path.substr(0, end);
      const htri_t there = H5Lexists(file_.get(), part.c_str(), H5P_DEFAULT);
      if (there < 0) owner_.refuse(part, "found something that cannot be read, expected a group or a data set");
      if (there == 0) return false;
      H5L_info_t link;
      if (H5Lget_info(file_.get(), part.c_str(), &link, H5P_DEFAULT) < 0) {
        owner_.refuse(part, "found a link that cannot be read");
      }
      if (link.type != H5L_TYPE_HARD) {
        owner_.refuse(part, std::string("found a link ") +
                                (link.type == H5L_TYPE_SOFT ? "to another path" : "out of the file") +
                                ", expected the data itself");
      }
      const H5I_type_t type = type_of(part);
      if (end == std::string::npos) return true;
      if (type != H5I_GROUP) owner_.refuse(part, "found no group, expected a group");
    }
  }

  std::size_t size_of_group(const std::string& path) const {
    H5G_info_t info;
    if (!has(path) || type_of(path) != H5I_GROUP) owner_.refuse(path, "found no group, expected a group");
    if (H5Gget_info_by_name(file_.get(), path.c_str(), &info, H5P_DEFAULT) < 0) {
      owner_.refuse(path, "found a group that cannot be read");
    }
    return info.nlinks;
  }

  /// The numbers of a data set of the classes that `fits` takes, converted to `memory`.
  template <class Number, class Fits>
  std::vector<Number> numbers(const std::string& path, hid_t memory, const std::string& expected, Fits&& fits,
                              bool* written = nullptr, std::optional<std::size_t> most = {}) const {
    const hdf5::Id set = open(path, expected);
    const hdf5::Id type(H5Dget_type(set.get()), &H5Tclose);
    if (!type.open() || !fits(type.get())) owner_.refuse(path, "found another type, expected " + expected);
    const std::size_t found = length(path, set.get(), H5Tget_size(type.get()), written);
    refuse_more(owner_.file_, path + ": ", found, most);
    std::vector<Number> result(found);
    if (result.empty()) return result;
    if (H5Dread(set.get(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.data()) < 0) {
      owner_.refuse(path, "found numbers that cannot be read: the file is damaged");
    }
    return result;
  }

  std::optional<std::string> text(const std::string& path) const {
    if (!has(path) || type_of(path) != H5I_DATASET) return std::nullopt;
    const hdf5::Id set = open(path, "a text");
    const hdf5::Id type(H5Dget_type(set.get()), &H5Tclose);
    if (!type.open() || H5Tget_class(type.get()) != H5T_STRING || H5Tis_variable_str(type.get()) != 0) {
      return std::nullopt;
    }
    const std::size_t size = H5Tget_size(type.get());
    if (size == 0 || size > 1U << 16U || length(path, set.get(), size) != 1) return std::nullopt;
    std::string result(size, '\0');
    if (H5Dread(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, result.data()) < 0) return std::nullopt;
    result.erase(std::min(result.find('\0'), result.size()));
    return result;
  }

 private:
  H5I_type_t type_of(const std::string& path) const {
    const hdf5::Id object(H5Oopen(file_.get(), path.c_str(), H5P_DEFAULT), &H5Oclose);
    if (!object.open()) owner_.refuse(path, "found something that cannot be read, expected a group or a data set");
    return H5Iget_type(object.get());
  }

  hdf5::Id open(const std::string& path, const std::string& expected) const {
    if (!has(path)) owner_.refuse(path, "found nothing, expected " + expected);
    if (type_of(path) != H5I_DATASET) owner_.refuse(path, "found no data set, expected " + expected);
    const hid_t id = H5Dopen2(file_.get(), path.c_str(), H5P_DEFAULT);
    if (id < 0) owner_.refuse(path, "found a data set that cannot be read, expected " + expected);
    return {id, &H5Dclose};
  }

  /// The number of elements, all of which must be stored in this file; they may be unwritten if `written` is given to
  /// report this. Unwritten data may be at most as much larger than the file as deflate allows.
  std::size_t length(const std::string& path, hid_t set, std::size_t element, bool* written = nullptr) const {
    const hdf5::Id space(H5Dget_space(set), &H5Sclose);
    if (!space.open()) owner_.refuse(path, "found a data set without a size");
    const int dimensions = H5Sget_simple_extent_ndims(space.get());
    if (dimensions < 0 || dimensions > 1) {
      owner_.refuse(path, "found " + std::to_string(dimensions) + " dimensions, expected a list of numbers");
    }
    const hssize_t points = H5Sget_simple_extent_npoints(space.get());
    if (points <= 0) return 0;
    refuse_elsewhere(path, set);
    const auto elements = static_cast<std::size_t>(points);
    const std::size_t stored = H5Dget_storage_size(set);
    const bool nothing = written != nullptr && stored == 0 && elements <= 1032 * size_ / element;
    if (nothing) *written = false;
    if (!nothing && (stored > size_ || stored / element < elements)) {
      owner_.refuse(path, "found a size of " + std::to_string(elements) + ", for which the file has no data");
    }
    return elements;
  }

  /// FCLIB writes its numbers in one piece. Of pieces, the library believes that they are as long as they should be.
  void refuse_elsewhere(const std::string& path, hid_t set) const {
    const hdf5::Id list(H5Dget_create_plist(set), &H5Pclose);
    if (!list.open() || H5Pget_external_count(list.get()) != 0) {
      owner_.refuse(path, "found numbers in another file, expected them in this one");
    }
    const H5D_layout_t layout = H5Pget_layout(list.get());
    if (layout == H5D_CHUNKED) {
      owner_.refuse(path,
                    "found numbers in chunks, expected them in one piece, as h5repack --layout=CONTI writes them");
    }
    if (layout != H5D_CONTIGUOUS && layout != H5D_COMPACT) {
      owner_.refuse(path, "found a virtual data set, expected the data itself");
    }
  }

  std::lock_guard<std::mutex> lock_;
  hdf5::Silence silence_;
  const Hdf5File& owner_;
  std::size_t size_;
  hdf5::Id file_;
};

namespace {

/// Whether an integer consists of whole bytes without padding bits.
bool is_plain_integer(hid_t type) {
  const std::size_t size = H5Tget_size(type);
  return H5Tget_class(type) == H5T_INTEGER && size <= 8 && H5Tget_precision(type) == 8 * size;
}

bool is_plain_real(hid_t type) {
  if (H5Tget_class(type) == H5T_INTEGER) return is_plain_integer(type) && H5Tget_size(type) <= 4;
  return H5Tequal(type, H5T_IEEE_F64LE) > 0 || H5Tequal(type, H5T_IEEE_F64BE) > 0 ||
         H5Tequal(type, H5T_IEEE_F32LE) > 0 || H5Tequal(type, H5T_IEEE_F32BE) > 0;
}

}  // namespace

bool has_hdf5() {
  return true;
}

Hdf5File::Hdf5File(const std::string& bytes, std::string file)
    : file_(std::move(file)), library_(std::make_unique<Library>(*this, bytes)) {}

bool Hdf5File::has(const std::string& path) const {
  return library_->has(path);
}

std::size_t Hdf5File::size_of_group(const std::string& path) const {
  return library_->size_of_group(path);
}

std::vector<std::int64_t> Hdf5File::integers(const std::string& path) const {
  return library_->numbers<std::int64_t>(path, H5T_NATIVE_INT64, "integers", is_plain_integer);
}

std::vector<double> Hdf5File::reals(const std::string& path) const {
  return library_->numbers<double>(path, H5T_NATIVE_DOUBLE, "numbers", is_plain_real);
}

std::vector<double> Hdf5File::reals(const std::string& path, bool& written, std::optional<std::size_t> most) const {
  written = true;
  return library_->numbers<double>(path, H5T_NATIVE_DOUBLE, "numbers", is_plain_real, &written, most);
}

std::optional<std::string> Hdf5File::text(const std::string& path) const {
  return library_->text(path);
}

#else

class Hdf5File::Library {};

bool has_hdf5() {
  return false;
}

Hdf5File::Hdf5File(const std::string&, std::string file) : file_(std::move(file)) {
  slipproof::refuse(file_, without_hdf5);
}

bool Hdf5File::has(const std::string&) const {
  return false;
}

std::size_t Hdf5File::size_of_group(const std::string&) const {
  return 0;
}

std::vector<std::int64_t> Hdf5File::integers(const std::string&) const {
  return {};
}

std::vector<double> Hdf5File::reals(const std::string&) const {
  return {};
}

std::vector<double> Hdf5File::reals(const std::string&, bool&, std::optional<std::size_t>) const {
  return {};
}

std::optional<std::string> Hdf5File::text(const std::string&) const {
  return std::nullopt;
}

#endif

std::int64_t Hdf5File::integer(const std::string& path) const {
  const std::vector<std::int64_t> all = integers(path);
  if (all.size() != 1) refuse(path, "found " + std::to_string(all.size()) + " numbers, expected one");
  return all[0];
}

Hdf5File::~Hdf5File() = default;

}  // namespace slipproof
