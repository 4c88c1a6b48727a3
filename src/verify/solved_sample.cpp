#include "verify/solved_sample.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "model/domain.hpp"
#include "model/linear_form.hpp"

namespace slipproof {

namespace {

/// The order of rational functions of a variable that grows beyond all bounds.
struct FieldAtInfinity : FieldOf<ForceFunction> {
  static int sign_of(const Polynomial& p) { return sign(p.coefficient(p.degree())); }
  std::optional<int> compare(const ForceFunction& x, const ForceFunction& y) const {
    const RationalFunction d = x.value() - y.value();
    return sign_of(d.numerator()) * sign_of(d.denominator());
  }
};

}  // namespace

SolvedSample::SolvedSample(const CompiledSetting& setting, std::vector<Rational> values)
    : setting_(&setting), values_(std::move(values)), constants_(setting.scope()), functions_(setting.scope()) {
  for (std::size_t k = 0; k < values_.size(); ++k) {
    constants_.set(CompiledSetting::parameter_slot(k), values_[k]);
    functions_.set(CompiledSetting::parameter_slot(k), RationalFunction(values_[k]));
  }
  functions_.set(CompiledSetting::force_slot(), RationalFunction::variable());
}

bool SolvedSample::read_scene(ForceKind kind) {
  Bicycle<Rational>& p = scene_.bicycle;
  p.J = Rational(0);
  const std::array<Rational*, 14> targets{&p.M,  &p.R,  &p.h,  &p.b2, &p.b3, &p.I1,          &p.I2,
                                          &p.I3, &p.r1, &p.r2, &p.L,  &*p.J, &scene_.road.f, &scene_.road.g};
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (!setting_->scene()[i]) {
      p.J.reset();
      continue;
    }
    auto value = constants_.number(*setting_->scene()[i]).number;
    if (!value) return false;
    *targets[i] = std::move(*value);
  }
  scene_.force_kind = kind;
  if (!in_domain(p, scene_.road)) return false;
  const auto number = functions_.number(*setting_->scene()[targets.size()]).number;
  if (!number || !number->divisors().empty()) return false;
  const RationalFunction& force = number->value();
  if (force.numerator().degree() > 1 || force.denominator().degree() > 0) return false;
  force_ = {force.numerator().coefficient(0), force.numerator().coefficient(1)};
  return !force_.beta.is_zero();
}

std::unique_ptr<SolvedSample> SolvedSample::make(const CompiledSetting& setting, ForceKind kind,
                                                 std::vector<Rational> values) {
  std::unique_ptr<SolvedSample> sample(new SolvedSample(setting, std::move(values)));
  if (!sample->read_scene(kind)) return nullptr;
  sample->domain_ = true_interval(setting.force_domain(), sample->functions_);
  return sample;
}

ForceInterval SolvedSample::in_variable(const ForceInterval& forces) const {
  if (forces.empty()) return forces;
  const auto turned = [&](const std::optional<Rational>& F) {
    return F ? std::optional<Rational>((*F - force_.alpha) / force_.beta) : std::nullopt;
  };
  auto lower = turned(forces.lower()), upper = turned(forces.upper());
  if (force_.beta > 0) {
    return ForceInterval::between(std::move(lower), forces.lower_closed(), std::move(upper), forces.upper_closed());
  }
  return ForceInterval::between(std::move(upper), forces.upper_closed(), std::move(lower), forces.lower_closed());
}

SolvedSample::TrueForces SolvedSample::true_at(const Program& statement) {
  TrueForces found;
  for (TruthCell& cell : over_forces(statement)) {
    cell.forces.intersect(*domain_);
    if (cell.forces.empty() || cell.truth == Truth::no) continue;
    (cell.truth == Truth::yes ? found.parts : found.unvalued).push_back(std::move(cell.forces));
  }
  return found;
}

ForceInterval SolvedSample::forces_of(const ModeSolution& mode, bool strict) const {
  ForceInterval forces = in_variable(strict ? mode.strict() : mode.closed());
  forces.intersect(*domain_);
  return forces;
}

const ModeTable& SolvedSample::table() {
  if (table_) return *table_;
  const Bicycle<Rational>& p = scene_.bicycle;
  table_ = only_modes_ ? std::make_shared<const ModeTable>(p, scene_.road, scene_.force_kind, *only_modes_)
                       : std::make_shared<const ModeTable>(p, scene_.road, scene_.force_kind);
  return *table_;
}

std::unique_ptr<SolvedSample> SolvedSample::under(const CompiledSetting& other) {
  std::unique_ptr<SolvedSample> sample(new SolvedSample(other, values_));
  table();
  sample->scene_ = scene_;
  sample->force_ = force_;
  sample->table_ = table_;
  sample->domain_ = domain_;
  sample->cells_ = cells_;
  return sample;
}

const std::vector<Cell>& SolvedSample::cells() {
  if (!cells_) {
    std::vector<Cell> cells = partition(table());
    for (Cell& cell : cells) cell.forces = in_variable(cell.forces);
    if (force_.beta < 0) std::reverse(cells.begin(), cells.end());
    cells_ = std::make_shared<const std::vector<Cell>>(std::move(cells));
  }
  return *cells_;
}

const LinearRows& SolvedSample::raw_rows(ContactState both) {
  LinearRows& rows = raw_rows_[static_cast<std::size_t>(both)];
  if (!rows.empty()) return rows;
  for (auto& equation : raw_system(scene_.bicycle, scene_.road, scene_.force_kind, {both, both})) {
    std::vector<Rational>& row = rows.emplace_back(equation.coefficients.begin(), equation.coefficients.end());
    row.push_back(equation.constant + row.back() * force_.alpha);
    row[unknown_count] *= force_.beta;
  }
  return rows;
}

LinearRows SolvedSample::equations(std::optional<ContactMode> mode) {
  const LinearRows& stick = raw_rows(ContactState::stick);
  LinearRows rows(stick.begin(), stick.begin() + 7);
  for (const std::size_t contact : {7U, 9U}) {  // a wheel's gap, then its slip or friction
    const Wheel wheel = contact == 7 ? Wheel::rear : Wheel::front;
    rows.push_back(stick[contact]);
    if (mode) rows.push_back(raw_rows((*mode)[wheel])[contact + 1]);
  }
  return rows;
}

Truth SolvedSample::eventually(const Program& statement, std::size_t parameter) const {
  Evaluator<ForceFunction, FieldAtInfinity> evaluator(setting_->scope());
  for (std::size_t k = 0; k < values_.size(); ++k) {
    evaluator.set(CompiledSetting::parameter_slot(k),
                  ForceFunction(k == parameter ? RationalFunction::variable() : RationalFunction(values_[k])));
  }
  return evaluator.truth(statement);
}

void SolvedSample::set_motion(const Motion<Affine<Rational>>& motion) {
  for (const Quantity q : all_quantities()) {
    functions_.set(CompiledSetting::quantity_slot(q), RationalFunction(in_variable(motion[q])));
  }
}

}  // namespace slipproof
