#include "report/expected/numbers.hpp"

#include <limits>

namespace slipproof::expected {

std::vector<ToldMotion> told_motions(const ExpectedAnswer& answer) {
  std::vector<ToldMotion> result;
  for (const MotionAtLoad& motion : answer.solved.at_load->motions) {
    ToldMotion told{equal_modes(motion.all_modes()), motion.strict(), false, {}, motion.forces};
    for (const Rational& value : motion.accelerations) told.accelerations.push_back({value, value});
    result.push_back(std::move(told));
  }
  for (const ContinuumAtLoad& continuum : answer.solved.at_load->continua) {
    result.push_back({name(continuum.mode), continuum.strict, true, continuum.accelerations, continuum.forces});
  }
  return result;
}

double binary64(const std::optional<Rational>& value, int sign) {
  return value ? nearest_binary64(*value) + 0.0 : sign * std::numeric_limits<double>::infinity();
}

std::string exact(const std::optional<Rational>& value) {
  return value ? exact_text(*value) : std::string();
}

ToldRoot told_root(const RealRoot& root, const std::string& symbol) {
  ToldRoot told{root, 0, {}};
  told.nearest = nearest_binary64(told.place);
  if (root.is_rational()) {
    told.text = exact_text(root.lower);
  } else {
    told.text = "root of " + text_of(*root.polynomial, symbol) + " in (" + exact_text(told.place.lower) + ", " +
                exact_text(told.place.upper) + ")";
  }
  return told;
}

}  // namespace slipproof::expected
