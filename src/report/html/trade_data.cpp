#include "report/html/trade_data.hpp"

#include <limits>

#include "base/input/diagnostic.hpp"
#include "base/input/text_file.hpp"
#include "base/output/json.hpp"

namespace slipproof {

namespace {

/// JSON has no infinity, so null stands for it.
double number(const Json& value) {
  return value.is_null() ? std::numeric_limits<double>::infinity() : value.get<double>();
}

Trade from_json(const Json& document) {
  if (document.at("schema") != "slipproof/trade/1") throw std::runtime_error("expected schema slipproof/trade/1");
  Trade trade;
  trade.options.scenes = document.at("scenes");
  trade.options.seed = document.at("seed");
  const Json& machine = document.at("machine");
  trade.machine = {machine.at("processor"), machine.at("compiler"), machine.at("flags"), machine.at("cores")};
  for (const Json& w : document.at("workloads")) {
    const Json& bits = w.at("threshold_bits");
    trade.workloads.push_back({w.at("name"), bits.is_null() ? std::nullopt : std::optional<int>(bits.get<int>())});
  }
  for (const Json& t : document.at("types")) {
    trade.types.push_back({t.at("name"), t.at("bits").is_null() ? 0 : t.at("bits").get<int>()});
  }
  for (const Json& r : document.at("rows")) {
    TradeRow row;
    row.workload = r.at("workload");
    row.type = r.at("type");
    row.scenes = r.at("scenes");
    row.scenes_per_second = number(r.at("scenes_per_second"));
    row.wrong = r.at("wrong");
    row.undecided = r.at("undecided");
    row.judged = r.at("judged");
    row.worst_acceleration = number(r.at("worst_relative_error_a"));
    row.worst_force = number(r.at("worst_relative_error_forces"));
    row.digits_lost = number(r.at("digits_lost"));
    row.condition = number(r.at("condition"));
    trade.rows.push_back(std::move(row));
  }
  if (trade.rows.size() != trade.workloads.size() * trade.types.size()) {
    throw std::runtime_error("expected a row for each type on each workload");
  }
  return trade;
}

}  // namespace

Trade read_trade(const std::filesystem::path& path) {
  const std::string text = read_text_file(path);
  try {
    return from_json(Json::parse(text));
  } catch (const std::exception& error) {
    throw InputError({{path.string(), 0, 0, std::string("no output of slipproof trade --json: ") + error.what()}});
  }
}

}  // namespace slipproof
