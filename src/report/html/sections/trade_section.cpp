#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "report/html/sections.hpp"
#include "report/planes/scatter.hpp"

namespace slipproof {

namespace {

bool ours(const std::string& type) {
  return type == "filter" || type == "exact";
}

std::string rounded(double x) {
  return std::isfinite(x) ? fmt::format("{:.3g}", x) : "∞";
}

void add_matrix(const Element& parent, const Trade& trade) {
  const Element scroll = parent.add("div", "scroll").set("tabindex", 0).set("role", "region");
  scroll.set("aria-label", "Wrong verdicts by workload and number type");
  const Element table = scroll.add("table", "trade");
  table.add("caption").text("Wrong verdicts: scenes whose set of contact modes is not the exact one, of " +
                            std::to_string(trade.options.scenes) + " in each workload");
  const Element head = table.add("thead").add("tr");
  head.add("th").set("scope", "col").text("workload");
  for (const TradeType& type : trade.types) head.add("th").set("scope", "col").text(type.name);
  const Element body = table.add("tbody");
  for (std::size_t w = 0; w < trade.workloads.size(); ++w) {
    const Element row = body.add("tr");
    row.add("th").set("scope", "row").text(trade.workloads[w].name);
    for (std::size_t t = 0; t < trade.types.size(); ++t) {
      const TradeRow& cell = trade.rows[w * trade.types.size() + t];
      row.add("td", cell.wrong == 0 ? "number none" : "number alarm").text(std::to_string(cell.wrong));
    }
  }
}

/// Why a type with more digits may have more wrong verdicts than one with fewer.
void add_ties(const Element& parent, const Trade& trade) {
  for (std::size_t t = 0; t + 1 < trade.types.size(); ++t) {
    const TradeType &less = trade.types[t], &more = trade.types[t + 1];
    const std::size_t few = trade.total(less.name).wrong, many = trade.total(more.name).wrong;
    if (ours(more.name) || more.bits <= less.bits || many <= few) continue;
    parent.add("p", "evidence")
        .text(
            fmt::format("{} has more wrong verdicts ({}) than {} ({}), and that is no error of measurement. What is "
                        "left are ties: forces exactly on a threshold, where a condition holds with equality. Rounding "
                        "makes of that equality a small number of either sign, by chance; more digits make it smaller, "
                        "not zero. Only exact arithmetic can tell that there is a tie.",
                        more.name, many, less.name, few));
    return;
  }
}

void add_details(const Element& parent, const Trade& trade) {
  const Element details = parent.add("details", "data");
  details.add("summary").text("All measurements");
  const Element scroll = details.add("div", "scroll").set("tabindex", 0).set("role", "region");
  scroll.set("aria-label", "All measurements");
  const Element table = scroll.add("table");
  const Element head = table.add("thead").add("tr");
  for (const char* name : {"workload", "type", "scenes/s", "wrong", "undecided", "worst error of a",
                           "worst error of forces", "digits lost", "condition"}) {
    head.add("th").set("scope", "col").text(name);
  }
  const Element body = table.add("tbody");
  for (const TradeRow& r : trade.rows) {
    const Element row = body.add("tr");
    row.add("th").set("scope", "row").text(r.workload);
    row.add("td").text(r.type);
    for (const std::string& value :
         {rounded(r.scenes_per_second), std::to_string(r.wrong), std::to_string(r.undecided),
          rounded(r.worst_acceleration), rounded(r.worst_force), rounded(r.digits_lost), rounded(r.condition)}) {
      row.add("td", "number").text(value);
    }
  }
}

}  // namespace

void add_trade_plot(const Element& parent, const Trade& trade, bool errors, bool small) {
  Scatter scatter;
  scatter.title = errors ? "Speed against the largest relative error on typical scenes"
                         : "Speed against the share of wrong verdicts over all workloads";
  scatter.x_name = "scenes a second, one thread";
  scatter.y_name = errors ? "largest relative error" : "share of wrong verdicts";
  if (small) scatter.width = 520, scatter.height = 330;
  for (const TradeType& type : trade.types) {
    const TradeTotal t = trade.total(type.name);
    const double share = t.scenes == 0 ? 0 : static_cast<double>(t.wrong) / static_cast<double>(t.scenes);
    scatter.dots.push_back({type.name, t.typical_speed, errors ? t.typical_error : share, ours(type.name)});
  }
  add_scatter(parent, scatter);
}

void add_trade_section(const Element& main, const PageInput& input) {
  if (!input.trade || input.trade->workloads.empty()) return;
  const Element section = add_section(main, "trade", "Speed and accuracy");
  const Trade& trade = *input.trade;
  section.add("p", "lead")
      .text(
          "The same scenes in every number type, from typical bicycles to forces that are exactly on a "
          "threshold. What the filter decides in binary64 is proved to be the exact answer; what it cannot "
          "decide goes on to exact arithmetic.");
  const Element grid = section.add("div", "grid");
  for (const bool errors : {false, true}) {
    const Element figure = grid.add("figure", "phase small");
    figure.add("h3").text(errors ? "Speed and error" : "Speed and wrong verdicts");
    add_trade_plot(figure.add("div", "plot"), trade, errors, true);
    figure.add("figcaption")
        .text(errors ? "The largest relative error of an acceleration or a force, where the modes are right, on " +
                           trade.workloads.front().name + ". To the right is faster, down is better."
                     : "Wrong sets of contact modes over all workloads. To the right is faster, down is better.");
  }
  add_ties(section, trade);
  add_matrix(section, trade);
  add_details(section, trade);
  section.add("p", "how")
      .text(fmt::format("Measured on {}, {} cores; {}, {}; {} scenes in each workload, seed {}. "
                        "Times are of that machine; everything else is the same on any.",
                        trade.machine.processor, trade.machine.cores, trade.machine.compiler, trade.machine.flags,
                        trade.options.scenes, trade.options.seed));
}

}  // namespace slipproof
