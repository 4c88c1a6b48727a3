// The public headers: what other programs include, and what is installed with all that these include. Each can be
// included by itself.
#pragma once

#include "base/input/diagnostic.hpp"             // InputError: every mistake of a file, with its place
#include "claims/reading/read_claims_file.hpp"   // papers,
#include "claims/verify/verify.hpp"              // and what is true of them
#include "contact/formats/read_files.hpp"        // contact problems of other solvers and their answers,
#include "contact/judge/judge.hpp"               // judged;
#include "contact/judge/small.hpp"               // small ones against all solutions
#include "contact/problem/every_push.hpp"        // whether a scene has one motion whatever else pushes it
#include "contact/space/solve_space.hpp"         // scenes in space, and all of their motions
#include "floating/batch/mechanism_batch.hpp"    // the modes of many scenes in columns of doubles
#include "mechanics/checks/checks.hpp"           // what looks wrong in a mechanism
#include "mechanics/reading/read_mechanism.hpp"  // mechanisms,
#include "mechanics/scene/solve_mechanism.hpp"   // scenes, and all of their motions
#include "mechanics/search/search.hpp"           // where a mechanism has no motion, or several
#include "proofs/check/files.hpp"                // checks certificates
#include "records/judging/record_judge.hpp"      // judges records of a solver's answers
#include "report/picture/motions_svg.hpp"        // pictures,
#include "report/scenes/mechanism_report.hpp"    // and reports as text and JSON,
#include "report/scenes/space_report.hpp"        // in space, too
