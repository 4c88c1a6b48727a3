// The shipped mechanisms, drawn as bodies, have the motions of their printed equations.
#include "mechanics/reading/shipped.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "mechanics/kernel/motions.hpp"
#include "mechanics/points/sampling.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/write_mechanism.hpp"
#include "support/how_many.hpp"

using namespace slipproof;

namespace {

const std::string drawn_folder = SLIPPROOF_SOURCE_DIR "/cases/mechanisms/bodies/";

template <class Item>
std::size_t index_of(const std::vector<Item>& items, const std::string& symbol) {
  return static_cast<std::size_t>(std::ranges::find_if(items, [&](const Item& item) { return item.symbol == symbol; }) -
                                  items.begin());
}

/// The same values by name; what only the drawing has, a velocity, is 1.
MechanismValues carried_over(const Mechanism& from, const MechanismValues& values, const Mechanism& to) {
  MechanismValues result = default_values(to);
  for (std::size_t i = 0; i < to.parameters.size(); ++i) {
    const std::size_t k = index_of(from.parameters, to.parameters[i].symbol);
    result.parameters[i] = k < from.parameters.size() ? values.parameters[k] : Rational(1);
    if (k < from.parameters.size()) result.given[i] = values.given[k];
  }
  for (std::size_t i = 0; i < to.angles.size(); ++i) {
    for (std::size_t k = 0; k < from.angles.size(); ++k) {
      if (from.angles[k].name == to.angles[i].name) result.angles[i] = values.angles[k];
    }
  }
  return result;
}

std::string text_of(const Range& range) {
  const auto end = [](const std::optional<Rational>& x) { return x ? x->str() : std::string("oo"); };
  return end(range.lower) + " " + end(range.upper);
}

/// Everything that is said of the motions, in the names of both mechanisms.
class Said {
 public:
  Said(const Mechanism& one, const Mechanism& other) {
    for (const auto& names : {acceleration_names, force_names}) {
      const auto first = names(one), second = names(other);
      for (const std::string& name : first) {
        if (std::ranges::find(second, name) != second.end()) common_.insert(name);
      }
    }
  }
  std::size_t names() const { return common_.size(); }

  std::multiset<std::string> operator()(const Mechanism& mechanism, const MechanismValues& values,
                                        const std::optional<Rational>& load) const {
    const MotionsAtLoad found = motions_of(friction_problem(mechanism, values), load);
    const auto accelerations = acceleration_names(mechanism), forces = force_names(mechanism);
    std::multiset<std::string> result;
    for (const MotionAtLoad& motion : found.motions) {
      std::map<std::string, std::string> said;
      for (std::size_t i = 0; i < accelerations.size(); ++i) {
        if (common_.contains(accelerations[i])) said[accelerations[i]] = motion.accelerations[i].str();
      }
      for (std::size_t i = 0; i < forces.size(); ++i) {
        if (common_.contains(forces[i])) said[forces[i]] = text_of(motion.forces[i]);
      }
      std::string text = equal_modes(motion.modes) + " | " + equal_modes(motion.boundary_modes);
      for (const auto& [name, value] : said) text += "; " + name + " " + value;
      result.insert(text);
    }
    for (const ContinuumAtLoad& continuum : found.continua) {
      std::string text = "continuum " + name(continuum.mode);
      for (std::size_t i = 0; i < accelerations.size(); ++i) {
        if (common_.contains(accelerations[i])) text += "; " + text_of(continuum.accelerations[i]);
      }
      result.insert(text);
    }
    return result;
  }

 private:
  std::set<std::string> common_;
};

void compare(const Mechanism& printed, const Mechanism& drawn, std::size_t wanted) {
  const Said said(printed, drawn);
  CHECK(said.names() >= printed.accelerations + 2 * printed.contacts.size());
  const ProblemMaker maker(printed), drawer(drawn);
  const auto samples = sample_values(printed, maker, wanted, 38);
  CHECK(samples.size() >= wanted / 2);
  std::size_t count = 0;
  for (const MechanismValues& values : samples) {
    const MechanismValues same_values = carried_over(printed, values, drawn);
    REQUIRE(drawer.broken(same_values).empty());
    std::optional<Rational> load;
    if (printed.load) load = Rational(static_cast<int>(count * 7 % 41) - 20, static_cast<int>(count % 3) + 1);
    REQUIRE(said(printed, values, load) == said(drawn, same_values, load));
    ++count;
  }
}

}  // namespace

TEST_CASE("shipped mechanisms drawn as bodies have the motions, forces and ranges of the printed ones") {
  const auto wanted = test::how_many<std::size_t>("SLIPPROOF_DRAWN_SCENES", 30);
  for (const ShippedMechanism& one : shipped_mechanisms()) {
    CAPTURE(one.name);
    const Mechanism printed = open_mechanism(std::string(one.name), "");
    compare(printed, read_mechanism(drawn_folder + std::string(one.name) + ".toml"), wanted);
  }
}

TEST_CASE("a mechanism written by its equations reads back with the same motions") {
  for (const ShippedMechanism& one : shipped_mechanisms()) {
    CAPTURE(one.name);
    const Mechanism drawn = read_mechanism(drawn_folder + std::string(one.name) + ".toml");
    compare(drawn, parse_mechanism(to_toml(drawn), "written.toml"), 5);
    const Mechanism printed = open_mechanism(std::string(one.name), "");
    compare(printed, parse_mechanism(to_toml(printed), "written.toml"), 5);
  }
}
