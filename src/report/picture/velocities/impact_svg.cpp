#include "report/picture/velocities/impact_svg.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "mechanics/bodies/bodies.hpp"
#include "report/picture/frame/panels.hpp"
#include "report/picture/mechanism_svg.hpp"
#include "report/picture/motions_svg.hpp"
#include "report/picture/space/space_svg.hpp"
#include "report/picture/velocities/moving_scene.hpp"

namespace slipproof {

namespace {

/// With velocities before: an impact has them as prescribed accelerations.
MechanismScene scene_before(const SolvedImpact& solved) {
  MechanismScene scene = solved.scene;
  const auto bodies = std::make_shared<Bodies>(*scene.mechanism.bodies);
  for (Body& body : bodies->bodies) {
    body.velocity = body.acceleration;
    body.spin = body.turning;
  }
  scene.mechanism.bodies = bodies;
  if (solved.scene.mechanism.impact->law != ImpactLaw::poisson || solved.space) return scene;
  for (std::size_t i = 0; i < solved.contacts.size(); ++i) {  // they show the impulse of both phases
    Mechanism& m = scene.mechanism;
    const std::size_t extra = m.contacts[i].normal;
    m.unknowns[extra].symbol = m.unknowns[extra - m.forces].symbol;
  }
  return scene;
}

class ImpactPicture {
 public:
  explicit ImpactPicture(const SolvedImpact& solved) : solved_(solved), m_(solved.scene.mechanism) {
    motions_ = drawn_motions(*solved.plane->at_load);
    for (MotionAtLoad& motion : motions_) show_whole_impulses(motion);
    MotionAtLoad none;
    none.accelerations.resize(acceleration_names(m_).size());
    none.forces.resize(m_.unknowns.size() - m_.accelerations, Range{Rational(0), Rational(0)});
    scenes_.push_back(scene_before(solved));
    const std::vector<std::string> names = acceleration_names(m_);
    for (const MotionAtLoad& motion : motions_) {
      scenes_.push_back(moving_scene(scenes_.front(), names, motion.accelerations));
    }
    motions_.insert(motions_.begin(), std::move(none));
  }

  std::string file() const {
    const CommonLook look = common_look(solved_.scene, motions_);
    PanelSheet sheet{solved_.scene.name,
                     "an impact by " + solved_.law_words(),
                     {},
                     picture_height(solved_.scene, PanelSheet{}.height)};
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      const std::string heading = i == 0 ? "before" : fmt::format("{}: {}", i, modes_text(motions_[i]));
      sheet.panels.push_back({heading, i == 0 ? "" : energy_words(solved_.outcomes[i - 1]),
                              [&look, this, i, heading](const Element& svg, LabelBox& seen) {
                                return add_mechanism(svg, scenes_[i], &motions_[i], heading, look, &seen);
                              }});
    }
    return panels_svg_file(sheet);
  }

 private:
  /// By Poisson's law a contact has its impulse beyond what compression gives back: it shows that of both phases, which
  /// comes first among the forces.
  void show_whole_impulses(MotionAtLoad& motion) const {
    if (m_.impact->law != ImpactLaw::poisson) return;
    for (std::size_t k = 0; k < m_.forces; ++k) motion.forces[m_.forces + k] = motion.forces[k];
  }

  static std::string energy_words(const ImpactOutcome& outcome) {
    if (!outcome.gains) return {};
    return *outcome.gains ? "gains energy" : "gains no energy";
  }

  const SolvedImpact& solved_;
  const Mechanism& m_;
  std::vector<MotionAtLoad> motions_;   ///< the first without impulses
  std::vector<MechanismScene> scenes_;  ///< of each, with its velocities
};

}  // namespace

std::string impact_svg_file(const SolvedImpact& solved, const Vec3& from) {
  if (solved.plane) return ImpactPicture(solved).file();
  SolvedSpace space = *solved.space;
  space.scene = scene_before(solved);
  return space_motions_svg_file(space, from);
}

}  // namespace slipproof
