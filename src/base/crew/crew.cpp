#include "base/crew/crew.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
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

/// A list of requests, and what is known of them here.
class Crew::Stage {
 public:
  using Take = std::function<void(std::uint64_t, std::string)>;

  Stage(std::vector<std::string> list, const Crew& crew, const Take* take = nullptr)
      : requests(std::move(list)), failures(requests.size()), crew_(crew), take_(take) {}

  /// Takes what is there; true where all is taken.
  bool advance() {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (!lock || take_ == nullptr) return false;
    for (; taken_ < requests.size(); ++taken_) {
      auto result = crew_.find(requests[taken_]);
      if (!result && failures[taken_]) std::rethrow_exception(failures[taken_]);
      if (!result) return false;
      (*take_)(taken_, *std::move(result));
    }
    return true;
  }
  std::uint64_t taken() const { return taken_; }
  void fail(std::uint64_t i, std::exception_ptr failure) {
    const std::scoped_lock lock(mutex_);
    failures[i] = std::move(failure);
  }

  const std::vector<std::string> requests;
  std::vector<std::exception_ptr> failures;

 private:
  const Crew& crew_;
  const Take* take_;
  std::uint64_t taken_ = 0;
  std::mutex mutex_;
};

Crew::Crew(CrewOptions options, Service service)
    : options_(std::move(options)), service_(std::move(service)), own_(journal_of(options_.rank), options_.work) {
  for (int rank = 0; rank < options_.ranks || std::filesystem::exists(journal_of(rank)); ++rank) {
    if (rank == options_.rank) continue;
    others_.emplace(rank, Journal(journal_of(rank), options_.work, Journal::Access::read));
  }
  while (options_.rank == 0 && own_.has(list_request(lists_))) ++lists_;
}

std::filesystem::path Crew::journal_of(int rank) const {
  std::filesystem::path journal = options_.checkpoint;
  return rank == 0 ? journal : journal += '.' + std::to_string(rank);
}

void Crew::refresh() {
  const std::scoped_lock lock(mutex_);
  for (auto& [rank, journal] : others_) journal.refresh();
}

std::optional<std::string> Crew::find(std::string_view request) const {
  const std::scoped_lock lock(mutex_);
  auto result = own_.find(request);
  for (auto other = others_.begin(); !result && other != others_.end(); ++other) result = other->second.find(request);
  return result;
}

bool Crew::has(std::string_view request) const {
  const std::scoped_lock lock(mutex_);
  return own_.has(request) ||
         std::ranges::any_of(others_, [&](const auto& other) { return other.second.has(request); });
}

void Crew::keep(std::string_view request, std::string_view result) {
  const std::scoped_lock lock(mutex_);
  own_.keep(request, result);
  const auto now = std::chrono::steady_clock::now();
  if (now - flushed_ < flush_after) return;
  own_.flush();
  flushed_ = now;
}

/// Answers these requests, which are in the order of the list, on threads of their own: one that waits for a part of
/// its work must not begin with another request. Takes what comes.
void Crew::answer(Stage& stage, const std::vector<std::uint64_t>& which) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto answer_one = [&](std::uint64_t i) {
    stop_if_asked();
    try {
      if (!has(stage.requests[i])) keep(stage.requests[i], service_(stage.requests[i]));
    } catch (const Stopped&) {
      throw;
    } catch (const std::exception&) {
      stage.fail(i, std::current_exception());
    }
    stage.advance();
  };
  const auto work = [&, token = StopScope::token()] {
    give_back_flint_memory_at_end();  // of what the service computes with
    const StopScope scope(token);
    try {
      for (std::size_t k = next++; k < which.size(); k = next++) answer_one(which[k]);
    } catch (...) {
      next = which.size();
      const std::scoped_lock lock(mutex);
      failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> threads;
    const auto count = std::min(static_cast<std::size_t>(thread_count(options_.threads)), which.size());
    while (threads.size() < count) threads.emplace_back(work);
  }
  if (failure) std::rethrow_exception(failure);
}

void Crew::each(std::uint64_t count, const std::function<std::string(std::uint64_t)>& request,
                const std::function<void(std::uint64_t, std::string)>& take) {
  const auto ranks = static_cast<std::uint64_t>(options_.ranks);
  std::vector<std::string> requests;
  ByteWriter list;
  for (std::uint64_t i = 0; i < count; ++i) list.text(requests.emplace_back(request(i)));
  if (ranks > 1) keep(list_request(lists_++), list.take());
  Stage stage(std::move(requests), *this, &take);
  std::vector<bool> lives(ranks, true);
  lives[0] = false;  // at first rank 0 answers its own
  for (refresh(); !stage.advance(); refresh()) {
    std::vector<std::uint64_t> left;
    for (std::uint64_t i = stage.taken(); i < count; ++i) {
      if (!lives[i % ranks] && !stage.failures[i] && !has(stage.requests[i])) left.push_back(i);
    }
    answer(stage, left);
    if (left.empty()) std::this_thread::sleep_for(patience);
    stop_if_asked();
    for (std::uint64_t rank = 1; rank < ranks; ++rank) {
      lives[rank] = Journal::is_written(journal_of(static_cast<int>(rank)));
    }
  }
  own_.flush();
}

void Crew::serve() {
  const auto begin = std::chrono::steady_clock::now();
  bool was_there = false;
  try {
    while (true) {
      const bool is_there = Journal::is_written(options_.checkpoint);
      refresh();
      was_there = was_there || is_there;
      if (const auto list = others_.at(0).find(list_request(lists_))) {
        if (!answer_list(*list)) return;
        ++lists_;
        continue;
      }
      if (!is_there && (was_there || std::chrono::steady_clock::now() - begin > most_without_rank_0)) return;
      std::this_thread::sleep_for(patience);
      stop_if_asked();
    }
  } catch (const std::exception&) {
    return;
  }
}

/// This rank's share; false where something failed.
bool Crew::answer_list(std::string_view bytes) {
  ByteReader list(bytes);
  std::vector<std::string> requests;
  while (!list.rest().empty()) requests.emplace_back(list.text());
  std::vector<std::uint64_t> share;
  for (auto i = static_cast<std::size_t>(options_.rank); i < requests.size();
       i += static_cast<std::size_t>(options_.ranks)) {
    share.push_back(i);
  }
  Stage stage(std::move(requests), *this);
  answer(stage, share);
  own_.flush();
  return std::ranges::none_of(stage.failures, [](const std::exception_ptr& failure) { return failure != nullptr; });
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
