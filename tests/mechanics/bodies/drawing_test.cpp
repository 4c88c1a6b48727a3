// What a drawing shows at a glance is warned of; and of single mistakes at random in drawings, how many are noticed.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <regex>
#include <string>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "base/input/text_file.hpp"
#include "mechanics/checks/checks.hpp"
#include "mechanics/kernel/motions.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/scene/scene.hpp"
#include "support/replaced.hpp"

using namespace slipproof;

namespace drawing_test {

namespace {

const std::filesystem::path drawn_cases = SLIPPROOF_SOURCE_DIR "/cases/mechanisms";

/// Two boxes, one on the other, and a wheel on a pin of the lower one.
const std::string good = R"(schema = "slipproof/mechanism/1"
name = "two boxes and a wheel"
gravity = ["0", "-10"]
[parameters]
mu = { domain = "mu > 0" }
b = { domain = "b > 1 and b < 3" }
[[body]]
name = "lower"
mass = "1"
inertia = "1"
at = ["0", "1"]
shape = { box = ["2*b", "2"] }
[[body]]
name = "upper"
mass = "1"
inertia = "1"
at = ["0", "3"]
shape = { box = ["2", "2"] }
[[body]]
name = "wheel"
mass = "1"
inertia = "1"
at = ["b", "1"]
[[joint]]
name = "axle"
kind = "pin"
between = ["lower", "wheel"]
at = ["b", "0"]
[[contact]]
name = "left"
of = "lower"
point = ["-b", "-1"]
normal = ["0", "1"]
friction = "mu"
[[contact]]
name = "tyre"
of = "wheel"
point = ["0", "0"]
radius = "1"
normal = ["0", "1"]
friction = "mu"
[[contact]]
name = "one"
of = "upper"
on = "lower"
point = ["-1", "-1"]
normal = ["0", "1"]
friction = "mu"
[[contact]]
name = "two"
of = "upper"
on = "lower"
point = ["1", "-1"]
normal = ["0", "1"]
friction = "mu"
[[force]]
on = "upper"
at = ["1", "0"]
is = ["1", "0"]
)";

using test::replaced;

/// What is warned of, one a line.
std::string warnings(const std::string& text) {
  const Mechanism mechanism = parse_mechanism(text, "drawn.toml");
  std::string all;
  for (const MechanismFinding& finding : check_mechanism(mechanism)) {
    if (finding.checkable) all += to_string(mechanism, finding) + "\n";
  }
  return all;
}

/// A vector in the text, with its section: a mistake in it may be a sign or a swapped axis.
struct WrittenVector {
  std::size_t begin, length;
  std::string x, y, key;
};

std::vector<WrittenVector> vectors(const std::string& text) {
  static const std::regex pair("\\[ *\"([^\"]*)\" *, *\"([^\"]*)\" *\\]"), table("\\[+([a-z]+)"), key("([a-z_]+) *=.*");
  std::vector<WrittenVector> result;
  std::string section;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    std::smatch found;
    if (std::regex_search(line, found, table, std::regex_constants::match_continuous)) section = found[1];
    if (std::regex_match(line, found, key)) {
      const std::string name = section + "." + found[1].str();
      for (std::sregex_iterator it(line.begin(), line.end(), pair); it != std::sregex_iterator(); ++it) {
        result.push_back({begin + static_cast<std::size_t>(it->position()), static_cast<std::size_t>(it->length()),
                          (*it)[1], (*it)[2], name});
      }
    }
    begin = end + 1;
  }
  return result;
}

std::optional<std::string> negative(const std::string& x) {
  if (x == "0") return std::nullopt;
  return "-(" + x + ")";
}

std::vector<std::string> mistakes_in(const std::string& text, const WrittenVector& v) {
  std::vector<std::string> result;
  const auto add = [&](const std::optional<std::string>& x, const std::optional<std::string>& y) {
    if (!x || !y) return;
    std::string changed = text;
    result.push_back(changed.replace(v.begin, v.length, "[\"" + *x + "\", \"" + *y + "\"]"));
  };
  add(negative(v.x), v.y);
  add(v.x, negative(v.y));
  if (v.x != v.y) add(v.y, v.x);
  return result;
}

/// The motions of a scene with another mechanism, which has the same names.
std::optional<MotionsAtLoad> motions(const MechanismScene& scene, const Mechanism& mechanism) {
  MechanismScene other = scene;
  other.values.starts = starts(mechanism);
  if (!ProblemMaker(mechanism).broken(other.values).empty()) return std::nullopt;
  try {
    const FrictionProblem problem = friction_problem(mechanism, other.values);
    return motions_of(problem, problem.has_load ? std::optional(Rational(7, 3)) : std::nullopt);
  } catch (const NoValue&) {
    return std::nullopt;
  }
}

bool same(const std::optional<MotionsAtLoad>& a, const std::optional<MotionsAtLoad>& b) {
  if (!a || !b || a->motions.size() != b->motions.size() || a->continua.size() != b->continua.size()) return false;
  for (std::size_t i = 0; i < a->motions.size(); ++i) {
    if (a->motions[i].accelerations != b->motions[i].accelerations) return false;
    if (a->motions[i].all_modes() != b->motions[i].all_modes()) return false;
  }
  return true;
}

struct Count {
  int noticed = 0, all = 0;
};

/// What pushes is what a person says: nothing else in a drawing tells its sign.
bool pushes(const std::string& key) {
  return key == "force.is" || key == "force.at" || key == "body.acceleration" || key == ".gravity";
}

void try_mistakes(const std::filesystem::path& file, const MechanismScene& scene,
                  std::map<std::string, Count>& counts) {
  const std::string text = read_text_file(file);
  const auto before = motions(scene, scene.mechanism);
  for (const WrittenVector& v : vectors(text)) {
    for (const std::string& mistaken : mistakes_in(text, v)) {
      bool noticed = true;
      try {
        const Mechanism mechanism = parse_mechanism(mistaken, "mistaken.toml");
        noticed = std::ranges::any_of(check_mechanism(mechanism), &MechanismFinding::checkable);
        if (!noticed && same(before, motions(scene, mechanism))) continue;  // no mistake: by symmetry, or a picture
      } catch (const InputError&) {
      }
      Count& count = counts[v.key];
      ++count.all;
      if (noticed) ++count.noticed;
    }
  }
}

}  // namespace

TEST_CASE("a good drawing has no warning, and each mistake has its own") {
  CHECK(warnings(good) == "");
  const auto warned = [&](const std::string& from, const std::string& to, const std::string& of) {
    const std::string said = warnings(replaced(good, from, to));
    CAPTURE(said);
    CHECK(said.find(of) != std::string::npos);
  };
  warned("point = [\"1\", \"-1\"]", "point = [\"-1\", \"-1\"]", "the contacts one and two are at one place");
  warned("point = [\"-b\", \"-1\"]\nnormal = [\"0\", \"1\"]", "point = [\"-b\", \"-1\"]\nnormal = [\"0\", \"-1\"]",
         "left: the normal points away from the centre of lower");
  warned("point = [\"1\", \"-1\"]\nnormal = [\"0\", \"1\"]", "point = [\"1\", \"-1\"]\nnormal = [\"-1\", \"0\"]",
         "two: the line that is touched cuts through lower");
  warned("at = [\"b\", \"0\"]", "at = [\"-b\", \"0\"]", "joint axle: it is outside of wheel");
  warned("at = [\"1\", \"0\"]", "at = [\"4\", \"0\"]", "the force acts outside of upper");
  warned("gravity = [\"0\", \"-10\"]", "gravity = [\"-10\", \"0\"]", "gravity presses nothing on the surface");
  warned("gravity = [\"0\", \"-10\"]", "gravity = [\"0\", \"10\"]", "gravity points up");
  warned("point = [\"1\", \"-1\"]", "point = [\"4\", \"-1\"]", "two: it is beyond the end of the face of lower");
  warned("at = [\"0\", \"3\"]", "at = [\"0\", \"2\"]", "the shapes of lower and upper lie in each other");
  warned("inertia = \"1\"\nat = [\"0\", \"3\"]", "inertia = \"3\"\nat = [\"0\", \"3\"]",
         "body upper: found a moment of inertia that is more than if all of its mass were where its shape ends");
  warned("point = [\"1\", \"-1\"]", "point = [\"4\", \"-1\"]", "two: it is outside of the shape of upper");
  warned("box = [\"2\", \"2\"] }", "box = [\"2\", \"2\"], at = [\"0\", \"2\"] }",
         "body upper: its centre of mass is outside of its shape");
  warned("at = [\"b\", \"1\"]", "at = [\"b\", \"1\"]\nshape = { circle = \"1/2\" }",
         "tyre: found another radius than that of the shape of wheel");
}

TEST_CASE("most single mistakes in drawings are noticed") {
  std::map<std::string, Count> counts;
  for (const auto& [drawings, scenes] : {std::pair(drawn_cases / "asked", drawn_cases / "asked/scenes"),
                                         std::pair(drawn_cases / "bodies", drawn_cases / "scenes")}) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(drawings)) {
      if (entry.path().extension() == ".toml" && std::filesystem::exists(scenes / entry.path().filename())) {
        files.push_back(entry.path());
      }
    }
    std::ranges::sort(files);
    for (const auto& file : files) {
      MechanismScene scene = read_scene(scenes / file.filename());
      const MechanismValues values = scene.values;
      scene.mechanism = read_mechanism(file);
      if (scene.values.parameters.size() != scene.mechanism.parameters.size()) continue;
      try_mistakes(file, scene, counts);
    }
  }
  Count drawn, pushed;
  for (const auto& [key, count] : counts) {
    MESSAGE(key << ": " << count.noticed << " of " << count.all);
    Count& sum = pushes(key) ? pushed : drawn;
    sum.noticed += count.noticed, sum.all += count.all;
  }
  MESSAGE("what is drawn: " << drawn.noticed << " of " << drawn.all << "; what pushes: " << pushed.noticed << " of "
                            << pushed.all);
  CHECK(drawn.all >= 600);
  CHECK(20 * drawn.noticed >= 19 * drawn.all);
}

}  // namespace drawing_test
