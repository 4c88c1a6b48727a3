#include "mechanics/family/solved_sample.hpp"

#include <algorithm>
#include <utility>

#include "mechanics/kernel/affine_space.hpp"

namespace slipproof {

namespace {

/// The order of rational functions of a variable that grows without bound.
struct FieldAtInfinity : FieldOf<ForceFunction> {
  static int sign_of(const Polynomial& p) { return sign(p.coefficient(p.degree())); }
  std::optional<int> compare(const ForceFunction& x, const ForceFunction& y) const {
    const RationalFunction d = x.value() - y.value();
    return sign_of(d.numerator()) * sign_of(d.denominator());
  }
};

}  // namespace

SolvedSample::SolvedSample(const CompiledFamily& family, std::vector<Rational> values)
    : family_(&family), values_(std::move(values)), constants_(family.scope()), functions_(family.scope()) {
  constants_.set(CompiledFamily::parameter_slot(0), values_);
  for (std::size_t k = 0; k < values_.size(); ++k) {
    functions_.set(CompiledFamily::parameter_slot(k), RationalFunction(values_[k]));
  }
  functions_.set(CompiledFamily::force_slot(), RationalFunction::variable());
}

bool SolvedSample::read_scene() {
  const CompiledScene& scene = family_->scene();
  point_ = default_values(family_->mechanism());
  point_.starts = family_->starts();
  for (std::size_t i = 0; i < scene.parameters.size(); ++i) {
    point_.given[i] = scene.parameters[i].has_value();
    if (!scene.parameters[i]) continue;
    auto value = constants_.number(*scene.parameters[i]).number;
    if (!value) return false;
    point_.parameters[i] = std::move(*value);
  }
  for (std::size_t i = 0; i < scene.angles.size(); ++i) {
    auto cosine = constants_.number(scene.angles[i].first).number,
         sine = constants_.number(scene.angles[i].second).number;
    if (!cosine || !sine) return false;
    point_.angles[i] = {std::move(*cosine), std::move(*sine)};
  }
  if (constants_.truth(family_->is_scene()) != Truth::yes || !read_load()) return false;
  try {
    problem_ = std::make_shared<const FrictionProblem>(family_->maker().problem(point_));
  } catch (const NoValue&) {
    return false;
  }
  return true;
}

bool SolvedSample::read_load() {
  if (!family_->scene().load) return true;
  const auto number = functions_.number(*family_->scene().load).number;
  if (!number || !number->divisors().empty()) return false;
  const RationalFunction& load = number->value();
  if (load.numerator().degree() > 1 || load.denominator().degree() > 0) return false;
  load_ = {load.numerator().coefficient(0), load.numerator().coefficient(1)};
  return !load_.beta.is_zero();
}

std::unique_ptr<SolvedSample> SolvedSample::make(const CompiledFamily& family, std::vector<Rational> values) {
  std::unique_ptr<SolvedSample> sample(new SolvedSample(family, std::move(values)));
  if (!sample->read_scene()) return nullptr;
  sample->domain_ = family.scene().load ? true_interval(family.force_domain(), sample->functions_)
                                        : std::optional(ForceInterval::point(0));
  return sample;
}

std::unique_ptr<SolvedSample> SolvedSample::in_domain(const CompiledFamily& family, std::vector<Rational> values) {
  return slipproof::in_domain(family, values) ? make(family, std::move(values)) : nullptr;
}

ForceInterval SolvedSample::in_variable(const ForceInterval& forces) const {
  if (forces.empty()) return forces;
  const auto turned = [&](const std::optional<Rational>& F) {
    return F ? std::optional<Rational>((*F - load_.alpha) / load_.beta) : std::nullopt;
  };
  auto lower = turned(forces.lower()), upper = turned(forces.upper());
  if (load_.beta > 0) {
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

ForceInterval SolvedSample::forces_of(const ModeOverLoads& mode, bool strict) const {
  ForceInterval forces = in_variable(strict ? *mode.strict : *mode.closed);
  forces.intersect(*domain_);
  return forces;
}

const MotionsOverLoads& SolvedSample::motions() {
  if (motions_) return *motions_;
  motions_ = motions_over_loads(*problem_, only_modes_);
  return *motions_;
}

std::unique_ptr<SolvedSample> SolvedSample::under(const CompiledFamily& other) {
  std::unique_ptr<SolvedSample> sample(new SolvedSample(other, values_));
  motions();
  sample->point_ = point_;
  sample->load_ = load_;
  sample->problem_ = problem_;
  sample->motions_ = motions_;
  sample->domain_ = domain_;
  sample->cells_ = cells_;
  sample->named_ = named_;
  return sample;
}

const std::vector<LoadCell>& SolvedSample::cells(const std::vector<MechanismMode>& named) {
  if (!cells_ || (!motions().all_tried() && named != named_)) {
    cells_ = std::make_shared<const std::vector<LoadCell>>(cells_in_detail(Detail::modes, named));
    named_ = named;
  }
  return *cells_;
}

std::vector<LoadCell> SolvedSample::cells_in_detail(Detail detail, const std::vector<MechanismMode>& named) {
  std::vector<LoadCell> cells = motions().cells(detail, named);
  const bool same = load_ == Affine<Rational>(0, 1);
  for (LoadCell& cell : cells) {
    if (same) break;
    cell.loads = in_variable(cell.loads);
    for (MotionOverLoads& motion : cell.motions) put_in_variable(motion);
  }
  if (load_.beta < 0) std::reverse(cells.begin(), cells.end());
  return cells;
}

void SolvedSample::put_in_variable(MotionOverLoads& motion) const {
  for (Affine<Rational>& value : motion.accelerations) value = in_variable(value);
  for (std::optional<Affine<Rational>>& value : motion.forces) {
    if (value) value = in_variable(*value);
  }
}

LinearRows SolvedSample::equations(const std::optional<MechanismMode>& mode) {
  LinearRows rows;
  const auto add = [&](const AffineForm& form) {
    std::vector<Rational>& row = rows.emplace_back(form.coefficients);
    row.push_back(form.constant + row.back() * load_.alpha);
    row[row.size() - 2] *= load_.beta;
  };
  for (const AffineForm& equation : problem().equations) add(equation);
  for (std::size_t i = 0; i < problem().elements.size(); ++i) {
    const ProblemElement& element = problem().elements[i];
    if (mode) {
      for (const StateEquation e : slipproof::equations(element.kind, (*mode)[i])) add(form_of(element, (*mode)[i], e));
    } else if (element.kind.law != ElementKind::Law::limited && element.kind.start != ElementKind::Start::open) {
      add(element.gap);
    }
  }
  return rows;
}

Truth SolvedSample::eventually(const Program& statement, std::size_t parameter) const {
  Evaluator<ForceFunction, FieldAtInfinity> evaluator(family_->scope());
  for (std::size_t k = 0; k < values_.size(); ++k) {
    evaluator.set(CompiledFamily::parameter_slot(k),
                  ForceFunction(k == parameter ? RationalFunction::variable() : RationalFunction(values_[k])));
  }
  return evaluator.truth(statement);
}

bool SolvedSample::set_motion(const ModeForms& forms, const std::vector<std::size_t>& slots) {
  bool determined = true;
  for (const std::size_t slot : slots) {
    if (!family_->is_quantity(slot)) continue;
    const AffineForm& form = quantity_form(forms, slot - family_->quantity_slot(0));
    if (!is_free_of_unknowns(form)) {
      determined = false;
      continue;
    }
    functions_.set(slot, RationalFunction(in_variable(Affine<Rational>(form.constant, form.coefficients.back()))));
  }
  return determined;
}

const AffineForm& quantity_form(const ModeForms& forms, std::size_t quantity) {
  const std::size_t first = forms.accelerations.size();
  return quantity < first ? forms.accelerations[quantity] : forms.forces[quantity - first];
}

}  // namespace slipproof
