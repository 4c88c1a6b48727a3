// Modules that cannot be loaded: the reason, with the file name. The tests of PNG pictures and of imports load modules.
#include "base/os/module.hpp"

#include <doctest/doctest.h>

#include <string>

TEST_CASE("a module that is not there, or is no module, is refused with its name") {
  std::string why;
  CHECK(slipproof::function_of_module("slipproof-nothing.so", "main", why) == nullptr);
  CHECK(why.find("slipproof-nothing.so") != std::string::npos);
  // CMakeCache.txt stands where modules are built.
  CHECK(slipproof::function_of_module("CMakeCache.txt", "main", why) == nullptr);
  CHECK(why.find("CMakeCache.txt") != std::string::npos);
}
