// The rule for judging answers to contact problems, in any form of problem and answer.
#pragma once

namespace slipproof {

/// The error of an answer is its distance from an exact solution: of forces over the largest force, of velocities over
/// the largest velocity. Up to `contact_tolerance` it is right, up to `contact_near` it is inaccurate, beyond it wrong.
inline constexpr double contact_tolerance = 1e-6, contact_near = 1e-2;

}  // namespace slipproof
