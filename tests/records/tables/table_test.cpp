// Records in NumPy's arrays are judged as the same records in CSV; what is malformed is told.
#include <nlohmann/json.hpp>

#include "records/tables/same_records.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

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

}  // namespace

TEST_CASE("the same records give the same bytes from CSV and arrays, at any number of threads") {
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
}

TEST_CASE("an array of two dimensions takes its names from outside, in either order") {
  const SameRecords records(60);
  const Folder folder;
  std::vector<std::string> names;
  std::string rows, columns, csv;
  for (const std::size_t k :
       {0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 10U, 11U, 12U, 13U, 14U, 17U, 18U, 19U, 20U, 21U, 22U, 23U, 24U, 25U}) {
    names.push_back(record_columns[k]);
    csv += (csv.empty() ? "" : ",") + record_columns[k];
    for (std::size_t i = 0; i < records.size(); ++i) columns += npy_number(records.number(i, k), ">f4");
  }
  csv += '\n';
  for (std::size_t i = 0; i < records.size(); ++i) {
    for (std::size_t k = 0; k < names.size(); ++k) {
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

TEST_CASE("no records are none") {
  const Folder folder;
  CHECK(certified_table(folder.write("n.npy", npy_file(short_fields(), "", 0))).summary.records == 0);
}

TEST_CASE("archives and tables of HDF5 are refused with the way to an array") {
  const Folder folder;
  const std::string path = folder.write("a.npz", "PK\x03\x04 and more");
  CHECK_FALSE(is_table_file(path));
  CertifyOptions options;
  options.file = path;
  const std::string said = refusal(
      [&] {
        certify(
            open_bytes(path), [](std::string_view) {}, options);
      },
      path);
  CHECK(said.starts_with("FILE: found an archive of NumPy (.npz), expected CSV, JSON Lines or one structured array"));
  CHECK(said.find("numpy.save(") != std::string::npos);
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
      {npy_file("[('mode', '|S536870912')]", short_row(), 1), "FILE: found 112 bytes of data, expected"},
  };
  check_refusals(files, "t", table_refusal);
  CHECK(files.size() > 40);
}
