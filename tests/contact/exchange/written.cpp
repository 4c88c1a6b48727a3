#include "contact/exchange/written.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace slipproof::test {

namespace {

const WrittenJoint* holder(const WrittenScene& scene, const WrittenBody& body) {
  const auto found = std::ranges::find(scene.joints, body.name, &WrittenJoint::second);
  return found == scene.joints.end() ? nullptr : &*found;
}

/// A quarter turn about an axis takes a cylinder from z.
std::string turn(const WrittenBody& body) {
  if (body.kind == "cylinder") return "1.5707963267948966 0 0";
  return body.kind == "bar" ? "0 1.5707963267948966 0" : "0 0 0";
}

std::string sizes(const WrittenBody& body, const Rational& times) {
  std::string text;
  for (const Rational& size : body.size) text += (text.empty() ? "" : " ") + decimal(size * times);
  return text;
}

}  // namespace

std::string decimal(const Rational& x) {
  Rational scaled = abs(x);
  int places = 0;
  for (; denominator(scaled) != 1; ++places) {
    if (places > 30) throw std::logic_error("no decimal");
    scaled *= 10;
  }
  std::string digits = scaled.str();
  if (places > 0) {
    if (digits.size() <= static_cast<std::size_t>(places)) {
      digits.insert(0, static_cast<std::size_t>(places) + 1 - digits.size(), '0');
    }
    digits.insert(digits.size() - static_cast<std::size_t>(places), ".");
  }
  return (x.sign() < 0 ? "-" : "") + digits;
}

std::string WrittenScene::urdf() const {
  std::string text = "<robot name=\"scene\">\n<link name=\"world\"/>\n";
  for (const WrittenBody& b : bodies) {
    std::string geometry = fmt::format("<box size=\"{}\"/>", sizes(b, 1));
    if (b.kind == "sphere") geometry = fmt::format("<sphere radius=\"{}\"/>", decimal(b.size[0]));
    if (b.kind == "cylinder" || b.kind == "bar") {
      geometry = fmt::format("<cylinder radius=\"{}\" length=\"{}\"/>", decimal(b.size[0]), decimal(b.size[1]));
    }
    text += fmt::format("<link name=\"{}\">\n", b.name);
    if (!b.fixed) {
      text += fmt::format(
          "<inertial><mass value=\"{0}\"/><inertia ixx=\"{1}\" ixy=\"0\" ixz=\"0\" iyy=\"{1}\" iyz=\"0\" "
          "izz=\"{1}\"/></inertial>\n",
          decimal(b.mass), decimal(b.inertia));
    }
    text +=
        fmt::format("<collision><origin rpy=\"{}\"/><geometry>{}</geometry></collision>\n</link>\n", turn(b), geometry);
  }
  for (const WrittenBody& b : bodies) {
    const WrittenJoint* joint = holder(*this, b);
    if (joint == nullptr) {
      text += fmt::format(
          "<joint name=\"at_{0}\" type=\"{1}\"><parent link=\"world\"/><child link=\"{0}\"/><origin xyz=\"{2} 0 "
          "{3}\"/></joint>\n",
          b.name, b.fixed ? "fixed" : "floating", decimal(b.x), decimal(b.z));
      continue;
    }
    // The link's frame is the joint's: one between stands where the body is.
    Rational x = joint->x, z = joint->z;
    for (const WrittenBody& first : bodies) {
      if (first.name == joint->first) x -= first.x, z -= first.z;
    }
    text += fmt::format(
        "<link name=\"on_{0}\"/>\n<joint name=\"{1}\" type=\"{2}\"><parent link=\"{3}\"/><child link=\"on_{0}\"/>"
        "<origin xyz=\"{4} 0 {5}\"/><axis xyz=\"{6}\"/>{7}</joint>\n"
        "<joint name=\"at_{0}\" type=\"fixed\"><parent link=\"on_{0}\"/><child link=\"{0}\"/><origin xyz=\"{8} 0 "
        "{9}\"/></joint>\n",
        b.name, joint->name, joint->kind == "hinge" ? "continuous" : "prismatic",
        joint->first.empty() ? "world" : joint->first, decimal(x), decimal(z),
        joint->kind == "hinge" ? "0 1 0" : "0 0 1",
        joint->kind == "hinge" ? "" : "<limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/>",
        decimal(b.x - joint->x), decimal(b.z - joint->z));
  }
  return text + "</robot>\n";
}

std::string WrittenScene::sdf() const {
  std::string text = "<sdf version=\"1.9\"><world name=\"scene\"><gravity>0 0 -9.81</gravity>\n";
  const std::string friction =
      fmt::format("<surface><friction><ode><mu>{0}</mu><mu2>{0}</mu2></ode></friction></surface>", decimal(mu));
  const std::string rough =
      "<surface><friction><ode><mu>77</mu><mu2>77</mu2></ode></friction></surface>";  // the lesser counts
  text += fmt::format(
      "<model name=\"plane\"><static>true</static><link name=\"l\"><collision name=\"c\"><geometry><plane>"
      "<normal>0 0 1</normal><size>1 1</size></plane></geometry>{}</collision></link></model>\n<model name=\"all\">\n",
      friction);
  for (const WrittenBody& b : bodies) {
    std::string geometry = fmt::format("<box><size>{}</size></box>", sizes(b, 1));
    if (b.kind == "sphere") geometry = fmt::format("<sphere><radius>{}</radius></sphere>", decimal(b.size[0]));
    if (b.kind == "cylinder" || b.kind == "bar") {
      geometry = fmt::format("<cylinder><radius>{}</radius><length>{}</length></cylinder>", decimal(b.size[0]),
                             decimal(b.size[1]));
    }
    text += fmt::format(
        "<link name=\"{0}\"><pose>{1} 0 {2} 0 0 "
        "0</pose><inertial><mass>{3}</mass><inertia><ixx>{4}</ixx><ixy>0</ixy><ixz>0</ixz>"
        "<iyy>{4}</iyy><iyz>0</iyz><izz>{4}</izz></inertia></inertial><collision name=\"c\"><pose>0 0 0 {5}</pose>"
        "<geometry>{6}</geometry>{7}</collision></link>\n",
        b.name, decimal(b.x), decimal(b.z), decimal(b.mass), decimal(b.inertia), turn(b), geometry,
        bodies.size() > 1 ? friction : rough);
    if (b.fixed)
      text += fmt::format("<joint name=\"at_{0}\" type=\"fixed\"><parent>world</parent><child>{0}</child></joint>\n",
                          b.name);
  }
  for (const WrittenJoint& j : joints) {
    text += fmt::format(
        "<joint name=\"{}\" type=\"{}\"><pose relative_to=\"__model__\">{} 0 {} 0 0 "
        "0</pose><parent>{}</parent><child>{}</child>"
        "<axis><xyz>{}</xyz></axis></joint>\n",
        j.name, j.kind == "hinge" ? "revolute" : "prismatic", decimal(j.x), decimal(j.z),
        j.first.empty() ? "world" : j.first, j.second, j.kind == "hinge" ? "0 1 0" : "0 0 1");
  }
  return text + "</model></world></sdf>\n";
}

std::string WrittenScene::mjcf() const {
  const auto body_text = [&](const auto& self, const WrittenBody& b, const Rational& x,
                             const Rational& z) -> std::string {
    std::string text = fmt::format("<body name=\"{}\" pos=\"{} 0 {}\">\n", b.name, decimal(b.x - x), decimal(b.z - z));
    const WrittenJoint* joint = holder(*this, b);
    if (joint != nullptr) {
      text += fmt::format("<joint name=\"{}\" type=\"{}\" pos=\"{} 0 {}\" axis=\"{}\"/>\n", joint->name, joint->kind,
                          decimal(joint->x - b.x), decimal(joint->z - b.z), joint->kind == "hinge" ? "0 1 0" : "0 0 1");
    } else if (!b.fixed) {
      text += "<freejoint/>\n";
    }
    text += fmt::format("<inertial pos=\"0 0 0\" mass=\"{0}\" diaginertia=\"{1} {1} {1}\"/>\n", decimal(b.mass),
                        decimal(b.inertia));
    if (b.kind == "box") text += fmt::format("<geom type=\"box\" size=\"{}\"/>\n", sizes(b, Rational(1, 2)));
    if (b.kind == "sphere") text += fmt::format("<geom type=\"sphere\" size=\"{}\"/>\n", decimal(b.size[0]));
    if (b.kind == "cylinder" || b.kind == "bar") {
      text += fmt::format("<geom type=\"cylinder\" size=\"{} {}\" euler=\"{}\"/>\n", decimal(b.size[0]),
                          decimal(b.size[1] / 2), b.kind == "bar" ? "0 90 0" : "90 0 0");
    }
    for (const WrittenBody& child : bodies) {
      const WrittenJoint* held = holder(*this, child);
      if (held != nullptr && held->first == b.name) text += self(self, child, b.x, b.z);
    }
    return text + "</body>\n";
  };
  std::string text = fmt::format(
      "<mujoco model=\"scene\"><option gravity=\"0 0 -9.81\"/><default><geom friction=\"{} 0 0\"/></default>\n"
      "<worldbody><geom type=\"plane\" size=\"1 1 1\" friction=\"0 0 0\"/>\n",
      decimal(mu));
  for (const WrittenBody& b : bodies) {
    const WrittenJoint* joint = holder(*this, b);
    if (joint == nullptr || joint->first.empty()) text += body_text(body_text, b, 0, 0);
  }
  return text + "</worldbody></mujoco>\n";
}

}  // namespace slipproof::test
