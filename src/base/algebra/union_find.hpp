// Sets that are joined until they are the connected parts of a graph.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace slipproof {

class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }

  /// Returns the representative of the set of i, which stays the same until the set is joined with another. Nearly
  /// constant time.
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) { parent_[find(i)] = find(j); }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace slipproof
