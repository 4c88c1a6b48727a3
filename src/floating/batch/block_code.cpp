#include "floating/batch/block_code.hpp"

#include <cmath>
#include <limits>

#include "base/number/binary64.hpp"

namespace slipproof {

namespace {

/// The numbers that the domain needs: for each truth program its differences, then the divisors.
std::vector<TapeRef> domain_of(const ModePrograms& programs) {
  std::vector<TapeRef> wanted;
  for (const auto* truths : {&programs.domain, &programs.loads}) {
    for (const TruthProgram& truth : *truths) {
      for (const auto& step : truth.steps) {
        if (step.operation == Operation::compare) wanted.push_back(step.difference);
      }
    }
  }
  wanted.insert(wanted.end(), programs.divisors.begin(), programs.divisors.end());
  return wanted;
}

SharedRange shared_range(const Rational& literal) {
  const double nearest = nearest_binary64(literal);
  const bool exact = std::isfinite(nearest) && to_rational(nearest) == literal;
  return {nearest, nearest, exact ? 0 : std::fabs(nearest) * batch_rounding + batch_underflow};
}

/// For each result, whether it is the same at all points.
std::vector<bool> same_for_all(const ModePrograms& programs, const std::vector<bool>& constant) {
  std::vector<bool> same(programs.nodes.size());
  for (std::size_t i = 0; i < same.size(); ++i) {
    const TapeNode& node = programs.nodes[i];
    same[i] = node.operation == TapeOperation::constant ||
              (node.operation == TapeOperation::input ? constant[node.first] : same[node.first] && same[node.second]);
  }
  return same;
}

/// What each part of the code computes: first the domain, then each mode.
std::vector<std::vector<TapeRef>> wanted_parts(const ModePrograms& programs) {
  std::vector<std::vector<TapeRef>> parts{domain_of(programs)};
  for (const ModeProgram& program : programs.programs) {
    std::vector<TapeRef>& part = parts.emplace_back();
    const auto add = [&](const SolvedForm& form) {
      part.push_back(form.constant);
      part.insert(part.end(), form.core.begin(), form.core.end());
    };
    for (const SolvedForm& equation : program.core) add(equation);
    for (const SolvedForm& condition : program.conditions) {
      if (!condition.varies()) add(condition);
    }
    part.insert(part.end(), program.pivots.begin(), program.pivots.end());
  }
  return parts;
}

/// The results that do not vary and that are wanted, or needed by results that vary.
std::vector<TapeRef> constants_for(const ModePrograms& programs, const std::vector<bool>& constant,
                                   const std::vector<std::vector<TapeRef>>& wanted) {
  const std::vector<bool> same = same_for_all(programs, constant);
  std::vector<bool> needed(programs.nodes.size(), false);
  for (const auto& part : wanted) {
    for (const TapeRef ref : part) needed[ref] = true;
  }
  std::vector<TapeRef> constants;
  for (std::size_t i = needed.size(); i-- > 0;) {
    const TapeNode& node = programs.nodes[i];
    if (!needed[i] || node.operation <= TapeOperation::input) continue;
    if (same[i]) {
      constants.push_back(static_cast<TapeRef>(i));
    } else {
      needed[node.first] = needed[node.second] = true;
    }
  }
  return constants;
}

/// For each step of codes that run one after another, whether something is divided by its result.
std::vector<bool> divisors_of(const std::vector<TapeCode>& codes, std::size_t places) {
  std::vector<bool> divisors;
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> writers(places, none);
  for (const TapeCode& code : codes) {
    for (const TapeStep& step : code.steps) {
      const std::size_t divisor = step.quotient ? writers[code.terms[step.terms].second] : none;
      if (divisor != none) divisors[divisor] = true;
      writers[step.target] = divisors.size();
      divisors.push_back(false);
    }
  }
  return divisors;
}

}  // namespace

BlockCode::BlockCode(const ModePrograms& given, std::vector<bool> same) : programs(&given), constant(std::move(same)) {
  TapeCompiler compiler(given.nodes, given.inputs());
  const auto wanted = wanted_parts(given);
  const std::vector<TapeRef> constants = constants_for(given, constant, wanted);
  of_constants = compiler.code_for(constants);
  for (const TapeRef ref : constants) constant_places.push_back(compiler.place(ref));
  for (std::size_t i = 0; i < constant.size(); ++i) {
    if (constant[i]) constant_places.push_back(static_cast<std::uint32_t>(i));
  }
  std::vector<std::vector<std::uint32_t>> wanted_places;
  std::vector<TapeCode> codes = compiler.code_for_parts(wanted, wanted_places);
  divisors = divisors_of(codes, compiler.places());
  domain = std::move(codes[0]);
  domain_numbers = wanted_places[0];
  for (std::size_t i = 0; i < given.programs.size(); ++i) {
    const ModeProgram& program = given.programs[i];
    BlockMode& mode = modes.emplace_back();
    mode.code = std::move(codes[i + 1]);
    auto place = wanted_places[i + 1].begin();
    const auto take = [&](const SolvedForm& form, std::vector<BlockForm>& to) {
      BlockForm& result = to.emplace_back();
      result.constant = *place++;
      for (std::size_t k = 0; k < form.core.size(); ++k) result.core[k] = *place++;
    };
    for (const SolvedForm& equation : program.core) take(equation, mode.equations);
    for (const SolvedForm& condition : program.conditions) {
      if (!condition.varies()) take(condition, mode.conditions);
    }
    mode.pivots.assign(place, wanted_places[i + 1].end());
    mode.only_refuted = program.free > 0 || !program.residuals.empty();
  }
  for (const auto& [place, ref] : compiler.literals()) {
    literals.emplace_back(place, shared_range(given.constants[given.nodes[ref].first]));
    constant_places.push_back(place);
  }
  places = compiler.places();
}

}  // namespace slipproof
