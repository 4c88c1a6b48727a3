#include "contact/imported/gazebo.hpp"

namespace slipproof::imported {

bool take_known_includes(TaggedFile& file, Mistakes& mistakes) {
  bool found = false;
  for (pugi::xml_node world : file.root().children("world")) {
    for (pugi::xml_node include = world.child("include"), next; include; include = next) {
      next = include.next_sibling("include");
      const std::string_view uri = include.child_value("uri");
      const bool known = uri == "model://sun" || (uri == "model://ground_plane" && !include.child("pose"));
      if (!known) {
        mistakes.add(file.place(include),
                     "found the included model " + in_quotes(uri) + ", expected it in the file itself");
      }
      found = found || uri == "model://ground_plane";
      world.remove_child(include);
    }
  }
  return found;
}

void add_ground_plane(Scene& scene) {
  Shape plane;
  plane.kind = Shape::Kind::plane;
  plane.name = "ground_plane";
  plane.mu = Rational(50);
  plane.greater_mu = Rational(100);
  scene.bodies[0].shapes.push_back(std::move(plane));
  scene.import_notes.emplace_back("Gazebo's ground_plane is the plane at height 0 with the coefficients 100 and 50");
}

}  // namespace slipproof::imported
