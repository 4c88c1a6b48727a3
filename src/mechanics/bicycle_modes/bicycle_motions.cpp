#include "mechanics/bicycle_modes/bicycle_motions.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "mechanics/bicycle/chain.hpp"
#include "mechanics/bicycle/conditions.hpp"
#include "mechanics/bicycle_modes/motions.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "mechanics/reading/shipped.hpp"

namespace slipproof {

namespace {

AffineForm form_of(const Affine<Rational>& value) {
  return {value.alpha, {value.beta}};
}

Chain<Affine<Rational>> chain_over_loads(const Bicycle<Rational>& bicycle, const Motion<Affine<Rational>>& motion) {
  return chain_of(bicycle, motion, Affine<Rational>(0, 1));
}

std::vector<Affine<Rational>> accelerations(const Motion<Affine<Rational>>& m, const Chain<Affine<Rational>>& chain) {
  using enum Quantity;
  return {m[a], m[a_y], m[phi], chain.eps1, m[eps2], m[eps3], m[gap2], m[slip2], m[gap3], m[slip3]};
}
std::vector<Affine<Rational>> forces(const Motion<Affine<Rational>>& m, const Chain<Affine<Rational>>& chain) {
  using enum Quantity;
  return {chain.T, m[N2], m[S2], m[N3], m[S3]};
}

std::vector<ContactMode> contact_modes(const std::optional<std::vector<MechanismMode>>& only) {
  const auto all = all_modes();
  if (!only) return {all.begin(), all.end()};
  std::vector<ContactMode> modes;
  for (const MechanismMode& mode : *only) {
    if (const auto known = contact_mode(mode)) modes.push_back(*known);
  }
  return modes;
}

class BicycleMotions final : public MotionsOverLoads {
 public:
  BicycleMotions(const Bicycle<Rational>& bicycle, const Road<Rational>& road, ForceKind kind,
                 const std::optional<std::vector<MechanismMode>>& only)
      : bicycle_(bicycle), road_(road), kind_(kind), table_(bicycle, road, kind, contact_modes(only)) {}

  std::optional<ModeOverLoads> find(const MechanismMode& mode) const override {
    const ModeSolution* s = solution(mode);
    if (s == nullptr) return std::nullopt;
    return ModeOverLoads{&s->closed(), &s->strict(), is_continuum(*s) && !s->continuum().one_motion};
  }

  std::optional<ModeForms> forms(const MechanismMode& mode) const override {
    const ModeSolution* s = solution(mode);
    if (s == nullptr || s->kind() != ModeSolution::Kind::regular) return kernel().forms(mode);
    const Motion<Affine<Rational>> motion = s->motion();
    const auto chain = chain_over_loads(bicycle_, motion);
    ModeForms result;
    for (const auto& value : accelerations(motion, chain)) result.accelerations.push_back(form_of(value));
    for (const auto& value : slipproof::forces(motion, chain)) result.forces.push_back(form_of(value));
    for (const Condition& condition : conditions(s->mode())) {
      result.conditions.push_back(form_of(s->condition_value(condition)));
    }
    return result;
  }

  std::vector<LoadCell> cells(Told told) const override {
    if (std::any_of(table_.solutions().begin(), table_.solutions().end(), is_continuum)) return kernel().cells(told);
    std::vector<LoadCell> result;
    for (Cell& cell : partition(table_)) {
      LoadCell& over = result.emplace_back(LoadCell{std::move(cell.forces), {}, {}});
      for (const FoundMotion<Affine<Rational>>& motion : cell.motions)
        over.motions.push_back(over_loads(motion, over, told));
    }
    return result;
  }

 private:
  /// With motions at some load.
  static bool is_continuum(const ModeSolution& s) {
    return s.kind() == ModeSolution::Kind::continuum && !s.closed().empty();
  }

  const ModeSolution* solution(const MechanismMode& mode) const {
    const auto known = contact_mode(mode);
    return known ? table_.find(*known) : nullptr;
  }

  MotionOverLoads over_loads(const FoundMotion<Affine<Rational>>& found, const LoadCell& cell, Told told) const {
    MotionOverLoads motion;
    const Rational inside = cell.loads.sample();
    for (const ContactMode mode : found.modes) {
      const bool strict = table_.find(mode)->strict().contains(inside);
      (strict ? motion.modes : motion.boundary_modes).push_back(mechanism_mode(mode));
    }
    if (told == Told::modes) return motion;
    const auto chain = chain_over_loads(bicycle_, found.values);
    motion.accelerations = accelerations(found.values, chain);
    for (auto& force : slipproof::forces(found.values, chain)) motion.forces.emplace_back(std::move(force));
    return motion;
  }

  const MotionsOverLoads& kernel() const {
    std::call_once(once_, [&] {
      kernel_ = motions_over_loads(friction_problem(bicycle_mechanism(), bicycle_values(bicycle_, road_, kind_)));
    });
    return *kernel_;
  }

  Bicycle<Rational> bicycle_;
  Road<Rational> road_;
  ForceKind kind_;
  ModeTable table_;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const MotionsOverLoads> kernel_;  ///< made when a continuum is asked about
};

}  // namespace

const Mechanism& bicycle_mechanism() {
  static const Mechanism mechanism = parse_mechanism(find_shipped("bicycle")->text, "bicycle");
  return mechanism;
}

std::size_t bicycle_parameter(std::string_view symbol) {
  static const std::map<std::string, std::size_t, std::less<>> indices = [] {
    std::map<std::string, std::size_t, std::less<>> result;
    for (const MechanismParameter& parameter : bicycle_mechanism().parameters) {
      result.emplace(parameter.symbol, result.size());
    }
    return result;
  }();
  return indices.find(symbol)->second;
}

MechanismValues bicycle_values(const Bicycle<Rational>& p, const Road<Rational>& road, ForceKind kind) {
  MechanismValues values = default_values(bicycle_mechanism());
  const auto put = [&](std::string_view symbol, const Rational& value) {
    values.parameters[bicycle_parameter(symbol)] = value;
  };
  for_each_number(p, road, put);
  put("external", kind == ForceKind::external ? 1 : 0);
  put("J", p.J.value_or(0));
  values.given[bicycle_parameter("J")] = p.J.has_value();
  return values;
}

BicycleOfValues bicycle_of(const MechanismValues& values) {
  const auto value = [&](std::string_view symbol) -> const Rational& {
    return values.parameters[bicycle_parameter(symbol)];
  };
  BicycleOfValues result{{}, {}, value("external").is_zero() ? ForceKind::internal : ForceKind::external};
  for_each_number(result.bicycle, result.road,
                  [&](std::string_view symbol, Rational& number) { number = value(symbol); });
  if (values.given[bicycle_parameter("J")]) result.bicycle.J = value("J");
  return result;
}

const MechanismMode& mechanism_mode(ContactMode mode) {
  static const auto modes = [] {
    std::array<MechanismMode, 16> all;
    for (const ContactMode m : all_modes()) all[m.index()] = {m.rear, m.front};
    return all;
  }();
  return modes[mode.index()];
}

std::optional<ContactMode> contact_mode(const MechanismMode& mode) {
  const auto of_wheel = [](ElementState state) { return state <= ElementState::lift; };
  if (mode.size() != 2 || !of_wheel(mode[0]) || !of_wheel(mode[1])) return std::nullopt;
  return ContactMode{mode[0], mode[1]};
}

std::unique_ptr<const MotionsOverLoads> bicycle_motions(const Bicycle<Rational>& bicycle, const Road<Rational>& road,
                                                        ForceKind kind,
                                                        const std::optional<std::vector<MechanismMode>>& only) {
  return std::make_unique<const BicycleMotions>(bicycle, road, kind, only);
}

}  // namespace slipproof
