#include "mechanics/lines/question.hpp"

#include <algorithm>

namespace slipproof {

std::vector<std::size_t> slots_behind(const Scope& scope, const std::vector<const Program*>& programs) {
  std::vector<std::size_t> found;
  std::vector<const Program*> open = programs;
  while (!open.empty()) {
    const Program* program = open.back();
    open.pop_back();
    for (const std::size_t slot : program->slots()) {
      if (std::find(found.begin(), found.end(), slot) != found.end()) continue;
      found.push_back(slot);
      if (scope.slots[slot].definition) open.push_back(&*scope.slots[slot].definition);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace slipproof
