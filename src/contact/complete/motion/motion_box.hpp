// Boxes in which a motion of a mode is proved to exist, and those in which it is the only one.
#pragma once

#include <Eigen/Dense>

#include "contact/complete/motion/motion.hpp"

namespace slipproof {

/// The motion at a point of the mode's unknowns, and what radii of these mean for forces and velocities; no radii where
/// the point is exact.
SpatialMotion motion_at(const ExactContacts& contacts, const ContactPattern& mode, const std::vector<bool>& touching,
                        const std::vector<Rational>& point, const std::vector<Rational>& radius = {});

/// A motion near a zero of the mode's equations in binary64, where their derivative is known. Forces that they leave
/// open are held, and equations that follow from others are dropped. Nothing where none can be proved.
std::optional<SpatialMotion> motion_in_box(const ExactContacts& contacts, const ContactPattern& mode,
                                           const std::vector<bool>& touching, const std::vector<double>& zero,
                                           const Eigen::MatrixXd& derivative);

}  // namespace slipproof
