#include "floating/tape/mode_programs.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "floating/tape/tape_inputs.hpp"
#include "mechanics/kernel/mode_solver.hpp"
#include "mechanics/mechanism/assemble.hpp"
#include "mechanics/mechanism/words.hpp"

namespace slipproof {

namespace {

/// Thrown if the mechanism contains something that a tape cannot compute.
struct NoTape {};

struct TapeNumber {
  TapeBuilder* tape = nullptr;
  std::vector<TapeRef>* divisors = nullptr;
  TapeRef ref = TapeBuilder::zero;

  TapeNumber with(TapeRef result) const { return {tape, divisors, result}; }
  friend TapeNumber operator+(const TapeNumber& x, const TapeNumber& y) { return x.with(x.tape->add(x.ref, y.ref)); }
  friend TapeNumber operator-(const TapeNumber& x, const TapeNumber& y) {
    return x.with(x.tape->subtract(x.ref, y.ref));
  }
  friend TapeNumber operator*(const TapeNumber& x, const TapeNumber& y) {
    return x.with(x.tape->multiply(x.ref, y.ref));
  }
  friend TapeNumber operator/(const TapeNumber& x, const TapeNumber& y) {
    x.divisors->push_back(y.ref);
    return x.with(x.tape->divide(x.ref, y.ref));
  }
  friend TapeNumber operator-(const TapeNumber& x) { return x.with(x.tape->negate(x.ref)); }
};

/// Tells an evaluator how to compute on a tape. Results cannot be ordered.
struct TapeField {
  TapeBuilder* tape = nullptr;
  std::vector<TapeRef>* divisors = nullptr;

  TapeNumber constant(const Rational& value) const { return {tape, divisors, tape->constant(value)}; }
  bool is_zero(const TapeNumber& x) const { return x.ref == TapeBuilder::zero; }
  std::optional<int> compare(const TapeNumber&, const TapeNumber&) const { return std::nullopt; }
};

using TapeEvaluator = Evaluator<TapeNumber, TapeField>;

/// Makes the forms of the mechanism for assemble().
class TapeForms {
 public:
  TapeForms(TapeBuilder& tape, TapeEvaluator& at, std::size_t unknowns, TapeRef load)
      : tape_(tape), at_(at), unknowns_(unknowns), load_(load) {}

  TapeForm form(const CompiledForm& compiled, const std::string&) {
    const auto numbers = coefficients(compiled, at_, unknowns_);
    if (!numbers) throw NoTape{};
    TapeForm result{
        &tape_, {}, tape_.add((*numbers)[unknowns_ + 1].ref, tape_.multiply(load_, (*numbers)[unknowns_].ref))};
    for (std::size_t i = 0; i < unknowns_; ++i) result.coefficients.push_back((*numbers)[i].ref);
    return result;
  }

  TapeForm unit(std::size_t unknown) const {
    TapeForm result{&tape_, std::vector<TapeRef>(unknowns_, TapeBuilder::zero), TapeBuilder::zero};
    result.coefficients[unknown] = TapeBuilder::one;
    return result;
  }

  TapeForm limit(const Program& friction, std::size_t normal, const std::string&) {
    const auto value = at_.number(friction);
    if (!value.number) throw NoTape{};
    TapeForm result = unit(normal);
    result.coefficients[normal] = value.number->ref;
    return result;
  }

 private:
  TapeBuilder& tape_;
  TapeEvaluator& at_;
  std::size_t unknowns_;
  TapeRef load_;
};

/// The problem that assemble() fills in.
struct TapeProblem {
  std::size_t unknowns = 0;
  std::vector<TapeForm> equations, accelerations, forces;
  std::vector<ElementForms<TapeForm>> elements;
};

class ProgramMaker {
 public:
  ProgramMaker(const Mechanism& mechanism, const std::vector<bool>& given)
      : mechanism_(mechanism),
        compiled_(mechanism),
        result_(mechanism),
        tape_(input_signs(mechanism), circles(mechanism)),
        at_(compiled_.scope(), TapeField{&tape_, &result_.divisors}) {
    result_.given = given;
    result_.parameters = mechanism.parameters.size();
    result_.angles = mechanism.angles.size();
    for (std::size_t i = 0; i < result_.parameters; ++i) {
      set(compiled_.parameter(i), given[i] ? tape_.input(i) : TapeBuilder::zero);
    }
    for (std::size_t i = 0; i < result_.angles; ++i) {
      set(compiled_.cosine(i), tape_.input(result_.cosine(i)));
      set(compiled_.sine(i), tape_.input(result_.cosine(i) + 1));
    }
    set(compiled_.load(), tape_.input(result_.load()));
  }

  ModePrograms make(const std::vector<ElementKind>& kinds) {
    TapeForms forms(tape_, at_, mechanism_.unknowns.size(), tape_.input(result_.load()));
    assemble(mechanism_, compiled_, kinds, forms, problem_);
    add_domain();
    reduce();
    result_.modes = modes_of(kinds);
    for (const MechanismMode& mode : result_.modes) add_mode(mode);
    join_motions();
    add_scales();
    result_.nodes = tape_.nodes();
    result_.constants = tape_.constants();
    return std::move(result_);
  }

 private:
  void set(std::size_t slot, TapeRef ref) { at_.set(slot, TapeNumber{&tape_, &result_.divisors, ref}); }

  TruthProgram truth(const Program& program) {
    TruthProgram result;
    add_step(result, program, program.root());
    return result;
  }

  std::size_t add_step(TruthProgram& result, const Program& program, std::uint32_t index) {
    const Program::Instruction& instruction = program.code()[index];
    TruthProgram::Step step;
    step.operation = instruction.operation;
    step.truth = instruction.truth;
    step.relation = instruction.relation;
    switch (instruction.operation) {
      case Operation::truth:
        break;
      case Operation::logical_not:
        step.first = add_step(result, program, instruction.first);
        break;
      case Operation::logical_and:
      case Operation::logical_or:
        step.first = add_step(result, program, instruction.first);
        step.second = add_step(result, program, instruction.second);
        break;
      default: {
        const auto x = at_.number(program, instruction.first), y = at_.number(program, instruction.second);
        if (!x.number || !y.number) throw NoTape{};
        step.difference = (*x.number - *y.number).ref;
        if (step.relation == Relation::greater) tape_.assume_positive(step.difference);
        if (step.relation == Relation::less) tape_.assume_positive(tape_.negate(step.difference));
      }
    }
    result.steps.push_back(step);
    return result.steps.size() - 1;
  }

  void add_domain() {
    for (std::size_t i = 0; i < result_.parameters; ++i) {
      if (result_.given[i]) result_.domain.push_back(truth(compiled_.parameter_domains[i]));
    }
    for (const Program& program : compiled_.angle_domains) result_.domain.push_back(truth(program));
    for (const Program& program : compiled_.assume) result_.domain.push_back(truth(program));
    for (const CompiledBound& bound : compiled_.load_domain) {
      const auto numbers = coefficients(bound.form, at_, 0);
      if (!numbers) throw NoTape{};
      TruthProgram::Step step;
      step.operation = Operation::compare;
      step.relation = bound.relation;
      step.difference = tape_.add((*numbers)[1].ref, tape_.multiply((*numbers)[0].ref, tape_.input(result_.load())));
      result_.loads.push_back({{step}});
    }
  }

  /// Eliminates the equations that all modes have in common.
  void reduce() {
    rows_ = problem_.equations;
    common_.eliminate(rows_, TapeBuilder::Doubt::nonzero_in_domain);
    elements_ = problem_.elements;
    for (auto& element : elements_) {
      for (TapeForm* form : {&element.gap, &element.normal, &element.slip, &element.tangent, &element.static_limit,
                             &element.kinetic_limit}) {
        if (!form->coefficients.empty()) *form = common_.reduced(std::move(*form));
      }
    }
  }

  void add_mode(const MechanismMode& mode) {
    std::vector<TapeForm> rows = rows_;
    for (std::size_t i = 0; i < mode.size(); ++i) {
      const auto& element = elements_[i];
      for (const StateEquation e : equations(element.kind, mode[i])) rows.push_back(form_of(element, mode[i], e));
    }
    const TapeSolution solution(common_, std::move(rows), problem_.unknowns);
    ModeProgram program;
    program.core = solution.core();
    program.pivots = solution.pivots();
    program.residuals = solution.residuals();
    program.free = solution.free();
    std::vector<bool> slipless(mode.size(), false);
    for (std::size_t i = 0; i < mode.size(); ++i) {
      const auto& element = elements_[i];
      for (const StateCondition c : conditions(element.kind, mode[i])) {
        SolvedForm form = solution.on(form_of(element, mode[i], c));
        if (!form.is_zero()) {
          program.conditions.push_back(std::move(form));
          continue;
        }
        program.never_strict = true;
        if (c == StateCondition::slips_forward || c == StateCondition::slips_backward) slipless[i] = true;
      }
    }
    for (const TapeForm& form : problem_.accelerations) program.accelerations.push_back(solution.on(form));
    for (const TapeForm& form : problem_.forces) program.forces.push_back(solution.on(form));
    program.determined = std::none_of(program.accelerations.begin(), program.accelerations.end(),
                                      [](const SolvedForm& form) { return form.varies(); });
    MotionValues& values = motions_.emplace_back(MotionValues{solution.divisor(), {}});
    for (const SolvedForm& form : program.accelerations) values.numerators.push_back(solution.numerator(form));
    result_.programs.push_back(std::move(program));
    slipless_.push_back(std::move(slipless));
    if (tape_.nodes().size() > max_tape_length) throw NoTape{};
  }

  std::size_t representative(std::size_t mode) const {
    while (result_.programs[mode].motion != mode) mode = result_.programs[mode].motion;
    return mode;
  }

  /// The accelerations in a mode that determines them.
  struct MotionValues {
    TapeRef divisor;
    std::vector<TapeRef> numerators;
  };

  /// Whether all accelerations are proved to be the same.
  bool is_same(const MotionValues& x, const MotionValues& y) {
    for (std::size_t i = 0; i < x.numerators.size(); ++i) {
      const TapeRef a = tape_.multiply(x.numerators[i], y.divisor), b = tape_.multiply(y.numerators[i], x.divisor);
      if (tape_.subtract(a, b) != TapeBuilder::zero) return false;
    }
    return true;
  }

  /// Finds modes that are the same motion: modes whose accelerations are the same programs. And if an element slips in
  /// a mode although its slip is proved to be 0, all solutions solve the equations of the mode in which it sticks; if
  /// these determine the accelerations, both modes are the same motion.
  void join_motions() {
    std::map<std::vector<TapeBuilder::Residues>, std::size_t> known;
    std::map<MechanismMode, std::size_t> places;
    for (std::size_t i = 0; i < result_.modes.size(); ++i) {
      places.emplace(result_.modes[i], i);
      ModeProgram& program = result_.programs[i];
      program.motion = i;
      if (!program.determined) continue;
      std::vector<TapeBuilder::Residues> values;
      for (const TapeRef numerator : motions_[i].numerators) {
        values.push_back(tape_.quotient_residues(numerator, motions_[i].divisor));
      }
      const std::size_t first = known.emplace(std::move(values), i).first->second;
      if (is_same(motions_[first], motions_[i])) program.motion = first;
    }
    for (std::size_t i = 0; i < result_.modes.size(); ++i) {
      for (std::size_t k = 0; k < result_.modes[i].size(); ++k) {
        if (!slipless_[i][k]) continue;
        MechanismMode stuck = result_.modes[i];
        stuck[k] = is_pulled(stuck[k]) ? ElementState::pulled_stick : ElementState::stick;
        const auto place = places.find(stuck);
        if (place == places.end() || !result_.programs[place->second].determined) continue;
        result_.programs[representative(i)].motion = representative(place->second);
      }
    }
    for (std::size_t i = 0; i < result_.modes.size(); ++i) result_.programs[i].motion = representative(i);
  }

  void add_scales() {
    const MechanismKinds& kinds = result_.kinds;
    const auto line = [&](std::size_t index) -> const TapeForm& {
      return MechanismKinds::line(problem_, kinds.unknown_accelerations, index);
    };
    const auto coefficients_of = [&](const MechanismKinds::Quotient& quotient) {
      std::vector<TapeRef> refs;
      for (const auto& [index, unknown] : quotient.places) refs.push_back(line(index).coefficients[unknown]);
      return refs;
    };
    for (std::size_t i = 0; i < kinds.lines.size(); ++i) result_.line_constants.push_back(line(i).constant);
    for (const auto& inertia : kinds.inertias) result_.inertias.push_back(coefficients_of(inertia));
    for (const auto& lever : kinds.levers) result_.levers.push_back(coefficients_of(lever));
  }

  const Mechanism& mechanism_;
  CompiledMechanism compiled_;
  ModePrograms result_;
  TapeBuilder tape_;
  TapeEvaluator at_;
  TapeProblem problem_;
  TapeElimination common_{tape_};
  std::vector<TapeForm> rows_;                    ///< the remaining equations
  std::vector<ElementForms<TapeForm>> elements_;  ///< reduced
  std::vector<MotionValues> motions_;
  std::vector<std::vector<bool>> slipless_;  ///< by mode: elements whose slip is 0 at all points
};

}  // namespace

std::optional<ModePrograms> mode_programs(const Mechanism& mechanism, const std::vector<ElementKind::Start>& starts,
                                          const std::vector<bool>& given) {
  const std::vector<ElementKind> kinds = element_kinds(mechanism, starts, given);
  if (mode_count(kinds) > max_program_modes) return std::nullopt;
  try {
    return ProgramMaker(mechanism, given).make(kinds);
  } catch (const NoTape&) {
    return std::nullopt;
  }
}

}  // namespace slipproof
