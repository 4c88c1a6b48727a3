#include "floating/program/tape_code.hpp"

#include <algorithm>
#include <array>

namespace slipproof {

TapeCompiler::TapeCompiler(const std::vector<TapeNode>& nodes, std::size_t inputs)
    : nodes_(nodes),
      places_(nodes.size(), nowhere),
      uses_(nodes.size(), 0),
      done_(nodes.size(), false),
      count_(static_cast<std::uint32_t>(inputs)) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].operation == TapeOperation::input) places_[i] = nodes[i].first;
  }
  forget();
}

void TapeCompiler::forget() {
  for (std::size_t i = 0; i < nodes_.size(); ++i) done_[i] = nodes_[i].operation == TapeOperation::input;
}

TapeCompiler::Signed TapeCompiler::resolved(TapeRef ref) const {
  bool negative = false;
  for (; nodes_[ref].operation == TapeOperation::negate; ref = nodes_[ref].first) negative = !negative;
  return {ref, negative};
}

bool TapeCompiler::is_sum(TapeRef ref) const {
  return nodes_[ref].operation == TapeOperation::add || nodes_[ref].operation == TapeOperation::subtract;
}

std::uint32_t TapeCompiler::place_for(TapeRef ref) {
  std::uint32_t& place = places_[ref];
  if (place != nowhere) return place;
  if (is_literal(ref)) {
    literals_.emplace_back(count_, ref);
    return place = count_++;
  }
  if (unused_.empty()) return place = count_++;
  place = unused_.back();
  unused_.pop_back();
  return place;
}

/// Counts how often other results need each result, plus one if it is wanted; 0 if it is not needed or already there.
void TapeCompiler::count_uses(const std::vector<TapeRef>& wanted) {
  std::fill(uses_.begin(), uses_.end(), 0);
  for (const TapeRef ref : wanted) uses_[ref] += 2;
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    const TapeNode& node = nodes_[i];
    if (uses_[i] == 0 || done_[i] || node.operation <= TapeOperation::input) continue;
    ++uses_[resolved(node.first).ref];
    ++uses_[resolved(node.second).ref];
  }
}

/// Calls see(x, y, negative) for each product of a sum, see(x, x, negative) for each plain term. Does not expand a part
/// that other results need, too.
template <class See>
void TapeCompiler::each_term(TapeRef ref, bool negative, const See& see) const {
  const TapeNode& node = nodes_[ref];
  if (node.operation == TapeOperation::negate) {
    const Signed x = resolved(ref);
    see(x.ref, x.ref, negative != x.negative, false);
    return;
  }
  if (node.operation == TapeOperation::multiply) {
    const Signed x = resolved(node.first), y = resolved(node.second);
    see(x.ref, y.ref, negative != (x.negative != y.negative), true);
    return;
  }
  for (const bool second : {false, true}) {
    const Signed x = resolved(second ? node.second : node.first);
    const bool sign = negative != (x.negative != (second && node.operation == TapeOperation::subtract));
    const bool inside = uses_[x.ref] == 1 && !done_[x.ref];
    if (inside && (is_sum(x.ref) || nodes_[x.ref].operation == TapeOperation::multiply)) {
      each_term(x.ref, sign, see);
    } else {
      see(x.ref, x.ref, sign, false);
    }
  }
}

void TapeCompiler::add_step(TapeRef ref, TapeCode& code) const {
  TapeStep step;
  step.terms = static_cast<std::uint32_t>(code.terms.size());
  const TapeNode& node = nodes_[ref];
  if (node.operation == TapeOperation::divide) {
    const Signed x = resolved(node.first), y = resolved(node.second);
    step.quotient = true;
    step.negative = x.negative != y.negative;
    code.terms.push_back({x.ref, y.ref});
  } else {
    std::array<std::vector<TapeTerm>, 4> terms;  // added products, added terms, subtracted products, subtracted terms
    each_term(ref, false, [&](TapeRef x, TapeRef y, bool negative, bool product) {
      terms[(negative ? 2U : 0U) + (product ? 0U : 1U)].push_back({x, y});
    });
    if (terms[0].empty() && terms[1].empty()) {
      step.negative = true;
      std::swap(terms[0], terms[2]);
      std::swap(terms[1], terms[3]);
    }
    for (const auto& some : terms) code.terms.insert(code.terms.end(), some.begin(), some.end());
    const auto count = [&](std::size_t i) { return static_cast<std::uint16_t>(terms[i].size()); };
    step.added_products = count(0);
    step.added = count(1);
    step.subtracted_products = count(2);
    step.subtracted = count(3);
  }
  step.target = ref;
  code.steps.push_back(step);
}

/// The results that get a step of their own: all that are needed and not part of a sum.
std::vector<bool> TapeCompiler::stepwise(const std::vector<TapeRef>& wanted) const {
  std::vector<bool> whole(nodes_.size(), false);
  for (const TapeRef ref : wanted) whole[ref] = true;
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    const auto ref = static_cast<TapeRef>(i);
    if (!whole[i] || done_[i] || is_literal(ref)) continue;
    if (nodes_[i].operation == TapeOperation::divide) {
      whole[resolved(nodes_[i].first).ref] = whole[resolved(nodes_[i].second).ref] = true;
    } else {
      each_term(ref, false, [&](TapeRef x, TapeRef y, bool, bool) { whole[x] = whole[y] = true; });
    }
  }
  return whole;
}

/// The steps, with results where the final code has places.
TapeCode TapeCompiler::steps_for(const std::vector<TapeRef>& wanted) {
  const std::vector<bool> whole = stepwise(wanted);
  TapeCode code;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto ref = static_cast<TapeRef>(i);
    if (!whole[i] || done_[i]) continue;
    if (is_literal(ref)) {
      place_for(ref);
    } else {
      add_step(ref, code);
      done_[i] = true;
    }
  }
  return code;
}

void TapeCompiler::find_places(TapeCode& code) {
  for (TapeTerm& term : code.terms) term = {place_for(term.first), place_for(term.second)};
  for (TapeStep& step : code.steps) step.target = place_for(step.target);
}

TapeCode TapeCompiler::code_for(const std::vector<TapeRef>& wanted) {
  count_uses(wanted);
  TapeCode code = steps_for(wanted);
  find_places(code);
  return code;
}

std::vector<TapeCode> TapeCompiler::code_for_parts(const std::vector<std::vector<TapeRef>>& wanted,
                                                   std::vector<std::vector<std::uint32_t>>& places) {
  const std::vector<bool> before = done_;
  std::vector<TapeRef> all;
  for (const auto& part : wanted) all.insert(all.end(), part.begin(), part.end());
  count_uses(all);
  std::vector<TapeCode> codes;
  for (const auto& part : wanted) codes.push_back(steps_for(part));

  // The last step that needs a result; for the results that a part wants, after its last step.
  std::vector<std::size_t> last(nodes_.size(), 0);
  std::size_t now = 0;
  const auto each_operand = [](const TapeCode& code, std::size_t step, const auto& see) {
    const std::size_t end = step + 1 < code.steps.size() ? code.steps[step + 1].terms : code.terms.size();
    for (std::size_t term = code.steps[step].terms; term < end; ++term) {
      see(code.terms[term].first);
      see(code.terms[term].second);
    }
  };
  for (std::size_t part = 0; part < codes.size(); ++part) {
    for (std::size_t step = 0; step < codes[part].steps.size(); ++step, ++now) {
      each_operand(codes[part], step, [&](TapeRef ref) { last[ref] = now; });
    }
    for (const TapeRef ref : wanted[part]) last[ref] = now++;
  }
  now = 0;
  const auto release = [&](TapeRef ref) {
    if (is_literal(ref) || before[ref] || last[ref] != now) return;
    last[ref] = std::numeric_limits<std::size_t>::max();
    unused_.push_back(places_[ref]);
  };
  places.assign(wanted.size(), {});
  for (std::size_t part = 0; part < codes.size(); ++part) {
    TapeCode placed = codes[part];
    for (std::size_t step = 0; step < codes[part].steps.size(); ++step, ++now) {
      each_operand(codes[part], step, release);
      placed.steps[step].target = place_for(codes[part].steps[step].target);
    }
    for (TapeTerm& term : placed.terms) term = {places_[term.first], places_[term.second]};
    for (const TapeRef ref : wanted[part]) places[part].push_back(place_for(ref));
    for (const TapeRef ref : wanted[part]) {
      release(ref);
      ++now;
    }
    codes[part] = std::move(placed);
  }
  return codes;
}

}  // namespace slipproof
