// Answers of solvers that are pasted into the explorer's page.
#pragma once

#include <string>
#include <string_view>

#include "base/output/json.hpp"

namespace slipproof {

/// Judges answers as `certify` does, each by a member of the list that is returned. `text` is one contact problem with
/// its answer, a JSON object over any number of lines: a small one in the plane, or an LCP; or records of the scene, as
/// CSV with a header or one JSON object a line. `scene` is the text of a scene file, in the plane. A record that cannot
/// be read is `invalid`. Throws InputError for what is none of these.
Json judge_pasted(std::string_view text, const std::string& scene);

}  // namespace slipproof
