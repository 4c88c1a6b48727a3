// How many threads work on a task.
#pragma once

namespace slipproof {

/// `wanted`, but at most one a core: more only bring a warning. 0 means all cores.
int thread_count(unsigned wanted);

}  // namespace slipproof
