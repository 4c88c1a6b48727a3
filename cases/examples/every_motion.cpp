// Every motion of a bicycle at one force, and the forces for which each contact mode is consistent.
#include <iostream>
#include <slipproof/slipproof.hpp>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: every_motion SCENE.toml\n";
    return 2;
  }
  try {
    const slipproof::Scene scene = slipproof::read_scene(argv[1]);
    const slipproof::ModeTable table(scene.bicycle, scene.road, scene.force_kind);
    for (const slipproof::ModeSolution& solution : table.solutions()) {
      if (!solution.closed().empty())
        std::cout << name(solution.mode()) << " for F in " << to_string(solution.closed()) << '\n';
    }
    if (!scene.F) return 0;
    const slipproof::MotionsAtForce found = motions_at(table, *scene.F);
    std::cout << "at F = " << *scene.F << ":\n";
    for (const auto& motion : found.motions) {
      std::cout << "  " << name(motion.modes.front()) << " with a = " << motion.values[slipproof::Quantity::a] << '\n';
    }
    return 0;
  } catch (const slipproof::InputError& error) {
    std::cerr << error.what() << '\n';
    return 3;
  }
}
