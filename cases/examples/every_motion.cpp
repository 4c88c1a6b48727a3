// Every motion of a bicycle at one force, and the forces for which each contact mode is consistent.
#include <iostream>
#include <slipproof/slipproof.hpp>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: every_motion SCENE.toml\n";
    return 2;
  }
  try {
    const slipproof::SolvedMechanism solved = slipproof::solve_mechanism(slipproof::read_scene(argv[1]));
    for (const slipproof::ConsistentMode& mode : solved.modes) {
      std::cout << name(mode.mode) << " for F in " << to_string(mode.solutions.loads) << '\n';
    }
    if (!solved.at_load) return 0;
    std::cout << "at F = " << *solved.scene.load << ":\n";
    for (const slipproof::MotionAtLoad& motion : solved.at_load->motions) {
      std::cout << "  " << name(motion.all_modes().front()) << " with a = " << motion.accelerations.front() << '\n';
    }
    return 0;
  } catch (const slipproof::InputError& error) {
    std::cerr << error.what() << '\n';
    return 3;
  }
}
