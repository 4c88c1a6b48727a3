// Certificates of `all-solutions` whose motion needs no friction, in numbers that a person can follow.
#pragma once

#include <string>

namespace slipproof::check_contact {

/// A block of mass and moment of inertia 1 in the plane, its center at a height of 1 between two contacts at a distance
/// of 2, rests under its weight of 1. Forces that press the contacts together move nothing. The squares are those of
/// the velocities of the center, across and up, and of the rotation.
inline const std::string kBlockRests =
    "slipproof-contact 1\n"
    "dimension 2 free 0 contacts 2\n"
    "mu 1/2 1/2\n"
    "matrix 14\n"
    "0 0 2  0 1 -1  0 3 -1\n"
    "1 0 -1  1 1 2  1 2 1  1 3 2\n"
    "2 1 1  2 2 2  2 3 1\n"
    "3 0 -1  3 1 2  3 2 1  3 3 2\n"
    "constant -1 0  -1 0\n"
    "no-answer\n"
    "all-solutions 1\n"
    "motion exact 1/2 0  1/2 0\n"
    "frictionless 0 3  1 0 1 0 1  1 1 0 1 0  1 -1 1 1 1\n"
    "end\n";

/// A block that is guided up and down rests under its weight of 1, and friction moves nothing. The motion is listed
/// three times, and one square adds nothing.
inline const std::string kGuided =
    "slipproof-contact 1\n"
    "dimension 2 free 0 contacts 1\n"
    "mu 1/2\n"
    "matrix 1  0 0 1\n"
    "constant -1 0\n"
    "no-answer\n"
    "all-solutions 3\n"
    "motion exact 1 0\n"
    "motion exact 1 1/2\n"
    "motion box modes stick center 1 0 radius 1/4 1/4 pinned 1 1 dropped 1  1 0 inverse 1  0 0 1\n"
    "frictionless 0 2  1 1 0  1 0 0\n"
    "end\n";

/// A point in space lifts off straight.
inline const std::string kLiftsOff =
    "slipproof-contact 1\n"
    "dimension 3 free 0 contacts 1\n"
    "mu 1/2\n"
    "matrix 3  0 0 2  1 1 1  2 2 1/2\n"
    "constant 3 0 0\n"
    "no-answer\n"
    "all-solutions 1\n"
    "motion exact 0 0 0\n"
    "frictionless 0 3  2 1 0 0  1 0 1 0  1/2 0 0 1\n"
    "end\n";

/// Two points: one slides on ice, the other one rests on a floor that rubs.
inline const std::string kOnIce =
    "slipproof-contact 1\n"
    "dimension 2 free 0 contacts 2\n"
    "mu 0 1/2\n"
    "matrix 4  0 0 1  1 1 1  2 2 1  3 3 1\n"
    "constant -1 2  -1 0\n"
    "no-answer\n"
    "all-solutions 1\n"
    "motion exact 1 0  1 0\n"
    "frictionless 0 4  1 1 0 0 0  1 0 1 0 0  1 0 0 1 0  1 0 0 0 1\n"
    "end\n";

/// Painleve's paradox for a symmetric W: it lifts with u = (1, 4), or slides with r = (1, -4) and u = (0, 1/2).
inline const std::string kThrownSideways =
    "slipproof-contact 1\n"
    "dimension 2 free 0 contacts 1\n"
    "mu 4\n"
    "matrix 4  0 0 1  0 1 1/2  1 0 1/2  1 1 1\n"
    "constant 1 4\n"
    "no-answer\n"
    "all-solutions 1\n"
    "motion exact 0 0\n"
    "frictionless 0 2  1 1 1/2  3/4 0 1\n"
    "end\n";

}  // namespace slipproof::check_contact
