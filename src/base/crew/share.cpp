#include "base/crew/share.hpp"

#include <map>
#include <mutex>
#include <utility>

#include "base/parallel/in_parallel.hpp"

namespace slipproof {

void share(Crew* crew, const Service& service, std::uint64_t count,
           const std::function<std::string(std::uint64_t)>& request,
           const std::function<void(std::uint64_t, std::string)>& take, Taking taking) {
  if (crew != nullptr) {
    crew->each(count, request, take, taking);
    return;
  }
  std::mutex mutex;
  std::uint64_t taken = 0;
  std::map<std::uint64_t, std::string> waiting;  // for an earlier one
  each_in_parallel(0, count, [&](std::size_t i) {
    std::string result = service(request(i));
    const std::scoped_lock lock(mutex);
    if (taking == Taking::as_they_come) return take(i, std::move(result));
    waiting.emplace(i, std::move(result));
    while (const auto next = waiting.extract(taken)) {
      ++taken;
      take(next.key(), std::move(next.mapped()));
    }
  });
}

}  // namespace slipproof
