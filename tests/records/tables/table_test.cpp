// Records in NumPy's files and in HDF5 are judged as the same records in CSV; what is malformed is told.
#include <nlohmann/json.hpp>

#include "records/certify/columns.hpp"
#include "records/certify/table_records.hpp"
#include "records/record/bicycle_records.hpp"
#include "support/certified.hpp"
#include "support/files/hdf5_writer.hpp"
#include "support/files/small_files.hpp"
#include "support/files/zip_file.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

/// Records with J, some of them wrong: CSV and every binary form of the same numbers.
class SameRecords {
 public:
  explicit SameRecords(std::size_t count, std::uint64_t seed = 71) {
    SolverRecords records(seed);
    while (cells_.size() < count) {
      Cells cells = records.next();
      if (cells[j_cell].empty()) continue;
      const std::size_t k = cells_.size();
      if (k % 7 == 3) cells[answer_cell + 7] = "12.5";
      if (k % 11 == 5) cells[mode_cell] = "lift/lift";
      if (k % 13 == 6) cells[mode_cell] = "";
      if (k % 50 == 8) cells[0] = "-1";
      cells_.push_back(std::move(cells));
    }
  }

  std::size_t size() const { return cells_.size(); }
  std::string csv() const {
    std::string text = test::header();
    for (const Cells& cells : cells_) text += joined(cells);
    return text;
  }
  std::string rows() const {
    std::string text;
    for (const Cells& cells : cells_) text += npy_row(cells);
    return text;
  }
  double number(std::size_t row, std::size_t column) const { return std::strtod(cells_[row][column].c_str(), nullptr); }
  const Cells& cells(std::size_t row) const { return cells_[row]; }

  /// One column as an array of its own.
  std::string column(std::size_t k, const std::string& descr) const {
    std::string data;
    for (std::size_t i = 0; i < size(); ++i) {
      if (descr.find('U') != std::string::npos) {
        for (std::size_t c = 0; c < 11; ++c)
          data += little(c < cells_[i][k].size() ? static_cast<unsigned char>(cells_[i][k][c]) : 0, 4);
      } else {
        data += k == kind_cell ? npy_number(cells_[i][k] == "external", descr) : npy_number(number(i, k), descr);
      }
    }
    return npy_with(npy_dictionary("'" + descr + "'", "(" + std::to_string(size()) + ",)"), data);
  }

 private:
  std::vector<Cells> cells_;
};

Certified certified_table(const std::string& path, const CertifyOptions& given = {}, const TableOptions& table = {}) {
  CertifyOptions options = given;
  options.file = path;
  Certified result;
  result.summary = certify(
      open_table(path, table), [&result](std::string_view out) { result.text += out; }, options);
  return result;
}

/// CSV refers to what scenes without J say; the lines are the same.
void check_same(const Certified& found, const Certified& expected) {
  CHECK(found.text == expected.text);
  CHECK(to_json(found.summary) == to_json(expected.summary));
}

std::string table_refusal(const std::string& path) {
  return refusal([&] { certified_table(path); }, path);
}

/// Records of a short bicycle in few columns, by their names.
const std::vector<std::string> short_columns{"R", "h", "b", "M2", "M3", "L",  "f",
                                             "g", "F", "a", "S2", "S3", "N2", "N3"};

std::string short_fields(const std::string& type = "<f8") {
  std::string descr = "[";
  for (const std::string& name : short_columns) descr += "('" + name + "', '" + type + "'), ";
  return descr + "]";
}

std::string short_row(double a = 1) {
  std::string row;
  for (const double x : {1., 1., 1., 1., 1., 1., 1., 10., 2., a, 0., 0., 5., 5.}) row += npy_number(x, "<f8");
  return row;
}

std::string npz_of(const std::vector<std::pair<std::string, std::string>>& arrays) {
  std::vector<Packed> files;
  for (const auto& [name, content] : arrays) files.push_back({name + ".npy", content});
  return zip(files);
}

}  // namespace

TEST_CASE("the same records give the same bytes from CSV, arrays and archives, at any number of threads") {
  const SameRecords records(700);
  const Folder folder;
  const Certified expected = certified(records.csv());
  CHECK(expected.summary.count(RecordVerdict::certified) > 300);
  CHECK(expected.summary.count(RecordVerdict::wrong) > 20);
  CHECK(expected.summary.count(RecordVerdict::invalid) > 5);
  const std::string structured = folder.write("s.npy", npy_file(npy_record_fields(), records.rows(), records.size()));
  for (const unsigned threads : {1U, 2U}) {
    CertifyOptions options;
    options.threads = threads;
    check_same(certified_table(structured, options), expected);
  }
  CertifyOptions rest;
  rest.first_record = 600;
  const Certified last = certified_table(structured, rest);
  CHECK(last.summary.records == 101);
  CHECK(expected.text.ends_with(last.text));

  std::vector<std::pair<std::string, std::string>> arrays;
  for (std::size_t k = 0; k < record_columns.size(); ++k) {
    const std::string type = k == mode_cell ? "<U11" : k == kind_cell ? ">i8" : k % 2 == 0 ? ">f8" : "<f8";
    arrays.emplace_back(record_columns[k], records.column(k, type));
  }
  check_same(certified_table(folder.write("c.npz", npz_of(arrays))), expected);
#ifdef SLIPPROOF_ZLIB
  std::vector<Packed> packed;
  for (const auto& [name, content] : arrays) packed.push_back(deflated(name + ".npy", content));
  const std::string deflated_path = folder.write("d.npz", zip(packed));
  check_same(certified_table(deflated_path), expected);
  CHECK(certified_table(deflated_path, rest).text == last.text);
#endif
}

TEST_CASE("an array of two dimensions takes its names from outside, in either order") {
  const SameRecords records(60);
  const Folder folder;
  TableOptions names;
  std::string rows, columns, csv;
  for (const std::size_t k : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 17, 18, 19, 20, 21, 22, 23, 24, 25}) {
    names.names.push_back(record_columns[k]);
    csv += (csv.empty() ? "" : ",") + record_columns[k];
    for (std::size_t i = 0; i < records.size(); ++i) columns += npy_number(records.number(i, k), ">f4");
  }
  csv += '\n';
  for (std::size_t i = 0; i < records.size(); ++i) {
    for (std::size_t k = 0; k < names.names.size(); ++k) {
      const double x = records.number(i, k < 15 ? k : k + 2);
      rows += npy_number(x, "<f8");
      csv += (k == 0 ? "" : ",") + fmt::format("{}", x);
    }
    csv += '\n';
  }
  const std::string shape = "(60, 24)";
  const std::string by_rows = folder.write("r.npy", npy_with(npy_dictionary("'<f8'", shape), rows, 2));
  check_same(certified_table(by_rows, {}, names), certified(csv));
  // binary32 is exact, and the others are not what they were: only the tables are the same.
  const std::string by_columns = folder.write("c.npy", npy_with(npy_dictionary("'>f4'", shape, "True"), columns));
  std::string in_rows;
  for (std::size_t i = 0; i < 60; ++i) {
    for (std::size_t k = 0; k < 24; ++k) in_rows += columns.substr(4 * (k * 60 + i), 4);
  }
  const std::string again = folder.write("a.npy", npy_with(npy_dictionary("'>f4'", shape), in_rows));
  check_same(certified_table(by_columns, {}, names), certified_table(again, {}, names));
  CHECK(
      table_refusal(by_rows) ==
      "FILE: found 24 columns and 0 names of columns, expected --columns with a name for each, or a structured array");
}

TEST_CASE("columns in memory are judged as one by one: backwards, apart, constant, and over a scene") {
  const SameRecords records(300, 72);
  const RecordJudge record_judge(bicycle_records(), {});
  const RecordFields& fields = record_judge.fields();
  std::vector<std::array<double, 30>> rows(records.size());
  std::vector<std::uint16_t> modes;
  RecordColumns columns(fields, records.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    for (std::size_t k = 0; k < record_columns.size(); ++k) rows[rows.size() - 1 - i][k] = records.number(i, k);
    rows[rows.size() - 1 - i][kind_cell] = records.cells(i)[kind_cell] == "external" ? 1 : 0;
    modes.push_back(fields.find_mode(records.cells(i)[mode_cell]).value_or(no_mode));
  }
  for (std::size_t k = 0; k < record_columns.size(); ++k) {
    const auto field = k == kind_cell ? std::optional(fields.word_field()) : fields.find(record_columns[k]);
    if (field) columns.numbers[*field] = {&rows.back()[k], -static_cast<std::ptrdiff_t>(sizeof rows[0])};
  }
  columns.modes = std::span<const std::uint16_t>(modes);
  const std::vector<nlohmann::json> lines = certified(records.csv()).lines();
  const ColumnsJudge judge(columns, record_judge);
  for (const unsigned threads : {1U, 2U}) {
    const JudgedColumns found = certify(columns, record_judge, threads);
    CHECK(to_json(found.summary) == to_json(certified(records.csv()).summary));
    std::size_t by_lanes = 0;
    for (std::size_t i = 0; i < records.size(); ++i) {
      const RecordJudgement one = judge(i);
      CHECK(name(found.verdicts[i]) == lines[i]["verdict"].get<std::string>());
      CHECK(found.verdicts[i] == one.verdict);
      CHECK((one.modes.empty() ? found.modes[i] == 0 : (found.modes[i] >> one.modes[0] & 1) == 1));
      CHECK(found.errors[i] == one.max_error);
      CHECK(found.tiers[i] == one.tier);
      if (one.verdict == RecordVerdict::certified && one.tier == Tier::filter) ++by_lanes;
    }
    CHECK(by_lanes > 100);
  }
  modes[7] = 77;
  CHECK_THROWS_WITH(certify(columns, record_judge), "record 8: found the mode 77, expected 0 to 15, or 65535 for none");
  modes[7] = no_mode;
  columns.number("S2") = {};
  columns.number("mu") = columns.number("r1");
  CHECK_THROWS_WITH(certify(columns, record_judge), "found mu together with r1, expected only one of them");
  columns.number("mu") = {};
  CHECK_THROWS_WITH(certify(columns, record_judge), "missing S2");
}

TEST_CASE("a column of one item is the same for all, and no records are none") {
  const Folder folder;
  const std::string two = npy_with(npy_dictionary("'<f8'", "(2,)"), npy_number(1, "<f8") + npy_number(2, "<f8"));
  std::vector<std::pair<std::string, std::string>> arrays;
  const std::string row = short_row();
  for (std::size_t k = 0; k < short_columns.size(); ++k) {
    const std::string one = row.substr(8 * k, 8);
    arrays.emplace_back(short_columns[k],
                        k == 9 ? two : npy_with(npy_dictionary("'<f8'", k % 2 == 0 ? "()" : "(1,)"), one));
  }
  const Certified found = certified_table(folder.write("c.npz", npz_of(arrays)));
  const Certified expected =
      certified_table(folder.write("e.npy", npy_file(short_fields(), short_row(1) + short_row(2), 2)));
  CHECK(found.text == expected.text);
  CHECK(found.summary.records == 2);
  CHECK(certified_table(folder.write("n.npy", npy_file(short_fields(), "", 0))).summary.records == 0);
}

TEST_CASE("NaN is an invalid answer, a code that is none a broken record") {
  const Folder folder;
  const std::string fields = short_fields().substr(0, short_fields().size() - 1) + "('mode', '<i2')]";
  const std::string path = folder.write(
      "r.npy", npy_file(fields, short_row(NAN) + npy_number(-1, "<i2") + short_row() + npy_number(16, "<i2"), 2));
  const Certified found = certified_table(path);
  CHECK(found.lines().at(0)["reason"] == "a: found NaN, expected a finite number");
  CHECK(found.lines().at(1)["reason"] == "mode: found 16, expected 0 to 15, or -1 for none");
  CHECK(found.summary.broken == 1);
  CertifyOptions stop;
  stop.stop_at_broken = true;
  CHECK(refusal([&] { certified_table(path, stop); }, path) ==
        "FILE: record 2: mode: found 16, expected 0 to 15, or -1 for none");
}

TEST_CASE("malformed tables are refused with what was found and expected") {
  const std::string good = npy_file(short_fields(), short_row(), 1);
  const auto dictionary = [](const std::string& text, const std::string& data = short_row()) {
    return npy_with(text, data);
  };
  const auto typed = [](const std::string& type) {
    return npy_file(short_fields().substr(0, short_fields().size() - 1) + "('x', " + type + ")]", short_row(), 1);
  };
  const auto shaped = [](const std::string& shape, const std::string& data = short_row()) {
    return npy_with(npy_dictionary(short_fields(), shape), data);
  };
  const std::string array = npy_with(npy_dictionary("'<f8'", "(2,)"), short_row().substr(0, 16));
  const std::string three = npy_with(npy_dictionary("'<f8'", "(3,)"), short_row().substr(0, 24));
  std::vector<Malformed> files{
      {good.substr(0, 6), "FILE: found no .npy array, expected one"},
      {good.substr(0, 9), "FILE: found no .npy array, expected one"},
      {good.substr(0, 40), "FILE: found a header that is cut off"},
      {good.substr(0, good.size() - 1), "FILE: found 111 bytes of data, expected 1 items of 112 bytes"},
      {good + "x", "FILE: found 113 bytes of data, expected 1 items of 112 bytes"},
      {std::string("\x93NUMPY\x02\x00\xff\xff\xff\xff{'descr'", 20), "FILE: found a header that is cut off"},
      {dictionary(""), "FILE: found a header that is no dictionary, at its byte 1"},
      {dictionary("{"), "FILE: found a header that is no dictionary"},
      {dictionary("{'descr': '<f8"), "FILE: found a header that is no dictionary"},
      {dictionary("import os"), "FILE: found a header that is no dictionary"},
      {dictionary(std::string(5000, '(')), "FILE: found a header that is no dictionary"},
      {dictionary("{'descr': '<f8'} x"), "FILE: found a header that is no dictionary"},
      {dictionary("{'fortran_order': False, 'shape': (1,)}"), "FILE: found no 'descr' in the header of an array"},
      {dictionary("{'descr': '<f8', 'shape': (1,)}"), "FILE: found no 'fortran_order' in the header"},
      {dictionary("{'descr': '<f8', 'fortran_order': False}"), "FILE: found no 'shape' in the header"},
      {dictionary("{'descr': '<f8', 'fortran_order': 1, 'shape': (1,)}"), "FILE: found the fortran_order '1'"},
      {dictionary("{'descr': 8, 'fortran_order': False, 'shape': (1,)}"),
       "FILE: found the type '8', expected one like"},
      {dictionary("{'descr': [('a',)], 'fortran_order': False, 'shape': (1,)}"), "FILE: found the field '(a)'"},
      {dictionary("{'descr': ['<f8'], 'fortran_order': False, 'shape': (1,)}"), "FILE: found the field '<f8'"},
      {shaped("(-1,)"), "FILE: found the size '-1' in the shape, expected a whole number from 0 on"},
      {shaped("(1.5,)"), "FILE: found the size '1.5' in the shape"},
      {shaped("1"), "FILE: found the shape '1', expected a tuple"},
      {shaped("(1099511627776,)"), "FILE: found 112 bytes of data, expected 1099511627776 items of 112 bytes"},
      {shaped("(18446744073709551615,)"), "FILE: found 112 bytes of data, expected"},
      {shaped("(99999999999999999999,)"), "FILE: found the shape '(99999999999999999999)', which is too large"},
      {shaped("(4294967296, 4294967296, 2)"),
       "FILE: found the shape '(4294967296, 4294967296, 2)', which is too large"},
      {shaped("(1, 1)"), "FILE: found 1 x 1 items, expected one dimension"},
      {typed("'|O'"), "FILE: x: found Python objects ('|O'), which only Python could read by running them"},
      {typed("'<q8'"), "FILE: found 112 bytes of data, expected 1 items of 120 bytes"},
      {typed("''"), "FILE: x: found the type ''"},
      {typed("'<f'"), "FILE: x: found the type '<f'"},
      {typed("[('y', '<f8')]"), "FILE: x: found a type with fields of its own"},
      {typed("'<f8', (1099511627776, 1099511627776)"), "FILE: x: found a shape that is too large"},
      {typed("'|S99999999999999999999'"), "FILE: x: found the type"},
      {npy_file(short_fields("<c16"), short_row() + short_row(), 1),
       "FILE: the column 'R': found the type '<c16', expected numbers"},
      {npy_file(short_fields("<f2"), short_row().substr(0, 28), 1),
       "FILE: the column 'R': found the type '<f2', expected numbers"},
      {npy_file(short_fields("<M8[s]"), short_row(), 1),
       "FILE: the column 'R': found the type '<M8[s]', expected numbers"},
      {npy_file(short_fields("|S8"), short_row(), 1), "FILE: the column 'R': found the type '|S8', expected numbers"},
      {npy_file("[('a', '<f8'), ('index', '<i8')]", short_row().substr(0, 16), 1),
       "FILE: found the column 'index', expected a parameter or a part of the answer"},
      {npy_file("[('a', '<f8'), ('a', '<f8')]", short_row().substr(0, 16), 1),
       "FILE: found the column 'a' twice, expected it once"},
      {npy_file("[('a', '<f8'), ('mode', '<f8')]", short_row().substr(0, 16), 1),
       "FILE: the column 'mode': found the type '<f8', expected texts of fixed length (S or U) or integers"},
      {npy_file("[('a', '<f8')]", short_row().substr(0, 8), 1), "FILE: missing M (or M2 and M3), R, h (or h0), "},
      {npy_file("[]", "", 1), "FILE: found no column"},
      {npy_with(npy_dictionary("'<f8'", "()"), short_row().substr(0, 8)), "FILE: found an array of a single item"},
      {npy_with(npy_dictionary("'<f8'", "(1, 1, 1)"), short_row().substr(0, 8)), "FILE: found an array of 1 x 1 x 1"},
      {npz_of({{"a", array}}).substr(0, 100), "FILE: found no directory: the archive is cut off"},
      {zip({}), "FILE: found an empty archive, expected an array for each column"},
      {zip({{"notes.txt", "x"}}), "FILE: found 'notes.txt' in the archive, expected arrays (.npy)"},
      {npz_of({{"a", array}, {"S2", three}}), "FILE: S2: found 3 items, expected 2 as in a, or one for all"},
      {npz_of({{"a", array.substr(0, array.size() - 1)}}), "FILE: a: found"},
      {npz_of({{"a", "x"}}), "FILE: a: found no .npy array, expected one"},
      {zip({{"a.npy", array, array.size(), 14}}), "FILE: a.npy: found the method 14, expected 0 or 8"},
      {zip({{"a.npy", array, std::size_t{1} << 31U, 8}}), "FILE: a.npy: found a size that its data cannot have"},
      {zip({{"a.npy", array, array.size(), 8}}), "FILE: a.npy: found data that are damaged"},
      {npz_of({{"a", array}, {"a", array}}), "FILE: found the column 'a' twice, expected it once"},
      {"\x89HDF\r\n\x1a\n" + std::string(500, 'x'), "FILE: found no whole HDF5 file"},
  };
  check_refusals(files, "t", table_refusal);
  CHECK(files.size() > 50);
}

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
