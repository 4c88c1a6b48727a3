// Records of mechanisms: right answers are certified, spoiled ones never.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "base/number/binary64.hpp"
#include "base/number/dice.hpp"
#include "base/number/format.hpp"
#include "mechanics/kernel/motions.hpp"
#include "mechanics/points/sampling.hpp"
#include "mechanics/reading/shipped.hpp"
#include "records/record/record.hpp"
#include "support/certified.hpp"
#include "support/how_many.hpp"
#include "support/unit_systems.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

using MechanismCells = std::vector<std::string>;

std::size_t mechanism_records() {
  return test::how_many<std::size_t>("SLIPPROOF_CERTIFY_RECORDS", test::quick(600, 180)) / 15 + 1;
}

std::string cell_of(double x) {
  return fmt::format("{}", x);
}

std::string line_of(const MechanismCells& cells) {
  return fmt::format("{}\n", fmt::join(cells, ","));
}

/// The header of a record with everything, and the place of the claimed mode and of the first answer.
struct MechanismTable {
  explicit MechanismTable(const Mechanism& mechanism) {
    for (const auto& parameter : mechanism.parameters) names.push_back(parameter.symbol);
    for (const auto& angle : mechanism.angles) names.push_back(angle.name + ".tan_half");
    if (mechanism.load) names.push_back(mechanism.load->symbol);
    mode = names.size();
    names.push_back("mode");
    for (const auto& name : acceleration_names(mechanism)) names.push_back(name);
    for (const auto& name : force_names(mechanism)) names.push_back(name);
  }
  MechanismCells names;
  std::size_t mode = 0;
};

/// Right answers at random points, whatever the number of motions: forces that are undetermined in the middle of their
/// ranges, one after the other.
class MechanismAnswersMaker {
 public:
  MechanismAnswersMaker(const Mechanism& mechanism, std::uint64_t seed)
      : mechanism_(mechanism),
        maker_(mechanism),
        dice_(seed, 1),
        samples_(sample_values(mechanism, maker_, 64, seed)) {}

  /// Nothing where there is no motion, or a continuum; `motions` is how many there are.
  std::optional<MechanismCells> next(std::size_t& motions) {
    const MechanismValues& sample = samples_[at_++ % samples_.size()];
    MechanismValues values = default_values(mechanism_);
    MechanismCells cells;
    for (std::size_t i = 0; i < sample.parameters.size(); ++i) {
      const double x = nearest_binary64(sample.parameters[i]) * (1 + dice_.number(0, 1000) * 1e-5);
      cells.push_back(cell_of(x));
      values.parameters[i] = to_rational(x);
    }
    for (std::size_t i = 0; i < sample.angles.size(); ++i) {
      const auto& on = sample.angles[i];
      const double t = on.cosine == -1 ? 3 : nearest_binary64(Rational(on.sine / (1 + on.cosine)));
      cells.push_back(cell_of(t));
      const Rational exact = to_rational(t), square = exact * exact;
      values.angles[i] = {(1 - square) / (1 + square), 2 * exact / (1 + square)};
    }
    std::optional<Rational> load;
    if (mechanism_.load) {
      const double x = dice_.number(-20000, 20000) * 1.0001e-3;
      cells.push_back(cell_of(x));
      load = to_rational(x);
      if (!maker_.load_domain(values).contains(*load)) return std::nullopt;
    }
    if (!maker_.broken(values).empty()) return std::nullopt;
    return with_answer(std::move(cells), maker_.problem(values), load, motions);
  }

  Dice& dice() { return dice_; }

 private:
  std::optional<MechanismCells> with_answer(MechanismCells cells, const FrictionProblem& problem,
                                            const std::optional<Rational>& load, std::size_t& motions) {
    const MotionsAtLoad found = motions_of(problem, load);
    motions = found.motions.size();
    if (motions == 0 || !found.continua.empty() || !found.motions.front().strict()) return std::nullopt;
    const MotionAtLoad& motion = found.motions.front();
    const ConsistentMode mode = mode_of(problem, motion.modes.front(), load).consistent.front();
    cells.push_back(name(mode.mode));
    for (const Rational& x : motion.accelerations) cells.push_back(cell_of(nearest_binary64(x)));
    Polyhedron left = mode.solutions;
    for (const AffineForm& force : problem.forces) {
      const Range range = ranges(left, {force}).front();
      Rational value = range.lower   ? Rational(*range.lower + 1)
                       : range.upper ? Rational(*range.upper - 1)
                                     : Rational(0);
      if (range.lower && range.upper) value = (*range.lower + *range.upper) / 2;
      const double rounded = nearest_binary64(value);
      if (!range.is_point()) {
        AffineForm taken = force;
        taken.constant -= to_rational(rounded);
        left = restrict_to_zeros(left, {taken}).value();
      }
      cells.push_back(cell_of(rounded));
    }
    return cells;
  }

  const Mechanism& mechanism_;
  ProblemMaker maker_;
  Dice dice_;
  std::vector<MechanismValues> samples_;
  std::size_t at_ = 0;
};

CertifyOptions options_for(const Mechanism& mechanism) {
  CertifyOptions options;
  options.mechanism.emplace(mechanism);
  return options;
}

/// Spoils one cell so that no judge may certify the record; false where there is nothing to spoil.
bool spoil(MechanismCells& cells, const MechanismTable& table, const Mechanism& mechanism, Dice& dice) {
  std::vector<std::size_t> not_zero;
  for (std::size_t i = table.mode + 1; i < cells.size(); ++i) {
    if (std::strtod(cells[i].c_str(), nullptr) != 0) not_zero.push_back(i);
  }
  const int kind = dice.number(0, 4);
  if (kind == 0) {
    const auto kinds = element_kinds(mechanism);
    std::string other;
    for (const ElementKind& element : kinds) {
      const auto known = states(element);
      other += (other.empty() ? "" : "/") +
               std::string(name(known[static_cast<std::size_t>(dice.number(0, static_cast<int>(known.size()) - 1))]));
    }
    if (other == cells[table.mode] || kinds.size() != 2) return false;
    // Boundary modes of the same motion are no mistake: only modes that lift what touches, or the other way round.
    const auto lifts = [](const std::string& mode) { return mode.find("lift") != std::string::npos; };
    if (lifts(other) == lifts(cells[table.mode])) return false;
    cells[table.mode] = other;
    return true;
  }
  if (not_zero.empty()) return false;
  std::string& cell = cells[not_zero[static_cast<std::size_t>(dice.number(0, static_cast<int>(not_zero.size()) - 1))]];
  const double x = std::strtod(cell.c_str(), nullptr);
  if (kind == 1) cell = cell_of(-x);
  if (kind == 2) {
    // Beyond the tolerance also of an undetermined force, which is held against the applied ones.
    double largest = 1;
    for (const std::size_t i : not_zero) largest = std::max(largest, std::fabs(std::strtod(cells[i].c_str(), nullptr)));
    cell = cell_of(x + largest * std::pow(10.0, -dice.number(1, 6)));
  }
  if (kind == 3) cell = dice.chance(2) ? "nan" : "-inf";
  if (kind == 4) cell = cell_of(x * 3);
  return true;
}

}  // namespace

TEST_CASE("right outputs of all shipped mechanisms are certified where the motion is the only one") {
  for (const ShippedMechanism& shipped : shipped_mechanisms()) {
    CAPTURE(shipped.name);
    const Mechanism mechanism = open_mechanism(std::string(shipped.name));
    const MechanismTable table(mechanism);
    MechanismAnswersMaker answers(mechanism, 7);
    std::string text = line_of(table.names);
    std::vector<std::size_t> motions;
    for (std::size_t tries = 0; motions.size() < mechanism_records() && tries < 20 * mechanism_records(); ++tries) {
      std::size_t several = 0;
      const auto cells = answers.next(several);
      if (!cells) continue;
      motions.push_back(several);
      text += line_of(*cells);
    }
    CHECK(motions.size() > 10);
    const auto found = certified(text, options_for(mechanism));
    const auto lines = found.lines();
    REQUIRE(lines.size() == motions.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      CAPTURE(lines[i].dump());
      CHECK(lines[i]["verdict"] == (motions[i] == 1 ? "certified" : "ambiguous"));
      CHECK(lines[i]["motions"] == motions[i]);
    }
    CHECK(found.summary.tiers[0] * 4 > motions.size());  // inertias of 0 among them
  }
}

TEST_CASE("spoiled outputs of mechanisms are never certified") {
  for (const ShippedMechanism& shipped : shipped_mechanisms()) {
    CAPTURE(shipped.name);
    const Mechanism mechanism = open_mechanism(std::string(shipped.name));
    const MechanismTable table(mechanism);
    MechanismAnswersMaker answers(mechanism, 8);
    std::string text = line_of(table.names);
    std::size_t made = 0;
    for (std::size_t tries = 0; made < mechanism_records() && tries < 20 * mechanism_records(); ++tries) {
      std::size_t several = 0;
      auto cells = answers.next(several);
      if (!cells || !spoil(*cells, table, mechanism, answers.dice())) continue;
      text += line_of(*cells);
      ++made;
    }
    const auto found = certified(text, options_for(mechanism));
    CHECK(found.summary.records == made);
    CAPTURE(found.text);
    CHECK(found.summary.count(RecordVerdict::certified) == 0);
    CHECK(found.summary.count(RecordVerdict::ambiguous) == 0);
  }
}

namespace {

/// The units of a record's cells; nothing of what has none, and of friction elements.
std::vector<std::optional<std::string>> units_of(const Mechanism& mechanism) {
  std::vector<std::optional<std::string>> units;
  for (const auto& parameter : mechanism.parameters) units.emplace_back(parameter.unit);
  units.resize(units.size() + mechanism.angles.size());
  if (mechanism.load) units.emplace_back(mechanism.load->unit);
  units.emplace_back();
  for (std::size_t i = 0; i < mechanism.accelerations; ++i) units.emplace_back(mechanism.unknowns[i].unit);
  for (const auto& contact : mechanism.contacts) units.resize(units.size() + (contact.slip ? 2 : 1), "m/s^2");
  units.resize(units.size() + mechanism.friction.size());
  for (std::size_t i = mechanism.accelerations; i < mechanism.unknowns.size(); ++i) {
    const MechanismUnknown& force = mechanism.unknowns[i];
    units.emplace_back(force.unit.empty() ? "N" : force.unit);
    if (force.unit.empty() && force.role == MechanismUnknown::Role::friction) units.back().reset();
  }
  return units;
}

/// Without answers whose units the file leaves open.
MechanismCells in_units(const MechanismCells& cells, std::size_t first_answer,
                        const std::vector<std::optional<std::string>>& units, const UnitSystem& system) {
  MechanismCells result = cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double x = std::strtod(cells[i].c_str(), nullptr);
    if (units[i] && std::isfinite(x)) result[i] = exact_text(Rational(to_rational(x) * system.factor(*units[i])));
    if (!units[i] && i >= first_answer) result[i].clear();
  }
  return result;
}

}  // namespace

TEST_CASE("no verdict on outputs of a mechanism depends on units") {
  std::size_t differences = 0;
  const std::size_t wanted = std::min<std::size_t>(mechanism_records() / 4, 700);  // about 10^4 of all mechanisms
  for (const ShippedMechanism& shipped : shipped_mechanisms()) {
    CAPTURE(shipped.name);
    const Mechanism mechanism = open_mechanism(std::string(shipped.name));
    const MechanismTable table(mechanism);
    const auto units = units_of(mechanism);
    REQUIRE(units.size() == table.names.size());
    MechanismAnswersMaker answers(mechanism, 11);
    std::vector<MechanismCells> records;
    for (std::size_t tries = 0; records.size() < wanted && tries < 20 * wanted; ++tries) {
      std::size_t several = 0;
      auto cells = answers.next(several);
      if (!cells) continue;
      // One component is wrong by little or much, zeros too.
      const auto at = static_cast<std::size_t>(
          answers.dice().number(static_cast<int>(table.mode) + 1, static_cast<int>(cells->size()) - 1));
      const double x = std::strtod((*cells)[at].c_str(), nullptr);
      const double error = std::pow(10.0, -answers.dice().number(0, 16));
      if (units[at]) (*cells)[at] = cell_of(x == 0 || answers.dice().chance(2) ? x + 10 * error : x * (1 + error));
      records.push_back(*cells);
    }
    std::vector<std::string> expected;
    for (const UnitSystem& system : unit_systems()) {
      std::string text = line_of(table.names);
      for (const MechanismCells& cells : records) text += line_of(in_units(cells, table.mode + 1, units, system));
      std::vector<std::string> found;
      for (const auto& line : certified(text, options_for(mechanism)).lines()) {
        found.push_back(line["verdict"].get<std::string>() + " " + line["modes"].dump());
      }
      if (expected.empty()) expected = found;
      REQUIRE(found.size() == expected.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i] == expected[i]) continue;
        ++differences;
        MESSAGE(system.name, ": ", found[i], " for ", expected[i], "\n", line_of(table.names), line_of(records[i]));
      }
    }
  }
  CHECK(differences == 0);
}

TEST_CASE("JSON Lines of a mechanism give what CSV gives, at any number of threads") {
  const Mechanism mechanism = open_mechanism("block-on-incline");
  const MechanismTable table(mechanism);
  MechanismAnswersMaker answers(mechanism, 9);
  std::string csv = line_of(table.names), json;
  for (int i = 0; i < 300; ++i) {
    std::size_t several = 0;
    auto cells = answers.next(several);
    if (!cells) continue;
    if (i % 10 == 3) spoil(*cells, table, mechanism, answers.dice());
    csv += line_of(*cells);
    std::string object;
    for (std::size_t k = 0; k < cells->size(); ++k) {
      object += fmt::format("{}\"{}\":\"{}\"", k == 0 ? "" : ",", table.names[k], (*cells)[k]);
    }
    json += "{" + object + "}\n";
  }
  CertifyOptions options = options_for(mechanism);
  options.threads = 1;
  const std::string one = certified(csv, options).text;
  options.threads = 2;
  CHECK(certified(csv, options).text == one);
  options.format = RecordFormat::json_lines;
  std::string from_json = certified(json, options).text;
  const auto strip = [](std::string text) {  // places in lines differ
    std::string result;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      auto parsed = nlohmann::json::parse(line);
      if (parsed["verdict"] == "invalid") parsed.erase("reason");
      result += parsed.dump() + '\n';
    }
    return result;
  };
  CHECK(strip(from_json) == strip(one));
}
