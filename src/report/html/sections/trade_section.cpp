#include <fmt/format.h>

#include <string>

#include "report/html/sections.hpp"
#include "report/planes/scatter.hpp"
#include "report/scenes/trade_report.hpp"

namespace slipproof {

namespace {

bool ours(const std::string& type) {
  return type == "filter" || type == "exact";
}

void add_matrix(const Element& parent, const Trade& trade) {
  ReportTable table{{"workload"}};
  for (const TradeType& type : trade.types) table.columns.emplace_back(type.name, true);
  for (std::size_t w = 0; w < trade.workloads.size(); ++w) {
    std::vector<ReportCell> cells{trade.workloads[w].name};
    for (std::size_t t = 0; t < trade.types.size(); ++t) {
      cells.push_back(ReportCell::count(trade.rows[w * trade.types.size() + t].wrong, true));
    }
    table.row(std::move(cells));
  }
  table.label = "Wrong verdicts by workload and number type";
  table.caption = "Wrong verdicts: scenes whose set of contact modes is not the exact one, of " +
                  std::to_string(trade.options.scenes) + " in each workload";
  table.css_class = "trade";
  add_table(parent, table);
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
    add_trade_plot(figure.add("div", "plot").set("tabindex", 0), trade, errors, true);
    figure.add("figcaption")
        .text(errors ? "The largest relative error of an acceleration or a force, where the modes are right, on " +
                           trade.workloads.front().name + ". To the right is faster, down is better."
                     : "Wrong sets of contact modes over all workloads. To the right is faster, down is better.");
  }
  add_ties(section, trade);
  add_matrix(section, trade);
  Document all;
  Document& measurements = all.details("All measurements");
  for (ReportTable& table : workload_tables(trade)) measurements.table(std::move(table));
  add_document(section, all);
  section.add("p", "how")
      .text(fmt::format("Measured on {}, {} cores; {}, {}; {} scenes in each workload, seed {}. "
                        "Times are of that machine; everything else is the same on any.",
                        trade.machine.processor, trade.machine.cores, trade.machine.compiler, trade.machine.flags,
                        trade.options.scenes, trade.options.seed));
}

}  // namespace slipproof
