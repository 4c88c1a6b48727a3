// Every motion of a scene in space, with bounds that are proved, and whether there is no other.
#include <iostream>
#include <slipproof/slipproof.hpp>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: every_motion_in_space SCENE.toml\n";
    return 2;
  }
  try {
    const slipproof::SolvedSpace solved =
        slipproof::solve_space(slipproof::read_scene(argv[1], slipproof::Dimensions::any));
    const slipproof::Mechanism& mechanism = solved.scene.mechanism;
    const std::vector<std::string> names = acceleration_names(mechanism);
    for (const slipproof::SpaceMotion& motion : solved.motions) {
      for (std::size_t i = 0; i < mechanism.contacts.size(); ++i) {
        std::cout << mechanism.contacts[i].name << ' ' << motion.modes[i] << '\n';
      }
      for (std::size_t i = 0; i < mechanism.accelerations; ++i) {
        const slipproof::Range& number = motion.accelerations[i];
        std::cout << "  " << names[i] << " from " << nearest_binary64(*number.lower) << " to "
                  << nearest_binary64(*number.upper) << (number.is_point() ? " exactly" : "") << '\n';
      }
    }
    std::cout << (solved.complete() ? "there is no other" : "there may be others") << '\n';
    return 0;
  } catch (const slipproof::InputError& error) {
    std::cerr << error.what() << '\n';
    return 3;
  }
}
