#include "contact/exchange/spatial.hpp"

#include <algorithm>

#include "contact/exchange/shapes/spatial_contacts.hpp"
#include "contact/problem/solutions.hpp"

namespace slipproof::imported {

namespace {

class SpatialBuilder {
 public:
  SpatialBuilder(const Scene& scene, const TouchOptions& options, Mistakes& mistakes)
      : scene_(scene), options_(options), mistakes_(mistakes) {}

  SpatialProblem build() {
    const std::size_t size = 6 * (scene_.bodies.size() - 1);
    result_.problem.title = scene_.name;
    result_.problem.M.assign(size, std::vector<Rational>(size));
    result_.problem.f.assign(size, 0);
    result_.problem.H.resize(size);
    result_.problem.G.resize(size);
    for (std::size_t i = 1; i < scene_.bodies.size(); ++i) add_body(i);
    std::vector<std::string> import_notes;
    const auto contacts = spatial_contacts(scene_, options_.touch, mistakes_, import_notes);
    for (const SpatialContact& contact : contacts) add_contact(contact, import_notes);
    for (const Joint& joint : scene_.joints) add_joint(joint);
    result_.import_notes = scene_.import_notes;
    result_.import_notes.insert(result_.import_notes.end(), import_notes.begin(), import_notes.end());
    return std::move(result_);
  }

 private:
  void add_body(std::size_t i) {
    const Body& body = scene_.bodies[i];
    const std::size_t at = 6 * (i - 1);
    const auto axes = Turn().axes;
    for (std::size_t k = 0; k < 3; ++k) {
      result_.problem.M[at + k][at + k] = body.mass;
      result_.problem.f[at + k] = body.mass * (*scene_.gravity)[k];
      for (std::size_t l = 0; l < 3; ++l) {
        result_.problem.M[at + 3 + k][at + 3 + l] = body.inertia.between(axes[k], axes[l]);
      }
    }
  }

  /// A column: how a point at `at` of one body moves along `direction` against the same point of another; or, without a
  /// point, how they turn about it.
  void add_column(RationalMatrix& to, std::size_t of, std::size_t on, const Vector& direction, const Vector* at) {
    for (auto& row : to) row.emplace_back(0);
    for (const auto& [body, sign] : {std::pair(of, 1), std::pair(on, -1)}) {
      if (body == 0) continue;
      const Vector turning = at == nullptr ? direction : cross(*at - scene_.bodies[body].at, direction);
      for (std::size_t k = 0; k < 3; ++k) {
        if (at != nullptr) to[6 * (body - 1) + k].back() += Rational(sign) * direction[k];
        to[6 * (body - 1) + 3 + k].back() += Rational(sign) * turning[k];
      }
    }
  }

  void add_contact(const SpatialContact& c, std::vector<std::string>& import_notes) {
    GlobalProblem& p = result_.problem;
    const auto [first, second] = tangents(c.normal);
    for (const Vector& direction : {c.normal, first, second}) {
      add_column(p.H, c.of, c.on, direction, &c.at);
      p.w.emplace_back(0);
    }
    p.mu.push_back(friction_at(scene_, *c.shape_on, *c.shape_of, options_, mistakes_));
    p.contacts.push_back(names_(c.shape_of->name + "_on_" + c.shape_on->name));
    if (!c.distance.is_zero()) {
      import_notes.push_back(p.contacts.back() + ": " + distance_in_words(c.distance) + ", moved to touch");
    }
  }

  void add_joint(const Joint& joint) {
    const auto axis = direction_of(joint.axis);
    if (!axis) return mistakes_.add(joint.place, joint.name + ": found an axis whose length is not rational");
    if (!joint.friction.is_zero()) {
      mistakes_.add(joint.place, joint.name + ": found friction in a joint, expected none in space");
    }
    const auto [first, second] = tangents(*axis);
    GlobalProblem& p = result_.problem;
    const auto hold = [&](const Vector& direction, const Vector* at) {
      add_column(p.G, joint.second, joint.first, direction, at);
      p.b.emplace_back(0);
    };
    for (const Vector& direction : {first, second}) {
      hold(direction, nullptr);
      hold(direction, &joint.at);
    }
    hold(*axis, joint.kind == Joint::Kind::hinge ? &joint.at : nullptr);
  }

  const Scene& scene_;
  const TouchOptions& options_;
  Mistakes& mistakes_;
  Identifiers names_;
  SpatialProblem result_;
};

}  // namespace

SpatialProblem to_spatial(Scene scene, const TouchOptions& options) {
  complete(scene, options);
  Mistakes mistakes(scene.file);
  refuse_what_is_only_in_space(scene, mistakes);
  mistakes.refuse_if_any();
  join_planar_chains(scene);
  SpatialProblem result = SpatialBuilder(scene, options, mistakes).build();
  mistakes.refuse_if_any();
  if (!positive_definite(result.problem.M)) {
    mistakes.add({}, "found a mass or an inertia that is not positive, expected positive ones");
  }
  if (result.problem.contacts.empty()) {
    mistakes.add(
        {}, "found nothing that touches within " + options.touch.str() + ", expected contacts (--touch, --ground)");
  }
  mistakes.refuse_if_any();
  return result;
}

}  // namespace slipproof::imported
