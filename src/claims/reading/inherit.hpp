// Settings that name only what differs from another one.
#pragma once

#include <vector>

#include "base/input/toml.hpp"

namespace slipproof::claims_reader {

/// The tables [[setting]] as if each with `inherits` had been written out: what it does not name is as in the setting
/// before it that it names, but for `id`, `statement` and `line`; tables come together by key, definitions by symbol.
/// An id that no setting has, one that stands later, and circles are reported at their places; such a setting inherits
/// nothing.
std::vector<TomlValue> written_out(const std::vector<const TomlValue*>& settings, Mistakes& mistakes);

}  // namespace slipproof::claims_reader
