#include "report/picture/arrows/mechanism_arrows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "report/picture/scene_numbers.hpp"

namespace slipproof {

namespace {

constexpr double plain_force = 34, contact_gap = 5, body_gap = 7, longest_velocity = 40, sliding_length = 24;

double length_of(Point v) {
  return std::hypot(v[0], v[1]);
}
Point halfway(Point from, Point to) {
  return {(from[0] + to[0]) / 2, (from[1] + to[1]) / 2};
}
bool has_direction(const MechanismGeometry::Contact& contact) {
  return contact.normal != Point{0, 0};
}

/// What several bodies share, each with its bodies: `v = 5 of car, trailer`.
class Shared {
 public:
  void add(const std::string& what, const std::string& body) {
    auto known = std::ranges::find(all_, what, [](const auto& one) { return one.first; });
    if (known == all_.end()) known = all_.insert(all_.end(), {what, {}});
    known->second.push_back(body);
  }
  std::vector<std::string> words() const {
    constexpr std::size_t most = 4;
    std::vector<std::string> words;
    for (const auto& [what, bodies] : all_) {
      words.push_back(bodies.size() > most ? fmt::format("{} of each of {} bodies", what, bodies.size())
                                           : fmt::format("{} of {}", what, fmt::join(bodies, " and ")));
    }
    return words;
  }

 private:
  std::vector<std::pair<std::string, std::vector<std::string>>> all_;
};

std::string size_of(const MechanismGeometry::Weight& weight, const NumberWords& numbers) {
  return weight.exact ? numbers.value(*weight.exact) : rounded_value(weight.size);
}

}  // namespace

Point moved(Point from, Point direction, double by) {
  return {from[0] + by * direction[0], from[1] - by * direction[1]};
}

double largest_arrow(const MechanismScene& scene, const MotionAtLoad& motion, const MechanismGeometry& geometry) {
  double largest = 0;
  const auto see = [&](double size) { largest = std::max(largest, std::abs(size)); };
  for (const MechanismGeometry::Contact& contact : geometry.contacts) {
    const MechanismContact& given = scene.mechanism.contacts[contact.index];
    for (const auto& force : {std::optional(given.normal), given.tangent}) {
      const auto value = force ? shown_value(range_of_force(scene, motion, *force)) : std::nullopt;
      if (value) see(drawn_size(*value));
    }
  }
  for (const auto& push : geometry.pushes) see(push.along == Point{0, 0} ? 0 : push.size);
  for (const auto& weight : geometry.weights) see(weight.size);
  return largest;
}

MechanismArrows::MechanismArrows(const Element& svg, const Input& input, PictureLabels& labels)
    : svg_(svg), in_(input), labels_(labels) {
  if (in_.motion == nullptr) return;
  const double largest = in_.largest > 0 ? in_.largest : largest_arrow(in_.scene, *in_.motion, in_.geometry);
  if (largest > 0) unit_ = in_.longest / largest;
}

void MechanismArrows::draw() {
  for (const auto& contact : in_.geometry.contacts) this->contact(contact);
  for (const auto& push : in_.geometry.pushes) this->push(push);
  for (const auto& weight : in_.geometry.weights) this->weight(weight);
  for (const auto& acceleration : in_.geometry.accelerations) this->acceleration(acceleration);
  for (const auto& outline : in_.geometry.outlines) shape(outline);
  double fastest = 0;
  for (const auto& movement : in_.geometry.movements) fastest = std::max(fastest, length_of(movement.velocity));
  for (const auto& movement : in_.geometry.movements) this->movement(movement, fastest);
}

double MechanismArrows::pixels(double size) const {
  return in_.motion == nullptr ? std::min(plain_force, in_.longest) : size * unit_;
}

void MechanismArrows::see(Point from, Point to) {
  labels_.avoid(from, to, 4);
  ends_.push_back(from), ends_.push_back(to);
}

void MechanismArrows::contact(const MechanismGeometry::Contact& contact) {
  const MechanismContact& given = in_.scene.mechanism.contacts[contact.index];
  std::string description = contact_text(in_.scene, in_.motion, contact.index);
  const auto draw = [&](std::size_t force, Point direction, bool pushes, std::string_view css) {
    if (in_.motion != nullptr)
      description += ", " + symbol_of(force) + " " + in_.numbers.range(range_of_force(in_.scene, *in_.motion, force));
    if (has_direction(contact)) this->force(in_.view.pixel(contact.at), force, direction, pushes, css);
  };
  draw(given.normal, contact.normal, true, "normal");
  if (given.tangent) draw(*given.tangent, contact.along, false, "friction");
  const ElementKind::Start start = in_.scene.values.starts[contact.index];
  if (start == ElementKind::Start::slides_forward || start == ElementKind::Start::slides_backward) {
    description += ", slides";
    sliding(contact, start == ElementKind::Start::slides_forward);
  } else if (const Rational slip = slip_of(contact.index); !slip.is_zero()) {
    const std::string value = in_.numbers.value(slip);
    description += ", " + given.slip_name + " " + value;
    if (!has_direction(contact)) return described_.push_back(std::move(description));
    const auto [from, to] = sliding(contact, slip > 0);
    if (in_.names) labels_.symbol({to, halfway(from, to)}, given.slip_name, value);
  }
  described_.push_back(std::move(description));
}

/// Draws an arrow that ends at the contact if it pushes, and begins there otherwise; its name is next to it.
void MechanismArrows::force(Point at, std::size_t unknown, Point direction, bool pushes, std::string_view css) {
  double length = pixels(1);
  bool determined = true;
  std::string value;
  if (in_.motion != nullptr) {
    const Range& range = range_of_force(in_.scene, *in_.motion, unknown);
    const double number = drawn_size(shown_value(range).value_or(Rational(0)));
    determined = range.is_point();
    value = in_.numbers.range(range);
    if (determined && number == 0) return;
    length = pixels(number);
  }
  // A pull leaves the contact on the side from which a push would come.
  const bool pulls = pushes && length < 0;
  const Point start =
      pushes && !pulls ? moved(at, direction, -length - contact_gap) : moved(at, direction, pulls ? -contact_gap : 0);
  const Point end = moved(start, direction, length);
  add_arrow(svg_, start, end[0] - start[0], end[1] - start[1], css, determined ? ArrowLine::solid : ArrowLine::dashed);
  see(start, end);
  drawn_.emplace_back(start, end);
  if (in_.names) labels_.symbol({pushes ? start : end, halfway(start, end)}, symbol_of(unknown), std::move(value));
}

/// The acceleration with which a contact begins to slip; 0 of one that does not.
Rational MechanismArrows::slip_of(std::size_t contact) const {
  if (in_.motion == nullptr || !in_.scene.mechanism.contacts[contact].slip) return 0;
  const std::string state = common_state(*in_.motion, contact);
  if (state != name(ElementState::slip_forward) && state != name(ElementState::slip_backward)) return 0;
  return in_.motion->accelerations[gap_index(in_.scene.mechanism, contact) + 1];
}

/// An arrow beside the contact, on the side of the body that slides.
std::pair<Point, Point> MechanismArrows::sliding(const MechanismGeometry::Contact& contact, bool forward) {
  const double way = forward ? sliding_length : -sliding_length;
  const Point from = moved(moved(in_.view.pixel(contact.at), contact.normal, 9), contact.along, -way / 2);
  const Point to = moved(from, contact.along, way);
  add_arrow(svg_, from, to[0] - from[0], to[1] - from[1], "moves");
  see(from, to);
  return {from, to};
}

/// Draws it beside an arrow of a force on the same line, where one would hide the other. Returns where it is.
std::pair<Point, Point> MechanismArrows::load_arrow(Point from, Point to, std::string_view css) {
  const auto hides = [&](const std::pair<Point, Point>& other) { return cover(from, to, other.first, other.second); };
  const double dx = to[0] - from[0], dy = to[1] - from[1], length = std::hypot(dx, dy);
  if (length > 0 && std::any_of(drawn_.begin(), drawn_.end(), hides)) {
    const Point aside{9 * dy / length, -9 * dx / length};
    from = {from[0] + aside[0], from[1] + aside[1]};
  }
  to = {from[0] + dx, from[1] + dy};
  add_arrow(svg_, from, dx, dy, css);
  see(from, to);
  drawn_.emplace_back(from, to);
  return {from, to};
}

/// An arrow or words that the file has, as they stand.
void MechanismArrows::shape(const MechanismGeometry::Outline& outline) {
  const Point from = in_.view.pixel(outline.points[0]);
  if (outline.kind == MechanismShape::Kind::label) labels_.words({from}, outline.text);
  if (outline.kind == MechanismShape::Kind::arrow) load_arrow(from, in_.view.pixel(outline.points[1]));
}

/// An arrow that ends where the force acts; of a couple its name and sense.
void MechanismArrows::push(const MechanismGeometry::Push& push) {
  const Point at = in_.view.pixel(push.at);
  if (push.along == Point{0, 0})
    return labels_.push({at}, push.name, push.value + (push.size > 0 ? " \u21ba" : " \u21bb"));
  const double length = pixels(push.size);
  const Point from = push.begins ? at : moved(at, push.along, -length);
  const auto [start, end] = load_arrow(from, moved(from, push.along, length));
  labels_.push({push.begins ? end : start, halfway(start, end)}, push.name, push.value);
  described_.push_back("pushed by " + push.name);
}

/// All are as long: accelerations have no scale in common with forces.
void MechanismArrows::acceleration(const MechanismGeometry::Acceleration& acceleration) {
  double length = plain_force;
  std::string value;
  if (in_.motion != nullptr) {
    const Rational& shown = in_.motion->accelerations[acceleration.index];
    value = in_.numbers.value(shown);
    length *= shown.sign();
    described_.push_back(acceleration.name + " " + value);
  }
  const Point at = in_.view.pixel(acceleration.at);
  const Point start = moved(at, acceleration.along, length < 0 ? -body_gap : body_gap);
  const Point end = moved(start, acceleration.along, length);
  if (length != 0) {
    add_arrow(svg_, start, end[0] - start[0], end[1] - start[1], "acceleration");
    see(start, end);
  }
  if (in_.names) labels_.symbol({end, halfway(start, end)}, acceleration.name, value);
}

void MechanismArrows::weight(const MechanismGeometry::Weight& weight) {
  const Point at = in_.view.pixel(weight.at);
  const auto [start, end] = load_arrow(at, moved(at, {0, -1}, pixels(weight.size)), "load weight");
  const std::string size = size_of(weight, in_.numbers);
  if (in_.names) labels_.words({end, halfway(start, end)}, "weight " + size);
  described_.push_back("weight of " + weight.body + " " + size);
}

/// The velocity of the body's centre, and its spin as part of a circle.
void MechanismArrows::movement(const MechanismGeometry::Movement& movement, double fastest) {
  const Point at = in_.view.pixel(movement.at);
  const double speed = length_of(movement.velocity);
  const bool named = in_.names && in_.geometry.movements.size() <= most_named;
  if (speed > 0) {
    const Point way{movement.velocity[0] / speed, movement.velocity[1] / speed};
    const Point end = moved(at, way, longest_velocity * speed / fastest);
    add_arrow(svg_, at, end[0] - at[0], end[1] - at[1], "moves", in_.is_virtual ? ArrowLine::dotted : ArrowLine::solid);
    see(at, end);
    if (named) labels_.words({end, halfway(at, end)}, "v " + rounded_value(speed));
    described_.push_back(movement.body + " moves with " + fmt::format("{:.4g}", speed));
  }
  if (movement.spin == 0) return;
  const double radius = add_turn(svg_, at, movement.spin > 0, "moves");
  labels_.avoid(LabelBox{at[0] - radius, at[1] - radius, at[0] + radius, at[1] + radius});
  ends_.push_back({at[0] - radius, at[1] - radius}), ends_.push_back({at[0] + radius, at[1] + radius});
  if (named)
    labels_.words({{at[0], at[1] - radius}, {at[0] + radius, at[1]}}, "spin " + rounded_value(std::abs(movement.spin)));
  described_.push_back(movement.body + (movement.spin > 0 ? " turns counterclockwise" : " turns clockwise"));
}

std::vector<std::string> weight_words(const MechanismGeometry& geometry, const NumberWords& numbers) {
  Shared weights;
  for (const auto& weight : geometry.weights) weights.add("weight " + size_of(weight, numbers), weight.body);
  return weights.words();
}

std::vector<std::string> movement_words(const MechanismGeometry& geometry) {
  Shared movements;
  for (const auto& movement : geometry.movements) {
    const double speed = length_of(movement.velocity);
    if (speed > 0) movements.add("v " + rounded_value(speed), movement.body);
    if (movement.spin != 0) movements.add("spin " + rounded_value(movement.spin), movement.body);
  }
  return movements.words();
}

}  // namespace slipproof
