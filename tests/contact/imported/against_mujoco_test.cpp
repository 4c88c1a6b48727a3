// Imported scenes against MuJoCo at the same state: its matrix of inertia, its bias and applied forces, and the
// Jacobians of its contacts. The scene has coordinates of all bodies; MuJoCo's velocities of bodies for each of its own
// coordinates project the one to the other.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include "base/number/binary64.hpp"
#include "base/number/parse.hpp"
#include "contact/exchange/export_scene.hpp"
#include "contact/exchange/space_mechanism.hpp"
#include "contact/imported/in_binary64.hpp"
#include "contact/imported/mujoco_state.hpp"
#include "contact/imported/read_scene.hpp"
#include "mechanics/bodies/bodies.hpp"
#include "mechanics/scene/scene.hpp"
#include "support/parsers.hpp"

using namespace slipproof;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::dense;
using test::Theirs;

namespace {

constexpr double near_enough = 1e-9;
/// What the scene says, in binary64.
struct Ours {
  std::vector<std::string> names;
  std::vector<Vector3d> at;
  std::vector<Vector3d> touching;  ///< the points of contacts with planes
  MatrixXd M, H, G;
  VectorXd f, b;
};

/// The three numbers of a line such as `at = ["1", "0", "1/2"]`.
Vector3d vector_in(const std::string& line) {
  Vector3d result;
  std::size_t from = line.find('"');
  for (int k = 0; k < 3; ++k) {
    const std::size_t to = line.find('"', from + 1);
    result(k) = nearest_binary64(parse_rational(line.substr(from + 1, to - from - 1)));
    from = line.find('"', to + 1);
  }
  return result;
}

/// That of a line such as `radius = "1/2"`.
double number_in(const std::string& line) {
  const std::size_t from = line.find('"') + 1;
  return nearest_binary64(parse_rational(line.substr(from, line.find('"', from) - from)));
}

/// Bodies stand along the scene's axes.
void read_places(const std::string& text, Ours& to) {
  std::istringstream lines(text);
  std::string part;
  const auto has = [&](const std::string& line, const std::string& key) { return line.rfind(key + " = ", 0) == 0; };
  Vector3d own(0, 0, 0);
  double radius = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("[[", 0) == 0) part = line;
    if (part == "[[body]]" && has(line, "at")) to.at.push_back(vector_in(line));
    if (part != "[[contact]]") continue;
    if (has(line, "of")) {
      const std::string name = line.substr(6, line.size() - 7);
      radius = 0;
      own = to.at[static_cast<std::size_t>(std::find(to.names.begin(), to.names.end(), name) - to.names.begin())];
    }
    if (has(line, "point")) to.touching.push_back(own + vector_in(line));
    if (has(line, "radius")) radius = number_in(line);
    if (has(line, "normal")) to.touching.back() -= radius * vector_in(line);  // `point` is the centre of what is round
  }
}

Ours ours(const std::string& text) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "slipproof-against-mujoco.toml";
  std::ofstream(file) << text;
  const MechanismScene scene = read_scene(file.string(), Dimensions::any);
  const GlobalProblem problem = global_problem(scene);
  std::filesystem::remove(file);
  Ours result;
  for (const auto& body : scene.mechanism.bodies->bodies) result.names.push_back(body.name);
  result.names.erase(result.names.begin());  // the ground
  read_places(text, result);
  const auto rows = static_cast<Eigen::Index>(problem.M.size());
  result.M = dense(problem.M, rows);
  result.H = dense(problem.H, rows);
  result.G = dense(problem.G, rows);
  result.f = dense(problem.f);
  result.b = dense(problem.b);
  return result;
}

class Comparison {
 public:
  Comparison(const Ours& own, Theirs& theirs) : o_(own), t_(theirs), nv_(theirs.m->nv) {}

  void compare() {
    const auto bodies = static_cast<Eigen::Index>(o_.names.size());
    T_ = MatrixXd::Zero(6 * bodies, nv_);
    a_ = VectorXd::Zero(6 * bodies);
    known_.assign(o_.names.size(), false);
    for (int body = 1; body < t_.m->nbody; ++body) know(body);
    extend();
    compare_inertia();
    compare_forces();
    compare_contacts();
    if (t_.m->neq == 0) compare_joints();
  }

 private:
  void know(int body) {
    const auto found = std::find(o_.names.begin(), o_.names.end(), t_.name(body));
    if (found == o_.names.end()) return;
    const auto i = static_cast<std::size_t>(found - o_.names.begin());
    known_[i] = true;
    const auto row = 6 * static_cast<Eigen::Index>(i);
    T_.middleRows(row, 6) = t_.jacobian(body, o_.at[i]);
    a_.segment(row, 6) = t_.bias_acceleration(body, o_.at[i]);
  }

  /// The coordinates of a body in free fall, which is left out.
  bool is_left_out(Eigen::Index coordinate) const { return T_.col(coordinate).isZero(0); }

  /// Links without mass move as their joints make them.
  void extend() {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < known_.size(); ++i) {
      if (!known_[i]) open.push_back(i);
    }
    if (open.empty()) return;
    std::vector<Eigen::Index> links;
    for (Eigen::Index j = 0; j < o_.G.cols(); ++j) {
      const bool touches = std::any_of(open.begin(), open.end(), [&](std::size_t i) {
        return !o_.G.col(j).segment(6 * static_cast<Eigen::Index>(i), 6).isZero(0);
      });
      if (touches) links.push_back(j);
    }
    MatrixXd left(static_cast<Eigen::Index>(links.size()), 6 * static_cast<Eigen::Index>(open.size()));
    MatrixXd right(left.rows(), nv_ + 1);
    for (Eigen::Index k = 0; k < left.rows(); ++k) {
      const VectorXd column = o_.G.col(links[static_cast<std::size_t>(k)]);
      for (std::size_t i = 0; i < open.size(); ++i) {
        left.block(k, 6 * static_cast<Eigen::Index>(i), 1, 6) =
            column.segment(6 * static_cast<Eigen::Index>(open[i]), 6).transpose();
      }
      right.row(k).head(nv_) = -column.transpose() * T_;
      right(k, nv_) = -o_.b(links[static_cast<std::size_t>(k)]) - column.dot(a_);
    }
    const MatrixXd found = left.colPivHouseholderQr().solve(right);
    for (std::size_t i = 0; i < open.size(); ++i) {
      const auto own = 6 * static_cast<Eigen::Index>(i), row = 6 * static_cast<Eigen::Index>(open[i]);
      T_.middleRows(row, 6) = found.block(own, 0, 6, nv_);
      a_.segment(row, 6) = found.block(own, nv_, 6, 1);
      known_[open[i]] = true;
    }
  }

  /// No joint is pulled apart.
  void compare_joints() {
    double worst = 0;
    for (Eigen::Index j = 0; j < o_.G.cols(); ++j) {
      worst = std::max(worst, (o_.G.col(j).transpose() * T_).norm() / o_.G.col(j).norm());
    }
    CHECK(worst < near_enough);
  }

  void compare_inertia() {
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> expected(nv_, nv_);
    mj_fullM(t_.m, expected.data(), t_.d->qM);
    const MatrixXd found = T_.transpose() * o_.M * T_;
    double worst = 0;
    for (Eigen::Index i = 0; i < nv_; ++i) {
      for (Eigen::Index j = 0; j < nv_; ++j) {
        if (is_left_out(i) || is_left_out(j)) continue;
        worst = std::max(worst, std::abs(found(i, j) - expected(i, j)) / std::sqrt(expected(i, i) * expected(j, j)));
      }
    }
    CHECK(worst < near_enough);
  }

  void compare_forces() {
    const VectorXd found = T_.transpose() * (o_.f - o_.M * a_);
    VectorXd expected(nv_);
    double greatest = 0;
    for (int i = 0; i < nv_; ++i) {
      if (is_left_out(i)) {
        expected(i) = found(i);
        continue;
      }
      expected(i) = t_.d->qfrc_passive[i] + t_.d->qfrc_actuator[i] - t_.d->qfrc_bias[i];
      greatest = std::max({greatest, std::abs(t_.d->qfrc_passive[i]), std::abs(t_.d->qfrc_bias[i])});
    }
    CHECK((found - expected).cwiseAbs().maxCoeff() < near_enough * std::max(1.0, greatest));
  }

  /// Each contact of MuJoCo has one of ours, with the same rows. Of cylinders and meshes it chooses up to four points,
  /// of which we need not have all: those at one place are compared.
  void compare_contacts() {
    rows_ = o_.H.cols() > 0 ? MatrixXd(o_.H.transpose() * T_) : MatrixXd(0, nv_);
    int missing = 0, expected = 0;
    for (int i = 0; i < t_.d->ncon; ++i) {
      const mjContact& contact = t_.d->contact[i];
      if (std::abs(contact.dist) > 1e-7) continue;
      const auto chosen = [&](int geom) {
        return t_.m->geom_type[geom] == mjGEOM_CYLINDER || t_.m->geom_type[geom] == mjGEOM_MESH;
      };
      if (!chosen(contact.geom1) && !chosen(contact.geom2)) {
        ++expected;
        bool found = false;
        for (Eigen::Index k = 0; k + 2 < rows_.rows() && !found; k += 3) found = have_same_rows(k, contact);
        if (!found) ++missing;
      } else if (const auto same = at_same_place(Vector3d(contact.pos))) {
        ++shared_points;
        CHECK(have_same_rows(3 * *same, contact));
      }
    }
    CAPTURE(expected);
    CHECK(missing == 0);
  }
  std::optional<Eigen::Index> at_same_place(const Vector3d& at) const {
    for (std::size_t k = 0; k < o_.touching.size(); ++k) {
      if ((o_.touching[k] - at).norm() < 1e-6) return static_cast<Eigen::Index>(k);
    }
    return std::nullopt;
  }

  /// Our tangents are theirs, turned about the normal. Its vertices are in binary32, its points between the surfaces.
  bool have_same_rows(Eigen::Index k, const mjContact& contact) const {
    const Vector3d at(contact.pos);
    const MatrixXd relative =
        (t_.jacobian(t_.m->geom_bodyid[contact.geom2], at) - t_.jacobian(t_.m->geom_bodyid[contact.geom1], at))
            .topRows(3);
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> frame(contact.frame);
    const MatrixXd theirs = frame * relative;
    const auto mesh = [&](int geom) { return t_.m->geom_type[geom] == mjGEOM_MESH; };
    const double exact = mesh(contact.geom1) || mesh(contact.geom2) ? 1e-6 : near_enough;
    const double near = (exact + std::abs(contact.dist)) * std::max(1.0, theirs.norm());
    const double sign = rows_.row(k).dot(theirs.row(0)) > 0 ? 1 : -1;
    if ((sign * rows_.row(k) - theirs.row(0)).norm() > near) return false;
    const MatrixXd own = rows_.middleRows(k + 1, 2), base = theirs.middleRows(1, 2);
    const MatrixXd turn = base.transpose().colPivHouseholderQr().solve(own.transpose());
    return (base.transpose() * turn - own.transpose()).norm() < near;
  }

 public:
  int shared_points = 0;  ///< of cylinders and meshes, at places that both have

 private:
  const Ours& o_;
  Theirs& t_;
  int nv_;
  MatrixXd rows_;  ///< of contacts, over MuJoCo's coordinates
  MatrixXd T_;     ///< velocities of our bodies for each of MuJoCo's coordinates
  VectorXd a_;     ///< their accelerations where MuJoCo's are 0
  std::vector<bool> known_;
};

/// Returns how many points of cylinders and meshes both have.
int compare(const std::string& file, const std::string& key) {
  CAPTURE(file);
  CAPTURE(key);
  const imported::Scene scene = imported::read_scene_of_bodies(file, {key, false, {}});
  imported::SpaceOptions options;
  options.overlaps = imported::Overlaps::left_out;
  const imported::SpaceMechanism found = to_space(scene, options);
  Theirs theirs(file, key);
  const Ours own = ours(found.text);
  REQUIRE(own.M.rows() == 6 * static_cast<Eigen::Index>(own.names.size()));
  REQUIRE(own.touching.size() == static_cast<std::size_t>(own.H.cols() / 3));
  Comparison comparison(own, theirs);
  comparison.compare();
  return comparison.shared_points;
}

int compare_text(const std::string& text, const std::string& key) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "slipproof-against-mujoco.xml";
  std::ofstream(file) << text;
  const int shared = compare(file.string(), key);
  std::filesystem::remove(file);
  return shared;
}

}  // namespace

TEST_CASE("imported scenes have MuJoCo's inertia, forces and contacts") {
  if (!has_parsers()) return;
  const std::string folder = SLIPPROOF_SOURCE_DIR "/cases/imported/";
  compare(folder + "cart.xml", "");
  compare(folder + "stool.xml", "");
  compare(folder + "biped.xml", "");
  compare(folder + "biped.xml", "walks");
  compare(folder + "press.xml", "");
}

TEST_CASE("armatures of hinges, slides and balls on bodies that move are MuJoCo's") {
  if (!has_parsers()) return;
  compare_text(
      "<mujoco><option gravity=\"0 0 -9.81\"/><worldbody><body name=\"a\" pos=\"0 0 2\"><freejoint/>"
      "<geom type=\"box\" size=\"0.2 0.1 0.3\" mass=\"2\"/>"
      "<body name=\"b\" pos=\"0.5 0 0\"><joint type=\"slide\" axis=\"0.6 0 0.8\" armature=\"0.7\"/>"
      "<geom type=\"capsule\" fromto=\"0 0 0 0.1 0.3 0.2\" size=\"0.05\" mass=\"1\"/>"
      "<body name=\"c\" pos=\"0 0.6 0.1\"><joint type=\"ball\" pos=\"0 -0.2 0\" armature=\"0.3\"/>"
      "<geom type=\"box\" size=\"0.1 0.2 0.05\" mass=\"1.5\"/>"
      "<body name=\"d\" pos=\"0 0.5 0\"><joint type=\"hinge\" axis=\"0 0.6 0.8\" pos=\"0 -0.2 0.1\" armature=\"0.2\"/>"
      "<geom type=\"box\" size=\"0.1 0.05 0.2\" mass=\"0.5\"/></body></body></body></body></worldbody>"
      "<keyframe><key name=\"moves\" qpos=\"0 0 2 1 0 0 0  0.1  1 0 0 0  0\" "
      "qvel=\"0.3 0.1 -0.2 0.4 -0.3 0.2  0.9  0.5 0.1 -0.4  1.3\"/></keyframe></mujoco>",
      "moves");
}

TEST_CASE("meshes and cylinders on planes touch at MuJoCo's points with its rows") {
  if (!has_parsers()) return;
  const auto free = [](const std::string& name, const std::string& at, const std::string& geom) {
    return "<body name=\"" + name + "\" pos=\"" + at + "\"><freejoint/><geom mass=\"1\" " + geom + "/></body>";
  };
  const auto scene = [](const std::string& bodies, const std::string& floor) {
    return "<mujoco><option gravity=\"0 0 -9.81\"/><asset>"
           "<mesh name=\"wedge\" vertex=\"-0.2 -0.1 -0.05  0.2 -0.1 -0.05  0.2 0.1 -0.05  -0.2 0.1 -0.05  -0.2 -0.1 "
           "0.05  -0.2 0.1 0.05\"/><mesh name=\"top\" vertex=\"0 0 -0.3  0.2 0 0  0 0.2 0  -0.2 -0.2 0  0 0 0.1\"/>"
           "</asset><worldbody><geom name=\"floor\" type=\"plane\" size=\"9 9 0.1\" " +
           floor + "/>" + bodies + "</worldbody></mujoco>";
  };
  const std::string wedge = "type=\"mesh\" mesh=\"wedge\"", top = "type=\"mesh\" mesh=\"top\"",
                    cylinder = "type=\"cylinder\" size=\"0.25 0.5\"";
  CHECK(compare_text(scene(free("stands", "0 0 0.5", cylinder), ""), "") >= 1);  // of three points at 120 degrees
  const std::string lying = cylinder + " euler=\"90 0 0\"";
  CHECK(compare_text(scene(free("lies", "0 0 0.25", lying), ""), "") == 1);  // its other end is off by rounding
  CHECK(compare_text(scene(free("slab", "0 0 0.05", wedge), ""), "") >= 3);
  CHECK(compare_text(scene(free("peg", "0 0 0.3", top), ""), "") == 1);
}

TEST_CASE("so have those that SLIPPROOF_MJCF_FILES names") {  // FILE or FILE@KEY, with spaces between them
  const char* given = std::getenv("SLIPPROOF_MJCF_FILES");
  if (given == nullptr || !has_parsers()) return;
  std::istringstream names(given);
  for (std::string name; names >> name;) {
    const std::size_t at = name.find('@');
    compare(name.substr(0, at), at == std::string::npos ? "" : name.substr(at + 1));
  }
}
