#include "report/picture/rest_svg.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/input/diagnostic.hpp"
#include "base/number/binary64.hpp"
#include "report/picture/mechanism_svg.hpp"
#include "report/picture/space/space_svg.hpp"
#include "report/picture/velocities/moving_scene.hpp"

namespace slipproof {

namespace {

/// The forces, or the virtual motion, in the form of a motion of the scene.
class RestPicture {
 public:
  explicit RestPicture(const RestAnswer& answer)
      : answer_(answer), problem_(answer.problem), m_(answer.scene.mechanism) {
    if (answer.decision.fall) rates_ = answer.decision.fall->rates;
    if (rates_.empty()) rates_.resize(problem_.rows.size());
    forces_ = answer.decision.forces;
    if (forces_.empty()) forces_.resize(problem_.forces.size());
  }

  std::string heading() const { return falls() ? "a virtual motion that proves its fall" : "forces that hold it"; }

  std::string in_plane() const {
    MotionAtLoad motion;
    motion.modes.emplace_back();
    for (std::size_t i = 0; i < m_.elements(); ++i) motion.modes[0].push_back(state(i));
    motion.accelerations = accelerations();
    for (const Rational& force : forces_) motion.forces.push_back({force, force});
    CommonLook look;
    look.is_virtual = falls();
    return mechanism_svg_file(falls() ? moving_scene(answer_.scene, problem_.rows, rates_) : answer_.scene, &motion,
                              look, heading());
  }

  std::string in_space(const Vec3& from) const {
    SpaceMotion motion;
    for (std::size_t i = 0; i < m_.contacts.size(); ++i) {
      const ElementState state = this->state(i);
      const bool slips = state == ElementState::slip_forward;
      motion.modes.emplace_back(slips ? "slip" : name(state));
      motion.slips.push_back(slips ? std::optional(slip_angle(m_.contacts[i])) : std::nullopt);
    }
    for (const Rational& rate : accelerations()) motion.accelerations.push_back({rate, rate});
    for (const Rational& force : forces_) motion.forces.emplace_back(Range{force, force});
    motion.strict = true;
    if (falls()) return virtual_motion_svg_file(answer_.scene, motion, from, heading());
    return space_svg_file({answer_.scene, {motion}, {}, {}, 0}, 0, from, heading());
  }

 private:
  bool falls() const { return answer_.decision.can == false; }
  Rational rate(std::size_t unknown) const { return problem_.rate_along(unknown - m_.accelerations, rates_); }

  ElementState state(std::size_t element) const {
    if (element >= m_.contacts.size()) {
      return moved_to(rate(m_.friction[element - m_.contacts.size()].force));
    }
    const MechanismContact& contact = m_.contacts[element];
    const bool open = answer_.scene.values.starts[element] == ElementKind::Start::open;
    if (open || rate(contact.normal).sign() > 0) return ElementState::lift;
    if (contact.frictionless()) return ElementState::touch;
    if (contact.second && !rate(contact.second->force).is_zero()) return ElementState::slip_forward;
    const ElementState along = moved_to(rate(*contact.tangent));
    return contact.second && along == ElementState::slip_backward ? ElementState::slip_forward : along;
  }
  static ElementState moved_to(const Rational& slip) {
    return slip.is_zero()    ? ElementState::stick
           : slip.sign() > 0 ? ElementState::slip_forward
                             : ElementState::slip_backward;
  }

  Range slip_angle(const MechanismContact& contact) const {
    const double angle =
        std::atan2(nearest_binary64(rate(contact.second->force)), nearest_binary64(rate(*contact.tangent)));
    const Rational degrees = to_rational(angle * 180 / std::numbers::pi);
    return {degrees, degrees};
  }

  /// In the order of acceleration_names().
  std::vector<Rational> accelerations() const {
    std::vector<Rational> result = rates_;
    for (const MechanismContact& contact : m_.contacts) {
      result.push_back(rate(contact.normal));
      if (contact.slip) result.push_back(contact.tangent ? rate(*contact.tangent) : Rational(0));
      if (contact.second) result.push_back(rate(contact.second->force));
    }
    for (const MechanismFriction& friction : m_.friction) result.push_back(rate(friction.force));
    return result;
  }

  const RestAnswer& answer_;
  const RestProblem& problem_;
  const Mechanism& m_;
  std::vector<Rational> rates_, forces_;
};

}  // namespace

std::string rest_svg_file(const RestAnswer& answer, const Vec3& from) {
  const auto refuse = [&](const char* message) { throw InputError({{answer.problem.file, 0, 0, message}}); };
  const RestDecision& decision = answer.decision;
  if (decision.forces.empty() && !decision.fall) {
    refuse("nothing is proved about its rest at one load, expected a proof to draw");
  }
  if (decision.fall && !answer.problem.by_virtual_work) {
    refuse(
        "found equations as printed, whose multipliers are no motion, expected equations by virtual work to draw a "
        "fall");
  }
  const RestPicture picture(answer);
  return answer.scene.mechanism.dimension == 2 ? picture.in_plane() : picture.in_space(from);
}

}  // namespace slipproof
