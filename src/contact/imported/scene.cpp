#include "contact/imported/scene.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace slipproof::imported {

std::string_view name(Shape::Kind kind) {
  constexpr std::array<std::string_view, 5> names{"box", "sphere", "cylinder", "capsule", "plane"};
  return names[static_cast<std::size_t>(kind)];
}

namespace {

/// Takes what a body is made of over to another that it is fixed to.
void add_to(Body& whole, const Body& part, bool is_ground) {
  whole.shapes.insert(whole.shapes.end(), part.shapes.begin(), part.shapes.end());
  if (is_ground || part.mass.is_zero()) return;
  const Rational mass = whole.mass + part.mass;
  const Vector at = (Rational(1) / mass) * (whole.mass * whole.at + part.mass * part.at);
  whole.inertia =
      whole.inertia + of_point(whole.mass, whole.at - at) + part.inertia + of_point(part.mass, part.at - at);
  whole.mass = mass;
  whole.at = at;
}

}  // namespace

void join_fixed(Scene& scene, Mistakes& mistakes) {
  std::vector<std::size_t> root(scene.bodies.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t body) {
    while (root[body] != body) body = root[body];
    return body;
  };
  for (const Joint& joint : scene.joints) {
    if (joint.kind != Joint::Kind::fixed) continue;
    const std::size_t a = find(joint.first), b = find(joint.second);
    root[std::max(a, b)] = std::min(a, b);  // the ground is the first
  }
  std::vector<std::size_t> number(scene.bodies.size());
  std::vector<Body> whole;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (find(i) == i) {
      number[i] = whole.size();
      whole.push_back(scene.bodies[i]);
    } else {
      number[i] = number[find(i)];
      add_to(whole[number[i]], scene.bodies[i], number[i] == 0);
      scene.import_notes.push_back(scene.bodies[i].name + " is fixed to " + whole[number[i]].name + ": one body");
    }
  }
  scene.bodies = std::move(whole);
  std::erase_if(scene.joints, [](const Joint& joint) { return joint.kind == Joint::Kind::fixed; });
  for (Joint& joint : scene.joints) joint.first = number[joint.first], joint.second = number[joint.second];
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (body.mass.sign() <= 0) {
      mistakes.add(body.place, body.name + ": found a body that moves, without a mass, expected an inertia");
    }
    for (const Shape& shape : body.shapes) {
      if (shape.kind != Shape::Kind::plane) continue;
      mistakes.add(shape.place, shape.name + ": found a plane on a body that moves, expected it to be fixed");
    }
  }
}

std::optional<Rational> friction_between(const Scene& scene, const Shape& a, const Shape& b,
                                         const std::optional<Rational>& given) {
  if (given) return given;
  if (scene.rule == FrictionRule::none || !a.mu || !b.mu) return std::nullopt;
  const auto greater = [](const Shape& shape) { return shape.greater_mu.value_or(*shape.mu); };
  if (scene.rule == FrictionRule::least && std::min(*a.mu, *b.mu) != std::min(greater(a), greater(b))) {
    return std::nullopt;
  }
  return scene.rule == FrictionRule::least ? std::min(*a.mu, *b.mu) : std::max(*a.mu, *b.mu);
}

bool are_joined(const Scene& scene, std::size_t a, std::size_t b) {
  if (a == 0 || b == 0) return false;
  return std::ranges::any_of(scene.joints, [&](const Joint& joint) {
    return (joint.first == a && joint.second == b) || (joint.first == b && joint.second == a);
  });
}

bool may_touch(const Shape& a, const Shape& b) {
  return (a.kinds & b.meets) != 0 || (b.kinds & a.meets) != 0;
}

std::string Identifiers::operator()(const std::string& name) {
  std::string base;
  for (const char c : name) base += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  if (base.empty() || std::isdigit(static_cast<unsigned char>(base.front())) != 0) base.insert(0, "b_");
  std::string result = base;
  for (int i = 2; std::ranges::find(used_, result) != used_.end(); ++i) result = base + "_" + std::to_string(i);
  used_.push_back(result);
  return result;
}

}  // namespace slipproof::imported
