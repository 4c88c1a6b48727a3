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

/// HTML has a sign for infinity.
ReportSpan rounded(double x, const char* form) {
  const std::string text = fmt::format(fmt::runtime(form), x);
  return std::isinf(x) ? drawn(text, [](const Element& parent) { parent.text("∞"); }) : ReportSpan(text);
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
      table.row({r.type, rounded(r.scenes_per_second, "{:.3g}"), ReportCell::count(r.wrong, true),
                 ReportCell::count(r.undecided), rounded(r.worst_acceleration, "{:.2g}"),
                 rounded(r.worst_force, "{:.2g}"), rounded(r.digits_lost, "{:.1f}"), rounded(r.condition, "{:.2g}")});
    }
    table.label = "Measurements: " + name;
    table.titled = true;
    tables.push_back(std::move(table));
  }
  return tables;
}

Document trade_document(const Trade& trade) {
  const Machine& m = trade.machine;
  Document document;
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
  table.titled = true;
  const TradeTotal exact = trade.total("exact");
  for (const TradeType& type : trade.types) {
    const TradeTotal t = trade.total(type.name);
    table.row({type.name, rounded(t.typical_speed, "{:.3g}"), rounded(t.typical_speed / exact.typical_speed, "{:.1f}x"),
               rounded(t.typical_error, "{:.2g}"), ReportCell::count(t.wrong, true), ReportCell::count(t.undecided),
               t.first_wrong_bits ? fmt::format("2^-{}", *t.first_wrong_bits) : "never"});
  }
  document.paragraph(fmt::format(
      "Of {} scenes. wrong: another set of contact modes than the exact one. undecided: NaN or a division by 0; "
      "filter: passed on to the kernel, which decided. digits: decimal digits lost by the worst value, whose condition "
      "number stands beside. wrong from: the distance from a threshold from which on wrong answers occur.",
      exact.scenes));
  document.status(fmt::format(
      "s {} workloads {} types {} scenes {}",
      trade.sound() ? "MEASURED" : "REFUTED the filter differs from the exact answer:", trade.workloads.size(),
      trade.types.size(), trade.workloads.size() * trade.options.scenes));
  return document;
}

}  // namespace slipproof
