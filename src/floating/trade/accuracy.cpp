#include "floating/trade/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/crew/bytes.hpp"
#include "base/number/binary64.hpp"
#include "floating/trade/arithmetic.hpp"

namespace slipproof {

namespace {

/// Relative errors of the motion of the one consistent mode.
void judge_motion(const Arithmetic& arithmetic, std::size_t scene, const Truth& truth, Accuracy& accuracy) {
  TradeRow& row = accuracy.row;
  const auto values = arithmetic.motion(scene, *truth.only);
  if (std::any_of(values.begin(), values.end(), [](const auto& x) { return !x; })) {
    ++row.undecided;
    return;
  }
  ++row.judged;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (truth.values[i].is_zero()) continue;
    const double error = nearest_binary64(Rational(abs((*values[i] - truth.values[i]) / truth.values[i])));
    const double lost = arithmetic.type().bits == 0 || error == 0
                            ? 0
                            : std::max(0.0, std::log10(error) + arithmetic.type().bits * std::log10(2.0));
    if (error > row.worst()) {
      row.digits_lost = lost;
      row.condition = truth.conditions[i];
    }
    double& worst = judged_quantities[i] == Quantity::a ? row.worst_acceleration : row.worst_force;
    worst = std::max(worst, error);
    accuracy.cancellations.add(truth.conditions[i], lost);
  }
}

Accuracy judge_type(Arithmetic& arithmetic, const Workload& workload, const std::vector<Truth>& truths) {
  Accuracy accuracy;
  TradeRow& row = accuracy.row;
  row.scenes = truths.size();
  arithmetic.load(workload.scenes);
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const Truth& truth = truths[i];
    const auto answer = arithmetic.answer(i);
    if (answer.tier) ++row.tiers[static_cast<std::size_t>(*answer.tier)];
    if (!answer.decided) ++row.undecided;
    if (!answer.decided && !answer.tier) continue;
    if (answer.consistent != truth.modes.consistent || (answer.strict && *answer.strict != truth.modes.strict)) {
      ++row.wrong;
    } else if (truth.only) {
      judge_motion(arithmetic, i, truth, accuracy);
    }
  }
  return accuracy;
}

}  // namespace

void Cancellations::add(double condition, double digits_lost) {
  if (!(condition < std::pow(10.0, decade_count))) return;
  const int decade = std::max(0, static_cast<int>(std::floor(std::log10(condition))));
  Cancellation& c = decades_[static_cast<std::size_t>(decade)];
  ++c.quantities;
  c.digits_lost = std::max(c.digits_lost, digits_lost);
  c.mean_digits_lost += digits_lost;
}

void Cancellations::add(const Cancellations& later) {
  for (std::size_t i = 0; i < decades_.size(); ++i) {
    decades_[i].quantities += later.decades_[i].quantities;
    decades_[i].digits_lost = std::max(decades_[i].digits_lost, later.decades_[i].digits_lost);
    decades_[i].mean_digits_lost += later.decades_[i].mean_digits_lost;
  }
}

void Cancellations::append_to(std::vector<Cancellation>& all, const std::string& type) const {
  for (std::size_t i = 0; i < decades_.size(); ++i) {
    Cancellation c = decades_[i];
    if (c.quantities == 0) continue;
    c.type = type;
    c.decade = static_cast<int>(i);
    c.mean_digits_lost /= static_cast<double>(c.quantities);
    all.push_back(std::move(c));
  }
}

void Accuracy::add(const Accuracy& later) {
  const TradeRow& r = later.row;
  row.scenes += r.scenes;
  row.wrong += r.wrong;
  row.undecided += r.undecided;
  for (std::size_t i = 0; i < tier_count; ++i) row.tiers[i] += r.tiers[i];
  row.judged += r.judged;
  if (r.worst() > row.worst()) row.digits_lost = r.digits_lost, row.condition = r.condition;
  row.worst_acceleration = std::max(row.worst_acceleration, r.worst_acceleration);
  row.worst_force = std::max(row.worst_force, r.worst_force);
  cancellations.add(later.cancellations);
}

std::vector<Accuracy> judge_accuracy(const Workload& workload) {
  std::vector<Truth> truths;
  for (const auto& scene : workload.scenes) truths.push_back(truth_of(scene));
  std::vector<Accuracy> types;
  for (const auto& arithmetic : all_arithmetics()) types.push_back(judge_type(*arithmetic, workload, truths));
  return types;
}

std::string accuracy_bytes(const std::vector<Accuracy>& types) {
  ByteWriter bytes;
  bytes.number(types.size());
  for (const auto& [row, cancellations] : types) {
    bytes.number(row.scenes).number(row.wrong).number(row.undecided).number(row.judged);
    for (const std::uint64_t count : row.tiers) bytes.number(count);
    bytes.real(row.worst_acceleration).real(row.worst_force).real(row.digits_lost).real(row.condition);
    for (const Cancellation& c : cancellations.decades_) {
      bytes.number(c.quantities);
      if (c.quantities != 0) bytes.real(c.digits_lost).real(c.mean_digits_lost);
    }
  }
  return bytes.take();
}

std::vector<Accuracy> read_accuracy(std::string_view text) {
  ByteReader bytes(text);
  std::vector<Accuracy> types;
  for (std::uint64_t left = bytes.number(); left > 0; --left) {
    auto& [row, cancellations] = types.emplace_back();
    for (std::size_t* count : {&row.scenes, &row.wrong, &row.undecided, &row.judged}) *count = bytes.number();
    for (auto& count : row.tiers) count = bytes.number();
    for (double* value : {&row.worst_acceleration, &row.worst_force, &row.digits_lost, &row.condition}) {
      *value = bytes.real();
    }
    for (Cancellation& c : cancellations.decades_) {
      c.quantities = bytes.number();
      if (c.quantities != 0) c.digits_lost = bytes.real(), c.mean_digits_lost = bytes.real();
    }
  }
  bytes.end();
  return types;
}

}  // namespace slipproof
