#include "contact/exchange/space_mechanism.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/input/toml.hpp"
#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "contact/exchange/shapes/polytope.hpp"
#include "contact/exchange/shapes/spatial_contacts.hpp"
#include "contact/exchange/shapes/stand.hpp"
#include "mechanics/reading/read_mechanism.hpp"

namespace slipproof::imported {

namespace {

std::string toml(const Rational& x) {
  return toml_string(exact_text(x));
}
std::string toml(const Vector& v) {
  return fmt::format("[{}, {}, {}]", toml(v.x), toml(v.y), toml(v.z));
}
bool is_zero(const Vector& v) {
  return v == Vector{};
}

/// The corners of a shape for a picture: of many, those that lie farthest in 32 directions spread over the sphere.
std::vector<Vector> drawn_corners(const Shape& shape) {
  constexpr std::size_t most = 32;
  const std::vector<Vector> all = corners_of(shape);
  if (all.size() <= most) return all;
  std::vector<Near> places;
  for (const Vector& p : all) places.push_back(near(p));
  std::vector<bool> taken(all.size());
  for (std::size_t k = 0; k < most; ++k) {
    const double z = 1 - (2 * static_cast<double>(k) + 1) / most, turn = 2.399963 * static_cast<double>(k);
    const double across = std::sqrt(1 - z * z);
    const Near direction{across * std::cos(turn), across * std::sin(turn), z};
    const auto along = [&](const Near& p) { return dot(p, direction); };
    taken[static_cast<std::size_t>(std::ranges::max_element(places, {}, along) - places.begin())] = true;
  }
  std::vector<Vector> result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (taken[i]) result.push_back(all[i]);
  }
  return result;
}

class SpaceWriter {
 public:
  SpaceWriter(Scene& scene, const SpaceOptions& options, Mistakes& mistakes)
      : scene_(scene), options_(options), mistakes_(mistakes) {
    names_("ground");
  }

  SpaceMechanism write() {
    for (const OnlyInSpace& one : scene_.only_in_space) {
      if (!one.left_out.empty()) scene_.import_notes.push_back(one.left_out);
    }
    body_names_.emplace_back("ground");
    for (std::size_t i = 1; i < scene_.bodies.size(); ++i) body_names_.push_back(names_(scene_.bodies[i].name));
    held_.resize(scene_.bodies.size());
    const std::string touching = contacts();
    std::string joints, bodies, pushes;
    for (const Joint& one : scene_.joints) {
      held_[one.first] = held_[one.second] = true;
      joints += joint(one);
    }
    const std::string falling = std::ranges::find(held_, true) == held_.end() ? open_contacts() : "";
    for (std::size_t i = 1; i < scene_.bodies.size(); ++i) bodies += body(i);
    for (const Push& one : scene_.pushes) pushes += push(one);
    result_.import_notes = scene_.import_notes;
    result_.text = head() + bodies + joints + touching + falling + pushes;
    return std::move(result_);
  }

 private:
  std::string head() const {
    std::string text =
        fmt::format("# {} {} in space. What was left out, moved, turned or assumed:\n", scene_.format, scene_.name);
    for (const std::string& one : result_.import_notes) text += "# - " + one + "\n";
    text += "schema = \"slipproof/mechanism/1\"\n";
    text += "name = " + toml_string(scene_.name.empty() ? scene_.format : scene_.name) + "\ndimension = 3\n";
    text += "gravity = " + (is_zero(*scene_.gravity) ? "\"none\"" : toml(*scene_.gravity)) + "\n";
    return text;
  }

  std::string body_text(const std::string& name, const Body& body) {
    ++result_.bodies;
    const Inertia& j = body.inertia;
    std::vector<Rational> inertia{j.xx, j.yy, j.zz};
    if (!j.xy.is_zero() || !j.xz.is_zero() || !j.yz.is_zero()) inertia.insert(inertia.end(), {j.xy, j.xz, j.yz});
    std::string text = fmt::format("\n[[body]]\nname = {}\nmass = {}\n", toml_string(name), toml(body.mass));
    if (body.turns) {
      text += "inertia = [" + listed(inertia, [](const Rational& x) { return toml(x); }) + "]\n";
    } else {
      text += "turning = " + toml(Vector{}) + "\n";
    }
    text += "at = " + toml(body.at) + "\n";
    if (!is_zero(body.velocity)) text += "velocity = " + toml(body.velocity) + "\n";
    if (!is_zero(body.spin)) text += "spin = " + toml(body.spin) + "\n";
    return text;
  }

  /// Nothing for a body in free fall, of which there is nothing to ask.
  std::string body(std::size_t i) {
    const Body& body = scene_.bodies[i];
    if (!held_[i]) {
      scene_.import_notes.push_back("left out: " + body.name + ", which falls freely: nothing touches or holds it");
      return "";
    }
    std::string text = body_text(body_names_[i], body);
    std::vector<std::string> shapes;
    for (const Shape& shape : body.shapes) shapes.push_back(shape_text(shape, body.at));
    if (shapes.size() == 1) text += "shape = " + shapes[0] + "\n";
    if (shapes.size() > 1) text += "shape = [" + listed(shapes) + "]\n";
    return text;
  }

  /// In the axes of the body, which are those of the scene.
  static std::string shape_text(const Shape& shape, const Vector& centre) {
    const Vector at = shape.pose.at - centre, &axis = shape.pose.turn.axes[2];
    switch (shape.kind) {
      case Shape::Kind::sphere:
        return fmt::format("{{ sphere = {}, at = {} }}", toml(shape.radius), toml(at));
      case Shape::Kind::cylinder:
      case Shape::Kind::capsule:
        return fmt::format("{{ {} = [{}, {}], at = {}, axis = {} }}", name(shape.kind), toml(shape.radius),
                           toml(2 * shape.half_length), toml(at), toml(axis));
      default:
        break;
    }
    const bool along = shape.kind == Shape::Kind::box && shape.pose.turn.axes == Turn().axes;
    if (along) return fmt::format("{{ box = {}, at = {} }}", toml(Rational(2) * shape.half), toml(at));
    return "{ hull = [" + listed(drawn_corners(shape), [&](const Vector& p) { return toml(p - centre); }) + "] }";
  }

  Vector in_body(std::size_t body, const Vector& p) const { return body == 0 ? p : p - scene_.bodies[body].at; }

  std::string between(std::size_t first, std::size_t second) const {
    return fmt::format("between = [{}, {}]\n", toml_string(body_names_[first]), toml_string(body_names_[second]));
  }

  std::string joint(const Joint& joint) {
    const std::string own = names_(joint.name);
    constexpr std::array<std::string_view, 4> kinds{"weld", "hinge", "slider", "ball"};
    std::string text = fmt::format("\n[[joint]]\nname = {}\nkind = \"{}\"\n{}at = {}\n", toml_string(own),
                                   kinds[static_cast<std::size_t>(joint.kind)], between(joint.first, joint.second),
                                   toml(in_body(joint.first, joint.at)));
    if (joint.kind != Joint::Kind::ball) {
      text += "axis = " + toml(unit_of(joint.axis)) + "\n";
    }
    if (!joint.armature.is_zero()) text += "armature = " + toml(joint.armature) + "\n";
    if (!joint.friction.is_zero()) {
      scene_.import_notes.push_back(fmt::format("{}: its friction of up to {} {} is left out", joint.name,
                                                exact_text(joint.friction),
                                                joint.kind == Joint::Kind::slide ? "N" : "N m"));
    }
    return text;
  }

  std::string contacts() {
    std::string text;
    const bool moving = std::ranges::any_of(
        scene_.bodies, [](const Body& body) { return !is_zero(body.velocity) || !is_zero(body.spin); });
    for (const SpatialContact& c :
         spatial_contacts(scene_, options_.touch, mistakes_, scene_.import_notes, options_.overlaps)) {
      const std::string own = names_(c.shape_of->name + "_on_" + c.shape_on->name);
      text += fmt::format("\n[[contact]]\nname = {}\nof = {}\npoint = {}\n", toml_string(own),
                          toml_string(body_names_[c.of]), toml(in_body(c.of, c.at + c.radius * c.normal)));
      if (!c.radius.is_zero()) text += "radius = " + toml(c.radius) + "\n";
      if (c.on != 0) text += "on = " + toml_string(body_names_[c.on]) + "\n";
      if (c.on_radius) {
        text += fmt::format("on_point = {}\non_radius = {}\n", toml(in_body(c.on, c.at - *c.on_radius * c.normal)),
                            toml(*c.on_radius));
      } else {
        text += fmt::format("normal = {}\nthrough = {}\n", toml(c.normal), toml(in_body(c.on, c.at)));
      }
      text += "friction = " + toml(friction_at(scene_, *c.shape_on, *c.shape_of, options_, mistakes_)) + "\n";
      ++result_.contacts;
      held_[c.of] = held_[c.on] = true;
      if (abs(c.distance) > Rational(1, 1'000'000'000'000)) {  // less is how numbers were rounded
        scene_.import_notes.push_back(own + ": " + distance_in_words(c.distance) + ", moved to touch");
      }
      if (c.only_at_rest && moving) {
        scene_.import_notes.push_back(own + ": the curvature there is left out, which counts for bodies that move");
      }
    }
    return text;
  }

  /// Where all fall freely: each is a metre above a plane, which holds it in the scene.
  std::string open_contacts() {
    std::string text;
    for (std::size_t i = 1; i < scene_.bodies.size(); ++i) {
      text += fmt::format(
          "\n[[contact]]\nname = {}\nof = {}\npoint = {}\nnormal = {}\nthrough = {}\nfriction = \"0\"\n"
          "state = \"open\"\n",
          toml_string(names_(body_names_[i] + "_above_ground")), toml_string(body_names_[i]), toml(Vector{}),
          toml(Vector{0, 0, 1}), toml(scene_.bodies[i].at - Vector{0, 0, 1}));
      held_[i] = true;
      scene_.import_notes.push_back(body_names_[i] +
                                    " falls freely: a plane a metre below it, which it does not touch, "
                                    "holds it in the scene");
    }
    return text;
  }

  std::string push(const Push& push) {
    std::string text;
    if (!held_[push.on] && push.on != 0) return text;
    const std::string on = toml_string(body_names_[push.on]);
    const std::string back = push.back_on == 0 ? "" : "back_on = " + toml_string(body_names_[push.back_on]) + "\n";
    if (push.on == 0)
      return this->push({push.name, push.back_on, 0, Rational(-1) * push.force, push.at, Rational(-1) * push.couple});
    if (!is_zero(push.force)) {
      text += fmt::format("\n[[force]]\non = {}\nat = {}\nis = {}\n{}", on, toml(in_body(push.on, push.at)),
                          toml(push.force), back);
    }
    if (!is_zero(push.couple)) text += fmt::format("\n[[torque]]\non = {}\nis = {}\n{}", on, toml(push.couple), back);
    return text;
  }

  Scene& scene_;
  const SpaceOptions& options_;
  Mistakes& mistakes_;
  Identifiers names_;
  std::vector<std::string> body_names_;
  std::vector<bool> held_;  ///< the bodies that something touches, or a joint has
  SpaceMechanism result_;
};

}  // namespace

SpaceMechanism to_space(Scene scene, const SpaceOptions& options) {
  complete(scene, options);
  join_free_slides(scene);
  if (options.stand) stand_on_ground(scene);
  Mistakes mistakes(scene.file);
  SpaceMechanism result = SpaceWriter(scene, options, mistakes).write();
  mistakes.refuse_if_any();
  parse_mechanism(result.text, "the mechanism that follows from " + scene.file);  // refuses what no mechanism is
  return result;
}

}  // namespace slipproof::imported
