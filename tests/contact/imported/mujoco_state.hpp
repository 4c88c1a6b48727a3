// What MuJoCo says of a scene.
#pragma once

#include <doctest/doctest.h>
#include <mujoco/mujoco.h>

#include <Eigen/Dense>
#include <array>
#include <cctype>
#include <string>
#include <vector>

namespace slipproof::test {

/// MuJoCo's model in the state of a keyframe, or in its own.
struct Theirs {
  mjModel* m = nullptr;
  mjData* d = nullptr;

  Theirs(const std::string& file, const std::string& key) {
    std::array<char, 1000> error{};
    m = mj_loadXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size()));
    CAPTURE(error.data());
    REQUIRE(m != nullptr);
    d = mj_makeData(m);
    if (!key.empty()) mj_resetDataKeyframe(m, d, mj_name2id(m, mjOBJ_KEY, key.c_str()));
    mj_forward(m, d);
  }
  ~Theirs() {
    mj_deleteData(d);
    mj_deleteModel(m);
  }
  Theirs(const Theirs&) = delete;
  Theirs& operator=(const Theirs&) = delete;

  std::string name(int body) const {
    const char* given = mj_id2name(m, mjOBJ_BODY, body);
    std::string result = given != nullptr && *given != '\0' ? given : "body" + std::to_string(body);
    for (char& c : result) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    return result;
  }
  /// The centre of mass of a body with all that is fixed to it.
  Eigen::Vector3d centre(int body) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double mass = 0;
    for (int i = 1; i < m->nbody; ++i) {
      if (m->body_weldid[i] != m->body_weldid[body]) continue;
      sum += m->body_mass[i] * Eigen::Vector3d(d->xipos + 3 * i);
      mass += m->body_mass[i];
    }
    return mass > 0 ? Eigen::Vector3d(sum / mass) : Eigen::Vector3d(d->xipos + 3 * body);
  }
  /// Six rows: the velocity of a point of a body, and its spin, for each of MuJoCo's coordinates.
  Eigen::MatrixXd jacobian(int body, const Eigen::Vector3d& at) const {
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> along(3, m->nv), turning(3, m->nv);
    mj_jac(m, d, along.data(), turning.data(), at.data(), body);
    Eigen::MatrixXd all(6, m->nv);
    all << along, turning;
    return all;
  }
  /// The accelerations that the velocities alone bring, at a point of a body.
  Eigen::VectorXd bias_acceleration(int body, const Eigen::Vector3d& at) {
    const bool weightless = (m->opt.disableflags & mjDSBL_GRAVITY) != 0;
    const Eigen::Vector3d gravity =
        weightless ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : Eigen::Vector3d(m->opt.gravity);
    std::vector<mjtNum> kept(d->qacc, d->qacc + m->nv);
    std::fill(d->qacc, d->qacc + m->nv, 0);
    mj_rnePostConstraint(m, d);
    std::array<mjtNum, 6> acceleration{}, velocity{};
    mj_objectAcceleration(m, d, mjOBJ_BODY, body, acceleration.data(), 0);
    mj_objectVelocity(m, d, mjOBJ_BODY, body, velocity.data(), 0);
    std::copy(kept.begin(), kept.end(), d->qacc);
    const Eigen::Vector3d turning(acceleration.data()), spin(velocity.data()),
        arm = at - Eigen::Vector3d(d->xipos + 3 * body);
    const Eigen::Vector3d along =
        Eigen::Vector3d(acceleration.data() + 3) + gravity + turning.cross(arm) + spin.cross(spin.cross(arm));
    Eigen::VectorXd all(6);
    all << along, turning;
    return all;
  }
};

}  // namespace slipproof::test
