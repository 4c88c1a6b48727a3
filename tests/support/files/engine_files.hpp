// A small folder of engines: two scenes and an impact, and the answers that a test gives.
#pragma once

#include <filesystem>
#include <string>

#include "support/files/small_files.hpp"

namespace slipproof::test {

/// `one-motion/pulled`: a point of weight 10 that is pulled along a floor with 6, mu = 1/2, so that ax = 1, ay = 0.
/// `none/rod`: Painleve's rod, which slides and has no motion, with ax, ay, phi.
class EngineFiles {
 public:
  EngineFiles() {
    for (const char* folder : {"scenes", "scenes/one-motion", "scenes/none", "answers", "mechanisms"}) {
      std::filesystem::create_directory(folder_.path(folder));
    }
    folder_.write("mechanisms/point.toml", R"(
schema = "slipproof/mechanism/1"
name = "point on a floor"
gravity = ["0", "-10"]
[parameters]
mu = "mu >= 0"
[load]
symbol = "F"
[[body]]
name = "point"
mass = "1"
turning = "0"
at = ["0", "0"]
shape = { circle = "1" }
[[contact]]
name = "floor"
of = "point"
point = ["0", "0"]
normal = ["0", "1"]
through = ["0", "0"]
friction = "mu"
[[force]]
on = "point"
is = ["F", "0"]
)");
    folder_.write("scenes/one-motion/pulled.toml", R"(
name = "a point that is pulled"
mechanism = "../../mechanisms/point.toml"
[values]
mu = "1/2"
F = "6"
)");
    folder_.write("scenes/none/rod.toml", R"(
name = "a rod that slides and jams"
mechanism = "painleve-rod"
[values]
m = "1"
l = "1"
I = "1/3"
mu = "2"
w = "0"
g = "10"
theta = { cos = "3/5", sin = "4/5" }
)");
  }

  /// `impact/bar`: a bar with m = 1 and I = 1/3 that comes with vy = -1 and omega = 3 to one of two stops, which it
  /// leaves at the other, e = 1/2: 2 J. After it vy and omega are 4/3 and -2/3 by Newton's law, 1/2 and -3/2 by
  /// Moreau's.
  void impact() const {
    std::filesystem::create_directory(folder_.path("scenes/impact"));
    folder_.write("scenes/impact/bar.toml", R"(
schema = "slipproof/mechanism/1"
name = "a bar on two stops"
gravity = "none"
restitution = "1/2"
[impact]
law = "moreau"
[[body]]
name = "bar"
mass = "1"
inertia = "1/3"
at = ["0", "0"]
velocity = ["0", "-1"]
spin = "3"
shape = { line = [["-1", "0"], ["2", "0"]] }
[[contact]]
name = "left"
of = "bar"
point = ["-1", "0"]
normal = ["0", "1"]
through = ["-1", "0"]
[[contact]]
name = "right"
of = "bar"
point = ["2", "0"]
normal = ["0", "1"]
through = ["2", "0"]
)");
  }

  std::filesystem::path folder() const { return folder_.path(""); }
  void line(const std::string& text) const { folder_.write("answers/e.jsonl", text + '\n'); }
  /// What engines.toml says of them.
  void design(const std::string& text) const { folder_.write("engines.toml", text); }
  /// An engine's answer to a scene: "motion":{...}, "refused":... or another member.
  void answer(const std::string& scene, const std::string& member) const {
    line(
        R"({"schema":"slipproof/engine-answer/1","engine":"e","version":"1","asked":"default","law":"cone","scene":")" +
        scene + "\"," + member + "}");
  }

 private:
  Folder folder_;
};

}  // namespace slipproof::test
