// The C++ side of speed.py: the same scenes, the same calls.
//   slipproof_python_speed COLUMNS SCENE: COLUMNS has 15 columns of binary64, one after the other
// Prints the best rate of the batch on one core, in scenes a second, and the best time of one solution, in
// seconds.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <vector>

#include "floating/batch/bicycle_batch.hpp"
#include "mechanics/scene/scene.hpp"
#include "mechanics/scene/solve_mechanism.hpp"

namespace {

using namespace slipproof;

double best_of(int repeats, const std::function<void()>& work) {
  double best = 1e9;
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  std::ifstream file(argv[1], std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  const std::size_t size = bytes.size() / sizeof(double) / 15;
  const auto at = [&](std::size_t i) {
    return Column(std::span(reinterpret_cast<const double*>(bytes.data()) + i * size, size));
  };
  BicycleColumns bicycles;
  for (std::size_t i = 0; i < bicycles.numbers.size(); ++i) bicycles.numbers[i] = at(i < 11 ? i : i == 11 ? 14 : i - 1);
  bicycles.F = at(13);
  const double batch = best_of(7, [&] { consistent_modes(bicycles, 1); });
  const MechanismScene scene = read_scene(argv[2]);
  const double solution = best_of(300, [&] { const SolvedMechanism solved = solve_mechanism(scene); });
  std::printf("%.9g %.9g\n", static_cast<double>(size) / batch, solution);
}
