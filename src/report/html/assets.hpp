// The style sheet and the script of the page, as text.
#pragma once

#include <string_view>

namespace slipproof::assets {

extern const std::string_view style_css, script_js;

}  // namespace slipproof::assets
