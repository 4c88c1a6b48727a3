#include "verify/identity.hpp"

#include <array>

#include "model/reduction.hpp"
#include "verify/polynomials.hpp"

namespace slipproof {

namespace {

using Symbols = Evaluator<Fraction, FractionField>;

/// The force and the parameters stand side by side.
Symbols symbols_of(const CompiledSetting& setting) {
  return symbolic(setting.scope(), CompiledSetting::force_slot(), 1 + setting.domains().size());
}

struct SymbolicScene {
  Bicycle<MultiPolynomial> bicycle;
  Road<MultiPolynomial> road;
  MultiPolynomial force;
};

/// Nothing if the scene is not polynomial in the parameters.
std::optional<SymbolicScene> scene_of(const CompiledSetting& setting, Symbols& symbols) {
  SymbolicScene scene;
  Bicycle<MultiPolynomial>& p = scene.bicycle;
  p.J = MultiPolynomial(0);
  const std::array<MultiPolynomial*, 15> targets{&p.M,  &p.R,  &p.h,          &p.b2,         &p.b3,
                                                 &p.I1, &p.I2, &p.I3,         &p.r1,         &p.r2,
                                                 &p.L,  &*p.J, &scene.road.f, &scene.road.g, &scene.force};
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (!setting.scene()[i]) {
      p.J.reset();
      continue;
    }
    auto value = symbols.number(*setting.scene()[i]).number;
    if (!value || !value->denominator.is_monic_constant()) return std::nullopt;
    *targets[i] = std::move(value->numerator);
  }
  return scene;
}

/// The unknowns of the model by the quantities of a motion; the sprocket and the chain follow from its equations.
void set_unknowns(const CompiledSetting& setting, const SymbolicScene& scene, Symbols& symbols) {
  const Bicycle<MultiPolynomial>& p = scene.bicycle;
  const auto value = [&](Quantity q) {
    const auto number = symbols.at(CompiledSetting::quantity_slot(q)).number;
    return number ? *number : Fraction();
  };
  const Fraction phi = value(Quantity::phi);
  const Fraction eps1 = Fraction(p.r2, p.r1) * (value(Quantity::eps2) - phi) + phi;
  const Fraction T = (Fraction(p.I1) * eps1 - Fraction(p.L * scene.force)) / Fraction(p.r1);
  for (std::size_t i = 0; i < unknown_count; ++i) {
    const auto quantity = parse_quantity(unknown_names[i]);
    symbols.set(setting.unknown_slot(i), quantity ? value(*quantity) : unknown_names[i] == "T" ? T : eps1);
  }
}

}  // namespace

bool is_identity(const ClaimsFile& file, const CompiledClaims& compiled, std::size_t claim, Reading reading) {
  const Claim& c = file.claims[claim];
  const ClaimBody& body = c.body(reading);
  const bool equations = c.kind == ClaimKind::consequence && body.given.empty() && body.claims.empty() &&
                         body.assume.empty() && !body.modes.empty();
  if (c.kind != ClaimKind::formula && !equations) return false;
  const CompiledSetting& setting = compiled.settings[c.setting];
  const Program& holds = compiled.claims[claim].body(reading).holds;
  const auto& modes = body.modes;
  if (modes.empty()) {
    Symbols symbols = symbols_of(setting);
    return symbols.truth(holds) == Truth::yes;
  }
  for (const ContactMode mode : modes) {
    Symbols symbols = symbols_of(setting);
    const auto scene = scene_of(setting, symbols);
    if (!scene || (!mode.on_road() && !scene->bicycle.J)) return false;
    const auto dynamics = reduce<MultiPolynomial, MultiPolynomial>(
        scene->bicycle, scene->road, file.settings[c.setting].force_kind, scene->force, MultiPolynomial(1));
    const ReducedMotion<MultiPolynomial, MultiPolynomial> motion(dynamics, mode);
    for (const Quantity q : all_quantities()) {
      auto value = motion.quantity(q);
      if (value.denominator.is_zero()) {  // singular for all parameters: the quantity has no value
        if (equations) return false;
        continue;
      }
      symbols.set(CompiledSetting::quantity_slot(q),
                  Fraction(std::move(value.numerator), std::move(value.denominator)));
    }
    if (equations) {
      set_unknowns(setting, *scene, symbols);
      for (const Program& equation : compiled.claims[claim].body(reading).equations) {
        if (symbols.truth(equation) != Truth::yes) return false;
      }
    } else if (symbols.truth(holds) != Truth::yes) {
      return false;
    }
  }
  return true;
}

}  // namespace slipproof
