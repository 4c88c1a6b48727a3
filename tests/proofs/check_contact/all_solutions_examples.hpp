// Certificates of `all-solutions`, in numbers that a person can follow.
#pragma once

#include <string>

namespace slipproof::check_contact {

/// A weight of 1 rests: u = r - 1.
inline const std::string kRests =
    "slipproof-contact 1\n"
    "dimension 1 free 0 contacts 1\n"
    "mu 0\n"
    "matrix 1  0 0 1\n"
    "constant -1\n"
    "no-answer\n"
    "all-solutions 1\n"
    "motion exact 1\n"
    "decide 0\n"
    "  empty -1\n"
    "  known 0\n"
    "end\n";

/// The same, with a free unknown x: 2 x - 2 r + 2 = 0, u = x. The motion is in a box.
inline const std::string kRestsInBox =
    "slipproof-contact 1\n"
    "dimension 1 free 1 contacts 1\n"
    "mu 0\n"
    "matrix 3  0 0 2  0 1 -2  1 0 1\n"
    "constant 2 0\n"
    "no-answer\n"
    "all-solutions 1\n"
    "eliminated 1  0 0 1/2\n"
    "motion box modes stick center 1 radius 1/4 pinned 0 dropped 0 inverse 1  0 0 1 alone 4\n"
    "decide 0\n"
    "  empty -1\n"
    "  known 0  -1  1\n"
    "end\n";

/// u = 1 - r: it lifts, or it rests.
inline const std::string kRestsOrLifts =
    "slipproof-contact 1\n"
    "dimension 1 free 0 contacts 1\n"
    "mu 0\n"
    "matrix 1  0 0 -1\n"
    "constant 1\n"
    "no-answer\n"
    "all-solutions 2\n"
    "motion exact 0\n"
    "motion exact 1\n"
    "decide 0\n"
    "  known 0  1  -1\n"
    "  known 1\n"
    "end\n";

/// u = r: it touches without a force. That it does not lift follows because more than 0 is proved.
inline const std::string kTouches =
    "slipproof-contact 1\n"
    "dimension 1 free 0 contacts 1\n"
    "mu 0\n"
    "matrix 1  0 0 1\n"
    "constant 0\n"
    "no-answer\n"
    "all-solutions 1\n"
    "motion exact 0\n"
    "decide 0\n"
    "  empty -1\n"
    "  known 0\n"
    "end\n";

/// Two contacts share a weight of 1, and the second one rubs, r = (t, -t), u_T = 2 - t for any t from 0 to 1. For t =
/// 0, the motion in the list, it touches.
inline const std::string kSharedWeight =
    "slipproof-contact 1\n"
    "dimension 2 free 0 contacts 2\n"
    "mu 0 1\n"
    "matrix 6  0 0 1  0 2 1  1 1 1  2 0 1  2 2 1  3 3 1\n"
    "constant -1 0  -1 2\n"
    "no-answer\n"
    "all-solutions 1\n"
    "motion box modes stick touch center 1 0 radius 1/4 1\n"
    "pinned 1 1 dropped 1  1 1 0 1 inverse 1  0 0 1 within 0 0 0 1\n"
    "decide 0\n"
    "  decide 1\n"
    "    empty -1 0 0 0\n"
    "    empty -1 0 1 0\n"
    "  decide 1\n"
    "    empty 1 0 -1 0\n"
    "    slips 1\n"
    "      empty 0 0 1 1\n"
    "      known 0  0 1 0 0  0 -1 0 0  0 0 1 1  0 0 0 -1\n"
    "      empty 0 0 0 1\n"
    "end\n";

/// A block in the plane under a push: r = (1, -1/2), u = (0, 3/2).
inline const std::string kSlides =
    "slipproof-contact 1\n"
    "dimension 2 free 0 contacts 1\n"
    "mu 1/2\n"
    "matrix 2  0 0 1  1 1 1\n"
    "constant -1 2\n"
    "no-answer\n"
    "all-solutions 1\n"
    "motion exact 1 -1/2\n"
    "decide 0\n"
    "  empty -1 0\n"
    "  slips 0\n"
    "    empty 1 1\n"
    "    known 0  1/2 1  -1/2 -1\n"
    "    empty 0 1\n"
    "end\n";

/// The same, with the motion in a box.
inline const std::string kSlidesInBox =
    "slipproof-contact 1\n"
    "dimension 2 free 0 contacts 1\n"
    "mu 1/2\n"
    "matrix 2  0 0 1  1 1 1\n"
    "constant -1 2\n"
    "no-answer\n"
    "all-solutions 1\n"
    "motion box modes slide+ center 1 -1/2 radius 1/4 1/4 pinned 0 dropped 0\n"
    "inverse 3  0 0 1  1 0 -1/2  1 1 1 alone 2\n"
    "decide 0\n"
    "  empty -1 0\n"
    "  slips 0\n"
    "    empty 1 1\n"
    "    known 0  -1 0  1 0  1/2 0  -1/2 0\n"
    "    empty 0 1\n"
    "end\n";

/// Painleve's paradox: it lifts, sticks with r = (15, -8), or slides with r = (1, -1) and u = (0, 7).
inline const std::string kParadox =
    "slipproof-contact 1\n"
    "dimension 2 free 0 contacts 1\n"
    "mu 1\n"
    "matrix 4  0 0 1  0 1 2  1 0 2  1 1 5\n"
    "constant 1 10\n"
    "no-answer\n"
    "all-solutions 3\n"
    "motion exact 0 0\n"
    "motion exact 15 -8\n"
    "motion box modes slide+ center 1 -1 radius 1/8 1/8 pinned 0 dropped 0\n"
    "inverse 4  0 0 -1  0 1 2  1 0 1  1 1 -1 alone 1\n"
    "decide 0\n"
    "  known 0  1 0  -1 0  0 1  0 -1\n"
    "  slips 0\n"
    "    known 1\n"
    "    known 2  1 0  -1 0  -1 0  1 0\n"
    "    empty 1 0\n"
    "end\n";

/// A block rests on a plane under a push of 3, below the limit of friction, 5.
inline const std::string kSticks =
    "slipproof-contact 1\n"
    "dimension 3 free 0 contacts 1\n"
    "mu 1/2\n"
    "matrix 3  0 0 1  1 1 1  2 2 1\n"
    "constant -10 3 0\n"
    "no-answer\n"
    "all-solutions 1\n"
    "motion box modes stick center 10 -3 0 radius 1/4 1/4 1/4 pinned 0 dropped 0\n"
    "inverse 3  0 0 1  1 1 1  2 2 1 alone 1\n"
    "decide 0\n"
    "  empty -1 0 0\n"
    "  slips 0 4  1 0  0 1  -1 0  0 -1\n"
    "    known 0  -1 0 0  1 0 0  0 -1 0  0 1 0  0 0 -1  0 0 1\n"
    "    empty -1/2 -1 -1\n"
    "    empty 0 1 0\n"
    "    empty 0 1 0\n"
    "    empty -1/2 -1 1\n"
    "end\n";

/// A block on a plane under a push of (9, 12): r = (10, -3, -4), u = (0, 6, 8) = (0, -2 r_T).
inline const std::string kSlidesInSpace =
    "slipproof-contact 1\n"
    "dimension 3 free 0 contacts 1\n"
    "mu 1/2\n"
    "matrix 3  0 0 1  1 1 1  2 2 1\n"
    "constant -10 9 12\n"
    "no-answer\n"
    "all-solutions 1\n"
    "motion box modes slide\n"
    "center 10 -3 -4 2\n"
    "radius 1/8 3/32 1/16 1/32\n"
    "pinned 0 dropped 0\n"
    "inverse 13\n"
    "0 0 1\n"
    "1 0 -3/10  1 1 16/75  1 2 -4/25  1 3 -3/50\n"
    "2 0 -2/5   2 1 -4/25  2 2 3/25   2 3 -2/25\n"
    "3 0 -3/10  3 1 -3/25  3 2 -4/25  3 3 -3/50\n"
    "alone 4\n"
    "decide 0\n"
    "  empty -1 0 0\n"
    "  slips 0 4  1 0  0 1  -1 0  0 -1\n"
    "    empty 5/2 3 4\n"
    "    arcs 0 2  48/73 55/73  28/53 45/53\n"
    "      empty 0 -55 48\n"
    "      known 0  -1 0 0  1 0 0\n"
    "        24/73 0 0  -14/53 0 0  45/106 0 0  -55/146 0 0\n"
    "        -3 -4588/3869 -6200/3869  29/10 4588/3869 6200/3869\n"
    "      empty 0 45 -28\n"
    "    empty 0 1 0\n"
    "    empty 0 1 1\n"
    "    empty 0 0 1\n"
    "end\n";

/// The same motion, and others that may be near it.
inline const std::string kNearASlide = [](const std::string& text) {
  const std::size_t alone = text.find("alone 4"), bounds = text.find("-1 0 0  1 0 0"), after = text.find("empty 0 45");
  return text.substr(0, alone) + "within 0 9/32 3/16" + text.substr(alone + 7, bounds - alone - 7) +
         "24/73 1 0  -14/53 -1 0  45/106 0 1  -55/146 0 -1\n" + text.substr(after);
}(kSlidesInSpace);

/// One contact lifts, one without friction rests and moves, one slides as in kSlides. Forces at the first and friction
/// at the second would matter to the others.
inline const std::string kThreeContacts =
    "slipproof-contact 1\n"
    "dimension 2 free 0 contacts 3\n"
    "mu 1/2 0 1/2\n"
    "matrix 9  0 0 1  1 1 1  2 2 1  3 3 1  4 0 1  4 3 1  4 4 1  5 3 1  5 5 1\n"
    "constant 5 1  -1 3  -1 2\n"
    "no-answer\n"
    "all-solutions 1\n"
    "motion box modes open stick slide+ center 1 1 -1/2 radius 1/4 1/4 1/8 pinned 0 dropped 0\n"
    "inverse 4  0 0 1  1 1 1  2 1 -1/2  2 2 1 alone 2\n"
    "decide 0\n"
    "  decide 1\n"
    "    empty 0 0 -1 0 0 0\n"
    "    decide 2\n"
    "      empty 0 0 0 0 -1 0\n"
    "      slips 2\n"
    "        empty 0 0 0 0 1 1\n"
    "        known 0  0 0 -1 0 0 0  0 0 1 0 0 0\n"
    "          0 0 0 0 -1 0  0 0 0 0 1 0  0 0 0 0 1/2 0  0 0 0 0 -1/2 0\n"
    "        empty 0 0 0 0 0 1\n"
    "  empty 1 0 0 0 0 0\n"
    "end\n";

/// u_N = -1 - r_N + 6/5 r_T1 + 8/5 r_T2 is at most -1 (kNoSolution).
inline const std::string kNoMotion =
    "slipproof-contact 1\n"
    "dimension 3 free 1 contacts 1\n"
    "mu 1/2\n"
    "matrix 7\n"
    "0 0 1  1 0 -1  1 1 -1  1 2 6/5  1 3 8/5  2 2 1  3 3 1\n"
    "constant -1 0 5 6\n"
    "no-answer\n"
    "all-solutions 0\n"
    "eliminated 1  0 0 1\n"
    "empty -1 0 0\n"
    "end\n";

}  // namespace slipproof::check_contact
