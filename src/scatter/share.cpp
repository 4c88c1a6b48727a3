#include "scatter/share.hpp"

#include <mutex>
#include <utility>

#include "parallel/in_parallel.hpp"

namespace slipproof {

void share(Crew* crew, const Service& service, std::uint64_t count,
           const std::function<std::string(std::uint64_t)>& request,
           const std::function<void(std::uint64_t, std::string)>& take) {
  if (crew != nullptr) {
    crew->each(count, request, take, Taking::as_they_come);
    return;
  }
  std::mutex mutex;
  each_in_parallel(0, count, [&](std::size_t i) {
    std::string result = service(request(i));
    const std::scoped_lock lock(mutex);
    take(i, std::move(result));
  });
}

}  // namespace slipproof
