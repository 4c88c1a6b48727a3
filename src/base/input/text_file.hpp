// Whole text files, read with a limit.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace slipproof {

/// Longest accepted scene or claims file, in bytes; such files are written by hand.
inline constexpr std::size_t max_text_file_size = 1U << 20U;

/// The bytes of a file. Throws InputError when it cannot be opened or read, is a directory, or is longer than
/// `max_size` (which also ends the reading of an endless device).
std::string read_text_file(const std::filesystem::path& path, std::size_t max_size = max_text_file_size);

/// Reads a file that the user did not name, such as one found in a folder. Also throws InputError if it is not a
/// regular file, without opening it, since reading a pipe would wait for a writer.
std::string read_found_file(const std::filesystem::path& path, std::size_t max_size = max_text_file_size);

}  // namespace slipproof
