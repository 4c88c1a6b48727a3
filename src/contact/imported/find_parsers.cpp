#include "base/os/module.hpp"
#include "contact/imported/parsers.hpp"

namespace slipproof::imported {

#ifdef SLIPPROOF_PARSERS

ParseScene find_parsers(std::string& why) {
  return reinterpret_cast<ParseScene>(function_of_module("slipproof-parsers.so", "slipproof_parse_scene", why));
}

#else

ParseScene find_parsers(std::string& why) {
  why = "slipproof was built without what reads it (SLIPPROOF_IMPORT)";
  return nullptr;
}

#endif

}  // namespace slipproof::imported
