// Tests that need the parsers of URDF, SDF and MJCF.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "contact/imported/parsers.hpp"

/// Whether they were built; says so if not.
inline bool has_parsers() {
  std::string why;
  const bool found = slipproof::imported::find_parsers(why) != nullptr;
  if (!found) MESSAGE("not tried: " << why);
  return found;
}
