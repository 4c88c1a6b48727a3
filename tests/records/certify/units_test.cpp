// No verdict depends on units, nor on the way in: CSV, JSON Lines, columns, the library, --mechanism bicycle.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/number/format.hpp"
#include "base/number/parse.hpp"
#include "mechanics/scene/bicycle_scene.hpp"
#include "records/certify/columns.hpp"
#include "records/record/bicycle_records.hpp"
#include "support/certified.hpp"
#include "support/how_many.hpp"
#include "support/scenes/solver_records.hpp"
#include "support/unit_systems.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

constexpr std::size_t friction_cell = 11, eps1_cell = 26;  ///< eps1 after those of solver_records.hpp

std::size_t answers_wanted() {
  return std::min<std::size_t>(10'000, test::how_many<std::size_t>("SLIPPROOF_CERTIFY_RECORDS", test::quick(100, 50)));
}

const std::vector<std::string>& units_of_columns() {
  static const std::vector<std::string> units{
      "kg",     "m", "m", "m",     "m",     "kg m^2", "kg m^2", "kg m^2", "m", "m", "m", "1", "m/s^2", "N",
      "kg m^2", "",  "",  "m/s^2", "m/s^2", "s^-2",   "s^-2",   "s^-2",   "N", "N", "N", "N", "s^-2"};
  return units;
}

double number_in(const std::string& cell) {
  return std::strtod(cell.c_str(), nullptr);
}

/// The sprocket's angular acceleration, which the mechanism asks for, from those of the frame and the rear wheel.
/// Nothing if these are rounded too much for it: it may be small, and they far larger, where the gear ratio is large.
std::optional<std::string> eps1_of(const Cells& cells) {
  const auto exact = [&](std::size_t i) { return to_rational(number_in(cells[i])); };
  const Rational ratio = exact(9) / exact(8), of_wheel = ratio * exact(20), of_frame = (1 - ratio) * exact(19);
  const Rational eps1 = of_wheel + of_frame;
  if (Rational(abs(eps1)) * 1000 < Rational(abs(of_wheel)) + Rational(abs(of_frame))) return std::nullopt;
  return exact_text(eps1);
}

/// As many cells as there are names.
std::string csv(const Cells& names, const std::vector<Cells>& records) {
  std::string text = joined(names);
  for (const Cells& cells : records) {
    text += joined({cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(names.size())});
  }
  return text;
}

/// With so much friction that more contacts stick and there may be several motions. Nothing if the answer is none of
/// them: eps1 is then as far from theirs as the gear ratio says, and only the mechanism is asked for it.
std::optional<Cells> with_high_friction(Cells cells) {
  cells[friction_cell] = "4";
  const auto found = certified(csv(record_columns, {cells}));
  if (found.lines().front()["verdict"] != "certified") return std::nullopt;
  return cells;
}

/// Right answers, and such as are wrong by little or much in one component, zeros too.
std::vector<Cells> answers(std::size_t count) {
  SolverRecords records(36);
  RandomBicycles& random = records.random();
  std::vector<Cells> result;
  while (result.size() < count) {
    Cells cells = records.next();
    const std::optional<std::string> eps1 = eps1_of(cells);
    if (!eps1) continue;
    cells.push_back(*eps1);
    if (result.size() % 11 == 5) cells = with_high_friction(cells).value_or(cells);
    const std::size_t at = answer_cell + result.size() % (eps1_cell - answer_cell);
    const double x = std::strtod(cells[at].c_str(), nullptr), draw = std::fabs(random.signed_log(1, 1e7));
    const double error = 1e-14 * draw * draw;
    const int kind = static_cast<int>(result.size() % 4);
    if (kind != 0) cells[at] = fmt::format("{}", x == 0 || kind == 3 ? x + 100 * error : x * (1 + error));
    if (result.size() % 7 == 3) cells[mode_cell].clear();
    result.push_back(std::move(cells));
  }
  return result;
}

Cells in_units(const Cells& cells, const UnitSystem& system) {
  Cells result = cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (units_of_columns()[i].empty() || cells[i].empty()) continue;
    const Rational exact = parse_rational(i == eps1_cell ? cells[i] : exact_text(to_rational(number_in(cells[i])))) *
                           system.factor(units_of_columns()[i]);
    const double nearest = nearest_binary64(exact);
    result[i] = to_rational(nearest) == exact ? fmt::format("{}", nearest) : exact_text(exact);
  }
  return result;
}

/// Of each record, as text.
std::vector<std::string> verdicts(const Certified& found, const char* members) {
  std::vector<std::string> result;
  for (const auto& line : found.lines()) {
    result.push_back(line["verdict"].get<std::string>() + " " + line[members].dump());
  }
  return result;
}

std::string as_json_lines(const Cells& names, const std::vector<Cells>& records) {
  std::string text;
  for (const Cells& cells : records) {
    nlohmann::ordered_json line;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!cells[i].empty()) line[names[i]] = cells[i];
    }
    text += line.dump() + '\n';
  }
  return text;
}

/// As --mechanism bicycle takes them.
std::vector<Cells> of_mechanism(std::vector<Cells> records) {
  for (Cells& cells : records) cells[kind_cell] = cells[kind_cell] == "external" ? "1" : "0";
  return records;
}

struct Difference {
  std::size_t count = 0;
  std::string first;

  void take(const std::vector<std::string>& found, const std::vector<std::string>& expected, const std::string& way,
            const std::vector<Cells>& records) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i] == expected[i]) continue;
      if (++count == 1) first = way + ": " + found[i] + " for " + expected[i] + "\n" + header() + joined(records[i]);
    }
  }
};

/// As the library takes single answers.
std::vector<std::string> by_library(const std::vector<Cells>& records) {
  const RecordJudge judge(bicycle_records(), {});
  const RecordFields& fields = judge.fields();
  std::vector<std::string> result;
  for (const Cells& cells : records) {
    Record record;
    record.clear(fields.size());
    for (std::size_t k = 0; k < record_columns.size(); ++k) {
      if (const auto field = fields.find(record_columns[k]); field && !cells[k].empty()) {
        record.set(*field, number_in(cells[k]));
      }
    }
    record.set(fields.word_field(), cells[kind_cell] == "external" ? 1 : 0);
    record.mode = fields.find_mode(cells[mode_cell]).value_or(no_mode);
    result.emplace_back(name(judge(record).verdict));
  }
  return result;
}

/// As .npy files, Python and C take many; those with J, then those without.
std::vector<std::string> by_columns(const std::vector<Cells>& records) {
  const RecordJudge judge(bicycle_records(), {});
  const RecordFields& fields = judge.fields();
  std::vector<std::string> result(records.size());
  for (const bool with_J : {true, false}) {
    std::vector<std::size_t> own;
    for (std::size_t i = 0; i < records.size(); ++i) {
      if (records[i][14].empty() != with_J) own.push_back(i);
    }
    std::vector<std::vector<double>> numbers(fields.size());
    std::vector<std::uint16_t> modes;
    RecordColumns columns(fields, own.size());
    for (std::size_t k = 0; k < record_columns.size(); ++k) {
      const auto field = fields.find(record_columns[k]);
      if (!field || (record_columns[k] == "J" && !with_J)) continue;
      for (const std::size_t i : own) numbers[*field].push_back(number_in(records[i][k]));
      columns.numbers[*field] = std::span<const double>(numbers[*field]);
    }
    std::vector<double>& kinds = numbers[fields.word_field()];
    for (const std::size_t i : own) {
      modes.push_back(fields.find_mode(records[i][mode_cell]).value_or(no_mode));
      kinds.push_back(records[i][kind_cell] == "external" ? 1 : 0);
    }
    columns.numbers[fields.word_field()] = std::span<const double>(kinds);
    columns.modes = std::span<const std::uint16_t>(modes);
    const JudgedColumns judged = certify(columns, judge);
    for (std::size_t i = 0; i < own.size(); ++i) result[own[i]] = std::string(name(judged.verdicts[i]));
  }
  return result;
}

std::vector<std::string> first_words(std::vector<std::string> texts) {
  for (std::string& text : texts) text = text.substr(0, text.find(' '));
  return texts;
}

}  // namespace

TEST_CASE("no verdict on the bicycle's outputs depends on units or on the way in") {
  const std::vector<Cells> records = answers(answers_wanted());
  CertifyOptions mechanism;
  mechanism.mechanism.emplace(bicycle_mechanism());
  Cells mechanism_names = record_columns;
  mechanism_names[kind_cell] = "external";
  mechanism_names.emplace_back("eps1");
  const auto as_mechanism = [&](const std::string& text) {
    return first_words(verdicts(certified(text, mechanism), "modes"));
  };
  const std::vector<std::string> expected = verdicts(certified(csv(record_columns, records)), "modes");
  const std::vector<std::string> expected_verdicts = first_words(expected);
  std::map<std::string, std::size_t> kinds;
  for (const std::string& verdict : expected_verdicts) ++kinds[verdict];
  for (const char* kind : {"certified", "inaccurate", "wrong"}) CHECK(kinds[kind] > 5);

  Difference difference;
  for (const UnitSystem& system : unit_systems()) {
    std::vector<Cells> own;
    for (const Cells& cells : records) own.push_back(in_units(cells, system));
    const std::string name = system.name;
    difference.take(verdicts(certified(csv(record_columns, own)), "modes"), expected, "CSV, " + name, own);
    difference.take(verdicts(certified(as_json_lines(record_columns, own)), "modes"), expected, "JSON, " + name, own);
    const std::vector<Cells> theirs = of_mechanism(own);
    difference.take(as_mechanism(csv(mechanism_names, theirs)), expected_verdicts, "mechanism CSV, " + name, own);
    difference.take(as_mechanism(as_json_lines(mechanism_names, theirs)), expected_verdicts, "mechanism JSON, " + name,
                    own);
    if (name == "m kg s" || name == "powers of two") {
      difference.take(by_library(own), expected_verdicts, "library, " + name, own);
      difference.take(by_columns(own), expected_verdicts, "columns, " + name, own);
    }
  }
  INFO(difference.first);
  CHECK(difference.count == 0);
}
