#include "precision/trade.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>

#include "number/binary64.hpp"
#include "parallel/stop.hpp"
#include "precision/arithmetic.hpp"
#include "precision/workload.hpp"

namespace slipproof {

namespace {

constexpr int highest_decade = 40;

/// Seconds that this thread has computed; other load on the machine does not count.
double cpu_time() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double scenes_per_second(const Arithmetic& arithmetic, std::size_t scenes, double seconds) {
  volatile unsigned sink = arithmetic.run();  // brings code and data near
  std::size_t passes = 0;
  double elapsed = 0;
  const double start = cpu_time();
  do {
    stop_if_asked();
    sink = arithmetic.run();
    ++passes;
    elapsed = cpu_time() - start;
  } while (elapsed < seconds || elapsed == 0);
  static_cast<void>(sink);
  return static_cast<double>(scenes * passes) / elapsed;
}

/// Digits lost by one type, by decade of the condition number.
class Cancellations {
 public:
  void add(double condition, double digits_lost) {
    if (!(condition < std::pow(10.0, highest_decade + 1))) return;
    const int decade = std::max(0, static_cast<int>(std::floor(std::log10(condition))));
    Cancellation& c = decades_[static_cast<std::size_t>(decade)];
    ++c.quantities;
    c.digits_lost = std::max(c.digits_lost, digits_lost);
    c.mean_digits_lost += digits_lost;
  }
  void append_to(std::vector<Cancellation>& all, const std::string& type) const {
    for (std::size_t i = 0; i < decades_.size(); ++i) {
      Cancellation c = decades_[i];
      if (c.quantities == 0) continue;
      c.type = type;
      c.decade = static_cast<int>(i);
      c.mean_digits_lost /= static_cast<double>(c.quantities);
      all.push_back(std::move(c));
    }
  }

 private:
  std::array<Cancellation, highest_decade + 1> decades_;
};

/// Relative errors of the motion of the one consistent mode.
void judge_motion(const Arithmetic& arithmetic, std::size_t scene, const Truth& truth, TradeRow& row,
                  Cancellations& cancellations) {
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
    if (error > std::max(row.worst_acceleration, row.worst_force)) {
      row.digits_lost = lost;
      row.condition = truth.conditions[i];
    }
    double& worst = judged_quantities[i] == Quantity::a ? row.worst_acceleration : row.worst_force;
    worst = std::max(worst, error);
    cancellations.add(truth.conditions[i], lost);
  }
}

TradeRow measure(Arithmetic& arithmetic, const Workload& workload, const std::vector<Truth>& truths, double seconds,
                 Cancellations& cancellations) {
  TradeRow row{.workload = workload.name, .type = arithmetic.type().name, .scenes = truths.size()};
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
      judge_motion(arithmetic, i, truth, row, cancellations);
    }
  }
  row.scenes_per_second = scenes_per_second(arithmetic, truths.size(), seconds);
  return row;
}

}  // namespace

bool Trade::sound() const {
  return std::none_of(rows.begin(), rows.end(), [](const TradeRow& r) { return r.type == "filter" && r.wrong != 0; });
}

std::vector<std::unique_ptr<Arithmetic>> all_arithmetics() {
  std::vector<std::unique_ptr<Arithmetic>> all;
  for (const auto make :
       {binary32_arithmetic, binary64_arithmetic, long_double_arithmetic, binary128_arithmetic, mpfr50_arithmetic,
        mpfr100_arithmetic, mpfr200_arithmetic, filter_arithmetic, exact_arithmetic}) {
    all.push_back(make());
  }
  return all;
}

Trade measure_trade(const TradeOptions& options, const std::function<void(std::size_t, std::size_t)>& progress) {
  Trade trade{options, this_machine(), {}, {}, {}, {}};
  const Workloads workloads(options.scenes, options.seed);
  const auto arithmetics = all_arithmetics();
  std::vector<Cancellations> cancellations(arithmetics.size());
  for (const auto& arithmetic : arithmetics) trade.types.push_back(arithmetic->type());
  for (std::size_t w = 0; w < workloads.size(); ++w) {
    const Workload workload = workloads.make(w);
    trade.workloads.push_back(workload);
    std::vector<Truth> truths;
    for (const auto& scene : workload.scenes) truths.push_back(truth_of(scene));
    for (std::size_t i = 0; i < arithmetics.size(); ++i) {
      trade.rows.push_back(measure(*arithmetics[i], workload, truths, options.seconds, cancellations[i]));
      if (progress) progress(trade.rows.size(), arithmetics.size() * workloads.size());
    }
  }
  for (std::size_t i = 0; i < arithmetics.size(); ++i) {
    cancellations[i].append_to(trade.cancellations, arithmetics[i]->type().name);
  }
  return trade;
}

}  // namespace slipproof
