// JSON in a page.
#pragma once

#include <string>

namespace slipproof {

/// JSON that cannot end the element that it stands in.
std::string inside_script(const std::string& json);

}  // namespace slipproof
