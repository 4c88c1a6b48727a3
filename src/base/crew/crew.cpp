#include "base/crew/crew.hpp"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <utility>

#include "base/crew/bytes.hpp"
#include "base/number/flint_memory.hpp"
#include "base/parallel/in_parallel.hpp"

namespace slipproof {

namespace {

constexpr std::chrono::milliseconds patience{5};
constexpr std::chrono::seconds flush_after{60}, most_without_rank_0{2};

std::string list_request(std::uint64_t list) {
  return "list " + std::to_string(list);
}

}  // namespace

Crew::Crew(CrewOptions options, Service service) : options_(std::move(options)), service_(std::move(service)) {
  for (int rank = 0; rank < options_.ranks || std::filesystem::exists(journal_of(rank)); ++rank) {
    const auto access = rank == options_.rank ? Journal::Access::write : Journal::Access::read;
    journals_.emplace(rank, Journal(journal_of(rank), options_.work, access));
  }
  while (options_.rank == 0 && own().has(list_request(lists_))) ++lists_;
}

std::filesystem::path Crew::journal_of(int rank) const {
  std::filesystem::path journal = options_.checkpoint;
  return rank == 0 ? journal : journal += '.' + std::to_string(rank);
}

void Crew::refresh() {
  const std::scoped_lock lock(mutex_);
  for (auto& [rank, journal] : journals_) {
    if (rank != options_.rank) journal.refresh();
  }
}

std::optional<std::string> Crew::find(std::string_view request) const {
  const std::scoped_lock lock(mutex_);
  const auto found = std::ranges::find_if(journals_, [&](const auto& journal) { return journal.second.has(request); });
  return found == journals_.end() ? std::nullopt : found->second.find(request);
}

bool Crew::has(std::string_view request) const {
  const std::scoped_lock lock(mutex_);
  return std::ranges::any_of(journals_, [&](const auto& journal) { return journal.second.has(request); });
}

std::exception_ptr Crew::failure_of(std::string_view request) const {
  const std::scoped_lock lock(mutex_);
  const auto found = failures_.find(request);
  return found == failures_.end() ? nullptr : found->second;
}

/// Keeps the result, or how the service failed.
void Crew::answer_one(std::string_view request) {
  stop_if_asked();
  if (has(request)) return;
  std::exception_ptr failure;
  std::string result;
  try {
    result = service_(request);
  } catch (const Stopped&) {
    throw;
  } catch (const std::exception&) {
    failure = std::current_exception();
  }
  const std::scoped_lock lock(mutex_);
  if (failure) return void(failures_.emplace(request, failure));
  own().keep(request, result);
  const auto now = std::chrono::steady_clock::now();
  if (now - flushed_ < flush_after) return;
  own().flush();
  flushed_ = now;
}

/// Answers in this order, on threads of their own: one that waits for a part of its work must not begin with another
/// request.
void Crew::answer(const std::vector<std::string_view>& requests, const std::function<void()>& after_each) {
  std::atomic<std::size_t> next = 0;
  const auto work = [&, token = StopScope::token()] {
    give_back_flint_memory_at_end();  // of what the service computes with
    const StopScope scope(token);
    try {
      for (std::size_t k = next++; k < requests.size(); k = next++) {
        answer_one(requests[k]);
        after_each();
      }
    } catch (...) {
      next = requests.size();
      throw;
    }
  };
  std::vector<std::future<void>> threads;
  const auto count = std::min(static_cast<std::size_t>(thread_count(options_.threads)), requests.size());
  while (threads.size() < count) threads.push_back(std::async(std::launch::async, work));
  for (std::future<void>& thread : threads) thread.get();
}

void Crew::each(std::uint64_t count, const std::function<std::string(std::uint64_t)>& request,
                const std::function<void(std::uint64_t, std::string)>& take) {
  const auto ranks = static_cast<std::uint64_t>(options_.ranks);
  std::vector<std::string> requests;
  ByteWriter list;
  for (std::uint64_t i = 0; i < count; ++i) list.text(requests.emplace_back(request(i)));
  if (ranks > 1) own().keep(list_request(lists_++), list.take());
  std::uint64_t taken = 0;
  std::mutex taking;
  const auto take_what_is_there = [&] {
    const std::unique_lock lock(taking, std::try_to_lock);
    for (; lock && taken < count; ++taken) {
      auto result = find(requests[taken]);
      if (const auto failure = result ? nullptr : failure_of(requests[taken])) std::rethrow_exception(failure);
      if (!result) return;
      take(taken, *std::move(result));
    }
  };
  std::vector<bool> lives(ranks, true);
  lives[0] = false;  // at first rank 0 answers its own
  while (refresh(), take_what_is_there(), taken < count) {
    std::vector<std::string_view> left;
    for (std::uint64_t i = taken; i < count; ++i) {
      if (!lives[i % ranks] && !failure_of(requests[i]) && !has(requests[i])) left.emplace_back(requests[i]);
    }
    answer(left, take_what_is_there);
    if (left.empty()) std::this_thread::sleep_for(patience);
    stop_if_asked();
    for (std::uint64_t rank = 1; rank < ranks; ++rank) {
      lives[rank] = Journal::is_written(journal_of(static_cast<int>(rank)));
    }
  }
  own().flush();
}

bool Crew::serve() try {
  const auto begin = std::chrono::steady_clock::now();
  for (bool was_there = false; options_.rank != 0 && failures_.empty();) {
    const bool is_there = Journal::is_written(options_.checkpoint);
    refresh();
    was_there = was_there || is_there;
    if (const auto list = journals_.at(0).find(list_request(lists_))) {
      std::vector<std::string_view> share;
      ByteReader bytes(*list);
      for (int i = 0; !bytes.rest().empty(); i = (i + 1) % options_.ranks) {
        const std::string_view request = bytes.text();
        if (i == options_.rank) share.push_back(request);
      }
      answer(share, [] {});
      own().flush();
      ++lists_;
    } else if (!is_there && (was_there || std::chrono::steady_clock::now() - begin > most_without_rank_0)) {
      return true;
    } else {
      std::this_thread::sleep_for(patience);
      stop_if_asked();
    }
  }
  return options_.rank != 0;
} catch (const std::exception&) {
  return true;
}

void share(Crew* crew, const Service& service, std::uint64_t count,
           const std::function<std::string(std::uint64_t)>& request,
           const std::function<void(std::uint64_t, std::string)>& take, bool in_order) {
  if (crew != nullptr) return crew->each(count, request, take);
  std::mutex mutex;
  std::uint64_t taken = 0;
  std::map<std::uint64_t, std::string> waiting;  // for an earlier one
  each_in_parallel(0, count, [&](std::size_t i) {
    std::string result = service(request(i));
    const std::scoped_lock lock(mutex);
    if (!in_order) return take(i, std::move(result));
    waiting.emplace(i, std::move(result));
    while (const auto next = waiting.extract(taken)) {
      ++taken;
      take(next.key(), std::move(next.mapped()));
    }
  });
}

}  // namespace slipproof
