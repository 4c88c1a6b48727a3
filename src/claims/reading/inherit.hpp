// Settings that contain only their differences from another one.
#pragma once

#include <vector>

#include "base/input/toml.hpp"

namespace slipproof::claims_reader {

/// The tables [[setting]] with each `inherits` written out. A key that a setting lacks is taken from the earlier
/// setting that it names, except `id`, `statement` and `line`; tables are merged by key, definitions by symbol. An
/// unknown id, the id of a later setting, and circles are reported at their places; such a setting inherits nothing.
std::vector<TomlValue> written_out(const std::vector<const TomlValue*>& settings, Mistakes& mistakes);

}  // namespace slipproof::claims_reader
