// MuJoCo: the accelerations of mj_forward. By default its own: pyramidal cones, impedance 0.9 at gap 0, so that a body
// at rest sinks by a tenth of what it would fall. With many iterations it is as hard and exact as it can be: elliptic
// cones, impedance 0.9999, tolerance 0. In both, friction belongs to an associated law, by which what slides also
// opens.
#include <mujoco/mujoco.h>

#include <cstring>
#include <memory>
#include <sstream>

#include "adapter.hpp"

using namespace engines;

namespace {

bool moves(const Body& body) {
  return body.acceleration != Vector{} || body.turning != 0 || body.turnings != Vector{} ||
         (!body.is_free && body.velocity != Vector{}) || (!body.turns && (body.spin != 0 || body.spins != Vector{}));
}

std::string words(const Vector& v) {
  std::ostringstream text;
  text.precision(17);
  text << v[0] << ' ' << v[1] << ' ' << v[2];
  return text.str();
}
Vector sum(const Vector& v, double factor, const Vector& w) {
  return {v[0] + factor * w[0], v[1] + factor * w[1], v[2] + factor * w[2]};
}

class Model {
 public:
  explicit Model(const Question& q) : q_(q) {
    text_.precision(17);
    if (!q.friction.empty()) throw Refused("brakes and clutches");
    text_ << "<mujoco><option gravity='" << words(q.gravity) << "'";
    if (q.iterations > 0) text_ << " cone='elliptic' solver='Newton' tolerance='0' iterations='" << q.iterations << "'";
    text_ << "/><size njmax='2000' nconmax='500'/><worldbody>";
    for (std::size_t i = 0; i < q.bodies.size(); ++i) add_body(i);
    text_ << "</worldbody><contact>";
    for (std::size_t i = 0; i < q.contacts.size(); ++i) {
      const double mu = q.contacts[i].friction;
      text_ << "<pair geom1='box" << i << "' geom2='disc" << i << "' friction='" << mu << ' ' << mu << " 0 0 0'"
            << hard() << "/>";
    }
    text_ << "</contact><equality>";
    for (const Joint& joint : q.joints) add(joint);
    text_ << "</equality></mujoco>";
  }
  std::string text() const { return text_.str(); }

 private:
  const char* hard() const { return q_.iterations > 0 ? " solimp='0.9999 0.9999 0.001 0.5 2'" : ""; }

  void add_body(std::size_t index) {
    const Body& body = q_.bodies[index];
    if (!body.is_ground()) {
      if (moves(body)) throw Refused("a body that moves as prescribed");
      text_ << "<body name='" << index << "' pos='" << words(body.at) << "'";
      if (q_.in_space) return add_in_space(index);
      text_ << ">";
      if (body.is_free) {
        text_ << "<joint name='x" << index << "' type='slide' axis='1 0 0'/><joint name='y" << index
              << "' type='slide' axis='0 1 0'/>";
      }
      if (body.turns) text_ << "<joint name='z" << index << "' type='hinge' axis='0 0 1'/>";
      if (!body.is_prescribed()) {
        const double i = body.turns ? body.inertia : 1;
        text_ << "<inertial pos='0 0 0' mass='" << (body.is_free ? body.mass : 1) << "' diaginertia='" << i << ' ' << i
              << ' ' << i << "'/>";
      }
    }
    for (std::size_t i = 0; i < q_.contacts.size(); ++i) add_geoms(index, i);
    if (!body.is_ground()) text_ << "</body>";
  }

  /// Its joint is called f and the number.
  void add_in_space(std::size_t index) {
    const Body& body = q_.bodies[index];
    const Quaternion& turn = body.turn;
    text_ << " quat='" << turn[0] << ' ' << turn[1] << ' ' << turn[2] << ' ' << turn[3] << "'>";
    if (!body.is_prescribed()) {
      text_ << "<freejoint name='f" << index << "'/><inertial pos='0 0 0' mass='" << body.mass << "' diaginertia='"
            << words(body.moments) << "'/>";
    }
    for (std::size_t i = 0; i < q_.contacts.size(); ++i) add_geoms(index, i);
    text_ << "</body>";
  }

  /// The disc overlaps the box by a little to be found.
  void add_geoms(std::size_t body, std::size_t index) {
    const Contact& c = q_.contacts[index];
    const double r = q_.disc(c), half = q_.half(c);
    const auto local = [&](std::size_t number, const Vector& v) { return in_body(q_.bodies[number], v); };
    const Vector up = q_.arm(c.of, c.at), face = q_.arm(c.on, c.at), n = local(c.on, c.normal);
    if (c.of == body) {
      text_ << "<geom name='disc" << index << "' type='sphere' size='" << r + 1e-9 * q_.size
            << "' contype='0' conaffinity='0' pos='" << words(local(c.of, sum(up, r, c.normal))) << "'/>";
    }
    if (c.on == body) {
      text_ << "<geom name='box" << index << "' type='box' size='" << half << ' ' << half << ' ' << half
            << "' contype='0' conaffinity='0' pos='" << words(local(c.on, sum(face, -half, c.normal)));
      if (q_.in_space) {
        text_ << "' zaxis='" << words(n) << "'/>";
      } else {
        text_ << "' xyaxes='" << words({n[1], -n[0]}) << ' ' << words(n) << "'/>";
      }
    }
  }

  void add(const Joint& joint) {
    if (q_.in_space) throw Refused("joints in space");
    // The ground is MuJoCo's world, and no body to begin with.
    const bool swap = q_.bodies[joint.first].is_ground();
    const std::size_t first = swap ? joint.second : joint.first, second = swap ? joint.first : joint.second;
    text_ << (joint.kind == "pin" ? "<connect" : "<weld") << " body1='" << first << "'";
    if (joint.kind != "pin" && joint.kind != "weld") throw Refused("MuJoCo has no " + joint.kind + " of this kind");
    if (!q_.bodies[second].is_ground()) text_ << " body2='" << second << "'";
    if (joint.kind == "pin") text_ << " anchor='" << words(q_.arm(first, joint.at)) << "'";
    text_ << hard() << "/>";
  }

  const Question& q_;
  std::ostringstream text_;
};

struct Free {
  void operator()(mjModel* m) const { mj_deleteModel(m); }
  void operator()(mjData* d) const { mj_deleteData(d); }
};

std::unique_ptr<mjModel, Free> load(const std::string& text) {
  auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), "scene.xml")], text.data(), text.size());
  char error[1000] = "";
  std::unique_ptr<mjModel, Free> model(mj_loadXML("scene.xml", files.get(), error, sizeof error));
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error(error);
  return model;
}

void tell(const Question& q, const mjModel& m, const mjData& d, Answer& answer) {
  for (const Contact& contact : q.contacts) answer.push(contact, 0, 0);
  for (int i = 0; i < d.ncon; ++i) {
    const mjContact& found = d.contact[i];
    const std::string name = mj_id2name(&m, mjOBJ_GEOM, found.geom2);
    const Contact& contact = q.contacts.at(std::stoul(name.substr(name.find_first_of("0123456789"))));
    mjtNum force[6];
    mj_contactForce(&m, &d, i, force);
    const mjtNum* f = found.frame;                // rows: from the first geom to the second, and two tangents
    const double turn = name[0] == 'd' ? 1 : -1;  // the force is on the second
    Vector total{};
    for (int k = 0; k < 3; ++k) total[k] = turn * (f[k] * force[0] + f[k + 3] * force[1] + f[k + 6] * force[2]);
    answer.push(contact, total);
  }
}

Answer ask(const Question& q) {
  if (q.impact) throw Refused("an impact: contacts are springs with dampers, in which it takes many steps");
  const auto model = load(Model(q).text());
  const mjModel& m = *model;
  const std::unique_ptr<mjData, Free> data(mj_makeData(&m));
  mjData& d = *data;
  const auto place = [&](const char* axis, std::size_t body) {
    const int joint = mj_name2id(&m, mjOBJ_JOINT, (axis + std::to_string(body)).c_str());
    return joint < 0 ? -1 : m.jnt_dofadr[joint];
  };
  // In space spins and couples of a joint are in the axes of the body.
  const auto freedoms = [&](std::size_t i) {
    if (q.in_space) {
      const int dof = place("f", i);
      return std::array<int, 6>{dof, dof + 1, dof + 2, dof + 3, dof + 4, dof + 5};
    }
    return std::array<int, 6>{place("x", i), place("y", i), place("z", i), -1, -1, -1};
  };
  const auto six = [&](const Body& body, const Vector& along, double turn, const Vector& turns) {
    const Vector w = in_body(body, turns);
    if (q.in_space) return std::array<double, 6>{along[0], along[1], along[2], w[0], w[1], w[2]};
    return std::array<double, 6>{along[0], along[1], turn};
  };
  const auto moves = [&](std::size_t i) { return i > 0 && !q.bodies[i].is_prescribed(); };
  for (std::size_t i = 1; i < q.bodies.size(); ++i) {
    const Body& body = q.bodies[i];
    const auto before = six(body, body.velocity, body.spin, body.spins);
    const auto push = six(body, body.force, body.torque, body.torques);
    for (std::size_t k = 0; k < 6 && moves(i); ++k) {
      if (const int dof = freedoms(i)[k]; dof >= 0) d.qvel[dof] = before[k], d.qfrc_applied[dof] = push[k];
    }
  }
  mj_forward(&m, &d);
  Answer answer;
  answer.settings = {{"cone", m.opt.cone == mjCONE_ELLIPTIC ? "elliptic" : "pyramidal"},
                     {"iterations", m.opt.iterations},
                     {"impedance", q.iterations > 0 ? 0.9999 : 0.9}};
  for (std::size_t i = 0; i < q.bodies.size(); ++i) {
    const Body& body = q.bodies[i];
    auto v = six(body, body.velocity, body.spin, body.spins);
    for (std::size_t k = 0; k < 6 && moves(i); ++k) {
      if (const int dof = freedoms(i)[k]; dof >= 0) v[k] += q.step * d.qacc[dof];
    }
    const Vector w = in_body(body, {v[3], v[4], v[5]}, true);
    if (q.in_space) v[3] = w[0], v[4] = w[1], v[5] = w[2];
    answer.velocity.push_back(v);
  }
  tell(q, m, d, answer);
  if (!q.watch.empty() && q.in_space) {
    model->opt.timestep = q.step;
    const auto step = [&] {
      mj_step(&m, &d);
      mj_kinematics(&m, &d);  // where bodies are after it, not before
    };
    step();
    watch(q, answer, step, [&](std::size_t i) {
      const int body = mj_name2id(&m, mjOBJ_BODY, std::to_string(i).c_str());
      const mjtNum *at = d.xpos + 3 * body, *t = d.xquat + 4 * body;
      Pose pose{{at[0], at[1], at[2]}, {t[0], t[1], t[2], t[3]}};
      if (!moves(i)) return pose;
      Body now = q.bodies[i];
      now.turn = pose.turn;
      const mjtNum* v = d.qvel + freedoms(i)[0];
      pose.velocity = {v[0], v[1], v[2]}, pose.spin = in_body(now, {v[3], v[4], v[5]}, true);
      return pose;
    });
  }
  return answer;
}

}  // namespace

int main() {
  return run(
      {"mujoco", mj_versionString(),
       "associated, soft: by the impedance in the settings a contact gives way; the accelerations from rest", ask,
       "associated, soft: by the impedance in the settings a contact gives way; a pyramid or an elliptic cone, as the "
       "settings say; the accelerations from rest"});
}
