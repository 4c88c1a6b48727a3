#include "mechanics/lines/scene_line.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace slipproof {

namespace {

Family family_of(const FreedScene& freed, const std::optional<Rational>& own, SceneLine::Load load) {
  Family family = freed.family();
  if (load == SceneLine::Load::every || !family.mechanism->load) return family;
  const std::string& symbol = family.mechanism->load->symbol;
  if (!own) throw std::invalid_argument("the scene has no value of " + symbol + ", expected one");
  family.scene[symbol] = make_number(*own);
  return family;
}

}  // namespace

SceneLine::SceneLine(const MechanismScene& scene, const std::string& parameter, Load load, std::size_t max_modes,
                     std::string_view takes_too_long)
    : scene_(scene, find_parameter(scene, parameter), FreedScene::Tied::stay),
      load_(load),
      family_(family_of(scene_, scene.load, load)) {
  if (mode_count(family_.kinds()) > static_cast<double>(max_modes)) {
    throw std::invalid_argument(
        fmt::format("found more than {} contact modes, expected fewer: {} takes too long", max_modes, takes_too_long));
  }
  modes_ = modes_of(family_.kinds());
}

LinePoints SceneLine::points(const Rational& inside, const std::set<IntegerPolynomial>& beside) const {
  Question question;
  question.modes = modes_;
  question.modes_meet = load_ == Load::every;
  return points_on(line(inside), family_, question, beside);
}

}  // namespace slipproof
