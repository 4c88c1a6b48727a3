// Records in HDF5 are judged as the same records in CSV; what is malformed is told.
#include "records/tables/same_records.hpp"
#include "support/files/hdf5_writer.hpp"

using namespace slipproof;
using namespace slipproof::test;

#ifdef SLIPPROOF_HDF5
namespace {

/// Properties of a data set in chunks.
class ChunkedSet {
 public:
  ChunkedSet(hsize_t rows, bool packed) : list_(H5Pcreate(H5P_DATASET_CREATE)) {
    H5Pset_chunk(list_, 1, &rows);
    if (!packed) return;
    H5Pset_shuffle(list_);
    H5Pset_deflate(list_, 4);
    H5Pset_fletcher32(list_);
  }
  ChunkedSet(const ChunkedSet&) = delete;
  ChunkedSet& operator=(const ChunkedSet&) = delete;
  ~ChunkedSet() { H5Pclose(list_); }
  hid_t get() const { return list_; }

 private:
  hid_t list_;
};

/// The records with fields, as h5py writes a structured array.
void write_records(const Hdf5Writer& file, const std::string& path, const SameRecords& records, hid_t properties) {
  const std::string rows = records.rows();
  const std::size_t item = rows.size() / records.size();
  const hid_t type = H5Tcreate(H5T_COMPOUND, item), text = H5Tcopy(H5T_C_S1);
  H5Tset_size(text, 12);
  std::size_t offset = 0;
  for (std::size_t k = 0; k < record_columns.size(); ++k) {
    const hid_t member = k == kind_cell ? H5T_STD_U8LE : k == mode_cell ? text : H5T_IEEE_F64LE;
    H5Tinsert(type, record_columns[k].c_str(), offset, member);
    offset += H5Tget_size(member);
  }
  file.set(path, type, {records.size()}, type, rows.data(), properties);
  H5Tclose(text);
  H5Tclose(type);
}

}  // namespace

TEST_CASE("records in HDF5: with fields or a data set a column, in one piece, in chunks, packed") {
  const SameRecords records(230, 73);
  const Folder folder;
  const Certified expected = certified(records.csv());
  const ChunkedSet chunks(50, false), packed(64, true);
  for (const hid_t properties : {hid_t{H5P_DEFAULT}, chunks.get(), packed.get()}) {
    const std::string path = folder.path("t.h5");
    {
      const Hdf5Writer file(path);
      file.group("/data");
      write_records(file, "/data/records", records, properties);
    }
    CHECK(is_table_file(path));
    check_same(certified_table(path), expected);
    CertifyOptions rest;
    rest.first_record = 200;
    CHECK(expected.text.ends_with(certified_table(path, rest).text));
    {
      const Hdf5Writer file(path);
      for (std::size_t k = 0; k < record_columns.size(); ++k) {
        Numbers numbers;
        if (k == mode_cell) continue;
        for (std::size_t i = 0; i < records.size(); ++i) {
          numbers.push_back(k == kind_cell ? records.cells(i)[k] == "external" : records.number(i, k));
        }
        file.reals("/" + record_columns[k], numbers, k == kind_cell ? H5T_STD_I16BE : H5T_IEEE_F64BE, properties);
      }
    }
    Certified without_modes = certified_table(path);
    CHECK(without_modes.summary.records == records.size());
    CHECK(without_modes.summary.count(RecordVerdict::certified) > expected.summary.count(RecordVerdict::certified));
  }
}

TEST_CASE("tables of HDF5 that are none are refused with their paths") {
  const Folder folder;
  const std::string path = folder.path("t.h5");
  const auto refused = [&](const std::function<void(const Hdf5Writer&)>& write) {
    {
      const Hdf5Writer file(path);
      write(file);
    }
    return table_refusal(path);
  };
  const ChunkedSet chunks(4, true);
  CHECK(refused([](const Hdf5Writer&) {}) ==
        "FILE: found neither a contact problem (/fclib_local, /fclib_global) nor a table of records");
  CHECK(refused([](const Hdf5Writer& f) {
          for (const char* group : {"/one", "/two"}) {
            f.group(group);
            f.reals(std::string(group) + "/a", {1, 2});
          }
        }) == "FILE: found tables at /one and /two, expected --table with the place of one");
  CHECK(refused([](const Hdf5Writer& f) {
          f.reals("/a", {1, 2});
          f.reals("/S2", {1, 2, 3});
        }).starts_with("FILE: /a: found 2 items, expected 3 as in /S2, or one for all"));
  CHECK(refused([](const Hdf5Writer& f) { f.set("/a", H5T_IEEE_F64LE, {3}, 0, nullptr); }) ==
        "FILE: /a: found records that were never written");
  CHECK(refused([&](const Hdf5Writer& f) {
          f.set("/a", H5T_IEEE_F64LE, {9}, 0, nullptr, chunks.get());
        }).starts_with("FILE: /a: found 0 chunks of 4, expected 9 items: some were never written"));
  CHECK(refused([](const Hdf5Writer& f) {
          f.set("/a", H5T_IEEE_F64LE, {1, 1}, H5T_NATIVE_DOUBLE, Numbers{1}.data());
          f.reals("/S2", {1});
        }).starts_with("FILE: the column 'a': found the type 'several dimensions', expected numbers"));
  CHECK(refused([](const Hdf5Writer& f) { H5Lcreate_soft("/b", f.file(), "/a", H5P_DEFAULT, H5P_DEFAULT); }) ==
        "FILE: /a: found a link to another place, expected the data itself");
  CHECK(refused([](const Hdf5Writer& f) {
          f.group("/g");
          H5Lcreate_hard(f.file(), "/g", f.file(), "/g/g", H5P_DEFAULT, H5P_DEFAULT);
        }).ends_with("found groups in groups, expected --table with the place of the records"));
  const ChunkedSet large(1U << 22U, true);  // 32 MiB for three numbers, of which some kilobytes stand in the file
  CHECK(refused([&](const Hdf5Writer& f) {
          const hsize_t three = 3, any = H5S_UNLIMITED;
          const hid_t space = H5Screate_simple(1, &three, &any);
          const hid_t set = H5Dcreate2(f.file(), "/a", H5T_IEEE_F64LE, space, H5P_DEFAULT, large.get(), H5P_DEFAULT);
          REQUIRE(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, Numbers{1, 2, 3}.data()) >= 0);
          H5Dclose(set);
          H5Sclose(space);
        }) == "FILE: /a: found chunks of 4194304 items for 3, expected no larger ones than what is in them");
  refused([&](const Hdf5Writer& f) { f.reals("/a", {1, 2, 3, 4, 5, 6, 7, 8}, H5T_IEEE_F64LE, chunks.get()); });
  std::string bytes = [&] {
    std::ifstream in(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  }();
  CHECK(refusal([&] { open_table(path, {.names = {"a"}, .place = ""}); }, path) ==
        "FILE: found columns that have names, expected no other ones from --columns");
  CHECK(refusal([&] { open_table(path, {.names = {}, .place = "/b"}); }, path) ==
        "FILE: /b: found nothing, expected a data set or a group");
  folder.write("t.h5", bytes.substr(0, bytes.size() / 2));
  CHECK(table_refusal(path) == "FILE: found no whole HDF5 file: it is cut off or damaged");
}
#endif
