#include "floating/trade/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/crew/bytes.hpp"
#include "base/number/binary64.hpp"
#include "floating/trade/arithmetic.hpp"

namespace slipproof {

namespace {

/// Judges the relative errors of a motion.
void judge_motion(const TradeType& type, const JudgedValues<Rational>& found, const ExactAnswer& truth,
                  Accuracy& accuracy) {
  TradeRow& row = accuracy.row;
  ++row.judged;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Rational& expected = truth.values[i];
    if (expected.is_zero()) continue;
    const double error = nearest_binary64(Rational(abs((found[i] - expected) / expected)));
    const bool lossless = type.bits == 0 || error == 0;
    const double lost = lossless ? 0 : std::max(0.0, std::log10(error) + type.bits * std::log10(2.0));
    if (error > row.worst()) row.digits_lost = lost, row.condition = (*truth.conditions)[i];
    double& worst = i == 0 ? row.worst_acceleration : row.worst_force;
    worst = std::max(worst, error);
    accuracy.add((*truth.conditions)[i], lost);
  }
}

Accuracy judge_type(Arithmetic& arithmetic, const Workload& workload, const std::vector<ExactAnswer>& truths) {
  Accuracy accuracy;
  TradeRow& row = accuracy.row;
  row.scenes = truths.size();
  arithmetic.load(workload);
  const std::vector<ModeAt> all = arithmetic.decide();
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const ExactAnswer& truth = truths[i];
    const std::span found(&all[i * truth.status.size()], truth.status.size());
    const std::optional<Tier> tier = arithmetic.tier(i);
    const auto same = [&](ModeAt x, ModeAt y) {
      return tier ? x == y : (x == ModeAt::inconsistent) == (y == ModeAt::inconsistent);
    };
    const bool unsure = std::ranges::find(found, ModeAt::unsure) != found.end();
    if (tier) ++row.tiers[static_cast<std::size_t>(*tier)];
    const bool passed_on = tier == Tier::exact && arithmetic.type().bits > 0;
    if (unsure || passed_on) ++row.undecided;
    if (unsure) continue;
    if (!std::ranges::equal(found, truth.status, same)) {
      ++row.wrong;
    } else if (truth.conditions) {
      if (const auto motion = arithmetic.motion(i, *truth.only)) {
        judge_motion(arithmetic.type(), *motion, truth, accuracy);
      } else {
        ++row.undecided;
      }
    }
  }
  return accuracy;
}

constexpr std::array counts{&TradeRow::scenes, &TradeRow::wrong, &TradeRow::undecided, &TradeRow::judged};
constexpr std::array reals{&TradeRow::worst_acceleration, &TradeRow::worst_force, &TradeRow::digits_lost,
                           &TradeRow::condition};

}  // namespace

void Accuracy::add(double condition, double digits_lost) {
  if (!(condition < std::pow(10.0, decades.size()))) return;
  Cancellation& c = decades[static_cast<std::size_t>(std::max(0.0, std::floor(std::log10(condition))))];
  ++c.quantities;
  c.digits_lost = std::max(c.digits_lost, digits_lost);
  c.mean_digits_lost += digits_lost;
}

void Accuracy::tell_cancellations(const std::string& type, std::vector<Cancellation>& all) const {
  for (std::size_t i = 0; i < decades.size(); ++i) {
    const auto& [name, decade, quantities, worst, sum] = decades[i];
    if (quantities == 0) continue;
    all.push_back({type, static_cast<int>(i), quantities, worst, sum / static_cast<double>(quantities)});
  }
}

std::vector<Accuracy> judge_accuracy(const Workload& workload) {
  std::vector<ExactAnswer> truths;
  for (const TradeScene& scene : workload.scenes) truths.push_back(workload.mechanism->exact_with_conditions(scene));
  std::vector<Accuracy> types;
  for (const auto& arithmetic : all_arithmetics()) types.push_back(judge_type(*arithmetic, workload, truths));
  return types;
}

std::string accuracy_bytes(const std::vector<Accuracy>& types) {
  ByteWriter bytes;
  bytes.number(types.size());
  for (const auto& [row, decades] : types) {
    for (const auto count : counts) bytes.number(row.*count);
    for (const std::uint64_t count : row.tiers) bytes.number(count);
    for (const auto real : reals) bytes.real(row.*real);
    for (const Cancellation& c : decades) bytes.number(c.quantities).real(c.digits_lost).real(c.mean_digits_lost);
  }
  return bytes.take();
}

void add_accuracy(std::string_view text, std::vector<Accuracy>& types) {
  ByteReader bytes(text);
  const std::uint64_t count_of_types = bytes.number();
  for (std::size_t i = 0; i < count_of_types; ++i) {
    if (i == types.size()) types.emplace_back();
    auto& [row, decades] = types[i];
    for (const auto count : counts) row.*count += bytes.number();
    for (auto& count : row.tiers) count += bytes.number();
    TradeRow later;
    for (const auto real : reals) later.*real = bytes.real();
    if (later.worst() > row.worst()) row.digits_lost = later.digits_lost, row.condition = later.condition;
    row.worst_acceleration = std::max(row.worst_acceleration, later.worst_acceleration);
    row.worst_force = std::max(row.worst_force, later.worst_force);
    for (Cancellation& c : decades) {
      c.quantities += bytes.number();
      c.digits_lost = std::max(c.digits_lost, bytes.real());
      c.mean_digits_lost += bytes.real();
    }
  }
  bytes.end();
}

}  // namespace slipproof
