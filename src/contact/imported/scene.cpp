#include "contact/imported/scene.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace slipproof::imported {

std::string_view name(Shape::Kind kind) {
  constexpr std::array<std::string_view, 6> names{"box", "sphere", "cylinder", "capsule", "plane", "hull"};
  return names[static_cast<std::size_t>(kind)];
}

void add_to(Body& whole, const Body& part, bool is_ground) {
  whole.shapes.insert(whole.shapes.end(), part.shapes.begin(), part.shapes.end());
  if (is_ground || part.mass.is_zero()) return;
  const Rational mass = whole.mass + part.mass;
  if (whole.mass.is_zero()) whole.velocity = part.velocity, whole.spin = part.spin, whole.at = part.at;
  const Vector at = (Rational(1) / mass) * (whole.mass * whole.at + part.mass * part.at);
  whole.inertia =
      whole.inertia + of_point(whole.mass, whole.at - at) + part.inertia + of_point(part.mass, part.at - at);
  whole.velocity = whole.velocity + cross(whole.spin, at - whole.at);
  whole.mass = mass;
  whole.at = at;
  whole.massless = whole.massless && part.massless;
}

namespace {

/// Renumbers what names bodies, and drops what has come to be inside of one.
void renumber(Scene& scene, const std::vector<std::size_t>& number) {
  for (Joint& joint : scene.joints) joint.first = number[joint.first], joint.second = number[joint.second];
  for (const Joint& joint : scene.joints) {
    if (joint.first == joint.second) scene.import_notes.push_back(joint.name + ": held fast, it cannot move");
  }
  std::erase_if(scene.joints, [](const Joint& joint) { return joint.first == joint.second; });
  for (Push& push : scene.pushes) push.on = number[push.on], push.back_on = number[push.back_on];
  std::erase_if(scene.pushes, [](const Push& push) { return push.on == push.back_on; });
  for (auto& [a, b] : scene.excluded) a = number[a], b = number[b];
  std::erase_if(scene.excluded, [](const auto& pair) { return pair.first == pair.second; });
}

}  // namespace

void join_fixed(Scene& scene, const ReadOptions& options, Mistakes& mistakes) {
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
  renumber(scene, number);
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    Body& body = scene.bodies[i];
    if (body.mass.is_zero() && !body.massless && options.mass) {
      const Rational& m = body.mass = *options.mass;
      body.inertia = {m, m, m, 0, 0, 0};
      scene.import_notes.push_back(body.name + " has no mass: " + m.str() + " kg and kg m^2 are taken (--mass)");
    } else if (body.mass.sign() <= 0 && !body.massless) {
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
  if (a.priority != b.priority) return a.priority > b.priority ? a.mu : b.mu;
  const auto greater = [](const Shape& shape) { return shape.greater_mu.value_or(*shape.mu); };
  if (scene.rule == FrictionRule::least && std::min(*a.mu, *b.mu) != std::min(greater(a), greater(b))) {
    return std::nullopt;
  }
  return scene.rule == FrictionRule::least ? std::min(*a.mu, *b.mu) : std::max(*a.mu, *b.mu);
}

void move(Scene& scene, const std::vector<bool>& bodies, const Vector& by) {
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    if (!bodies[i]) continue;
    scene.bodies[i].at = scene.bodies[i].at + by;
    for (Shape& shape : scene.bodies[i].shapes) shape.pose.at = shape.pose.at + by;
  }
  for (Joint& joint : scene.joints) {
    if (bodies[joint.second]) joint.at = joint.at + by;
  }
  for (Push& push : scene.pushes) {
    if (bodies[push.on]) push.at = push.at + by;
  }
}

namespace {

/// The three joints that hold a body to the ground behind two massless links, from the body on; empty if others do.
std::vector<std::size_t> chain_of_three(const Scene& scene, std::size_t body) {
  std::vector<std::size_t> chain;
  if (scene.bodies[body].massless) return chain;
  for (;;) {
    const auto held = std::ranges::find(scene.joints, body, &Joint::second);
    if (held == scene.joints.end() || chain.size() == 3) return {};
    chain.push_back(static_cast<std::size_t>(held - scene.joints.begin()));
    body = held->first;
    if (!scene.bodies[body].massless) break;
  }
  return chain.size() == 3 && body == 0 ? chain : std::vector<std::size_t>();
}

std::ptrdiff_t slides_in(const Scene& scene, const std::vector<std::size_t>& chain) {
  return std::ranges::count(chain, Joint::Kind::slide, [&](std::size_t j) { return scene.joints[j].kind; });
}

/// Takes joints out, and the massless links that only they hold. What pushes the links pushes the body behind them.
void take_out(Scene& scene, const std::vector<bool>& joint_gone) {
  std::vector<std::size_t> number(scene.bodies.size()), behind(scene.bodies.size());
  std::iota(behind.begin(), behind.end(), std::size_t{0});
  for (std::size_t j = joint_gone.size(); j-- > 0;) {
    const Joint& joint = scene.joints[j];
    if (joint_gone[j] && joint.first != 0) behind[joint.first] = behind[joint.second];
  }
  std::vector<Body> rest;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (behind[i] != i) continue;
    number[i] = rest.size();
    rest.push_back(std::move(scene.bodies[i]));
  }
  for (std::size_t i = 0; i < number.size(); ++i) number[i] = number[behind[i]];
  for (Push& push : scene.pushes) {  // what slides exert between links, the ground exerts on the body
    if (behind[push.back_on] != push.back_on) push.back_on = 0;
  }
  std::vector<Joint> joints;
  for (std::size_t j = 0; j < joint_gone.size(); ++j) {
    if (!joint_gone[j]) joints.push_back(std::move(scene.joints[j]));
  }
  scene.bodies = std::move(rest);
  scene.joints = std::move(joints);
  renumber(scene, number);
}

}  // namespace

void join_planar_chains(Scene& scene) {
  std::vector<bool> gone(scene.joints.size());
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    const std::vector<std::size_t> chain = chain_of_three(scene, i);
    if (slides_in(scene, chain) != 2) continue;
    for (const std::size_t j : chain) gone[j] = true;
    scene.import_notes.push_back(scene.bodies[i].name + " slides along two axes and turns: it is free in their plane");
  }
  take_out(scene, gone);
}

void join_free_slides(Scene& scene) {
  std::vector<bool> gone(scene.joints.size());
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    const std::vector<std::size_t> chain = chain_of_three(scene, i);
    if (slides_in(scene, chain) != 3) continue;
    bool plain = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Joint &joint = scene.joints[chain[k]], &next = scene.joints[chain[(k + 1) % 3]];
      plain = plain && joint.friction.is_zero() && joint.armature.is_zero() && dot(joint.axis, next.axis).is_zero();
    }
    if (!plain) continue;
    for (const std::size_t j : chain) gone[j] = true;
    scene.bodies[i].turns = false;
    scene.import_notes.push_back(scene.bodies[i].name + " slides along three axes: it moves freely, and does not turn");
  }
  take_out(scene, gone);
}

void refuse_what_is_only_in_space(const Scene& scene, Mistakes& mistakes) {
  for (const OnlyInSpace& one : scene.only_in_space) mistakes.add(one.place, one.found);
}

bool are_joined(const Scene& scene, std::size_t a, std::size_t b) {
  const auto is_pair = [&](const auto& pair) { return pair == std::pair(a, b) || pair == std::pair(b, a); };
  if (std::ranges::any_of(scene.excluded, is_pair)) return true;
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
  if (base.empty() || std::isalpha(static_cast<unsigned char>(base.front())) == 0) base.insert(0, "b_");
  std::string result = base;
  for (int i = 2; std::ranges::find(used_, result) != used_.end(); ++i) result = base + "_" + std::to_string(i);
  used_.push_back(result);
  return result;
}

}  // namespace slipproof::imported
