// Correct answers are certified, corrupted ones never; streams of any size and at any number of threads give the same.
#include <doctest/doctest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/certified.hpp"
#include "support/how_many.hpp"
#include "support/scenes/solver_records.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

std::size_t record_count() {
  return test::how_many<std::size_t>("SLIPPROOF_CERTIFY_RECORDS", 4000);
}

double number(const std::string& cell) {
  return std::strtod(cell.c_str(), nullptr);
}

/// Spoils one field so that no correct judge may certify it.
void corrupt(Cells& c, std::size_t kind, RandomBicycles& random) {
  // A component that is not zero: S2, S3, N2, N3, a.
  std::vector<std::size_t> candidates;
  for (const std::size_t i : {0U, 5U, 6U, 7U, 8U}) {
    if (number(c[answer_cell + i]) != 0) candidates.push_back(answer_cell + i);
  }
  if (candidates.empty()) return;
  std::string& cell = c[candidates[random.next() % candidates.size()]];
  switch (kind % 5) {
    case 0: {
      std::string mode = c[mode_cell];
      while (mode == c[mode_cell]) mode = name(all_modes()[random.next() % 16]);
      c[mode_cell] = mode;
      break;
    }
    case 1:
      cell = fmt::format("{}", number(cell) * (1 + (random.coin() ? 1 : -1) * random.log_uniform(2e-9, 1)));
      break;
    case 2:
      std::swap(c[answer_cell + 5], c[answer_cell + 6]);
      std::swap(c[answer_cell + 7], c[answer_cell + 8]);
      break;
    case 3:
      cell = random.coin() ? "nan" : "-inf";
      break;
    default:
      cell = fmt::format("{}", -number(cell));
  }
}

}  // namespace

TEST_CASE("correct outputs are all certified") {
  SolverRecords records(91);
  std::string text = header();
  const std::size_t n = record_count();
  for (std::size_t i = 0; i < n; ++i) text += joined(records.next());
  const auto [lines, summary] = certified(text);
  CHECK(summary.records == n);
  CHECK(summary.count(RecordVerdict::certified) == n);
  CHECK(summary.all_certified());
  CHECK(summary.tiers[0] > n * 3 / 4);
  CHECK(summary.worst_certified_error < 1e-9);
}

TEST_CASE("right outputs for bicycles as they are built are certified by binary64, wheels in the air included") {
  SolverRecords records(95, false);
  std::string text = header();
  const std::size_t n = record_count();
  std::size_t in_the_air = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Cells cells = records.next();
    if (cells[mode_cell].find("lift") != std::string::npos) ++in_the_air;
    text += joined(cells);
  }
  const auto [lines, summary] = certified(text);
  CHECK(summary.tiers[0] == n);
  CHECK(in_the_air > n / 100);
}

TEST_CASE("outputs corrupted in one field are all reported, none is certified") {
  SolverRecords records(92);
  std::string text = header();
  const std::size_t n = record_count() / 4;
  std::size_t made = 0;
  for (std::size_t i = 0; made < n; ++i) {
    Cells cells = records.next(), before = cells;
    corrupt(cells, i, records.random());
    if (cells == before) continue;  // equal wheels, swapped; nothing but zeros
    text += joined(cells);
    ++made;
  }
  const auto [lines, summary] = certified(text);
  CHECK(summary.records == n);
  CHECK(summary.count(RecordVerdict::certified) == 0);
  CHECK(summary.count(RecordVerdict::ambiguous) == 0);
  CHECK(summary.count(RecordVerdict::invalid) > 0);
  CHECK(summary.count(RecordVerdict::inaccurate) > 0);
  CHECK(summary.count(RecordVerdict::wrong) > 0);
  CHECK(std::count(lines.begin(), lines.end(), '\n') == static_cast<std::ptrdiff_t>(n));
}

TEST_CASE("the same bytes at any number of threads, in the order of the records, and from the middle on") {
  SolverRecords records(93);
  std::string text = header();
  constexpr std::uint64_t n = 3000;
  for (std::uint64_t i = 0; i < n; ++i) {
    Cells cells = records.next();
    if (i % 100 == 7) corrupt(cells, i / 100, records.random());
    text += joined(cells);
  }
  CertifyOptions options;
  options.threads = 1;
  const auto [one, summary] = certified(text, options);
  options.threads = 2;
  const auto [two, summary_two] = certified(text, options);
  CHECK(one == two);
  std::istringstream lines(one);
  std::string line;
  for (std::uint64_t i = 1; i <= n; ++i) {
    REQUIRE(std::getline(lines, line));
    CHECK(nlohmann::json::parse(line).at("record") == i);
  }
  options.first_record = 2001;
  const auto [rest, summary_rest] = certified(text, options);
  CHECK(summary_rest.records == 1000);
  CHECK(one.substr(one.find("{\"record\":2001,")) == rest);
}

/// The same answer of a scene in other units of mass: too large a number for the filter.
void make_heavy(Cells& cells) {
  for (const std::size_t k : {0U, 5U, 6U, 7U, 13U, 14U, 22U, 23U, 24U, 25U}) {
    if (!cells[k].empty()) cells[k] = fmt::format("{}", number(cells[k]) * 0x1p50);
  }
}

/// Outside the domain, though only the ratio of the radii is in the equations.
void turn_sprockets(Cells& cells) {
  for (const std::size_t k : {8U, 9U}) cells[k] = "-" + cells[k];
}

TEST_CASE("a line of CSV is judged as if it stood alone, however many others there are and however it is written") {
  SolverRecords records(96);
  std::vector<std::string> lines, with_blanks;
  for (std::size_t i = 0; i < test::quick<std::size_t>(120, 70); ++i) {
    Cells cells = records.next();
    if (i % 9 == 4) corrupt(cells, i / 9, records.random());
    if (i % 17 == 1) make_heavy(cells);
    if (i % 19 == 1) turn_sprockets(cells);
    if (i % 31 == 3) cells[i % 26].clear();
    if (i % 37 == 5) cells[mode_cell] = i % 2 == 0 ? "stick" : "";
    if (i % 41 == 6) cells[kind_cell] = "intern";
    if (i % 43 == 7) cells.pop_back();
    if (i % 47 == 8) cells.emplace_back("1");
    if (i % 53 == 9) cells[0] = "1e400";
    const auto add = [&](Cells written) {
      lines.push_back(joined(written));
      for (std::string& cell : written) cell = "\t" + cell + ' ';
      with_blanks.push_back(joined(written));
    };
    add(cells);
    if (i % 5 != 2) continue;
    add(cells);
    std::string& parameter = cells[i % 14];  // and with a number that goes on: what was right is wrong
    parameter += parameter.find('.') == std::string::npos ? ".5" : "";
    parameter.insert(parameter.find('.'), "7");
    add(cells);
    parameter += "7777";
    add(cells);
    parameter.insert(parameter.find('.') + 2, "7");
    add(cells);
  }
  std::string text = header();
  for (const std::string& line : lines) text += line;
  std::istringstream all(certified(text).text);
  std::string judged;
  std::size_t compared = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    REQUIRE(std::getline(all, judged));
    const auto as_record = [&](const std::string& line) {
      const std::string alone = certified(header() + std::string(i, '\n') + line).text;
      return "{\"record\":" + std::to_string(i + 1) + alone.substr(alone.find(','));
    };
    REQUIRE(judged + '\n' == as_record(lines[i]));
    if (judged.find(", column ") != std::string::npos) continue;  // blanks move the place
    REQUIRE(judged + '\n' == as_record(with_blanks[i]));
    ++compared;
  }
  CHECK(compared > lines.size() * 3 / 4);
}

TEST_CASE("JSON Lines give what CSV gives") {
  SolverRecords records(94);
  std::string csv = header(), json;
  for (int i = 0; i < 200; ++i) {
    Cells cells = records.next();
    if (i % 10 == 3) corrupt(cells, static_cast<std::size_t>(i) / 10 * 5 + 1, records.random());
    csv += joined(cells);
    json += '{';
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (cells[k].empty()) continue;
      const bool text = k == kind_cell || k == mode_cell || k == 4;
      json += (k == 0 ? "\"" : ",\"") + record_columns[k] + "\":" + (text ? "\"" + cells[k] + "\"" : cells[k]);
    }
    json += "}\n";
  }
  CertifyOptions options;
  const auto from_csv = certified(csv, options).text;
  options.format = RecordFormat::json_lines;
  CHECK(certified(json, options).text == from_csv);
}
