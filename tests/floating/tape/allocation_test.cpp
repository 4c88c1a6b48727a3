// The fast tiers do not allocate: counted by replacing the global operators new.
#include <doctest/doctest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "floating/filter/batch.hpp"
#include "support/filter_scenes.hpp"

namespace {
std::atomic<long> allocations{0};

void* counted(std::size_t size) {
  ++allocations;
  if (void* p = std::malloc(size == 0 ? 1 : size)) return p;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) {
  return counted(size);
}
void* operator new[](std::size_t size) {
  return counted(size);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {  // of std::stable_sort
  return counted(size);
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete[](void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}
void operator delete[](void* p, std::size_t) noexcept {
  std::free(p);
}

using namespace slipproof;
using namespace slipproof::test;

TEST_CASE("the first two tiers allocate nothing, one by one and in a batch; the exact tier does") {
  FilterScenes random(71);
  std::vector<ForcedScene<double>> scenes;
  for (int i = 0; i < 100; ++i) {
    scenes.push_back(nearest_binary64(random.scene(Population::bicycles)));
    scenes.back().F = random.uniform(-300, 3000);
  }
  const long before = allocations;
  unsigned seen = 0;
  for (const auto& s : scenes) seen |= filter_modes(s).consistent | double_double_modes(s).consistent;
  CHECK(allocations == before);
  CHECK(seen != 0);

  ForcedScene<Column> columns = convert<double, Column>(scenes[0], [](double x) { return Column(x); });
  std::vector<double> F(1000);
  for (double& x : F) x = random.uniform(-300, 3000);
  columns.F = F;
  std::vector<ConsistentModes> answers(F.size());
  TierCounts counts{};
  const long before_batch = allocations;
  consistent_modes(columns, answers, counts);
  CHECK(allocations == before_batch);
  CHECK(counts[0] == F.size());

  scenes[0].bicycle.M = 1e300;
  const long before_exact = allocations;
  CHECK(consistent_modes(scenes[0]).tier == Tier::exact);
  CHECK(allocations > before_exact);
}
