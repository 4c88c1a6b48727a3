#include "floating/trade/trade.hpp"

#include <time.h>

#include <algorithm>
#include <utility>

#include "base/crew/bytes.hpp"
#include "base/crew/share.hpp"
#include "base/parallel/in_parallel.hpp"
#include "floating/trade/accuracy.hpp"
#include "floating/trade/arithmetic.hpp"
#include "floating/trade/workload.hpp"

namespace slipproof {

namespace {

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

/// The rows of all types over all workloads, and what they lost.
struct JudgedTrade {
  std::vector<std::vector<Accuracy>> workloads;
  std::vector<Cancellations> cancellations;
};

/// A request is the number of a piece: those of the first workload, of the second, ...
JudgedTrade judge_pieces(const TradeOptions& options, const Workloads& workloads, const std::function<void()>& done,
                         Crew* crew) {
  JudgedTrade all;
  all.workloads.resize(workloads.size());
  const auto take = [&](std::uint64_t i, const std::string& result) {
    std::vector<Accuracy> piece = read_accuracy(result);
    std::vector<Accuracy>& sum = all.workloads[i / workloads.pieces()];
    all.cancellations.resize(piece.size());
    for (std::size_t t = 0; t < piece.size(); ++t) {
      all.cancellations[t].add(piece[t].cancellations);
      if (!sum.empty()) sum[t].add(piece[t]);
    }
    if (sum.empty()) sum = std::move(piece);
    done();
  };
  on_threads(options.threads, [&] {
    share(
        crew, [&](std::string_view request) { return trade_answer(options, request); },
        workloads.size() * workloads.pieces(), [](std::uint64_t i) { return ByteWriter().number(i).take(); }, take,
        Taking::in_order);
  });
  return all;
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

std::string trade_answer(const TradeOptions& options, std::string_view request) {
  ByteReader bytes(request);
  const std::uint64_t number = bytes.number();
  bytes.end();
  const Workloads workloads(options.scenes, options.seed);
  return accuracy_bytes(judge_accuracy(workloads.make(number / workloads.pieces(), number % workloads.pieces())));
}

Trade measure_trade(const TradeOptions& options, const std::function<void(std::size_t, std::size_t)>& progress,
                    Crew* crew) {
  Trade trade{options, this_machine(), {}, {}, {}, {}};
  const Workloads workloads(options.scenes, options.seed);
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
      if (crew != nullptr) crew->stop_if_asked();
      TradeRow& row = trade.rows.emplace_back(judged.workloads[w].at(t).row);
      row.workload = workload.name;
      row.type = trade.types[t].name;
      arithmetics[t]->load(workload.scenes);
      row.scenes_per_second = scenes_per_second(*arithmetics[t], workload.scenes.size(), options.seconds);
      one_more();
    }
  }
  for (std::size_t t = 0; t < arithmetics.size(); ++t) {
    judged.cancellations[t].append_to(trade.cancellations, trade.types[t].name);
  }
  return trade;
}

}  // namespace slipproof
