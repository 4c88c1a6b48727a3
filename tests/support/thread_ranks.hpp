// Ranks that are threads of this process: what is between them is a queue each.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "base/crew/crew.hpp"

namespace slipproof::test {

class ThreadRanks {
 public:
  explicit ThreadRanks(int ranks) {
    for (int rank = 0; rank < ranks; ++rank) ends_.push_back(std::make_unique<End>(*this, rank));
  }
  Transport& operator[](int rank) { return *ends_.at(static_cast<std::size_t>(rank)); }
  int size() const { return static_cast<int>(ends_.size()); }

  /// Every rank does its part, the others of 0 on threads of their own.
  void run(const std::function<void(Transport&)>& lead, const std::function<void(Transport&)>& follow) {
    std::vector<std::jthread> others;
    for (int rank = 1; rank < size(); ++rank) others.emplace_back([&, rank] { follow((*this)[rank]); });
    lead((*this)[0]);
  }

 private:
  class End final : public Transport {
   public:
    End(ThreadRanks& all, int rank) : all_(all), rank_(rank) {}
    int rank() const override { return rank_; }
    int ranks() const override { return all_.size(); }
    void send(int to, std::string bytes) override {
      End& other = *all_.ends_.at(static_cast<std::size_t>(to));
      const std::scoped_lock lock(other.mutex_);
      other.queue_.push_back({rank_, std::move(bytes)});
    }
    std::optional<Message> receive() override {
      const std::scoped_lock lock(mutex_);
      if (queue_.empty()) return std::nullopt;
      Message message = std::move(queue_.front());
      queue_.pop_front();
      return message;
    }

   private:
    ThreadRanks& all_;
    int rank_;
    std::mutex mutex_;
    std::deque<Message> queue_;
  };

  std::vector<std::unique_ptr<End>> ends_;
};

/// lead(crew) on rank 0 of so many ranks, of one thread each, that answer with the same service.
inline void by_crew(int ranks, const Service& service, const std::function<void(Crew&)>& lead,
                    Journal* journal = nullptr) {
  ThreadRanks(ranks).run(
      [&](Transport& transport) {
        Crew crew(transport, {.threads = 1, .journal = journal}, service);
        lead(crew);
      },
      [&](Transport& transport) { Crew(transport, {.threads = 1}, service).serve(); });
}

}  // namespace slipproof::test
