#include "contact/exchange/planar.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/input/toml.hpp"
#include "base/number/format.hpp"
#include "base/output/listed.hpp"
#include "contact/exchange/planar_contacts.hpp"
#include "contact/exchange/view.hpp"
#include "mechanics/reading/read_mechanism.hpp"

namespace slipproof::imported {

namespace {

std::string quoted(const Rational& x) {
  return toml_string(exact_text(x));
}
std::string quoted(const Point& p) {
  return fmt::format("[{}, {}]", quoted(p.x), quoted(p.y));
}

const View& view_of(const Scene& scene, const std::string& wanted, Mistakes& mistakes) {
  std::vector<std::string> reasons;
  for (const View& view : views()) {
    if (!wanted.empty() && view.name != wanted) continue;
    const std::vector<std::string> why = leaves(scene, view);
    if (why.empty()) return view;
    reasons.push_back(fmt::format("{}: {}", view.name, listed(why, "; ")));
  }
  if (reasons.empty()) reasons.push_back("found the plane " + in_quotes(wanted) + ", expected xz, yz or xy");
  mistakes.add({}, "the scene does not stay in a plane (--spatial reads it in space): " + listed(reasons, "; "));
  mistakes.refuse_if_any();
  return views().front();
}

class PlanarWriter {
 public:
  PlanarWriter(const Scene& scene, const View& view, const PlanarOptions& options, Mistakes& mistakes)
      : scene_(scene), view_(view), options_(options), mistakes_(mistakes) {
    names_("ground");
  }

  PlanarMechanism write() {
    std::string bodies, held;
    body_names_.emplace_back("ground");
    for (std::size_t i = 1; i < scene_.bodies.size(); ++i) body_names_.push_back(names_(scene_.bodies[i].name));
    for (std::size_t i = 1; i < scene_.bodies.size(); ++i) bodies += body(i);
    for (const Joint& one : scene_.joints) held += joint(one);
    const std::string touching = contacts();
    result_.import_notes = scene_.import_notes;
    result_.import_notes.insert(result_.import_notes.end(), contact_notes_.begin(), contact_notes_.end());
    result_.plane = view_.name;
    result_.text = head() + bodies + held + touching;
    return std::move(result_);
  }

 private:
  std::string head() const {
    std::string text;
    text += fmt::format("# {} {} in its plane {}. What was left out, moved, turned or assumed:\n", scene_.format,
                        scene_.name, view_.name);
    for (const std::string& one : result_.import_notes) text += "# - " + one + "\n";
    text += "schema = \"slipproof/mechanism/1\"\n";
    text += "name = " + toml_string(scene_.name.empty() ? scene_.format : scene_.name) + "\n";
    const Point gravity = view_(*scene_.gravity);
    text += "gravity = " + (gravity == Point{} ? "\"none\"" : quoted(gravity)) + "\n";
    return text;
  }

  std::string body(std::size_t i) {
    const Body& body = scene_.bodies[i];
    std::string text = fmt::format("\n[[body]]\nname = {}\nmass = {}\ninertia = {}\nat = {}\n",
                                   toml_string(body_names_[i]), quoted(body.mass),
                                   quoted(body.inertia.between(view_.toward, view_.toward)), quoted(view_(body.at)));
    std::vector<std::string> shapes;
    for (const Shape& shape : body.shapes) {
      std::string why;
      const auto outline = outline_of(shape, view_, why);
      if (!outline) continue;
      const auto own = [&](const Point& p) { return quoted(p - view_(body.at)); };
      if (!outline->corners.empty()) shapes.push_back("{ polygon = [" + listed(outline->corners, own) + "] }");
      for (const Point& c : outline->centres) {
        shapes.push_back(fmt::format("{{ circle = {}, at = {} }}", quoted(outline->radius), own(c)));
      }
    }
    if (shapes.size() == 1) text += "shape = " + shapes[0] + "\n";
    if (shapes.size() > 1) text += "shape = [" + listed(shapes) + "]\n";
    return text;
  }

  Point in_body(std::size_t body, const Point& p) const { return body == 0 ? p : p - view_(scene_.bodies[body].at); }

  std::string joint(const Joint& joint) {
    const std::string name = names_(joint.name),
                      between = fmt::format("between = [{}, {}]\n", toml_string(body_names_[joint.first]),
                                            toml_string(body_names_[joint.second]));
    const bool hinge = joint.kind == Joint::Kind::hinge;
    std::string text = fmt::format("\n[[joint]]\nname = {}\nkind = \"{}\"\n{}at = {}\n", toml_string(name),
                                   hinge ? "pin" : "slider", between, quoted(in_body(joint.first, view_(joint.at))));
    if (!hinge) {
      const auto axis = direction_of(joint.axis);
      if (!axis) mistakes_.add(joint.place, joint.name + ": found an axis whose length is not rational");
      if (axis) text += "axis = " + quoted(view_(*axis)) + "\n";
    }
    if (joint.friction.is_zero()) return text;
    if (!hinge) mistakes_.add(joint.place, joint.name + ": found friction in a slider, expected none");
    return text + fmt::format("\n[[friction]]\nname = {}\n{}limit = {}\n",
                              toml_string(names_(joint.name + "_friction")), between, quoted(joint.friction));
  }

  std::string contacts() {
    std::string text;
    for (const PlanarContact& c : planar_contacts(scene_, view_, options_.touch, mistakes_)) {
      const std::string& own = body_names_[c.of];
      text += fmt::format("\n[[contact]]\nname = {}\nof = {}\npoint = {}\n",
                          toml_string(names_(own + (c.on == 0 ? "" : "_on_" + body_names_[c.on]) + "_touch")),
                          toml_string(own), quoted(in_body(c.of, c.centre)));
      if (!c.radius.is_zero()) text += "radius = " + quoted(c.radius) + "\n";
      if (c.on != 0) text += "on = " + toml_string(body_names_[c.on]) + "\n";
      if (c.normal) {
        text += fmt::format("normal = {}\nthrough = {}\n", quoted(*c.normal), quoted(in_body(c.on, c.through)));
      } else {
        text += fmt::format("on_point = {}\non_radius = {}\n", quoted(in_body(c.on, c.through)), quoted(c.on_radius));
      }
      const Rational mu = friction_at(scene_, *c.line_of, *c.point_of, options_, mistakes_);
      text += "friction = " + quoted(mu) + "\n";
      if (!c.distance.is_zero()) {
        contact_notes_.push_back(c.point_of->name + " and " + c.line_of->name + ": " + distance_in_words(c.distance) +
                                 ", moved to touch");
      }
      ++result_.contacts;
    }
    return text;
  }

  const Scene& scene_;
  const View& view_;
  const PlanarOptions& options_;
  Mistakes& mistakes_;
  Identifiers names_;
  std::vector<std::string> body_names_, contact_notes_;
  PlanarMechanism result_;
};

}  // namespace

PlanarMechanism to_planar(Scene scene, const PlanarOptions& options) {
  complete(scene, options);
  Mistakes mistakes(scene.file);
  refuse_what_is_only_in_space(scene, mistakes);
  mistakes.refuse_if_any();
  join_planar_chains(scene);
  const View& view = view_of(scene, options.plane, mistakes);
  PlanarMechanism result = PlanarWriter(scene, view, options, mistakes).write();
  mistakes.refuse_if_any();
  parse_mechanism(result.text, "the mechanism that follows from " + scene.file);  // refuses what no mechanism is
  return result;
}

}  // namespace slipproof::imported
