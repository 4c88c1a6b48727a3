#include "base/input/text_file.hpp"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

#include "base/input/diagnostic.hpp"

namespace slipproof {

std::string read_text_file(const std::filesystem::path& path, std::size_t max_size) {
  const auto refuse = [&path](const std::string& message) {
    throw InputError({Diagnostic{.file = path.string(), .message = message}});
  };
  const auto reason = [] { return std::generic_category().message(errno); };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse("found a directory, expected a file");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) refuse("cannot be opened: " + reason());
  std::string text;
  char buffer[1U << 14U];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, file.get())) {
    text.append(buffer, count);
    if (text.size() > max_size) refuse("longer than " + std::to_string(max_size) + " bytes, expected a shorter file");
  }
  if (std::ferror(file.get()) != 0) refuse("cannot be read: " + reason());
  return text;
}

std::string read_found_file(const std::filesystem::path& path, std::size_t max_size) {
  std::error_code ignored;
  const std::filesystem::file_status found = std::filesystem::status(path, ignored);
  if (std::filesystem::is_other(found)) {
    throw InputError({Diagnostic{.file = path.string(), .message = "found a pipe or a device, expected a file"}});
  }
  return read_text_file(path, max_size);
}

}  // namespace slipproof
