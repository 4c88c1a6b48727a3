#include "report/picture/space/space_arrows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/markup/symbol.hpp"
#include "report/picture/labels/contact_table.hpp"
#include "report/picture/polyline.hpp"
#include "report/picture/space/flat.hpp"
#include "report/picture/space/scenery.hpp"

namespace slipproof {

namespace {

// In pixels, of what is not foreshortened.
constexpr double longest_push = 78, plain_push = 36, longest_way = 46, slip_reach = 30, turn_radius = 17;
constexpr double nothing = 1e-7;  ///< of the largest

const std::optional<Range>& force_of(const MechanismScene& scene, const SpaceMotion& motion, std::size_t unknown) {
  return motion.forces[unknown - scene.mechanism.accelerations];
}

/// The force on the body; nothing where a part of it is open.
std::optional<Vec3> force_at(const MechanismScene& scene, const SpaceMotion& motion,
                             const SpaceGeometry::Contact& contact) {
  const MechanismContact& c = scene.mechanism.contacts[contact.index];
  Vec3 force{};
  const auto add = [&](std::size_t unknown, const Vec3& along) {
    const auto& range = force_of(scene, motion, unknown);
    if (range) force = force + range_middle(*range) * along;
    return range.has_value();
  };
  bool known = add(c.normal, contact.normal);
  if (c.tangent) known = add(*c.tangent, contact.first) && known;
  if (c.second) known = add(c.second->force, contact.second) && known;
  return known ? std::optional(force) : std::nullopt;
}

/// 0 where the range holds it: it is not known to move.
double sure_middle(const Range& range) {
  const bool holds_zero = (!range.lower || range.lower->sign() <= 0) && (!range.upper || range.upper->sign() >= 0);
  return holds_zero ? 0 : range_middle(range);
}

/// Its acceleration, and its angular acceleration.
std::pair<Vec3, Vec3> accelerations(const SpaceGeometry::MovingBody& body, const SpaceMotion& motion) {
  std::array<double, 6> all = body.prescribed;
  for (std::size_t i = 0; i < 6; ++i) {
    const auto [unknown, sign] = body.unknowns[i];
    if (sign != 0) all[i] = sign * sure_middle(motion.accelerations[unknown]);
  }
  return {{all[0], all[1], all[2]}, {all[3], all[4], all[5]}};
}

Point halfway_to(Point from, Point to) {
  return {(from[0] + to[0]) / 2, (from[1] + to[1]) / 2};
}

}  // namespace

void SpaceSizes::see(const SpaceGeometry& geometry) {
  for (const auto& push : geometry.pushes) force = std::max(force, push.couple ? 0 : length(push.is));
  for (const auto& weight : geometry.weights) force = std::max(force, length(weight.is));
  for (const auto& body : geometry.bodies) {
    speed = std::max(speed, length(body.velocity));
    spin = std::max(spin, length(body.spin));
  }
}

void SpaceSizes::see(const MechanismScene& scene, const SpaceGeometry& geometry, const SpaceMotion& motion) {
  for (const auto& contact : geometry.contacts)
    force = std::max(force, length(force_at(scene, motion, contact).value_or(Vec3{})));
  for (const auto& body : geometry.bodies) {
    const auto [straight, turning_now] = accelerations(body, motion);
    acceleration = std::max(acceleration, length(straight));
    turning = std::max(turning, length(turning_now));
  }
}

SpaceArrows::SpaceArrows(const Element& svg, const Input& input, PictureLabels& labels)
    : svg_(svg), in_(input), labels_(labels) {
  if (in_.sizes.force > 0) force_unit_ = longest_push / in_.view.scale() / in_.sizes.force;
}

void SpaceArrows::draw() {
  for (std::size_t i = 0; i < in_.geometry.contacts.size(); ++i) contact(i);
  for (const auto& push : in_.geometry.pushes) this->push(push);
  for (const auto& weight : in_.geometry.weights) this->weight(weight);
  for (const auto& body : in_.geometry.bodies) this->body(body);
}

Point SpaceArrows::see(const Vec3& p) {
  ends_.push_back(in_.view.pixel(p));
  return ends_.back();
}

void SpaceArrows::arrow(const Vec3& from, const Vec3& to, std::string_view css, ArrowLine line, Anchor anchor) {
  strokes_.push_back(
      {SpaceStroke::Kind::arrow, anchor == Anchor::start ? from : to, {from, to}, std::string(css), line});
  const Point start = see(from), end = see(to);
  add_arrow(svg_, start, end[0] - start[0], end[1] - start[1], css, line);
  labels_.avoid(start, end, 4);
}

void SpaceArrows::contact(std::size_t number) {
  const SpaceGeometry::Contact& contact = in_.geometry.contacts[number];
  const Point at = see(contact.at);
  const bool lifts = in_.motion != nullptr && in_.motion->modes[contact.index] == "lift";
  in_.motion == nullptr ? contact_directions(contact) : contact_force(contact);
  if (in_.motion != nullptr && in_.motion->slips[contact.index]) slip(contact, *in_.motion->slips[contact.index]);
  const std::string css = lifts ? "contact paper frame" : "contact ink";
  svg_.add("circle", css).set("cx", at[0]).set("cy", at[1]).set("r", 3);
  strokes_.push_back({SpaceStroke::Kind::dot, contact.at, {contact.at}, css});
  labels_.avoid(LabelBox{at[0] - 4, at[1] - 4, at[0] + 4, at[1] + 4});
  const std::string words = contact_text(in_.scene, in_.motion, contact.index);
  names_.push_back({contact.at, contact.at, in_.lettered ? contact_letter(contact.index) : words});
  labels_.words({at}, names_.back().text);
  described_.push_back(words);
}

/// From the contact, into its cone: the circle is as high as N, and mu times as wide.
void SpaceArrows::contact_force(const SpaceGeometry::Contact& contact) {
  const MechanismContact& c = in_.scene.mechanism.contacts[contact.index];
  const auto force = force_at(in_.scene, *in_.motion, contact);
  if (!force || length(*force) <= nothing * in_.sizes.force) return;
  const auto narrow = [&](std::size_t unknown) {
    return in_.numbers.is_narrow(*force_of(in_.scene, *in_.motion, unknown));
  };
  const bool determined =
      narrow(c.normal) && (!c.tangent || narrow(*c.tangent)) && (!c.second || narrow(c.second->force));
  if (contact.mu > 0) cone(contact, force_unit_ * dot(*force, contact.normal));
  arrow(contact.at, contact.at + force_unit_ * *force, "friction", determined ? ArrowLine::solid : ArrowLine::dashed);
  signs_.insert(determined ? SpaceSign::force : SpaceSign::open_force);
}

void SpaceArrows::contact_directions(const SpaceGeometry::Contact& contact) {
  const MechanismContact& c = in_.scene.mechanism.contacts[contact.index];
  const double reach = plain_push / in_.view.scale();
  const auto direction = [&](std::size_t unknown, const Vec3& along, std::string_view css) {
    constexpr double seen = 8;  // in pixels
    const Vec3 end = contact.at + reach * along;
    arrow(contact.at, end, css);
    const Point start = in_.view.pixel(contact.at), tip = in_.view.pixel(end);
    if (in_.lettered || std::hypot(tip[0] - start[0], tip[1] - start[1]) < seen) return;
    name_once(force_symbol(in_.scene.mechanism, contact.index, unknown), start, tip);
  };
  direction(c.normal, contact.normal, "normal");
  signs_.insert(SpaceSign::normal);
  if (c.tangent) signs_.insert(SpaceSign::tangents);
  if (c.tangent) direction(*c.tangent, contact.first, "friction");
  if (c.second) direction(c.second->force, contact.second, "friction");
}

/// Contacts that are behind each other have one name for what looks the same.
void SpaceArrows::name_once(const std::string& symbol, Point start, Point tip) {
  constexpr double same_place = 10;
  const auto same = [&](const auto& other) {
    return other.first == plain_symbol(symbol) &&
           std::hypot(other.second[0] - tip[0], other.second[1] - tip[1]) < same_place;
  };
  if (std::ranges::any_of(named_, same)) return;
  named_.emplace_back(plain_symbol(symbol), tip);
  labels_.symbol({tip, halfway_to(start, tip)}, symbol, {});
}

void SpaceArrows::cone(const SpaceGeometry::Contact& contact, double height) {
  constexpr int sides = 32;
  std::vector<Vec3> circle;
  std::vector<Point> outline{in_.view.pixel(contact.at)};
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides, radius = contact.mu * height;
    circle.push_back(contact.at + height * contact.normal + radius * std::cos(angle) * contact.first +
                     radius * std::sin(angle) * contact.second);
    outline.push_back(see(circle.back()));
  }
  std::vector<Pixel> hull;
  for (const Point& p : hull_of(outline)) hull.push_back({p[0], p[1]});
  if (hull.size() < 3) return;
  strokes_.push_back({SpaceStroke::Kind::cone, contact.at, circle, "cone"});
  svg_.add("path", "cone").set("d", closed_path_of(hull));
  svg_.add("path", "cone").set("d", path_through(circle, in_.view));
  signs_.insert(SpaceSign::cone);
}

/// In the plane of the contact: the direction, and all that its enclosure holds.
void SpaceArrows::slip(const SpaceGeometry::Contact& contact, const Range& degrees) {
  constexpr double to_radians = std::numbers::pi / 180, seen = 1;
  const double reach = slip_reach / in_.view.scale();
  const auto at = [&](double angle) {
    return contact.at + reach * std::cos(angle * to_radians) * contact.first +
           reach * std::sin(angle * to_radians) * contact.second;
  };
  const double middle = range_middle(degrees),
               width = range_middle({degrees.upper, degrees.upper}) - range_middle({degrees.lower, degrees.lower});
  if (width > seen) {
    std::vector<Vec3> sector{contact.at};
    constexpr int steps = 24;
    for (int i = 0; i <= steps; ++i) sector.push_back(at(middle - width / 2 + i * width / steps));
    for (const Vec3& p : sector) see(p);
    strokes_.push_back({SpaceStroke::Kind::area, contact.at, sector, "arc"});
    svg_.add("path", "arc").set("d", path_through(sector, in_.view));
  }
  const bool slides = in_.scene.values.starts[contact.index] != ElementKind::Start::rest;
  arrow(contact.at, at(middle), "slips", slides ? ArrowLine::solid : ArrowLine::dotted);
  signs_.insert(slides ? SpaceSign::sliding : SpaceSign::slip);
  described_.push_back(in_.scene.mechanism.contacts[contact.index].name + " slips at " + angle_text(degrees));
}

void SpaceArrows::push(const SpaceGeometry::Push& push) {
  const bool plain = in_.motion == nullptr;
  described_.push_back("pushed by " + push.name);
  signs_.insert(SpaceSign::load);
  names_.push_back({push.at, push.at, plain_symbol(push.name) + (push.value.empty() ? "" : " " + push.value)});
  if (push.couple)
    return labels_.push(turn(push.at, push.is, turn_radius + 5, "load", ArrowLine::solid), push.name, push.value);
  const Vec3 way = (plain ? plain_push / in_.view.scale() : force_unit_ * length(push.is)) * direction_of(push.is);
  names_.back().at = push.at - way;
  arrow(push.at - way, push.at, "load", ArrowLine::solid, Anchor::end);
  const Point start = in_.view.pixel(push.at - way), end = in_.view.pixel(push.at);
  labels_.push({start, halfway_to(start, end)}, push.name, push.value);
}

void SpaceArrows::weight(const SpaceGeometry::Weight& weight) {
  const bool plain = in_.motion == nullptr;
  const double reach = plain ? plain_push / in_.view.scale() : force_unit_ * length(weight.is);
  const Vec3 end = weight.at + reach * direction_of(weight.is);
  arrow(weight.at, end, "load weight");
  const std::string words = quantity("weight", length(weight.is), "N", "");
  const Point tip = in_.view.pixel(end);
  if (named() && !in_.lettered) {
    labels_.words({tip, halfway_to(in_.view.pixel(weight.at), tip)}, words);
    names_.push_back({weight.at, end, words});
  }
  described_.push_back(words + " of " + weight.body);
  signs_.insert(SpaceSign::load);
}

void SpaceArrows::body(const SpaceGeometry::MovingBody& body) {
  straight(body.at, body.velocity, true, body.name, in_.sizes.speed);
  const auto turning = [&](const Vec3& axis, bool before, double largest) {
    if (length(axis) <= nothing * largest || largest == 0) return;
    const std::string words = quantity(before ? "spin" : after("spin", "turning", "turns at a rate of"), length(axis),
                                       before || in_.geometry.is_impact ? "rad/s" : "rad/s²", body.name);
    const auto places = turn(body.at, axis, before ? turn_radius : turn_radius + 8,
                             before ? "velocity" : "acceleration", before ? ArrowLine::solid : ArrowLine::dotted);
    if (named()) labels_.words(places, words);
    sign_of_motion(before);
    describe(body.name, words);
  };
  turning(body.spin, true, in_.sizes.spin);
  if (in_.motion == nullptr) return;
  const auto [acceleration, angular] = accelerations(body, *in_.motion);
  straight(body.at, acceleration, false, body.name, in_.sizes.acceleration);
  turning(angular, false, in_.sizes.turning);
}

void SpaceArrows::straight(const Vec3& at, const Vec3& way, bool before, const std::string& name, double size) {
  if (size == 0 || length(way) <= nothing * size) return;
  const Vec3 end = at + (longest_way / in_.view.scale() / size) * way;
  arrow(at, end, before ? "velocity" : "acceleration", before ? ArrowLine::solid : ArrowLine::dotted);
  const std::string words = quantity(before ? "v" : after("v", "a", "moves at a rate of"), length(way),
                                     before || in_.geometry.is_impact ? "m/s" : "m/s²", name);
  const Point from = in_.view.pixel(at), to = in_.view.pixel(end);
  if (named()) {
    labels_.words({to, halfway_to(from, to)}, words);
    names_.push_back({at, end, words});
  }
  sign_of_motion(before);
  describe(name, words);
}

void SpaceArrows::sign_of_motion(bool before) {
  signs_.insert(before ? SpaceSign::velocity : in_.is_virtual ? SpaceSign::virtual_rate : SpaceSign::acceleration);
}

/// What an impact makes of a velocity, or otherwise its change, or the rate of a virtual motion.
std::string SpaceArrows::after(const char* velocity, const char* change, const char* rate) const {
  if (in_.geometry.is_impact) return std::string(velocity) + " after";
  return in_.is_virtual ? rate : change;
}

/// `v = 3 m/s`; with several bodies `cart: v = 3 m/s`.
std::string SpaceArrows::quantity(const std::string& symbol, double value, const std::string& unit,
                                  const std::string& body) const {
  const bool has_unit = in_.geometry.has_units && !(in_.is_virtual && unit.ends_with("²"));
  std::string words = symbol + " " + rounded_value(value) + (has_unit ? " " + unit : "");
  return body.empty() || in_.geometry.bodies.size() < 2 ? words : body + ": " + words;
}

void SpaceArrows::describe(const std::string& body, const std::string& words) {
  described_.push_back(words.starts_with(body + ": ") ? words : body + ": " + words);
}

std::vector<Point> SpaceArrows::turn(const Vec3& at, const Vec3& axis, double radius, std::string_view css,
                                     ArrowLine line) {
  constexpr int steps = 24;
  const AcrossDirections across(direction_of(axis));
  const double reach = radius / in_.view.scale();
  std::vector<Pixel> arc;
  std::vector<Point> near;
  strokes_.push_back({SpaceStroke::Kind::turn, at, {}, std::string(css), line});
  for (int i = 0; i <= steps; ++i) {
    const double angle = 1.5 * std::numbers::pi * i / steps;
    strokes_.back().points.push_back(at + reach * std::cos(angle) * across.first +
                                     reach * std::sin(angle) * across.second);
    const Point p = see(strokes_.back().points.back());
    if (i > 0) labels_.avoid({arc.back().x, arc.back().y}, p, 3);
    arc.push_back({p[0], p[1]});
    if (i % 6 == 0) near.push_back(p);
  }
  const Element path = svg_.add("path", css).set("style", "fill:none").set("d", path_of(arc));
  if (line == ArrowLine::dotted) path.set("stroke-dasharray", dashes_of(line));
  const Pixel before = arc[arc.size() - 2], end = arc.back();
  const double dx = end.x - before.x, dy = end.y - before.y, step = std::max(std::hypot(dx, dy), 0.1);
  add_arrow(svg_, {end.x, end.y}, 8 * dx / step, 8 * dy / step, css);
  ends_.push_back({end.x + 8 * dx / step, end.y + 8 * dy / step});
  return near;
}

}  // namespace slipproof
