#include "report/scenes/trade_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/output/json.hpp"

namespace slipproof {

namespace {

/// JSON has no infinity, so null stands for it.
Json number(double x) {
  return std::isfinite(x) ? Json(x) : Json(nullptr);
}

Json row_json(const TradeRow& r) {
  Json row{{"workload", r.workload}, {"type", r.type},
           {"scenes", r.scenes},     {"scenes_per_second", number(std::round(r.scenes_per_second))},
           {"wrong", r.wrong},       {"undecided", r.undecided}};
  if (r.tiers != TierCounts{}) {
    for (std::size_t i = 0; i < tier_count; ++i) {
      row["tiers"][std::string(name(static_cast<Tier>(i)))] = r.tiers[i];
    }
  }
  row["judged"] = r.judged;
  row["worst_relative_error_a"] = number(r.worst_acceleration);
  row["worst_relative_error_forces"] = number(r.worst_force);
  row["digits_lost"] = number(r.digits_lost);
  row["condition"] = number(r.condition);
  return row;
}

}  // namespace

std::string trade_json(const Trade& trade) {
  Json document{{"schema", "slipproof/trade/1"},
                {"machine",
                 {{"processor", trade.machine.processor},
                  {"cores", trade.machine.cores},
                  {"compiler", trade.machine.compiler},
                  {"flags", trade.machine.flags}}},
                {"scenes", trade.options.scenes},
                {"seed", trade.options.seed},
                {"workloads", Json::array()},
                {"types", Json::array()},
                {"rows", Json::array()},
                {"cancellation", Json::array()}};
  for (const TradeWorkload& w : trade.workloads) {
    document["workloads"].push_back(
        {{"name", w.name}, {"threshold_bits", w.threshold_bits ? Json(*w.threshold_bits) : Json(nullptr)}});
  }
  for (const TradeType& t : trade.types) {
    document["types"].push_back({{"name", t.name}, {"bits", t.bits == 0 ? Json(nullptr) : Json(t.bits)}});
  }
  for (const TradeRow& r : trade.rows) document["rows"].push_back(row_json(r));
  for (const Cancellation& c : trade.cancellations) {
    document["cancellation"].push_back({{"type", c.type},
                                        {"condition_decade", c.decade},
                                        {"quantities", c.quantities},
                                        {"digits_lost", c.digits_lost},
                                        {"mean_digits_lost", c.mean_digits_lost}});
  }
  return json_text(document, 2) + '\n';
}

std::string trade_text(const Trade& trade) {
  const Machine& m = trade.machine;
  std::string text = fmt::format("{}, {} cores\n{}, {}\n{} scenes a workload, seed {}; CPU time of one thread\n",
                                 m.processor, m.cores, m.compiler, m.flags, trade.options.scenes, trade.options.seed);
  for (std::size_t i = 0; i < trade.rows.size(); ++i) {
    const TradeRow& r = trade.rows[i];
    if (i % trade.types.size() == 0) {
      text += fmt::format("\n{:<28}{:>11}{:>7}{:>11}{:>10}{:>14}{:>8}{:>11}\n", r.workload, "scenes/s", "wrong",
                          "undecided", "error a", "error forces", "digits", "condition");
    }
    text +=
        fmt::format("  {:<26}{:>11.3g}{:>7}{:>11}{:>10.2g}{:>14.2g}{:>8.1f}{:>11.2g}\n", r.type, r.scenes_per_second,
                    r.wrong, r.undecided, r.worst_acceleration, r.worst_force, r.digits_lost, r.condition);
  }
  text += fmt::format("\n{:<28}{:>11}{:>11}{:>15}{:>9}{:>11}{:>12}\n", "all workloads", "typical/s", "to exact",
                      "error typical", "wrong", "undecided", "wrong from");
  const TradeTotal exact = trade.total("exact");
  for (const TradeType& type : trade.types) {
    const TradeTotal t = trade.total(type.name);
    text += fmt::format("  {:<26}{:>11.3g}{:>10.1f}x{:>15.2g}{:>9}{:>11}{:>12}\n", type.name, t.typical_speed,
                        t.typical_speed / exact.typical_speed, t.typical_error, t.wrong, t.undecided,
                        t.first_wrong_bits ? fmt::format("2^-{}", *t.first_wrong_bits) : "never");
  }
  return text + fmt::format(
                    "\nOf {} scenes. wrong: another set of contact modes than the exact one. undecided: NaN or a "
                    "division by 0;\nfilter: passed on to the kernel, which decided. digits: decimal digits lost by "
                    "the worst value, whose condition\nnumber stands beside. wrong from: the distance from a threshold "
                    "from which on wrong answers occur.\n",
                    exact.scenes);
}

}  // namespace slipproof
