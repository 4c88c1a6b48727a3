#include "base/input/toml.hpp"
#include "base/number/format.hpp"
#include "mechanics/bicycle/scene.hpp"

namespace slipproof {

std::string to_toml(const Scene& scene) {
  std::string text = "name = " + toml_string(scene.name) + "\n";
  const auto line = [&text](std::string_view key, const Rational& value) {
    text += std::string(key) + " = \"" + exact_text(value) + "\"\n";
  };
  const Bicycle<Rational>& bicycle = scene.bicycle;
  text += "[bicycle]\n";
  line("R", bicycle.R);
  line("h", bicycle.h);
  line("b2", bicycle.b2);
  line("b3", bicycle.b3);
  line("I1", bicycle.I1);
  line("I2", bicycle.I2);
  line("I3", bicycle.I3);
  line("r1", bicycle.r1);
  line("r2", bicycle.r2);
  line("L", bicycle.L);
  line("M", bicycle.M);
  if (bicycle.J) line("J", *bicycle.J);
  text += "[road]\n";
  line("f", scene.road.f);
  line("g", scene.road.g);
  text += "[force]\n";
  text += scene.force_kind == ForceKind::internal ? "kind = \"internal\"\n" : "kind = \"external\"\n";
  if (scene.F) line("F", *scene.F);
  return text;
}

}  // namespace slipproof
