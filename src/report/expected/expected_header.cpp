#include <fmt/format.h>

#include <cmath>

#include "report/expected/expected.hpp"
#include "report/expected/numbers.hpp"

namespace slipproof {

namespace expected {

namespace {

constexpr const char* header =
    R"text(// The motions that an engine should find, written by `slipproof expect --format c++`.
#pragma once

#include <cstddef>
#include <limits>

namespace slipproof_expected {

/// A number, exactly and as the nearest double. An infinite one has no exact text.
struct Number {
  double nearest;
  const char* exact;
};
/// A quantity lies between two numbers, which are equal unless nothing determines it.
struct Quantity {
  const char* name;
  Number lower, upper;
};
struct Motion {
  const char* modes;
  bool strict, continuum;
  const Quantity* accelerations;
  std::size_t acceleration_count;
  const Quantity* forces;
  std::size_t force_count;
};
/// Where the motions change along a parameter.
struct Threshold {
  const char* parameter;
  Number at;
};
struct Scene {
  const char *name, *question;
  const Motion* motions;  ///< none: the scene has no motion
  std::size_t motion_count;
  const Threshold* thresholds;
  std::size_t threshold_count;
};

namespace data {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

)text";

/// A string literal; bytes beyond ASCII stay as they are.
std::string quoted(const std::string& text) {
  std::string literal = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      literal += std::string("\\") + c;
    } else if ((c >= 0 && c < ' ') || c == '\x7f') {
      literal += fmt::format("\\{:03o}", static_cast<int>(c));
    } else {
      literal += c;
    }
  }
  return literal + '"';
}

std::string number(double nearest, const std::string& exact) {
  if (std::isinf(nearest)) return nearest > 0 ? "{infinity, \"\"}" : "{-infinity, \"\"}";
  return fmt::format("{{{}, {}}}", nearest, quoted(exact));
}

/// An array of these rows: its definition goes to `text`; returns the pointer to it with its length.
std::string array(std::string& text, const std::string& type, const std::string& id,
                  const std::vector<std::string>& rows) {
  if (rows.empty()) return "nullptr, 0";
  text += fmt::format("inline constexpr {} {}[] = {{\n", type, id);
  for (const std::string& row : rows) text += "    {" + row + "},\n";
  text += "};\n";
  return fmt::format("{}, {}", id, rows.size());
}

std::vector<std::string> quantities(const std::vector<std::string>& names, const std::vector<Range>& ranges) {
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < names.size(); ++i) {
    rows.push_back(fmt::format("{}, {}, {}", quoted(names[i]),
                               number(binary64(ranges[i].lower, -1), exact(ranges[i].lower)),
                               number(binary64(ranges[i].upper, 1), exact(ranges[i].upper))));
  }
  return rows;
}

std::string scene_row(std::string& text, const ExpectedAnswer& answer, std::size_t index) {
  const MechanismScene& scene = answer.solved.scene;
  const auto accelerations = acceleration_names(scene.mechanism), forces = force_names(scene.mechanism);
  std::vector<std::string> motions, thresholds;
  for (const ToldMotion& motion : told_motions(answer)) {
    const std::string id = fmt::format("of_scene_{}_motion_{}", index + 1, motions.size() + 1);
    const std::string a =
        array(text, "Quantity", "accelerations_" + id, quantities(accelerations, motion.accelerations));
    const std::string f = array(text, "Quantity", "forces_" + id, quantities(forces, motion.forces));
    motions.push_back(fmt::format("{}, {}, {}, {}, {}", quoted(motion.modes), motion.strict, motion.continuum, a, f));
  }
  for (const MotionChange& change : answer.changes) {
    const ToldRoot root = told_root(change.at, scene.threshold->parameter);
    thresholds.push_back(fmt::format("{}, {}", quoted(scene.threshold->parameter), number(root.nearest, root.text)));
  }
  const std::string m = array(text, "Motion", fmt::format("motions_{}", index + 1), motions);
  const std::string t = array(text, "Threshold", fmt::format("thresholds_{}", index + 1), thresholds);
  return fmt::format("{}, {}, {}, {}", quoted(answer.id), quoted(scene.question), m, t);
}

}  // namespace

}  // namespace expected

std::string expected_header(const std::vector<ExpectedAnswer>& answers) {
  std::string text = expected::header;
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < answers.size(); ++i) rows.push_back(expected::scene_row(text, answers[i], i));
  expected::array(text, "Scene", "scenes", rows);
  return text + "\n}  // namespace data\n\nusing data::scenes;\n\n}  // namespace slipproof_expected\n";
}

}  // namespace slipproof
