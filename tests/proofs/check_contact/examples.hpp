// A certificate for each claim, in numbers that a person can follow, and what the tests do with them.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "proofs/check_contact/record.hpp"
#include "support/replaced.hpp"

namespace slipproof::check_contact {

/// `accepted: ...`, `rejected: ...` or `unreadable: ...`. Which problem it is about is left out where it names none.
inline std::string verdict(const std::string& text) {
  using Kind = ContactVerdict::Kind;
  ContactVerdict found = checked_on_record(text);
  found.message.resize(std::min(found.message.find(", names no problem"), found.message.size()));
  return (found.kind == Kind::accepted   ? "accepted: "
          : found.kind == Kind::rejected ? "rejected: "
                                         : "unreadable: ") +
         found.message;
}

using test::replaced;

/// A change of a certificate, and why it is rejected then.
struct Forgery {
  std::string from, to, expected;
};

inline void reject_all(const std::string& certificate, const std::vector<Forgery>& forgeries) {
  const std::string genuine = verdict(certificate);
  REQUIRE_MESSAGE(genuine.starts_with("accepted: "), genuine);
  for (const Forgery& forgery : forgeries) {
    const std::string found = verdict(replaced(certificate, forgery.from, forgery.to));
    INFO("'", forgery.from, "' -> '", forgery.to, "'");
    CHECK(found == "rejected: " + forgery.expected);
  }
}

/// Slides with r_T = -(3, 4) against u_T = (6, 8); the constant is off by 1/4, the answer by 1/8.
inline const std::string kEps =
    "slipproof-contact 1\n"
    "dimension 3 free 1 contacts 1\n"
    "mu 1/2\n"
    "matrix 4\n"
    "0 0 2  1 1 1  2 2 1  3 3 1\n"
    "constant -6  -10 9 49/4\n"
    "answer 3  10 -3 -33/8\n"
    "eps 1/4 1/8\n"
    "point 3  10 -3 -4\n"
    "motion 0  0 6 8\n"
    "end\n";

/// It slides, and friction is far from its limit.
inline const std::string kNoneWithin =
    "slipproof-contact 1\n"
    "dimension 3 free 0 contacts 1\n"
    "mu 1/2\n"
    "matrix 3\n"
    "0 0 1  1 1 1  2 2 1\n"
    "constant -1 1 0\n"
    "answer 1 0 0\n"
    "none-within 1/8\n"
    "end\n";

/// v = 1, and u_N = -v - r_N + 6/5 r_T1 + 8/5 r_T2, which is -1 - r_N + 2 |r_T| at most.
inline const std::string kNoSolution =
    "slipproof-contact 1\n"
    "dimension 3 free 1 contacts 1\n"
    "mu 1/2\n"
    "matrix 7\n"
    "0 0 1  1 0 -1  1 1 -1  1 2 6/5  1 3 8/5  2 2 1  3 3 1\n"
    "constant -1 0 5 6\n"
    "no-answer\n"
    "no-solution\n"
    "multipliers 1 1 0 0\n"
    "end\n";

/// As in kEps: r = (10, -3, -4), u = (0, 6, 8) = (0, -2 r_T).
inline const std::string kSlide =
    "slipproof-contact 1\n"
    "dimension 3 free 0 contacts 1\n"
    "mu 1/2\n"
    "matrix 3\n"
    "0 0 1  1 1 1  2 2 1\n"
    "constant -10 9 12\n"
    "answer 10 -3 -4\n"
    "enclosure 2\n"
    "modes slide\n"
    "center 10 -3 -4 2\n"
    "radius 2 2 2 2\n"
    "pinned 0\n"
    "dropped 0\n"
    "inverse 13\n"
    "0 0 1\n"
    "1 0 -3/10  1 1 16/75  1 2 -4/25  1 3 -3/50\n"
    "2 0 -2/5   2 1 -4/25  2 2 3/25   2 3 -2/25\n"
    "3 0 -3/10  3 1 -3/25  3 2 -4/25  3 3 -3/50\n"
    "end\n";

/// kSlide with the name of its problem.
inline const std::string kNamed =
    "slipproof-contact 1\n"
    "problem 3407f8654cb2daeb5e7c0ffe1f6b727dbb187f245deeaf6b097482bc53d59714\n" +
    kSlide.substr(kSlide.find("dimension"));

/// Slides either way with r = (4, -2), u_T = 3 and r = (4, 2), u_T = -3; a third contact is open.
inline const std::string kPlane =
    "slipproof-contact 1\n"
    "dimension 2 free 0 contacts 3\n"
    "mu 1/2 1/2 1\n"
    "matrix 6\n"
    "0 0 1  1 1 1  2 2 1  3 3 1  4 0 1  4 4 1\n"
    "constant -4 5  -4 -5  -3 7\n"
    "answer 4 -2  4 2  0 0\n"
    "enclosure 1/2\n"
    "modes slide+ slide- open\n"
    "center 4 -2 4 2\n"
    "radius 0x1p-2 1/4 1/4 1/4\n"
    "pinned 0\n"
    "dropped 0\n"
    "inverse 6\n"
    "0 0 1  1 0 -1/2  1 1 1  2 2 1  3 2 1/2  3 3 1\n"
    "end\n";

/// 2 x_0 + x_1 = 3 = x_0 + 2 x_1, by an inverse that knows only the diagonal, from a center that is off.
inline const std::string kComplementarity =
    "slipproof-contact 1\n"
    "dimension 1 free 0 contacts 2\n"
    "mu 0 0\n"
    "matrix 4\n"
    "0 0 2  0 1 1  1 0 1  1 1 2\n"
    "constant -3 -3\n"
    "answer 1 1\n"
    "enclosure 3/16\n"
    "modes stick stick\n"
    "center 17/16 1\n"
    "radius 1/8 1/8\n"
    "pinned 0\n"
    "dropped 0\n"
    "inverse 2\n"
    "0 0 1/2  1 1 1/2\n"
    "end\n";

/// The same equations, by half of the matrix and a bound on how much it shortens: M is J with its columns over 16 and
/// 8, and its least singular value is 0.0777.
inline const std::string kBall =
    "slipproof-contact 1\n"
    "dimension 1 free 0 contacts 2\n"
    "mu 0 0\n"
    "mirrored 0\n"
    "1 0 2\n"
    "2 0 1 1 2\n"
    "constant -3 -3\n"
    "answer 1 1\n"
    "ball 1/8\n"
    "modes stick stick\n"
    "center 65/64 1\n"
    "radius 1/16 1/8\n"
    "pinned 0\n"
    "dropped 0\n"
    "rows 1 1\n"
    "least 3/64\n"
    "defect 9/256\n"
    "bend 0\n"
    "order 8 1 0\n"
    "end\n";

/// A rod of weight 2 that rests on two supports: v = 0, r_1 + r_2 = 2. Which of them bears what is free.
inline const std::string kRod =
    "slipproof-contact 1\n"
    "dimension 1 free 1 contacts 2\n"
    "mu 0 0\n"
    "matrix 5\n"
    "0 0 1  0 1 -1  0 2 -1  1 0 1  2 0 1\n"
    "constant 2 0 0\n"
    "answer 0 5/4 3/4\n"
    "enclosure 1/2\n"
    "modes stick stick\n"
    "center 0 1 1\n"
    "radius 1/4 1/4 1/4\n"
    "pinned 1 2\n"
    "dropped 1  2 1 1 1\n"
    "inverse 3\n"
    "0 1 1  1 0 -1  1 1 1\n"
    "end\n";

/// Sticks with r_T = (3, 3), which is |r_T| < 5; a second contact has no friction and u_T = (5, 7).
inline const std::string kStick =
    "slipproof-contact 1\n"
    "dimension 3 free 0 contacts 2\n"
    "mu 1/2 0\n"
    "matrix 6\n"
    "0 0 1  1 1 1  2 2 1  3 3 1  4 4 1  5 5 1\n"
    "constant -10 -3 -3  -1 5 7\n"
    "answer 10 3 3  1 0 0\n"
    "enclosure 1/4\n"
    "modes stick stick\n"
    "center 10 3 3 1\n"
    "radius 1/4 1/4 1/4 1/4\n"
    "pinned 0\n"
    "dropped 0\n"
    "inverse 4\n"
    "0 0 1  1 1 1  2 2 1  3 3 1\n"
    "end\n";

inline const std::string kDominant =
    "slipproof-contact 1\n"
    "dimension 1 free 0 contacts 2\n"
    "mu 0 0\n"
    "matrix 3\n"
    "0 0 2  0 1 -3  1 1 1\n"
    "constant 1 -1\n"
    "no-answer\n"
    "unique dominant 2 1\n"
    "end\n";

/// A + A^T = (2 1; 1 2), L L^T = (1 1/2; 1/2 5/4).
inline const std::string kDefinite =
    "slipproof-contact 1\n"
    "dimension 1 free 0 contacts 2\n"
    "mu 0 0\n"
    "matrix 4\n"
    "0 0 1  0 1 3  1 0 -2  1 1 1\n"
    "constant 1 -1\n"
    "no-answer\n"
    "unique definite 3  0 0 1  1 0 1/2  1 1 1\n"
    "end\n";

/// One contact in the plane. Mode determinants: 1 -+ 3/2 * 1/2 where it slides, 2 where it sticks.
inline const std::string kDeterminants =
    "slipproof-contact 1\n"
    "dimension 2 free 0 contacts 1\n"
    "mu 3/2\n"
    "matrix 3\n"
    "0 0 1  0 1 1/2  1 1 2\n"
    "constant 1 -1\n"
    "no-answer\n"
    "unique determinants 1  1 1 1\n"
    "end\n";

/// The bound takes 1/2 of a_00: mu^2 a_11 for the symmetric part, and mu/4 twice for the other. A + A^T less that is
/// (1 1/2; 1/2 2).
inline const std::string kBound =
    "slipproof-contact 1\n"
    "dimension 2 free 0 contacts 1\n"
    "mu 1/2\n"
    "matrix 4\n"
    "0 0 1  0 1 1/2  1 0 0  1 1 1\n"
    "constant 1 -1\n"
    "no-answer\n"
    "unique bound 2  0 0 1/2  1 1 1\n"
    "end\n";

}  // namespace slipproof::check_contact
