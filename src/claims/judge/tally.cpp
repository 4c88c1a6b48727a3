#include "claims/judge/tally.hpp"

#include <algorithm>
#include <tuple>

#include "claims/sampling/sampler.hpp"

namespace slipproof {

namespace {

void write_first(ByteWriter& bytes, const FirstSamples& first) {
  bytes.number(first.numbers().size());
  for (const std::uint64_t i : first.numbers()) bytes.number(i);
}

FirstSamples read_first(ByteReader& bytes) {
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t left = bytes.number(); left > 0; --left) numbers.push_back(bytes.number());
  FirstSamples first;
  first.add(numbers);
  return first;
}

Simplest read_simplest(ByteReader& bytes) {
  Simplest simplest;
  if (const auto values = bytes.rationals(); !values.empty()) simplest.keep(values, complexity(values));
  return simplest;
}

}  // namespace

void FirstSamples::add(std::span<const std::uint64_t> others) {
  numbers_.insert(numbers_.end(), others.begin(), others.end());
  std::sort(numbers_.begin(), numbers_.end());
  if (numbers_.size() > max_bases) numbers_.resize(max_bases);
}

void Simplest::keep(const std::vector<Rational>& other, const Complexity& c) {
  if (!values.empty() && !(std::tie(c, other) < std::tie(its_complexity, values))) return;
  values = other;
  its_complexity = c;
}

void Tally::add(const Judgement& judgement, const CompiledSetting& setting, const std::vector<Rational>& values) {
  const Outcome outcome = judgement.outcome;
  ++tried;
  if (judgement.reason == Reason::unsure) ++unsure;
  if (outcome == Outcome::holds) ++held;
  if (outcome == Outcome::undecided) ++undecided;
  if (outcome != Outcome::refuted) return;
  ++refuted;
  const Complexity c = complexity(values);
  simplest.keep(values, c);
  if (unrealisable(setting, values).empty()) realisable.keep(values, c);
}

void Tally::add(const Tally& other) {
  tried += other.tried;
  lines += other.lines;
  cells += other.cells;
  held_at.add(other.held_at.numbers());
  speaks_at.add(other.speaks_at.numbers());
  held += other.held;
  refuted += other.refuted;
  undecided += other.undecided;
  unsure += other.unsure;
  simplest.keep(other.simplest);
  realisable.keep(other.realisable);
  fail(other.failure);
}

void Tally::fail(const std::string& why) {
  if (!why.empty() && (failure.empty() || why < failure)) failure = why;
}

void write_tally(ByteWriter& bytes, const Tally& tally) {
  for (const std::uint64_t count :
       {tally.tried, tally.held, tally.refuted, tally.undecided, tally.unsure, tally.lines, tally.cells}) {
    bytes.number(count);
  }
  write_first(bytes, tally.held_at);
  write_first(bytes, tally.speaks_at);
  bytes.rationals(tally.simplest.values).rationals(tally.realisable.values).text(tally.failure);
}

Tally read_tally(ByteReader& bytes) {
  Tally tally;
  for (std::uint64_t* count :
       {&tally.tried, &tally.held, &tally.refuted, &tally.undecided, &tally.unsure, &tally.lines, &tally.cells}) {
    *count = bytes.number();
  }
  tally.held_at = read_first(bytes);
  tally.speaks_at = read_first(bytes);
  tally.simplest = read_simplest(bytes);
  tally.realisable = read_simplest(bytes);
  tally.failure = bytes.text();
  return tally;
}

}  // namespace slipproof
