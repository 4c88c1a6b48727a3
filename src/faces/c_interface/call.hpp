// Common to all calls of the C interface: no exception leaves them; failures become a status and an error.
#pragma once

#include <string>
#include <utility>

#include "base/input/diagnostic.hpp"
#include "faces/c_interface/slipproof.h"

namespace slipproof::c {

/// Thrown for an argument that cannot be used: SLIPPROOF_BAD_ARGUMENT.
class BadArgument : public InputError {
 public:
  BadArgument(std::string argument, std::string message)
      : InputError({{std::move(argument), 0, 0, std::move(message)}}) {}
};

/// Throws BadArgument for a null pointer.
void need(const void* pointer, const char* argument);

/// The status for the exception in flight. Stores its message in `error` unless that is null.
slipproof_status status_of_exception(slipproof_error** error) noexcept;

/// Runs `body` and converts every exception to an error.
template <class Body>
slipproof_status call(slipproof_error** error, const Body& body) noexcept {
  if (error != nullptr) *error = nullptr;
  try {
    body();
    return SLIPPROOF_OK;
  } catch (...) {
    return status_of_exception(error);
  }
}

}  // namespace slipproof::c
