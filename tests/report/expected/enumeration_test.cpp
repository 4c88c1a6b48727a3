// The expected motions of the shipped scenes against what does not come from the kernel: Newton's and Euler's equations
// of the exported bodies, and all contact modes of the exported contact problem, tried one by one.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "base/number/binary64.hpp"
#include "contact/exchange/export_bodies.hpp"
#include "contact/exchange/export_scene.hpp"
#include "mechanics/reading/read_mechanism.hpp"
#include "report/expected/expected.hpp"
#include "support/engine_scene.hpp"
#include "support/exact_simplex.hpp"
#include "support/how_many.hpp"

using namespace slipproof;
using namespace slipproof::test;

namespace {

const std::filesystem::path scenes_folder = SLIPPROOF_SOURCE_DIR "/cases/engines/scenes";

/// Those in the plane, without impacts.
std::vector<std::filesystem::path> shipped_scenes() {
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scenes_folder)) {
    const std::string folder = entry.path().parent_path().filename().string();
    if (entry.path().extension() == ".toml" && !folder.starts_with("space-") && folder != "impact")
      files.insert(entry.path());
  }
  return {files.begin(), files.end()};
}

/// M a = f + H r + G l; H^T a + w are gaps and slips, G^T a + b = 0. The unknowns: a, r, l.
class ModeByMode {
 public:
  explicit ModeByMode(const GlobalProblem& problem)
      : p_(problem),
        n_(p_.M.size()),
        contacts_(p_.mu.size()),
        joints_(p_.b.size()),
        unknowns_(n_ + 2 * contacts_ + joints_) {
    for (std::size_t i = 0; i < n_; ++i) {
      std::vector<Rational> row(unknowns_ + 1);
      for (std::size_t j = 0; j < n_; ++j) row[j] = p_.M[i][j];
      for (std::size_t j = 0; j < 2 * contacts_; ++j) row[n_ + j] = -p_.H[i][j];
      for (std::size_t j = 0; j < joints_; ++j) row[n_ + 2 * contacts_ + j] = -p_.G[i][j];
      row[unknowns_] = p_.f[i];
      equations_.push_back(std::move(row));
    }
    for (std::size_t j = 0; j < joints_; ++j) {
      std::vector<Rational> row(unknowns_ + 1);
      for (std::size_t i = 0; i < n_; ++i) row[i] = p_.G[i][j];
      row[unknowns_] = -p_.b[j];
      equations_.push_back(std::move(row));
    }
  }

  /// The accelerations that some mode has; `vary` where those of one mode are not one.
  struct Found {
    std::set<std::vector<Rational>> motions;
    bool vary = false;
  };
  Found all() {
    try_from(0, equations_, {});
    return std::move(found_);
  }

 private:
  using Row = std::vector<Rational>;

  Row force(std::size_t index, const Rational& factor = 1) const {
    Row row(unknowns_ + 1);
    row[n_ + index] = factor;
    return row;
  }
  /// A gap or a slip, as an equation `= 0` has its constant on the other side.
  Row velocity(std::size_t index, const Rational& factor = 1) const {
    Row row(unknowns_ + 1);
    for (std::size_t i = 0; i < n_; ++i) row[i] = factor * p_.H[i][index];
    row[unknowns_] = -factor * p_.w[index];
    return row;
  }
  /// mu N + factor S
  Row cone(std::size_t contact, const Rational& factor) const {
    Row row = force(2 * contact, p_.mu[contact]);
    row[n_ + 2 * contact + 1] = factor;
    return row;
  }

  /// Equations = 0 and conditions >= 0, contact by contact; what has no solution already is left.
  void try_from(std::size_t contact, const Rows& equations, const Rows& conditions) {
    const auto solved = solve_equations(equations, unknowns_);
    if (!solved) return;
    if (contact == contacts_) return look(*solved, conditions);
    const std::size_t n = 2 * contact, t = n + 1;
    const auto next = [&](const std::vector<Row>& equal, const std::vector<Row>& at_least) {
      Rows e = equations, c = conditions;
      e.insert(e.end(), equal.begin(), equal.end());
      c.insert(c.end(), at_least.begin(), at_least.end());
      try_from(contact + 1, e, c);
    };
    next({force(n), force(t)}, {velocity(n)});                                          // open
    next({velocity(n), velocity(t)}, {force(n), cone(contact, 1), cone(contact, -1)});  // at rest
    next({velocity(n), cone(contact, 1)}, {force(n), velocity(t)});                     // S = -mu N
    next({velocity(n), cone(contact, -1)}, {force(n), velocity(t, -1)});                // S = mu N
  }

  void look(const AffineSolutions& solved, const Rows& conditions) {
    const auto value = [&](const Row& row, const std::vector<Rational>& x) {
      Rational sum;
      for (std::size_t i = 0; i < unknowns_; ++i) sum += row[i] * x[i];
      return sum;
    };
    Rows A;
    std::vector<Rational> b;
    for (const Row& condition : conditions) {
      Row row;
      for (const auto& direction : solved.directions) row.push_back(-value(condition, direction));
      A.push_back(std::move(row));
      b.push_back(value(condition, solved.x0) - condition[unknowns_]);
    }
    ExactSimplex simplex(A, b, solved.directions.size());
    if (!simplex.feasible()) return;
    std::vector<Rational> motion;
    for (std::size_t i = 0; i < n_; ++i) {
      Row along;
      for (const auto& direction : solved.directions) along.push_back(direction[i]);
      Row back = along;
      for (Rational& x : back) x = -x;
      const auto highest = simplex.maximum(along), lowest = simplex.maximum(back);
      if (!highest || !lowest || *highest != -*lowest) {
        found_.vary = true;
        return;
      }
      motion.push_back(solved.x0[i] + *highest);
    }
    found_.motions.insert(std::move(motion));
  }

  GlobalProblem p_;
  std::size_t n_, contacts_, joints_, unknowns_;
  Rows equations_;
  Found found_;
};

/// With too many modes for a test that is run each time.
bool is_long(const MechanismScene& scene) {
  const double most = static_cast<double>(how_many("SLIPPROOF_EXPECTED_MODES", 64));
  return mode_count(element_kinds(scene.mechanism, scene.values.starts, scene.values.given)) > most;
}

}  // namespace

TEST_CASE("the expected motions of the shipped scenes are those of all modes, tried one by one") {
  std::size_t tried = 0;
  for (const auto& file : shipped_scenes()) {
    const MechanismScene scene = read_scene(file);
    const Mechanism& m = scene.mechanism;
    if (is_long(scene)) continue;
    const bool at_rest = std::ranges::all_of(scene.values.starts, [](auto s) { return s == ElementKind::Start::rest; });
    const bool one_coefficient = std::ranges::all_of(m.contacts, [](const MechanismContact& c) {
      return c.frictionless() || same(c.static_friction.expression, c.kinetic_friction.expression);
    });
    if (!at_rest || !one_coefficient || !m.friction.empty()) continue;
    CAPTURE(file.string());
    ++tried;
    const auto found = ModeByMode(global_problem(scene)).all();
    const ExpectedAnswer expected = expected_answer(scene, "scene");
    const MotionsAtLoad& told = *expected.solved.at_load;
    CHECK(found.vary == !told.continua.empty());
    std::set<std::vector<Rational>> motions;
    for (const MotionAtLoad& motion : told.motions) {
      motions.insert({motion.accelerations.begin(), motion.accelerations.begin() + static_cast<long>(m.accelerations)});
    }
    CHECK(motions.size() == told.motions.size());
    // A motion inside of a continuum is not told apart from it.
    if (told.continua.empty()) {
      CHECK(motions == found.motions);
    } else {
      CHECK(std::ranges::includes(found.motions, motions));
    }
  }
  CHECK(tried > 100);
}

TEST_CASE("the expected motions of the shipped scenes obey the equations of the exported bodies") {
  std::size_t held = 0;
  for (const auto& file : shipped_scenes()) {
    MechanismScene scene = read_scene(file);
    if (is_long(scene)) continue;
    CAPTURE(file.string());
    scene.threshold.reset();
    const ExpectedAnswer expected = expected_answer(scene, "scene");
    const Mechanism& m = scene.mechanism;
    const auto accelerations = acceleration_names(m), forces = force_names(m);
    const EngineScene engine(bodies_json(scene));
    for (const MotionAtLoad& motion : expected.solved.at_load->motions) {
      EngineScene::Values values;
      bool determined = true;
      for (std::size_t i = 0; i < accelerations.size(); ++i) {
        values[accelerations[i]] = nearest_binary64(motion.accelerations[i]);
      }
      for (std::size_t i = 0; i < forces.size(); ++i) {
        determined = determined && motion.forces[i].is_point();
        if (determined) values[forces[i]] = nearest_binary64(*motion.forces[i].lower);
      }
      if (!determined) continue;
      ++held;
      CHECK(engine.residual(values) < 1e-12);
    }
  }
  CHECK(held > 100);
}
