#include "claims/planes/claims_plane.hpp"

#include <algorithm>
#include <memory>

#include "base/input/diagnostic.hpp"
#include "claims/judge/judge.hpp"
#include "claims/paper/compiled.hpp"
#include "claims/paper/setting_names.hpp"
#include "mechanics/planes/plane_words.hpp"

namespace slipproof {

namespace {

/// A definition that claims compare with something.
struct Threshold {
  std::string symbol;
  Expression with;  ///< what it is compared with
};

/// Collects the definitions that the comparisons in an expression compare with something.
void collect(const Expression& expression, const SettingNames& names, std::vector<Threshold>& found) {
  if (expression->operation == Operation::logical_and || expression->operation == Operation::logical_or) {
    for (const Expression& part : expression->operands) collect(part, names, found);
  }
  if (expression->operation != Operation::compare) return;
  const auto& operands = expression->operands;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (operands[i]->operation != Operation::symbol) continue;
    const auto entry = names.find(operands[i]->symbol);
    if (!entry || entry->kind != SettingNames::Kind::definition) continue;
    const auto known = [&](const Threshold& t) { return t.symbol == operands[i]->symbol; };
    if (std::any_of(found.begin(), found.end(), known)) continue;
    found.push_back({operands[i]->symbol, operands[i == 0 ? 1 : i - 1]});
  }
}

/// Solves columns, with all data that this needs.
class ColumnSolver {
 public:
  ColumnSolver(const ClaimsFile& claims, const Figure& figure, Reading reading)
      : claims_(&claims),
        figure_(figure),
        reading_(reading),
        compiled_(claims),
        setting_(compiled_.settings[figure.setting]),
        given_(claims.settings[figure.setting]),
        names_(given_) {
    using InPlanes = ClaimKind::Traits::InPlanes;
    std::vector<Threshold> lines;
    for (std::size_t i = 0; i < claims.claims.size(); ++i) {
      const Claim& claim = claims.claims[i];
      const InPlanes drawn = claim.kind().traits().in_planes;
      if (claim.setting != figure.setting || drawn == InPlanes::no) continue;
      judged_.push_back(i);
      if (drawn != InPlanes::with_thresholds) continue;
      for (const Reading r : all_readings) {
        collect(claim.body(r).forces, names_, thresholds_);
        collect(claim.body(r).region, names_, lines);
      }
    }
    // A threshold of the force cannot depend on the force.
    const auto depends = [&](const Expression& e) { return names_.depends(e, Reading::repaired, given_.force.symbol); };
    std::erase_if(thresholds_, [&](const Threshold& t) { return depends(make_symbol(t.symbol)) || !depends(t.with); });
    for (const Threshold& t : thresholds_) with_.push_back(setting_.compile(t.with, reading));
    const std::string& x = given_.parameters[figure.x].symbol;
    for (const Threshold& line : lines) {
      const bool with_x = is_symbol(line.with, x);
      if (with_x && !names_.depends(make_symbol(line.symbol), Reading::printed, x)) lines_.push_back(line.symbol);
    }
  }

  std::vector<std::string> curves() const {
    std::vector<std::string> symbols;
    for (const Threshold& t : thresholds_) symbols.push_back(t.symbol);
    return symbols;
  }

  std::vector<std::string> judged() const {
    std::vector<std::string> ids;
    for (const std::size_t claim : judged_) ids.push_back(claims_->claims[claim].id);
    return ids;
  }

  std::vector<Plane::Line> lines() const {
    std::vector<Plane::Line> lines;
    for (const std::string& symbol : lines_) {
      const auto meant = value(symbol, Reading::repaired, figure_.x_to);
      const auto printed = value(symbol, Reading::printed, figure_.x_to);
      if (meant) lines.push_back({symbol, *meant, false});
      if (printed && printed != meant) lines.push_back({symbol, *printed, true});
    }
    return lines;
  }

  std::vector<LoadCell> numbers(const Rational& x) const {
    return SolvedSample::make(setting_, values_at(x))->cells_with_numbers();
  }

  std::optional<PhaseColumn> at(const Rational& x) const {
    const auto sample = SolvedSample::in_domain(setting_, values_at(x));
    if (!sample) return std::nullopt;
    PhaseColumn column;
    column.cells = sample->cells();
    for (std::size_t c = 0; c < thresholds_.size(); ++c) column.curves.push_back(force_of(c, x));
    for (const std::size_t claim : judged_) {
      const Judgement judgement = judge(*claims_, compiled_, claim, reading_, *sample);
      const bool refuted = judgement.outcome == Outcome::refuted && judgement.witnesses;
      column.refuted.push_back(refuted ? judgement.witnesses : std::nullopt);
    }
    return column;
  }

 private:
  std::vector<Rational> values_at(const Rational& x) const {
    std::vector<Rational> values = figure_.values;
    values[figure_.x] = x;
    return values;
  }

  Evaluator<Rational> evaluator(const Rational& x) const {
    Evaluator<Rational> values(setting_.scope());
    for (std::size_t k = 0; k < figure_.values.size(); ++k) {
      values.set(CompiledSetting::parameter_slot(k), k == figure_.x ? x : figure_.values[k]);
    }
    return values;
  }

  std::optional<Rational> value(std::string_view symbol, Reading reading, const Rational& x) const {
    return evaluator(x).at(setting_.definition_slot(names_.find(symbol)->index, reading)).number;
  }

  /// The value of the force variable at which a threshold equals what it is compared with.
  std::optional<Rational> force_of(std::size_t curve, const Rational& x) const {
    const auto threshold = value(thresholds_[curve].symbol, reading_, x);
    if (!threshold) return std::nullopt;
    auto at_zero = evaluator(x), at_one = evaluator(x);
    at_zero.set(CompiledSetting::force_slot(), Rational(0));
    at_one.set(CompiledSetting::force_slot(), Rational(1));
    const auto zero = at_zero.number(with_[curve]).number, one = at_one.number(with_[curve]).number;
    if (!zero || !one || *zero == *one) return std::nullopt;
    return Rational((*threshold - *zero) / (*one - *zero));
  }

  const ClaimsFile* claims_;
  const Figure figure_;
  const Reading reading_;
  const CompiledClaims compiled_;
  const CompiledSetting& setting_;
  const Setting& given_;
  const SettingNames names_;
  std::vector<Threshold> thresholds_;
  std::vector<Program> with_;
  std::vector<std::string> lines_;
  std::vector<std::size_t> judged_;
};

}  // namespace

Plane claims_plane(const ClaimsFile& claims, const Figure& figure, Reading reading) {
  const auto solver = std::make_shared<const ColumnSolver>(claims, figure, reading);
  if (!solver->at((figure.x_from + figure.x_to) / 2)) {
    throw InputError(
        {{claims.file, 0, 0, "the values of figure " + in_quotes(figure.id) + " are outside of their domains"}});
  }
  Plane plane;
  plane.id = figure.id;
  plane.title = figure.title;
  plane.x = {claims.settings[figure.setting].parameters[figure.x].symbol, figure.x_from, figure.x_to};
  plane.y = {figure.y_label, figure.y_from, figure.y_to};
  plane.curves = solver->curves();
  plane.lines = solver->lines();
  plane.claims = solver->judged();
  tell_of_mechanism(plane, *claims.settings[figure.setting].mechanism);
  plane.solve = [solver](const Rational& x) { return solver->at(x); };
  plane.numbers = [solver](const Rational& x) { return solver->numbers(x); };
  return plane;
}

MechanismScene figure_scene(const ClaimsFile& claims, const Figure& figure) {
  const Setting& setting = claims.settings[figure.setting];
  const CompiledSetting compiled(setting);
  std::vector<Rational> values = figure.values;
  values[figure.x] = (figure.x_from + figure.x_to) / 2;
  const auto sample = SolvedSample::make(compiled, std::move(values));
  MechanismScene scene;
  scene.name = figure.title;
  scene.mechanism = *setting.mechanism;
  scene.values = sample->point();
  if (scene.mechanism.load) scene.load = sample->load((figure.y_from + figure.y_to) / 2);
  return scene;
}

}  // namespace slipproof
