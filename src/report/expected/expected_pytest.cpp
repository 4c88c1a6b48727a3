#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/input/diagnostic.hpp"
#include "base/number/binary64.hpp"
#include "base/output/json.hpp"
#include "contact/exchange/export_bodies.hpp"
#include "mechanics/kernel/motion.hpp"
#include "report/expected/expected.hpp"
#include "report/picture/space/space_words.hpp"

namespace slipproof {

namespace expected {

namespace {

constexpr const char* before =
    R"py("""The motions that an engine should find, written by `slipproof expect --format pytest`.

Fill in accelerations(), then run pytest on this file.
"""

import pytest

TOLERANCE = 1e-6  # over the size of a scene: the largest of gravity and of the accelerations that are expected


def accelerations(scene):
    """What the engine answers from the state of a scene, which is a dict of the schema slipproof/bodies/1.

    Returns the accelerations by the names of the scene's unknowns, such as {"ax": 0.5, "ay": 0.0, "alpha": 0.0}, or
    None if the engine says that there is no motion.
    """
    pytest.skip("accelerations(scene) is not written yet")


)py";

constexpr const char* after = R"py(

def distance(answer, motion):
    """By how much an answer is outside of a motion; a range is what nothing determines."""
    return max(max(lower - answer[name], answer[name] - upper, 0.0) for name, (lower, upper) in motion.items())


@pytest.mark.parametrize("name", SCENES)
def test_motion(name):
    scene = SCENES[name]
    answer = accelerations(scene["bodies"])
    told = scene["question"] or name
    if not scene["motions"]:
        assert answer is None, f"{told}: there is no motion, the engine says {answer}"
        return
    assert answer is not None, f"{told}: the engine says that there is no motion, expected {scene['motions']}"
    off = {modes: distance(answer, motion) / scene["size"] for modes, motion in scene["motions"].items()}
    nearest = min(off, key=off.get)
    assert off[nearest] <= TOLERANCE, (
        f"{told}: found {answer}, which is off by {off[nearest]:.3g} of the size of the scene, "
        f"expected {nearest}: {scene['motions'][nearest]}"
    )
)py";

/// A motion or a continuum, with a range for each acceleration.
struct ToldMotion {
  std::string modes;  ///< joined by ` = `, strict ones first; those of a continuum say so
  std::vector<Range> accelerations;
};

std::vector<ToldMotion> told_motions(const ExpectedAnswer& answer) {
  std::vector<ToldMotion> result;
  for (const MotionAtLoad& motion : answer.solved.at_load->motions) {
    ToldMotion told{equal_modes(motion.all_modes()), {}};
    for (const Rational& value : motion.accelerations) told.accelerations.push_back({value, value});
    result.push_back(std::move(told));
  }
  for (const ContinuumAtLoad& continuum : answer.solved.at_load->continua) {
    result.push_back({"continuum " + name(continuum.mode), continuum.accelerations});
  }
  return result;
}

/// Throws InputError where an engine may be right without being near one of these.
std::vector<ToldMotion> told_motions(const ExpectedInSpace& answer) {
  const SolvedSpace& solved = answer.solved;
  const auto refuse = [&](const std::string& found) {
    throw InputError({{solved.scene.mechanism.file, 0, 0,
                       answer.id + ": found " + found +
                           ", expected for pytest that all are known, each alone; "
                           "--format json has what is known"}});
  };
  if (!solved.complete()) refuse("that other motions may be left");
  std::vector<ToldMotion> result;
  std::map<std::string, std::size_t> same_mode;
  for (const SpaceMotion& motion : solved.motions) {
    if (!motion.exists) refuse("a motion that is not proved to exist");
    if (!motion.unique && motion.others_within != Rational(0)) refuse("a motion beside which others may be");
    const std::string mode = mode_of(motion);
    const std::size_t count = ++same_mode[mode];
    result.push_back({count == 1 ? mode : mode + " (" + std::to_string(count) + ")", motion.accelerations});
  }
  return result;
}

/// The nearest binary64 to a value; an end that is absent is infinite with this sign.
double binary64(const std::optional<Rational>& value, int sign) {
  return value ? nearest_binary64(*value) + 0.0 : sign * std::numeric_limits<double>::infinity();
}

/// A JSON value as Python writes it.
std::string python(const Json& value, std::size_t indent = 0) {
  const std::string inner(indent + 4, ' '), outer(indent, ' ');
  if (value.is_null()) return "None";
  if (value.is_boolean()) return value.get<bool>() ? "True" : "False";
  if (value.is_number_float() && std::isinf(value.get<double>())) return value.get<double>() > 0 ? "INF" : "-INF";
  const bool flat = std::ranges::none_of(value, [](const Json& item) { return item.is_structured() && !item.empty(); });
  if (value.is_array()) {
    std::string text = "[";
    for (const Json& item : value) text += (text.size() > 1 ? ", " : "") + python(item, indent);
    return text + "]";
  }
  if (!value.is_object()) return json_text(value);
  std::string text = "{";
  for (const auto& [key, item] : value.items()) {
    if (text.size() > 1) text += flat ? ", " : ",";
    if (!flat) text += "\n" + inner;
    text += json_text(Json(key)) + ": " + python(item, indent + 4);
  }
  return text + (flat ? "}" : ",\n" + outer + "}");
}

double size_of(const Json& bodies, const std::vector<ToldMotion>& motions, std::size_t unknowns) {
  double square = 0;
  for (const Json& component : bodies["gravity"]) square += component.get<double>() * component.get<double>();
  double size = std::sqrt(square);
  for (const ToldMotion& motion : motions) {
    for (std::size_t i = 0; i < unknowns; ++i) {
      for (const double end :
           {binary64(motion.accelerations[i].lower, 1), binary64(motion.accelerations[i].upper, 1)}) {
        if (std::isfinite(end)) size = std::max(size, std::abs(end));
      }
    }
  }
  return size > 0 ? size : 1;
}

template <class Answer>
Json test_json(const Answer& answer) {
  const MechanismScene& scene = answer.solved.scene;
  const Mechanism& m = scene.mechanism;
  const auto told = told_motions(answer);
  Json motions = Json::object();
  for (const ToldMotion& motion : told) {
    Json& entry = motions[motion.modes] = Json::object();
    for (std::size_t i = 0; i < m.accelerations; ++i) {
      entry[m.unknowns[i].symbol] = {binary64(motion.accelerations[i].lower, -1),
                                     binary64(motion.accelerations[i].upper, 1)};
    }
  }
  const Json bodies = Json::parse(bodies_json(scene));
  return {{"question", scene.question.empty() ? Json(nullptr) : Json(scene.question)},
          {"size", size_of(bodies, told, m.accelerations)},
          {"motions", std::move(motions)},
          {"bodies", bodies}};
}

Json test_json(const ExpectedImpact& impact) {
  throw InputError({{impact.scene().mechanism.file, 0, 0,
                     impact.id + ": found an impact, whose outcomes depend on the law, expected for pytest a scene "
                                 "without one; --format json has them by each law"}});
}

}  // namespace

}  // namespace expected

std::string expected_pytest(const std::vector<Expected>& answers) {
  Json scenes = Json::object();
  for (const Expected& answer : answers) {
    std::visit([&](const auto& one) { scenes[one.id] = expected::test_json(one); }, answer);
  }
  return std::string(expected::before) + "INF = float(\"inf\")\n\nSCENES = " + expected::python(scenes) + "\n" +
         expected::after;
}

}  // namespace slipproof
