#include "base/os/module.hpp"

#ifdef SLIPPROOF_MODULES

#include <dlfcn.h>

#include <array>
#include <filesystem>

namespace slipproof {

void* function_of_module(const std::string& module, const char* function, std::string& why) {
  std::error_code error;
  const auto beside = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  const std::array<std::filesystem::path, 3> folders{beside, beside.parent_path() / SLIPPROOF_LIBRARIES,
                                                     SLIPPROOF_MODULES};
  for (const std::filesystem::path& folder : folders) {
    const std::filesystem::path place = folder / module;
    if (!std::filesystem::exists(place, error)) continue;
    void* loaded = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* result = loaded == nullptr ? nullptr : dlsym(loaded, function);
    if (result == nullptr) why = dlerror();
    return result;
  }
  why = "the part of slipproof for it, " + module + ", is not installed";
  return nullptr;
}

}  // namespace slipproof

#else

namespace slipproof {

void* function_of_module(const std::string& module, const char*, std::string& why) {
  why = "this slipproof was built without " + module;
  return nullptr;
}

}  // namespace slipproof

#endif
