#include "mechanics/lines/scene_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "mechanics/family/free.hpp"

namespace slipproof {

namespace {

Family freed(const MechanismScene& scene, const std::string& parameter, SceneLine::Load load) {
  Family family = with_free(scene, parameter);
  if (load == SceneLine::Load::every || !scene.mechanism.load) return family;
  const std::string& symbol = scene.mechanism.load->symbol;
  if (!scene.load) throw std::invalid_argument("the scene has no value of " + symbol + ", expected one");
  family.scene[symbol] = make_number(*scene.load);
  return family;
}

}  // namespace

SceneLine::SceneLine(const MechanismScene& scene, const std::string& parameter, Load load, std::size_t max_modes,
                     std::string_view takes_too_long)
    : scene_(scene), load_(load), family_(freed(scene, parameter, load)) {
  if (mode_count(family_.kinds()) > static_cast<double>(max_modes)) {
    throw std::invalid_argument(
        fmt::format("found more than {} contact modes, expected fewer: {} takes too long", max_modes, takes_too_long));
  }
  modes_ = modes_of(family_.kinds());
  const auto& all = scene.mechanism.parameters;
  index_ = static_cast<std::size_t>(std::ranges::find(all, parameter, &MechanismParameter::symbol) - all.begin());
}

MechanismValues SceneLine::values(const Rational& x) const {
  MechanismValues changed = scene_.values;
  changed.parameters[index_] = x;
  return changed;
}

LinePoints SceneLine::points(const Rational& inside, const std::set<IntegerPolynomial>& beside) const {
  Question question;
  question.modes = modes_;
  question.modes_meet = load_ == Load::every;
  return points_on({{Rational(0)}, {Rational(1)}, inside}, family_, question, beside);
}

}  // namespace slipproof
