#include <dlfcn.h>

#include <array>
#include <filesystem>

#include "contact/imported/parsers.hpp"

namespace slipproof::imported {

#ifdef SLIPPROOF_PARSERS

ParseScene find_parsers(std::string& why) {
  std::error_code error;
  const auto beside = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  const std::filesystem::path name = "slipproof-parsers.so";
  const std::array<std::filesystem::path, 3> places{beside / name, beside.parent_path() / SLIPPROOF_LIBRARIES / name,
                                                    SLIPPROOF_PARSERS};
  for (const std::filesystem::path& place : places) {
    if (!std::filesystem::exists(place, error)) continue;
    void* module = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr) {
      why = dlerror();
      return nullptr;
    }
    return reinterpret_cast<ParseScene>(dlsym(module, "slipproof_parse_scene"));
  }
  why = "the part of slipproof that reads it, " + name.string() + ", is not installed";
  return nullptr;
}

#else

ParseScene find_parsers(std::string& why) {
  why = "slipproof was built without what reads it (SLIPPROOF_IMPORT)";
  return nullptr;
}

#endif

}  // namespace slipproof::imported
