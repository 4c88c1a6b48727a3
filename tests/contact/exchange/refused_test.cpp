// Files that are foreign, damaged or hostile: each is refused with what was found, or read with what was left out told.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "base/input/diagnostic.hpp"
#include "contact/exchange/planar.hpp"
#include "contact/exchange/spatial.hpp"
#include "contact/imported/parsers.hpp"
#include "contact/imported/read_scene.hpp"

using namespace slipproof;

namespace {

const std::string urdf = R"(<robot name="r">
<link name="world"/>
<link name="a"><inertial><origin xyz="0 0 0"/><mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
<collision><geometry><box size="1 1 1"/></geometry></collision></link>
<link name="b"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
<collision><geometry><sphere radius="0.5"/></geometry></collision></link>
<joint name="j" type="floating"><parent link="world"/><child link="a"/><origin xyz="0 0 0.5"/></joint>
<joint name="k" type="continuous"><parent link="a"/><child link="b"/><origin xyz="2 0 0"/><axis xyz="0 1 0"/></joint>
</robot>)";

const std::string sdf = R"(<sdf version="1.9"><world name="w"><gravity>0 0 -9.81</gravity>
<model name="floor"><static>true</static><link name="l"><collision name="c"><geometry><plane><normal>0 0 1</normal><size>1 1</size></plane></geometry></collision></link></model>
<model name="m">
<link name="a"><pose>0 0 0.5 0 0 0</pose><inertial><mass>2</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz><ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial><collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision></link>
<link name="b"><pose>2 0 0.5 0 0 0</pose><inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz><ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial><collision name="c"><geometry><sphere><radius>0.5</radius></sphere></geometry></collision></link>
<joint name="k" type="revolute"><parent>a</parent><child>b</child><axis><xyz>0 1 0</xyz></axis></joint>
</model></world></sdf>)";

const std::string mjcf = R"(<mujoco model="m"><option gravity="0 0 -9.81"/>
<worldbody><geom name="floor" type="plane" size="1 1 1"/>
<body name="a" pos="0 0 0.5"><freejoint/><geom name="box" type="box" size="0.5 0.5 0.5" mass="2"/>
<body name="b" pos="2 0 0"><joint name="k" type="hinge" axis="0 1 0"/><geom name="ball" type="sphere" size="0.5" mass="1"/></body></body>
</worldbody></mujoco>)";

/// What in a file is replaced, by what, and a part of what is said.
struct Change {
  std::string from, to, said;
};

std::string changed(std::string text, const Change& change) {
  const std::size_t at = text.find(change.from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, change.from.size(), change.to);
}

/// What is said against a scene: the mistakes, or, after it was read, `read: ` and what was told.
std::string said_of(const std::string& text, bool level) {
  try {
    imported::PlanarOptions options;
    if (level) options.ground = 0, options.mu = 1;
    const auto found = to_planar(imported::parse_scene_of_bodies(text, "scene.xml"), options);
    std::string all = "read:";
    for (const std::string& one : found.import_notes) all += " " + one + ";";
    return all;
  } catch (const InputError& error) {
    return error.what();
  }
}

void check(const std::string& base, bool level, const std::vector<Change>& changes) {
  std::string why;
  if (imported::find_parsers(why) == nullptr) {
    MESSAGE("not tried: " << why);
    return;
  }
  CHECK(said_of(base, level).rfind("read:", 0) == 0);
  for (const Change& change : changes) {
    CAPTURE(change.from);
    CAPTURE(change.to);
    const std::string said = said_of(changed(base, change), level);
    CAPTURE(said);
    CHECK(said.find(change.said) != std::string::npos);
  }
  for (std::size_t cut = 1; cut <= 20; ++cut) {  // a file that ends early
    const std::string said = said_of(base.substr(0, base.size() * cut / 21), level);
    CAPTURE(said);
    CHECK(said.find("scene.xml") != std::string::npos);
  }
}

const std::string deep = [] {
  std::string text;
  for (int i = 0; i < 20000; ++i) text += "<a>";
  return text;
}();

}  // namespace

TEST_CASE("forty foreign and hostile URDF files are refused clearly") {
  check(urdf, true,
        {{"<robot", "<robots", "found no XML"},
         {"<robot name=\"r\">", "<html><robot name=\"r\">", "found no XML"},
         {"size=\"1 1 1\"", "size=\"1 1\"", "found no robot that urdfdom understands"},
         {"size=\"1 1 1\"", "size=\"1 1 -1\"", "size that is not positive"},
         {"size=\"1 1 1\"", "size=\"0 1 1\"", "size that is not positive"},
         {"radius=\"0.5\"", "radius=\"nan\"", ""},
         {"radius=\"0.5\"", "radius=\"1e999\"", ""},
         {"radius=\"0.5\"", "radius=\"zero\"", "found no robot"},
         {"mass value=\"2\"", "mass value=\"-2\"", "negative mass"},
         {"mass value=\"2\"", "mass value=\"0\"", "without a mass"},
         {"ixy=\"0\"", "ixy=\"0.5\"", "is not symmetric to it"},
         {"iyy=\"1\"", "iyy=\"-1\"", "inertia"},
         {"<sphere radius=\"0.5\"/>", "<mesh filename=\"file:///etc/passwd\"/>", "found the mesh"},
         {"<sphere radius=\"0.5\"/>", "<capsule radius=\"0.5\" length=\"1\"/>", "found <capsule>"},
         {"<sphere radius=\"0.5\"/>", "", "found no robot"},
         {"type=\"continuous\"", "type=\"planar\"", "another type"},
         {"type=\"continuous\"", "type=\"ball\"", "found no robot"},
         {"axis xyz=\"0 1 0\"", "axis xyz=\"1 1 0\"", "does not stay in a plane"},
         {"axis xyz=\"0 1 0\"", "axis xyz=\"0 0 0\"", ""},
         {"<axis xyz=\"0 1 0\"/>", "<axis xyz=\"0 1 0\"/><mimic joint=\"j\"/>", "found <mimic>"},
         {"<parent link=\"a\"/>", "<parent link=\"nobody\"/>", "found no robot"},
         {"<parent link=\"a\"/>", "<parent link=\"b\"/>", "no chain of joints"},
         {"link name=\"b\"", "link name=\"a\"", "found no robot"},
         {"xyz=\"2 0 0\"", "xyz=\"0.7 0 0\"", "read:"},
         {"xyz=\"0 0 0.5\"", "xyz=\"0 0 0.2\"", "inside each other"},
         {"xyz=\"0 0 0.5\"", "xyz=\"0 0 0.50005\"", "moved to touch"},
         {"xyz=\"0 0 0.5\"", "rpy=\"0.3 0 0\" xyz=\"0 0 0.5\"", "seen askew"},
         {"</robot>", "<transmission name=\"t\"/></robot>", "left out: transmission (line 9)"},
         {"</robot>", "<gazebo reference=\"a\"><mu1>0.2</mu1></gazebo></robot>", "left out: gazebo"},
         {"</robot>", "<force/></robot>", "found <force>"},
         {"</robot>", deep + "</robot>", "found no XML"},
         {"<robot name=\"r\">", "<!DOCTYPE r [<!ENTITY x SYSTEM \"file:///etc/passwd\">]><robot name=\"&x;\">", ""},
         {"name=\"world\"", "name=\"base\"", "found no robot"},
         {"type=\"floating\"", "type=\"fixed\"", "read:"},
         {"type=\"continuous\"", "type=\"prismatic\"", "found no robot"},
         {"</joint>\n</robot>", "<dynamics friction=\"0.5\" damping=\"1\"/></joint>\n</robot>", "read:"},
         {"</joint>\n</robot>", "<limit lower=\"0\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint>\n</robot>",
          "at a limit"},
         {"<link name=\"world\"/>", "<link/>", "found no robot"},
         {"value=\"2\"", "value=\"2,0\"", ""},
         {"<robot name=\"r\">", "<robot>", "found no robot"}});
}

TEST_CASE("forty foreign and hostile SDF files are refused clearly") {
  check(sdf, false,
        {{"<sdf version=\"1.9\">", "<sdf>", "version"},
         {"version=\"1.9\"", "version=\"99\"", "version"},
         {"<size>1 1 1</size>", "<size>1 1 -1</size>", "size that is not positive"},
         {"<size>1 1 1</size>", "", "read:"},
         {"<radius>0.5</radius>", "<radius>nan</radius>", ""},
         {"<radius>0.5</radius>", "<radius>-1</radius>", "size that is not positive"},
         {"<radius>0.5</radius>", "<radius>half</radius>", "sdformat"},
         {"<mass>2</mass>", "<mass>-2</mass>", ""},
         {"<ixy>0</ixy>", "<ixy>0.4</ixy>", "is not symmetric to it"},
         {"<iyy>1</iyy>", "<iyy>0</iyy>", ""},
         {"<sphere><radius>0.5</radius></sphere>", "<mesh><uri>model://x/y.dae</uri></mesh>", "found the mesh"},
         {"<sphere><radius>0.5</radius></sphere>", "<heightmap/>", "found <heightmap>"},
         {"<sphere><radius>0.5</radius></sphere>", "<ellipsoid><radii>1 1 1</radii></ellipsoid>", "found <ellipsoid>"},
         {"<sphere><radius>0.5</radius></sphere>", "<empty/>", "found <empty>"},
         {"type=\"revolute\"", "type=\"ball\"", "another type"},
         {"type=\"revolute\"", "type=\"universal\"", ""},
         {"type=\"revolute\"", "type=\"glue\"", "sdformat"},
         {"<xyz>0 1 0</xyz>", "<xyz>1 1 0</xyz>", "does not stay in a plane"},
         {"<xyz>0 1 0</xyz>", "<xyz>0 0 0</xyz>", ""},
         {"<parent>a</parent>", "<parent>nobody</parent>", "sdformat"},
         {"<parent>a</parent>", "<parent>b</parent>", "sdformat"},
         {"<link name=\"b\">", "<link name=\"a\">", "sdformat"},
         {"<pose>0 0 0.5 0 0 0</pose>", "<pose>0 0 0.2 0 0 0</pose>", "inside each other"},
         {"<pose>0 0 0.5 0 0 0</pose>", "<pose>0 0 0.5</pose>", ""},
         {"<pose>0 0 0.5 0 0 0</pose>", "<pose relative_to=\"b\">0 0 0.5 0 0 0</pose>", ""},
         {"<pose>0 0 0.5 0 0 0</pose>", "<pose relative_to=\"nobody\">0 0 0.5 0 0 0</pose>", "sdformat"},
         {"<pose>0 0 0.5 0 0 0</pose>", "<pose>0 0 0.5 0.3 0 0</pose>", "seen askew"},
         {"<world name=\"w\">",
          "<world name=\"w\"><include><uri>model://sun</uri></include><include><uri>model://bus</uri></include>",
          "found the included model 'model://bus'"},
         {"<world name=\"w\">", "<world name=\"w\"><plugin name=\"p\" filename=\"x.so\"/>", "left out: plugin"},
         {"<world name=\"w\">", "<world name=\"w\"><wind/>", "found <wind>"},
         {"<world name=\"w\">", "<world name=\"w\"><actor name=\"x\"/>", "found <actor>"},
         {"0 0 -9.81", "0 -9.81 0", "does not stay in a plane"},
         {"0 0 -9.81", "0 0 0", "read:"},
         {"<xyz>0 1 0</xyz>",
          "<xyz>0 1 0</xyz><dynamics><spring_stiffness>3</spring_stiffness><spring_reference>1</spring_reference>"
          "</dynamics>",
          "found a spring"},
         {"<xyz>0 1 0</xyz>", "<xyz>0 1 0</xyz><dynamics><spring_stiffness>3</spring_stiffness></dynamics>", "read:"},
         {"<xyz>0 1 0</xyz>", "<xyz>0 1 0</xyz><limit><lower>0</lower><upper>1</upper></limit>", "at a limit"},
         {"<link name=\"a\">", "<link name=\"a\"><gravity>false</gravity>", "without gravity"},
         {"<link name=\"a\">", "<link name=\"a\"><kinematic>true</kinematic>", "found <kinematic>"},
         {"<static>true</static>", "", "plane on a body that moves"},
         {"</sdf>", deep, "found no XML"},
         {"<model name=\"m\">", "<model name=\"m\"><model name=\"inner\"><link name=\"x\"/></model>",
          "body m_inner_x: nothing holds it"}});
}

TEST_CASE("forty foreign and hostile MJCF files are refused clearly") {
  check(
      mjcf, false,
      {{"<mujoco model=\"m\">", "<mujoco>", "read:"},
       {"size=\"0.5 0.5 0.5\"", "size=\"0.5 0.5\"", "MuJoCo"},
       {"size=\"0.5 0.5 0.5\"", "size=\"0.5 0.5 -1\"", "MuJoCo"},
       {"type=\"sphere\"", "type=\"ellipsoid\"", "MuJoCo"},
       {"type=\"sphere\"", "type=\"blob\"", "MuJoCo"},
       {"type=\"sphere\" size=\"0.5\"", "type=\"mesh\" mesh=\"x\"", "MuJoCo"},
       {"mass=\"1\"", "mass=\"-1\"", ""},
       {"mass=\"1\"", "mass=\"nan\"", ""},
       {"mass=\"1\"", "mass=\"0\"", ""},
       {"mass=\"1\"", "mass=\"one\"", "MuJoCo"},
       {"axis=\"0 1 0\"", "axis=\"1 1 0\"", "does not stay in a plane"},
       {"axis=\"0 1 0\"", "axis=\"0 0 0\"", "MuJoCo"},
       {"type=\"hinge\"", "type=\"ball\"", ""},
       {"type=\"hinge\"", "type=\"glue\"", "MuJoCo"},
       {"<joint name=\"k\"", "<joint stiffness=\"2\" springref=\"1\" name=\"k\"", "spring under tension"},
       {"<joint name=\"k\"", "<joint armature=\"2\" name=\"k\"", "armature"},
       {"<joint name=\"k\"", "<joint limited=\"true\" range=\"0 1\" name=\"k\"", "at a limit"},
       {"<joint name=\"k\"", "<joint limited=\"true\" range=\"-10 10\" name=\"k\"", "limits, which are not reached"},
       {"<joint name=\"k\"", "<joint frictionloss=\"2\" name=\"k\"", "read:"},
       {"<joint name=\"k\"", "<joint type=\"slide\" axis=\"1 0 0\"/><joint name=\"k\"", "several joints"},
       {"name=\"ball\"", "name=\"box\"", "MuJoCo"},
       {"name=\"ball\"", "margin=\"0.1\" name=\"ball\"", "left out"},
       {"name=\"ball\"", "condim=\"1\" name=\"ball\"", "read:"},
       {"name=\"ball\"", "contype=\"0\" conaffinity=\"0\" name=\"ball\"", "read:"},
       {"pos=\"0 0 0.5\"", "pos=\"0 0 0.2\"", "inside each other"},
       {"pos=\"0 0 0.5\"", "pos=\"0 0 0.5\" euler=\"30 0 0\"", "seen askew"},
       {"pos=\"0 0 0.5\"", "pos=\"0 0 0.5\" mocap=\"true\"", "MuJoCo"},
       {"pos=\"0 0 0.5\"", "pos=\"0 0 1e400\"", ""},
       {"<worldbody>", "<tendon><fixed><joint joint=\"k\" coef=\"1\"/></fixed></tendon><worldbody>", "found a tendon"},
       {"<worldbody>", "<equality><connect body1=\"b\" anchor=\"0 0 0\"/></equality><worldbody>",
        "found an equality constraint"},
       {"<worldbody>", "<include file=\"/etc/passwd\"/><worldbody>", "found an included file that cannot be read"},
       {"<worldbody>", "<contact><exclude body1=\"a\" body2=\"b\"/></contact><worldbody>", "read:"},
       {"<worldbody>", "<asset><texture file=\"/etc/passwd\"/></asset><worldbody>", "left out: texture"},
       {"<worldbody>", "<actuator><position joint=\"k\"/></actuator><worldbody>", "actuators at rest"},
       {"<worldbody>", "<actuator><general joint=\"k\" biastype=\"affine\" biasprm=\"1 0 0\"/></actuator><worldbody>",
        "found an actuator that pushes"},
       {"<worldbody>", "<actuator><motor joint=\"k\"/></actuator><worldbody>", "actuators at rest"},
       {"<option gravity=\"0 0 -9.81\"/>", "<option gravity=\"0 0 -9.81\" density=\"1\"/>", "found a fluid"},
       {"<option gravity=\"0 0 -9.81\"/>", "<option><flag gravity=\"disable\"/></option>", "disabled"},
       {"0 0 -9.81", "0 -9.81 0", "does not stay in a plane"},
       {"<worldbody>", "<worldbody><composite type=\"rope\"/>", "MuJoCo"},
       {"<worldbody>", "<worldbody>" + deep, "found no XML"}});
}

TEST_CASE("a file that is no scene is refused with what it begins with") {
  CHECK(said_of("<html/>", false).find("expected <robot> (URDF), <sdf> or <mujoco> (MJCF)") != std::string::npos);
  CHECK(said_of("", false).find("found no XML") != std::string::npos);
  CHECK(said_of(std::string("\0\1\2", 3), false).find("found no XML") != std::string::npos);
}
