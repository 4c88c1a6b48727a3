#include "mechanics/lines/line.hpp"

#include <random>

#include "mechanics/lines/question.hpp"

namespace slipproof {

std::vector<Rational> Line::at(const Rational& t) const {
  std::vector<Rational> values = origin;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!direction[k].is_zero()) values[k] += t * direction[k];
  }
  return values;
}

Line along_parameter(const std::vector<Rational>& values, std::size_t parameter) {
  Line line{values, std::vector<Rational>(values.size()), values[parameter]};
  line.origin[parameter] = 0;
  line.direction[parameter] = 1;
  return line;
}

Line through(const std::vector<Rational>& first, const std::vector<Rational>& second) {
  Line line{first, second, Rational(0)};
  for (std::size_t k = 0; k < first.size(); ++k) line.direction[k] -= first[k];
  return line;
}

Line scaling(const std::vector<Rational>& values, const std::vector<bool>& chosen) {
  Line line{values, std::vector<Rational>(values.size()), Rational(1)};
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (chosen[k]) std::swap(line.origin[k], line.direction[k]);
  }
  return line;
}

std::vector<bool> parameters_of(const CompiledFamily& family, const std::vector<const Program*>& programs,
                                Beside beside) {
  std::vector<const Program*> all = programs;
  if (beside == Beside::the_scene) {
    for (const Program* program : family.scene().programs()) all.push_back(program);
  }
  std::vector<bool> result(family.domains().size());
  for (const std::size_t slot : slots_behind(family.scope(), all)) {
    for (std::size_t k = 0; k < result.size(); ++k) {
      if (CompiledFamily::parameter_slot(k) == slot) result[k] = true;
    }
  }
  return result;
}

Line line_number(std::uint64_t k, std::uint64_t seed, const std::vector<std::vector<Rational>>& bases,
                 const std::vector<bool>& matters) {
  std::vector<std::size_t> parameters;
  for (std::size_t p = 0; p < matters.size(); ++p) {
    if (matters[p]) parameters.push_back(p);
  }
  std::mt19937_64 engine(seed * 0x9E3779B97F4A7C15U + k * 0xD1B54A32D192ED03U + 7);
  const auto die = [&](std::size_t sides) { return static_cast<std::size_t>(engine() % sides); };
  const std::uint64_t turn = k / 2;
  const std::size_t base = static_cast<std::size_t>(k) % bases.size();
  // Every second line varies one parameter. Most formulas have degree 1 or 2 in each parameter, so such a line crosses
  // their zeros at rational values and hits surfaces. The other lines change all parameters that matter at once.
  if (k % 2 == 0) return along_parameter(bases[base], parameters[turn % parameters.size()]);
  if (turn % 4 == 3 || bases.size() == 1) {
    std::vector<bool> chosen(matters.size());
    chosen[parameters[die(parameters.size())]] = true;
    for (const std::size_t p : parameters) chosen[p] = chosen[p] || die(2) == 0;
    return scaling(bases[base], chosen);
  }
  const std::size_t other = (base + 1 + die(bases.size() - 1)) % bases.size();
  Line line = through(bases[base], bases[other]);
  for (std::size_t p = 0; p < matters.size(); ++p) {
    if (!matters[p]) line.direction[p] = 0;
  }
  return line;
}

}  // namespace slipproof
