// A scene with one parameter free, followed in all of its modes.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mechanics/family/compiled_family.hpp"
#include "mechanics/family/freed_scene.hpp"
#include "mechanics/lines/critical.hpp"

namespace slipproof {

class SceneLine {
 public:
  enum class Load : std::uint8_t {
    every,  ///< the ends of all intervals of loads count, and where those of two modes meet
    own     ///< the load is the scene's, which must have one if the mechanism does
  };
  /// Throws std::invalid_argument, with a message for people, if the scene has no such parameter or load, or more than
  /// `max_modes` modes; what then `takes_too_long` ends the message.
  SceneLine(const MechanismScene& scene, const std::string& parameter, Load load, std::size_t max_modes,
            std::string_view takes_too_long);

  const CompiledFamily& family() const { return family_; }
  const std::vector<MechanismMode>& modes() const { return modes_; }
  const FreedScene& scene() const { return scene_; }
  /// The scene's value of the parameter.
  const Rational& own() const { return scene_.free().own; }
  /// Its t is the parameter's value.
  Line line(const Rational& inside) const { return {{Rational(0)}, {Rational(1)}, inside}; }
  /// Where the motions change, seen from a value in the domain; the zeros of `beside` count, too.
  LinePoints points(const Rational& inside, const std::set<IntegerPolynomial>& beside = {}) const;

 private:
  const FreedScene scene_;
  const Load load_;
  const CompiledFamily family_;
  std::vector<MechanismMode> modes_;
};

}  // namespace slipproof
