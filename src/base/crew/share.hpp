// Distributes work by index over the threads of this process, or over a crew of many ranks.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "base/crew/crew.hpp"

namespace slipproof {

/// take(i, answer to request(i)) for i = 0, 1, ... count - 1, one at a time, by default each as it comes. Without a
/// crew `service` answers, on the threads of the caller's on_threads(); with one it must be the crew's. What is thrown
/// is as of Crew::each(); without a crew what any of them throws.
void share(Crew* crew, const Service& service, std::uint64_t count,
           const std::function<std::string(std::uint64_t)>& request,
           const std::function<void(std::uint64_t, std::string)>& take, Taking taking = Taking::as_they_come);

}  // namespace slipproof
