// Bytes as they come: of files, and of pipes that somebody is still writing to.
#pragma once

#include <cstddef>
#include <functional>
#include <istream>
#include <string>

namespace slipproof {

/// Puts bytes into a buffer, as many as are there, `size` at most: it waits for the first one only. Returns their
/// number, 0 at the end. Throws InputError.
using ByteSource = std::function<std::size_t(char* buffer, std::size_t size)>;

/// The bytes of a file; of standard input for "-". Throws InputError if there is no such file.
ByteSource open_bytes(const std::string& file);

/// The bytes of a stream, which must outlive the source. Waits until the buffer is full, as a stream does not say how
/// many bytes it has ready. `file` is its name in messages.
ByteSource bytes_of(std::istream& stream, std::string file);

}  // namespace slipproof
