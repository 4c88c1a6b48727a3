#include "report/scenes/trade_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/values/exact_json.hpp"

namespace slipproof {

namespace {

/// JSON has no infinity: null.
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

std::string rounded(double x, int digits) {
  return std::isfinite(x) ? fmt::format("{:.{}g}", x, digits) : "oo";
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
  return dump(document);
}

TradeTotal total(const Trade& trade, const std::string& type) {
  TradeTotal t;
  for (std::size_t i = 0; i < trade.rows.size(); ++i) {
    const TradeRow& r = trade.rows[i];
    if (r.type != type) continue;
    const std::size_t workload = i / trade.types.size();
    t.scenes += r.scenes;
    t.wrong += r.wrong;
    t.undecided += r.undecided;
    if (workload == 0) {
      t.typical_speed = r.scenes_per_second;
      t.typical_error = std::max(r.worst_acceleration, r.worst_force);
    }
    const auto& bits = trade.workloads[workload].threshold_bits;
    if (bits && r.wrong != 0 && !t.first_wrong_bits) t.first_wrong_bits = bits;
  }
  return t;
}

std::vector<ReportTable> workload_tables(const Trade& trade) {
  std::vector<ReportTable> tables;
  for (std::size_t w = 0; w < trade.workloads.size(); ++w) {
    const std::string& name = trade.workloads[w].name;
    ReportTable table{{{name, false, 26},
                       {"scenes/s", true, 9},
                       {"wrong", true},
                       {"undecided", true},
                       {"error a", true, 8},
                       {"error forces", true},
                       {"digits", true},
                       {"condition", true}}};
    for (std::size_t t = 0; t < trade.types.size(); ++t) {
      const TradeRow& r = trade.rows[w * trade.types.size() + t];
      table.row({r.type, rounded(r.scenes_per_second, 3), TableCell::count(r.wrong, true),
                 TableCell::count(r.undecided), rounded(r.worst_acceleration, 2), rounded(r.worst_force, 2),
                 rounded(r.digits_lost, 2), rounded(r.condition, 2)});
    }
    table.label = "Measurements: " + name;
    tables.push_back(std::move(table));
  }
  return tables;
}

Document trade_document(const Trade& trade) {
  const Machine& m = trade.machine;
  Document document;
  document.title("Speed and accuracy");
  document.line(fmt::format("{}, {} cores", m.processor, m.cores));
  document.line(m.compiler + ", " + m.flags);
  document.line(
      fmt::format("{} scenes a workload, seed {}; CPU time of one thread", trade.options.scenes, trade.options.seed));
  for (ReportTable& table : workload_tables(trade)) document.table(std::move(table));
  ReportTable& table = document.table({{{"all workloads", false, 26},
                                        {"typical/s", true},
                                        {"to exact", true, 9},
                                        {"error typical", true},
                                        {"wrong", true, 7},
                                        {"undecided", true},
                                        {"wrong from", true}}});
  const TradeTotal exact = total(trade, "exact");
  for (const TradeType& type : trade.types) {
    const TradeTotal t = total(trade, type.name);
    table.row({type.name, rounded(t.typical_speed, 3), fmt::format("{:.1f}x", t.typical_speed / exact.typical_speed),
               rounded(t.typical_error, 2), TableCell::count(t.wrong, true), TableCell::count(t.undecided),
               t.first_wrong_bits ? fmt::format("2^-{}", *t.first_wrong_bits) : "never"});
  }
  document.paragraph(
      fmt::format("Of {} scenes. wrong: another set of contact modes than the exact one. undecided: NaN or a division "
                  "by 0; filter: "
                  "passed on to a later tier, which decided. digits: decimal digits lost by the worst value, whose "
                  "condition number "
                  "follows. wrong from: the distance from a threshold from which on wrong answers occur.",
                  exact.scenes));
  document.status(fmt::format(
      "s {} workloads {} types {} scenes {}",
      trade.sound() ? "MEASURED" : "REFUTED the filter differs from the exact answer:", trade.workloads.size(),
      trade.types.size(), trade.workloads.size() * trade.options.scenes));
  return document;
}

}  // namespace slipproof
