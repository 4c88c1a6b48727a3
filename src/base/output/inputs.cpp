#include "base/output/inputs.hpp"

#include <sys/stat.h>

#include <optional>

#include "base/input/diagnostic.hpp"

namespace slipproof {

namespace {

std::optional<std::pair<dev_t, ino_t>> identity(const std::filesystem::path& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0 || !S_ISREG(found.st_mode)) return std::nullopt;
  return std::pair(found.st_dev, found.st_ino);
}

}  // namespace

Inputs::Inputs(const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& file : files) add(file);
}

void Inputs::add(const std::filesystem::path& file) {
  if (const auto known = identity(file)) files_.emplace(*known, file);
}

void Inputs::refuse(const std::filesystem::path& path) const {
  const auto known = identity(path);
  const auto found = known ? files_.find(*known) : files_.end();
  if (found == files_.end()) return;
  throw InputError({{path.string(), 0, 0,
                     "found the input " + in_quotes(found->second.string()) +
                         " where the result is to be written, expected another file"}});
}

}  // namespace slipproof
