#include "contact/imported/read_scene.hpp"

#include "base/input/text_file.hpp"
#include "contact/imported/parsers.hpp"

namespace slipproof::imported {

namespace {

constexpr std::size_t max_scene_size = std::size_t{16} << 20U;

void check_sizes(const Scene& scene, Mistakes& mistakes) {
  for (const Body& body : scene.bodies) {
    if (body.mass.sign() < 0) mistakes.add(body.place, body.name + ": found a negative mass");
    for (const Shape& shape : body.shapes) {
      const bool is_box = shape.kind == Shape::Kind::box,
                 is_round = !is_box && shape.kind != Shape::Kind::plane && shape.kind != Shape::Kind::hull;
      const bool has_length = shape.kind == Shape::Kind::cylinder || shape.kind == Shape::Kind::capsule;
      if ((is_box && (shape.half.x.sign() <= 0 || shape.half.y.sign() <= 0 || shape.half.z.sign() <= 0)) ||
          (is_round && shape.radius.sign() <= 0) || (has_length && shape.half_length.sign() <= 0)) {
        mistakes.add(shape.place, shape.name + ": found a " + std::string(name(shape.kind)) +
                                      " with a size that is not positive, expected a positive one");
      }
    }
  }
}

}  // namespace

Scene parse_scene_of_bodies(std::string text, const std::string& file, const ReadOptions& options) {
  TaggedFile tagged(std::move(text), file);
  Mistakes mistakes(file);
  Scene scene;
  scene.file = file;
  const std::string root = tagged.root().name();
  const Place beginning = tagged.place(tagged.root());
  std::string why;
  if (root != "robot" && root != "sdf" && root != "mujoco") {
    mistakes.add(beginning, "found <" + root + ">, expected <robot> (URDF), <sdf> or <mujoco> (MJCF)");
  } else if (const ParseScene parse = find_parsers(why)) {
    parse(&tagged, &options, &scene, &mistakes);
  } else {
    mistakes.add(beginning, "found <" + root + ">, and " + why);
  }
  check_sizes(scene, mistakes);
  mistakes.refuse_if_any();
  join_fixed(scene, options, mistakes);
  if (scene.bodies.size() == 1) mistakes.add(beginning, "found nothing that moves, expected a body with a mass");
  mistakes.refuse_if_any();
  return scene;
}

Scene read_scene_of_bodies(const std::filesystem::path& file, const ReadOptions& options) {
  return parse_scene_of_bodies(read_text_file(file, max_scene_size), file.string(), options);
}

}  // namespace slipproof::imported
