// What is said when a result cannot be written.
#pragma once

#include <stdexcept>
#include <string>

namespace slipproof {

/// A result that could not be written, with the place and the reason; the program's exit code is 6.
class OutputError : public std::runtime_error {
 public:
  OutputError(const std::string& place, const std::string& reason)
      : std::runtime_error(place + ": cannot be written: " + reason) {}
  /// Repeats a message of another process.
  explicit OutputError(const std::string& message) : std::runtime_error(message) {}
  /// Describes a place and the system's error number.
  OutputError(const std::string& place, int system_error);
};

}  // namespace slipproof
