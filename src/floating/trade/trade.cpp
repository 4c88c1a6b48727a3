#include "floating/trade/trade.hpp"

#include <time.h>

#include <algorithm>

#include "base/crew/bytes.hpp"
#include "base/crew/crew.hpp"
#include "base/parallel/in_parallel.hpp"
#include "floating/trade/accuracy.hpp"
#include "floating/trade/arithmetic.hpp"
#include "floating/trade/workload.hpp"

namespace slipproof {

namespace {

/// CPU seconds of this thread; other load on the machine does not count.
double cpu_time() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double scenes_per_second(Arithmetic& arithmetic, std::size_t scenes, double seconds) {
  arithmetic.decide();  // fills the caches with code and data
  std::size_t passes = 0;
  double elapsed = 0;
  const double start = cpu_time();
  do {
    stop_if_asked();
    arithmetic.decide();
    ++passes;
    elapsed = cpu_time() - start;
  } while (elapsed < seconds || elapsed == 0);
  return static_cast<double>(scenes * passes) / elapsed;
}

/// By type: the result for each workload, then for all workloads together.
struct JudgedTrade {
  std::vector<std::vector<Accuracy>> workloads;
  std::vector<Accuracy> together;
};

/// A request is the number of a piece; the pieces of the first workload come first, then those of the second, ...
JudgedTrade judge_pieces(const TradeOptions& options, const Workloads& workloads, const std::function<void()>& done,
                         Crew* crew) {
  JudgedTrade all;
  all.workloads.resize(Workloads::size());
  const auto take = [&](std::uint64_t i, const std::string& result) {
    add_accuracy(result, all.workloads[i / workloads.pieces()]);
    add_accuracy(result, all.together);
    done();
  };
  on_threads(options.threads, [&] {
    share(
        crew, [&](std::string_view request) { return trade_answer(options, request); },
        workloads.size() * workloads.pieces(), [](std::uint64_t i) { return ByteWriter().number(i).take(); }, take,
        true);
  });
  return all;
}

}  // namespace

bool Trade::sound() const {
  return std::none_of(rows.begin(), rows.end(), [](const TradeRow& r) { return r.type == "filter" && r.wrong != 0; });
}

TradeTotal Trade::total(const std::string& type) const {
  TradeTotal t;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const TradeRow& r = rows[i];
    if (r.type != type) continue;
    const std::size_t workload = i / types.size();
    t.scenes += r.scenes;
    t.wrong += r.wrong;
    t.undecided += r.undecided;
    if (workload == 0) {
      t.typical_speed = r.scenes_per_second;
      t.typical_error = std::max(r.worst_acceleration, r.worst_force);
    }
    const auto& bits = workloads[workload].threshold_bits;
    if (bits && r.wrong != 0 && !t.first_wrong_bits) t.first_wrong_bits = bits;
  }
  return t;
}

std::string trade_answer(const TradeOptions& options, std::string_view request) {
  ByteReader bytes(request);
  const std::uint64_t number = bytes.number();
  bytes.end();
  const Workloads workloads{options.scenes, options.seed};
  return accuracy_bytes(judge_accuracy(workloads.make(number / workloads.pieces(), number % workloads.pieces())));
}

Trade measure_trade(const TradeOptions& options, const std::function<void(std::size_t, std::size_t)>& progress,
                    Crew* crew) {
  Trade trade{options, this_machine(), {}, {}, {}, {}};
  const Workloads workloads{options.scenes, options.seed};
  const auto arithmetics = all_arithmetics();
  for (const auto& arithmetic : arithmetics) trade.types.push_back(arithmetic->type());
  std::size_t done = 0;
  const auto one_more = [&] {
    if (progress) progress(++done, (workloads.pieces() + arithmetics.size()) * workloads.size());
  };
  const JudgedTrade judged = judge_pieces(options, workloads, one_more, crew);
  for (std::size_t w = 0; w < workloads.size(); ++w) {
    const Workload workload = workloads.make(w);
    trade.workloads.push_back(workload);
    for (std::size_t t = 0; t < arithmetics.size(); ++t) {
      TradeRow& row = trade.rows.emplace_back(judged.workloads[w].at(t).row);
      row.workload = workload.name;
      row.type = trade.types[t].name;
      arithmetics[t]->load(workload);
      row.scenes_per_second = scenes_per_second(*arithmetics[t], workload.scenes.size(), options.seconds);
      one_more();
    }
  }
  for (std::size_t t = 0; t < arithmetics.size(); ++t) {
    judged.together.at(t).tell_cancellations(trade.types[t].name, trade.cancellations);
  }
  return trade;
}

}  // namespace slipproof
